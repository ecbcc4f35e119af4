// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_error.h"

#include <charconv>
#include <cmath>
#include <string_view>
#include <type_traits>

namespace bedmix {

/// Words and numbers of a text, apart by blanks and ends of lines. Failures throw ForeignError, with the
/// place.
class WordReader {
 public:
  /// The first line is `at`.line of the file.
  WordReader(std::string_view text, const SourceLocation& at)
      : now_(text.data()), end_(now_ + text.size()), lineStart_(now_), at_(at) {}

  /// Goes to the next word of this line; false where there is none.
  bool findInLine() {
    while (now_ != end_ && isBlank(*now_)) ++now_;
    return now_ != end_ && *now_ != '\n';
  }
  /// Goes to the next word; false at the end of the text.
  bool find() {
    while (!findInLine()) {
      if (now_ == end_) return false;
      newLine();
    }
    return true;
  }
  /// Passes the end of this line, behind which there must be no more words in it.
  void endLine() {
    if (findInLine()) fail("stands where the line should end");
    if (now_ != end_) newLine();
  }

  /// Passes the rest of this line, whatever it is.
  void skipLine() {
    while (now_ != end_ && *now_ != '\n') ++now_;
    if (now_ != end_) newLine();
  }
  /// The next bytes, of which there must be as many.
  std::string_view takeBytes(std::size_t count) {
    const std::string_view bytes = rest().substr(0, count);
    now_ += count;
    return bytes;
  }

  /// The word that was found.
  std::string_view word() {
    const char* start = now_;
    while (!atWordEnd(now_)) ++now_;
    return {start, static_cast<std::size_t>(now_ - start)};
  }
  /// The word that was found, which must be a finite number.
  template <class T>
  T number() {
    T value{};
    const auto [stop, error] = std::from_chars(now_, end_, value);
    bool isNumber = error == std::errc() && atWordEnd(stop);
    if constexpr (std::is_floating_point_v<T>) isNumber = isNumber && std::isfinite(value);
    if (!isNumber) fail(std::is_integral_v<T> ? "is not a whole number" : "is not a number");
    now_ = stop;
    return value;
  }

  /// Fails because of the word at hand.
  [[noreturn]] void fail(const std::string& what) {
    const int column = static_cast<int>(now_ - lineStart_) + 1;
    throw ForeignError({at_.file, at_.line, column}, "'" + std::string(word().substr(0, 40)) + "' " + what);
  }
  /// This line.
  const SourceLocation& at() const { return at_; }
  /// What has not been read.
  std::string_view rest() const { return {now_, static_cast<std::size_t>(end_ - now_)}; }

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  bool atWordEnd(const char* p) const { return p == end_ || *p == '\n' || isBlank(*p); }
  void newLine() {
    lineStart_ = ++now_;
    ++at_.line;
  }

  const char* now_;
  const char* end_;
  const char* lineStart_;
  SourceLocation at_;
};

}  // namespace bedmix
