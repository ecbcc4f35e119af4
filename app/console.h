// SPDX-License-Identifier: MIT
#pragma once

#include "app/exit_code.h"
#include "engine/core/diagnostic.h"

#include <span>
#include <string>
#include <string_view>

namespace bedmix {

/// The two streams of the program: data goes to stdout, whatever is said about it to stderr.
class Console {
 public:
  Console();

  /// --quiet: nothing but errors is said.
  bool quiet = false;

  /// Whether stderr is a terminal that a line can be rewritten on.
  bool isTerminal() const { return isTerminal_; }

  void say(std::string_view message) const;
  void warn(std::string_view message) const;
  /// Says everything that is wrong; the exit code of the first.
  ExitCode fail(std::span<const Diagnostic> problems) const;
  ExitCode fail(const Diagnostic& problem) const { return fail(std::span(&problem, 1)); }
  /// `at` is the file, option or place it is about, or empty.
  ExitCode fail(std::string at, std::string message, Trouble trouble = Trouble::input) const;
  /// Text for stdout, a line end added. A reader that has gone is no trouble.
  void print(std::string_view data) const;

 private:
  std::string marked(std::string_view word, std::string_view colour) const;

  bool isTerminal_;
  bool hasColour_;
};

}  // namespace bedmix
