// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <bit>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace bedmix {

/// A file of VTK's XML formats (VTK User's Guide, ch. 19), its numbers appended to the text as raw bytes.
class VtkFile {
 public:
  explicit VtkFile(std::string_view type) : type_(type) {}

  void xml(std::string_view text) { xml_ += text; }
  /// A DataArray of so many numbers a point or cell.
  template <class T>
  void array(std::string_view name, std::span<const T> values, int components = 1) {
    xml_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        typeName<T>(), name, components, data_.size());
    append(std::as_bytes(values));
  }
  /// The time of a frame, s, where ParaView looks for it.
  void time(double seconds);

  std::string bytes() const;

 private:
  template <class T>
  static std::string typeName() {
    return (std::floating_point<T> ? "Float"
            : std::is_signed_v<T>  ? "Int"
                                   : "UInt") +
           std::to_string(8 * sizeof(T));
  }
  void append(std::span<const std::byte> bytes);

  std::string type_, xml_, data_;
};

}  // namespace bedmix
