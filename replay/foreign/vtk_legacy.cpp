// SPDX-License-Identifier: MIT
#include "replay/foreign/vtk_legacy.h"

#include "replay/foreign/word_reader.h"

#include <fmt/format.h>

#include <bit>

namespace bedmix {

namespace {

class LegacyReader {
 public:
  LegacyReader(std::string_view text, const std::filesystem::path& path)
      : path_(path), words_(text, {path.string(), 1, 1}) {}

  VtkPoints read() {
    if (!words_.rest().starts_with("# vtk DataFile Version"))
      throw ForeignError(path_, "is no legacy file of VTK");
    words_.skipLine();
    words_.skipLine();  // a title
    const std::string_view coding = word();
    if (coding != "ASCII" && coding != "BINARY") throw ForeignError(words_.at(), "neither ASCII nor BINARY");
    isBinary_ = coding == "BINARY";
    if (word() != "DATASET") throw ForeignError(words_.at(), "the file names no DATASET");
    if (const std::string_view kind = word(); kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID")
      throw ForeignError(words_.at(), fmt::format("holds {}; particles are the points of POLYDATA or "
                                                  "UNSTRUCTURED_GRID",
                                                  kind.substr(0, 40)));
    while (words_.find()) readPart(words_.word());
    if (!hasPoints_) throw ForeignError(path_, "has no POINTS, or is cut off before them");
    return std::move(points_);
  }

 private:
  void readPart(std::string_view part) {
    if (part == "POINTS") {
      const std::uint64_t count = length();
      points_.coordinates = numbers(count, 3);
      hasPoints_ = true;
    } else if (part == "VERTICES" || part == "LINES" || part == "POLYGONS" || part == "TRIANGLE_STRIPS" ||
               part == "CELLS") {
      offsets_ = length();
      indices_ = length();
      // Since version 5.1 two parts follow that are lists by themselves.
      if (words_.rest().substr(0, 10).find("OFFSETS") == std::string_view::npos) numbers(indices_, 1, "int");
    } else if (part == "OFFSETS") {
      numbers(offsets_, 1);
    } else if (part == "CONNECTIVITY") {
      numbers(indices_, 1);
    } else if (part == "CELL_TYPES") {
      numbers(length(), 1, "int");
    } else if (part == "POINT_DATA" || part == "CELL_DATA") {
      isPointData_ = part == "POINT_DATA";
      rows_ = length();
    } else if (part == "SCALARS") {
      const std::string name(word());
      const std::string kind(word());
      const std::uint64_t components = words_.findInLine() ? words_.number<std::uint64_t>() : 1;
      words_.endLine();
      word();  // LOOKUP_TABLE
      word();
      keep(name, components, numbers(rows_, components, kind));
    } else if (part == "VECTORS" || part == "NORMALS") {
      const std::string name(word());
      keep(name, 3, numbers(rows_, 3));
    } else if (part == "FIELD") {
      word();
      for (std::uint64_t left = length(); left > 0; --left) readFieldArray();
    } else if (part == "METADATA") {
      words_.skipLine();
      while (words_.findInLine()) words_.skipLine();  // up to an empty line
    } else {
      throw ForeignError(words_.at(), fmt::format("'{}' is not known, or the file is damaged before it",
                                                  part.substr(0, 40)));
    }
  }

  void readFieldArray() {
    std::string name(word());
    if (name == "METADATA") {
      readPart(name);
      name = word();
    }
    const std::uint64_t components = length(), rows = length();
    const std::string kind(word());
    if (kind == "string") throw ForeignError(words_.at(), "holds an array of texts, which is not read");
    keep(name, components, numbers(rows, components, kind));
  }

  void keep(const std::string& name, std::uint64_t components, std::vector<double> values) {
    if (isPointData_)
      points_.arrays.push_back({name, static_cast<std::size_t>(components), std::move(values)});
  }

  std::string_view word() {
    if (!words_.find()) throw ForeignError(words_.at(), "the file is cut off");
    return words_.word();
  }
  std::uint64_t length() {
    if (!words_.find()) throw ForeignError(words_.at(), "the file is cut off");
    return words_.number<std::uint64_t>();
  }

  /// What stands behind this line, of the kind that the line ends with where none is given.
  std::vector<double> numbers(std::uint64_t rows, std::uint64_t perRow, std::string kindName = "") {
    if (kindName.empty()) kindName = word();
    const VtkNumber kind = vtkNumber(kindName, words_.at());
    const std::size_t left = words_.rest().size();
    if (perRow != 0 && rows > left / perRow) throw ForeignError(words_.at(), "the file is cut off");
    const auto count = static_cast<std::size_t>(rows * perRow);
    if (isBinary_) {
      words_.endLine();
      if (count > words_.rest().size() / kind.size) throw ForeignError(words_.at(), "the file is cut off");
      return vtkNumbers(words_.takeBytes(count * kind.size), kind,
                        std::endian::native == std::endian::little);
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
      if (!words_.find()) throw ForeignError(words_.at(), "the file is cut off");
      values.push_back(words_.number<double>());
    }
    // A number at the very end of the file may have more digits to come.
    if (count > 0 && words_.rest().empty()) throw ForeignError(words_.at(), "the file is cut off");
    return values;
  }

  std::filesystem::path path_;
  WordReader words_;
  VtkPoints points_;
  bool isBinary_ = false, hasPoints_ = false, isPointData_ = false;
  std::uint64_t rows_ = 0, offsets_ = 0, indices_ = 0;
};

}  // namespace

VtkPoints readVtkLegacy(std::string_view text, const std::filesystem::path& path) {
  return LegacyReader(text, path).read();
}

}  // namespace bedmix
