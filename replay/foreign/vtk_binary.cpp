// SPDX-License-Identifier: MIT
#include "replay/foreign/vtk_binary.h"

#include "replay/foreign/foreign_error.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>
#include <zlib.h>

namespace bedmix {

namespace {

int base64Digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

class CodedBytes {
 public:
  CodedBytes(std::string_view text, bool isBase64, const VtkCoding& coding, const SourceLocation& at)
      : text_(text), isBase64_(isBase64), coding_(coding), at_(at) {}

  std::string take(std::uint64_t n) {
    if (n > text_.size() + decoded_.size()) fail("is cut off, or longer than the file by what it says");
    const auto size = static_cast<std::size_t>(n);
    if (!isBase64_) {
      std::string bytes(text_.substr(0, size));
      text_.remove_prefix(size);
      return bytes;
    }
    while (decoded_.size() < size) decodeFour();
    std::string bytes = decoded_.substr(0, size);
    decoded_.erase(0, size);
    return bytes;
  }
  std::uint64_t takeLength() {
    std::string bytes = take(coding_.headerSize);
    const bool isBigEndian = coding_.isSwapped == (std::endian::native == std::endian::little);
    if (isBigEndian) std::reverse(bytes.begin(), bytes.end());
    std::uint64_t length = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) length = length << 8 | static_cast<unsigned char>(bytes[i]);
    return length;
  }
  [[noreturn]] void fail(const std::string& what) const { throw ForeignError(at_, "the array " + what); }

 private:
  /// Lengths and data may be padded each by themselves.
  void decodeFour() {
    std::uint32_t bits = 0;
    int digits = 0;
    for (int i = 0; i < 4; ++i) {
      while (!text_.empty() && (text_.front() == '\n' || text_.front() == ' ' || text_.front() == '\r'))
        text_.remove_prefix(1);
      if (text_.empty()) fail("is cut off");
      const int digit = base64Digit(text_.front());
      if (digit < 0 && text_.front() != '=') fail("is cut off or no base64");
      if (digit >= 0 && digits < i) fail("is no base64");
      text_.remove_prefix(1);
      bits = bits << 6 | static_cast<std::uint32_t>(std::max(digit, 0));
      if (digit >= 0) ++digits;
    }
    if (digits < 2) fail("is no base64");
    for (int byte = 0; byte < digits - 1; ++byte)
      decoded_ += static_cast<char>(bits >> (16 - 8 * byte) & 0xff);
  }

  std::string_view text_;
  bool isBase64_;
  VtkCoding coding_;
  SourceLocation at_;
  std::string decoded_;
};

}  // namespace

std::string vtkBytes(std::string_view text, bool isBase64, const VtkCoding& coding,
                     const SourceLocation& at) {
  CodedBytes coded(text, isBase64, coding, at);
  const std::uint64_t first = coded.takeLength();
  if (!coding.isCompressed) return coded.take(first);

  const std::uint64_t blockSize = coded.takeLength(), lastSize = coded.takeLength();
  std::vector<std::uint64_t> packedSizes;
  for (std::uint64_t b = 0; b < first; ++b) packedSizes.push_back(coded.takeLength());
  std::string bytes;
  for (std::uint64_t b = 0; b < first; ++b) {
    const std::string packed = coded.take(packedSizes[b]);
    const std::uint64_t size = b + 1 == first && lastSize != 0 ? lastSize : blockSize;
    constexpr std::uint64_t mostPerByte = 1032;  // what deflate can make of a byte
    if (size / mostPerByte > packed.size()) coded.fail("is longer than what it holds can be");
    const std::size_t begin = bytes.size();
    bytes.resize(begin + static_cast<std::size_t>(size));
    uLongf done = static_cast<uLongf>(size);
    const int status =
        uncompress(reinterpret_cast<Bytef*>(bytes.data() + begin), &done,
                   reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size()));
    if (status != Z_OK || done != size) coded.fail("is damaged: zlib cannot unpack it");
  }
  return bytes;
}

}  // namespace bedmix
