// SPDX-License-Identifier: MIT
#include "replay/foreign/vtk_xml.h"

#include "replay/foreign/vtk_binary.h"
#include "replay/foreign/word_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <pugixml.hpp>

namespace bedmix {

namespace {

/// A VTKFile element and the data appended to it, which may be no XML.
class VtkDocument {
 public:
  VtkDocument(std::string_view text, const std::filesystem::path& path) : text_(text), path_(path) {
    std::string xml(text);
    if (const std::size_t tag = text.find("<AppendedData"); tag != std::string_view::npos) {
      const std::size_t end = text.find('>', tag);
      const std::size_t mark = text.find('_', end);
      if (end == std::string_view::npos || mark == std::string_view::npos)
        throw ForeignError(path, "is cut off before its appended data");
      appended_ = text.substr(mark + 1);
      xml = std::string(text.substr(0, end + 1)) + "</AppendedData></VTKFile>";
    }
    const pugi::xml_parse_result parsed = document_.load_buffer(xml.data(), xml.size());
    if (!parsed)
      throw ForeignError(at(parsed.offset), fmt::format("is damaged or cut off: {}", parsed.description()));
    if (!root()) throw ForeignError(path, "is no XML file of VTK: it has no VTKFile");
    readCoding();
  }

  pugi::xml_node root() const { return document_.child("VTKFile"); }
  SourceLocation at(std::ptrdiff_t offset) const {
    const auto end =
        text_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
    return {path_.string(), static_cast<int>(std::count(text_.begin(), end, '\n')) + 1, 1};
  }
  SourceLocation at(const pugi::xml_node& node) const { return at(node.offset_debug()); }

  VtkPoints::Array array(const pugi::xml_node& node) const {
    VtkPoints::Array array{
        node.attribute("Name").value(), node.attribute("NumberOfComponents").as_uint(1), {}};
    const VtkNumber kind = vtkNumber(node.attribute("type").value(), at(node));
    const std::string_view format = node.attribute("format").value();
    const std::string_view text = node.child_value();
    if (format == "ascii") {
      for (WordReader words(text, at(node)); words.find();) array.values.push_back(words.number<double>());
      return array;
    }
    std::string bytes;
    if (format == "binary") {
      bytes = vtkBytes(text, true, coding_, at(node));
    } else if (format == "appended") {
      const std::size_t offset = node.attribute("offset").as_ullong(appended_.size());
      if (offset >= appended_.size()) throw ForeignError(at(node), "the array is cut off");
      bytes = vtkBytes(appended_.substr(offset), isBase64_, coding_, at(node));
    } else {
      throw ForeignError(at(node), fmt::format("the array has the format '{}', which is not known", format));
    }
    if (bytes.size() % kind.size != 0) throw ForeignError(at(node), "the array ends within a number");
    array.values = vtkNumbers(bytes, kind, coding_.isSwapped);
    return array;
  }

 private:
  void readCoding() {
    const std::string_view order = root().attribute("byte_order").value();
    const bool isBig = order == "BigEndian";
    coding_.isSwapped = isBig == (std::endian::native == std::endian::little);
    coding_.headerSize = std::string_view(root().attribute("header_type").value()) == "UInt64" ? 8 : 4;
    const std::string_view compressor = root().attribute("compressor").value();
    coding_.isCompressed = !compressor.empty();
    if (coding_.isCompressed && compressor != "vtkZLibDataCompressor")
      throw ForeignError(path_,
                         fmt::format("is packed by {}; only vtkZLibDataCompressor is read", compressor));
    isBase64_ = std::string_view(root().child("AppendedData").attribute("encoding").value()) == "base64";
  }

  std::string_view text_, appended_;
  std::filesystem::path path_;
  pugi::xml_document document_;
  VtkCoding coding_;
  bool isBase64_ = false;
};

}  // namespace

VtkPoints readVtkXml(std::string_view text, const std::filesystem::path& path) {
  const VtkDocument document(text, path);
  const std::string type = document.root().attribute("type").value();
  if (type != "PolyData" && type != "UnstructuredGrid")
    throw ForeignError(
        path, fmt::format("holds '{}'; particles are the points of PolyData or UnstructuredGrid", type));

  const pugi::xml_node data = document.root().child(type.c_str());
  const pugi::xml_node piece = data.child("Piece");
  if (!piece || piece.next_sibling("Piece"))
    throw ForeignError(document.at(data), "has not one Piece, and only such files are read");
  VtkPoints points;
  const std::size_t count = piece.attribute("NumberOfPoints").as_ullong();
  if (const pugi::xml_node node = piece.child("Points").child("DataArray"))
    points.coordinates = document.array(node).values;
  if (points.coordinates.size() / 3 != count || points.coordinates.size() % 3 != 0)
    throw ForeignError(document.at(piece), fmt::format("says that it has {} points and holds {} coordinates",
                                                       count, points.coordinates.size()));
  for (const pugi::xml_node& node : piece.child("PointData").children("DataArray"))
    if (std::string_view(node.attribute("type").value()) != "String")
      points.arrays.push_back(document.array(node));
  return points;
}

std::vector<PvdEntry> readPvd(std::string_view text, const std::filesystem::path& path) {
  const VtkDocument document(text, path);
  std::vector<PvdEntry> entries;
  for (const pugi::xml_node& node : document.root().child("Collection").children("DataSet")) {
    const std::string_view time = node.attribute("timestep").value();
    WordReader words(time, document.at(node));
    words.find();
    PvdEntry entry{words.number<double>(), {}};
    const std::filesystem::path file =
        std::filesystem::path(node.attribute("file").value()).lexically_normal();
    if (file.empty() || file.is_absolute() || *file.begin() == "..")
      throw ForeignError(
          document.at(node),
          fmt::format("names '{}', which is not in the folder of the collection", file.string()));
    if (!entries.empty() && !(entry.time > entries.back().time))
      throw ForeignError(document.at(node),
                         fmt::format("has the timestep {} after {}; times must increase, and a "
                                     "time have one file",
                                     entry.time, entries.back().time));
    entry.path = path.parent_path() / file;
    entries.push_back(std::move(entry));
  }
  if (entries.empty()) throw ForeignError(path, "is a collection without files");
  return entries;
}

}  // namespace bedmix
