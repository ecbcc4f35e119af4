// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bedmix {

/// A place in an input. `line` and `column` count from 1; 0 means "the input as a whole".
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

/// Whose trouble it is, which decides the exit code: the user's input, a file or disk, something this machine
/// lacks for drawing and encoding, or a solution that became invalid.
enum class Trouble { input, file, unavailable, solution };

/// One thing that is wrong: where, what and why, and what to do about it.
struct Diagnostic {
  SourceLocation at;
  std::string message;
  Trouble trouble = Trouble::input;

  Diagnostic() = default;
  // Written out because g++ 12 warns of uninitialized members when it does this itself.
  Diagnostic(SourceLocation where, std::string what, Trouble whose = Trouble::input)
      : at(std::move(where)), message(std::move(what)), trouble(whose) {}
};

/// "file:line:column: message", the form editors understand.
inline std::string toString(const Diagnostic& d) {
  std::string text = d.at.file;
  if (d.at.line > 0) text += ':' + std::to_string(d.at.line) + ':' + std::to_string(d.at.column);
  return text.empty() ? d.message : text + ": " + d.message;
}

/// A value, or every reason why there is none. Failures of the user's input and of files travel this way;
/// nothing below app/ prints or exits.
template <class T>
struct [[nodiscard]] Result {
  std::optional<T> value;
  std::vector<Diagnostic> problems;

  Result(T v) : value(std::move(v)) {}                           // NOLINT: a value is a Result
  Result(std::vector<Diagnostic> p) : problems(std::move(p)) {}  // NOLINT
  Result(Diagnostic p) : problems{std::move(p)} {}               // NOLINT

  explicit operator bool() const { return value.has_value(); }
  T& operator*() { return *value; }
  const T& operator*() const { return *value; }
  T* operator->() { return &*value; }
  const T* operator->() const { return &*value; }
};

/// The Result of an action that yields nothing.
struct Done {};

}  // namespace bedmix
