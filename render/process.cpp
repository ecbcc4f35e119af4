// SPDX-License-Identifier: MIT
#include "render/process.h"

#include "render/c_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <spawn.h>
#include <sys/wait.h>

extern char** environ;

namespace bedmix {

namespace {}  // namespace

Result<ProcessEnd> runProcess(const std::vector<std::string>& command, const std::string& input) {
  // Unnamed files instead of pipes: nothing can block, and nobody gets a SIGPIPE.
  const CFile in(std::tmpfile()), out(std::tmpfile());
  if (!in || !out || std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() ||
      std::fflush(in.get()) != 0)
    return Diagnostic{{}, std::string("no temporary file: ") + std::strerror(errno), Trouble::file};
  std::rewind(in.get());

  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in.get()), 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), 1);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), 2);
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return Diagnostic{{}, command[0] + " does not start: " + std::strerror(error)};

  int state = 0;
  while (waitpid(child, &state, 0) < 0 && errno == EINTR) {
  }
  ProcessEnd end;
  end.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  std::rewind(out.get());
  std::array<char, 4096> chunk{};
  while (const std::size_t n = std::fread(chunk.data(), 1, chunk.size(), out.get()))
    end.output.append(chunk.data(), n);
  return end;
}

}  // namespace bedmix
