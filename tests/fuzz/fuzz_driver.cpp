// SPDX-License-Identifier: MIT
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/mutations.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

// Feeds one target with the corpus, then with mutated seeds: the same ones for the same --seed. What
// libFuzzer does, less the search for coverage, with any compiler.

namespace {

using namespace bedmix;
using namespace bedmix::fuzz;

constexpr int patience = 10;       // s of computing, for one input
constexpr int longPatience = 300;  // s, when it waits for another process or the machine is busy

struct Options {
  std::optional<double> seconds;  // of computing
  std::uint64_t runs = 1000;
  std::uint64_t seed = 1;
  std::vector<std::filesystem::path> corpus;
};

/// The input on its way through the target, in a file that is left behind where it ends the process.
class KeptInput {
 public:
  explicit KeptInput(std::string path)
      : path_(std::move(path)), file_(open(path_.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0644)) {}
  ~KeptInput() {
    close(file_);
    unlink(path_.c_str());
  }
  bool keep(const std::string& input) const {
    return ftruncate(file_, static_cast<off_t>(input.size())) == 0 &&
           pwrite(file_, input.data(), input.size(), 0) == static_cast<ssize_t>(input.size());
  }

 private:
  std::string path_;
  int file_;
};

void onHang(int) {
  constexpr char message[] = "an input takes too long; it is kept as *.failing\n";
  if (write(STDERR_FILENO, message, sizeof message - 1) > 0) std::abort();
  std::abort();
}

void feed(const std::string& input, const KeptInput& kept) {
  if (!kept.keep(input)) std::abort();
  constexpr itimerval most{{}, {patience, 0}}, none{};
  setitimer(ITIMER_PROF, &most, nullptr);
  alarm(longPatience);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  alarm(0);
  setitimer(ITIMER_PROF, &none, nullptr);
}

/// Seconds that this process and its children have computed for.
double computed() {
  double seconds = 0.0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    for (const timeval& time : {used.ru_utime, used.ru_stime})
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return seconds;
}

std::vector<std::string> readCorpus(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::string> inputs;
  const auto add = [&](const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  };
  for (const auto& path : paths) {
    if (!std::filesystem::is_directory(path)) {
      add(path);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(path)) add(entry.path());
  }
  return inputs;
}

std::optional<Options> parse(int count, char** words) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const bool isOption = word.starts_with("--");
    if (isOption && i + 1 == count) return std::nullopt;
    if (word == "--seconds")
      options.seconds = std::strtod(words[++i], nullptr);
    else if (word == "--runs")
      options.runs = std::strtoull(words[++i], nullptr, 10);
    else if (word == "--seed")
      options.seed = std::strtoull(words[++i], nullptr, 10);
    else if (isOption)
      return std::nullopt;
    else
      options.corpus.emplace_back(word);
  }
  return options;
}

}  // namespace

int main(int count, char** words) {
  const std::optional<Options> options = parse(count, words);
  if (!options) {
    fmt::print(stderr, "{} [--seconds S of computing | --runs N] [--seed K] [FILE or FOLDER of inputs ...]\n",
               words[0]);
    return 2;
  }
  const std::string name = std::filesystem::path(words[0]).filename().string();
  const KeptInput kept(fmt::format("{}-{}.failing", name, options->seed));
  for (const int late : {SIGALRM, SIGPROF}) std::signal(late, onHang);

  std::vector<std::string> known = readCorpus(options->corpus);
  for (const std::string& input : known) feed(input, kept);
  for (const std::string& input : seeds()) {
    feed(input, kept);
    known.push_back(input);
  }

  const double start = computed();
  const auto elapsed = [&] { return computed() - start; };
  const auto goesOn = [&](std::uint64_t run) {
    return options->seconds ? elapsed() < *options->seconds : run < options->runs;
  };
  Rng rng(options->seed);
  std::uint64_t run = 0;
  for (; goesOn(run); ++run) {
    std::string input = oneOf(known, rng);
    if (below(16, rng) == 0) input = splice(input, oneOf(known, rng), rng);
    for (std::size_t left = 1 + below(4, rng); left > 0; --left) mutate(input, rng);
    feed(input, kept);
  }
  fmt::print("{}: {} runs in {:.1f} s of computing, {:.0f} a second, no finding\n", name, run, elapsed(),
             static_cast<double>(run) / elapsed());
}
