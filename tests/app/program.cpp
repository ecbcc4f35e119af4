// SPDX-License-Identifier: MIT
#include "tests/app/program.h"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <tuple>
#include <unistd.h>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

/// Starts argv in `folder`, stdout into a file, stderr into a pipe whose reading end it returns.
std::pair<pid_t, int> spawn(std::vector<std::string> arguments, const fs::path& folder,
                            const fs::path& outFile) {
  std::vector<char*> argv;
  for (std::string& a : arguments) argv.push_back(a.data());
  argv.push_back(nullptr);
  int pipeEnds[2];
  if (pipe2(pipeEnds, O_CLOEXEC) != 0) std::abort();
  const pid_t pid = fork();
  if (pid == 0) {
    const int out = open(outFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(out, STDOUT_FILENO);
    dup2(pipeEnds[1], STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) execvp(argv[0], argv.data());
    _exit(127);
  }
  close(pipeEnds[1]);
  return {pid, pipeEnds[0]};
}

}  // namespace

Program::Program(std::vector<std::string> arguments, const fs::path& folder) : outFile_(folder / ".stdout") {
  std::tie(pid_, errPipe_) = spawn(std::move(arguments), folder, outFile_);
}

Program::~Program() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  close(errPipe_);
}

bool Program::waitForMessage(const std::string& text) {
  char buffer[4096];
  while (err_.find(text) == std::string::npos) {
    const ssize_t got = read(errPipe_, buffer, sizeof buffer);
    if (got <= 0) return false;
    err_.append(buffer, static_cast<std::size_t>(got));
  }
  return true;
}

void Program::send(int signal) const { kill(pid_, signal); }

void Program::fillDisk(std::uint64_t bytes) const {
  const rlimit limit{bytes, bytes};
  if (prlimit(pid_, RLIMIT_FSIZE, &limit, nullptr) != 0) std::abort();
}

Outcome Program::wait() {
  char buffer[4096];
  for (ssize_t got; (got = read(errPipe_, buffer, sizeof buffer)) > 0;)
    err_.append(buffer, static_cast<std::size_t>(got));
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, readFile(outFile_), err_};
}

ProgramTest::ProgramTest() {
  std::string pattern = (fs::path(::testing::TempDir()) / "bedmix-XXXXXX").string();
  if (!mkdtemp(pattern.data())) std::abort();
  folder = pattern;
  setenv("BEDMIX", BEDMIX_PROGRAM, 1);
}

ProgramTest::~ProgramTest() { fs::remove_all(folder); }

Outcome ProgramTest::bedmix(std::vector<std::string> arguments) const {
  return start(std::move(arguments))->wait();
}

std::unique_ptr<Program> ProgramTest::start(std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), BEDMIX_PROGRAM);
  return std::make_unique<Program>(std::move(arguments), folder);
}

Outcome ProgramTest::shell(const std::string& command) const {
  return Program({"bash", "-c", command}, folder).wait();
}

std::string readFile(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void writeFile(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

::testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "no \"" << part << "\" in:\n" << text;
}

}  // namespace bedmix
