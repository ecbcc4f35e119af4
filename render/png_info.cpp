// SPDX-License-Identifier: MIT
#include "render/png_info.h"

#include <cstdint>
#include <fstream>
#include <string_view>

namespace bedmix {

namespace {

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t longestText = 1 << 16;  // bytes; a foreign file may claim any length

std::uint32_t bigEndian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
  return value;
}

std::string take(std::istream& file, std::size_t length) {
  std::string bytes(length, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(length));
  return bytes;
}

Size sizeIn(const std::string& header) {
  const std::uint32_t width = bigEndian(header.data()), height = bigEndian(header.data() + 4);
  return {static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace

Result<PngInfo> readPngInfo(const std::filesystem::path& path) {
  const Diagnostic failure{{path.string()}, "is no complete PNG", Trouble::file};
  std::ifstream file(path, std::ios::binary);
  if (take(file, signature.size()) != signature) return failure;
  PngInfo info;
  // A chunk: length, name, data, checksum.
  while (file) {
    const std::string head = take(file, 8);
    const std::string_view name = std::string_view(head).substr(4);
    const std::uint32_t length = bigEndian(head.data());
    std::string data;
    if ((name == "IHDR" || name == "tEXt") && length <= longestText)
      data = take(file, length);
    else
      file.seekg(length, std::ios::cur);
    take(file, 4);
    if (!file) break;
    if (name == "IEND") return info;
    if (name == "IHDR" && length >= 8) info.size = sizeIn(data);
    if (const std::size_t zero = data.find('\0'); name == "tEXt" && zero != std::string::npos)
      info.text.emplace_back(data.substr(0, zero), data.substr(zero + 1));
  }
  return failure;
}

}  // namespace bedmix
