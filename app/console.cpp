// SPDX-License-Identifier: MIT
#include "app/console.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace bedmix {

namespace {

bool wantsColour() {
  const char* noColour = std::getenv("NO_COLOR");  // https://no-color.org
  const char* term = std::getenv("TERM");
  return !(noColour && *noColour) && term && std::string_view(term) != "dumb";
}

/// Where it cannot be said, a run is worth more than what is said of it.
void tell(const std::string& line) { std::fputs((line + '\n').c_str(), stderr); }

}  // namespace

Console::Console() : isTerminal_(isatty(STDERR_FILENO) == 1), hasColour_(isTerminal_ && wantsColour()) {}

std::string Console::marked(std::string_view word, std::string_view colour) const {
  return hasColour_ ? fmt::format("\033[{}m{}\033[0m", colour, word) : std::string(word);
}

void Console::say(std::string_view message) const {
  if (!quiet) tell(std::string(message));
}

void Console::warn(std::string_view message) const {
  if (!quiet) tell(fmt::format("{} {}", marked("warning:", "1;33"), message));
}

ExitCode Console::fail(std::span<const Diagnostic> problems) const {
  for (const Diagnostic& d : problems) tell(fmt::format("{} {}", marked("error:", "1;31"), toString(d)));
  return problems.empty() ? ExitCode::done : exitCodeOf(problems.front().trouble);
}

ExitCode Console::fail(std::string at, std::string message, Trouble trouble) const {
  Diagnostic problem;
  problem.at.file = std::move(at);
  problem.message = std::move(message);
  problem.trouble = trouble;
  return fail(problem);
}

void Console::print(std::string_view data) const {
  std::fwrite(data.data(), 1, data.size(), stdout);
  if (!data.ends_with('\n')) std::fputc('\n', stdout);
  // A reader that leaves has had enough.
  if ((std::fflush(stdout) != 0 || std::ferror(stdout) != 0) && errno != EPIPE)
    throw std::filesystem::filesystem_error("cannot print", "stdout",
                                            std::error_code(errno, std::generic_category()));
}

}  // namespace bedmix
