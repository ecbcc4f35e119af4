// SPDX-License-Identifier: MIT
#include "replay/foreign/line_reader.h"

#include "replay/foreign/foreign_error.h"

namespace bedmix {

namespace {

constexpr std::size_t blockSize = std::size_t{1} << 18;

}  // namespace

std::optional<std::string_view> LineReader::next() {
  std::size_t searched = from_;
  for (;;) {
    const std::size_t end = block_.find('\n', searched);
    if (end != std::string::npos) {
      const std::string_view line(block_.data() + from_, end - from_);
      from_ = end + 1;
      ++line_;
      return line;
    }
    searched = block_.size() - from_;
    if (!refill()) return std::nullopt;
  }
}

/// Moves the line that has begun to the front and reads on behind it; false at the end of the file.
bool LineReader::refill() {
  const std::size_t begun = block_.size() - from_;
  if (begun >= blockSize) throw ForeignError(path_, "is no text: it has no lines");
  blockOffset_ += from_;
  block_.erase(0, from_);
  from_ = 0;
  block_.resize(begun + blockSize);
  const std::size_t n = file_.read(block_.data() + begun, blockSize);
  block_.resize(begun + n);
  return n > 0;
}

}  // namespace bedmix
