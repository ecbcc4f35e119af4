// SPDX-License-Identifier: MIT
#include "replay/export/vtk_file.h"

namespace bedmix {

void VtkFile::time(double seconds) {
  xml_ += fmt::format(
      "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">"
      "{}</DataArray>\n</FieldData>\n",
      seconds);
}

void VtkFile::append(std::span<const std::byte> bytes) {
  const std::uint64_t size = bytes.size();
  data_.append(reinterpret_cast<const char*>(&size), sizeof size);
  data_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

std::string VtkFile::bytes() const {
  constexpr bool isLittle = std::endian::native == std::endian::little;
  return fmt::format(
             "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"{1}\" "
             "header_type=\"UInt64\">\n<{0}",
             type_, isLittle ? "LittleEndian" : "BigEndian") +
         xml_ + fmt::format("</{}>\n<AppendedData encoding=\"raw\">\n_", type_) + data_ +
         "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace bedmix
