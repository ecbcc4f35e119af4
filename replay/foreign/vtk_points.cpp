// SPDX-License-Identifier: MIT
#include "replay/foreign/vtk_points.h"

#include "replay/foreign/foreign_error.h"
#include "replay/foreign/repeated_id.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

namespace bedmix {

namespace {

template <class T>
std::vector<double> numbersOf(std::string_view bytes, bool isSwapped) {
  std::vector<double> numbers(bytes.size() / sizeof(T));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes.data() + i * sizeof(T), sizeof(T));
    if (isSwapped) std::reverse(raw, raw + sizeof(T));
    T number;
    std::memcpy(&number, raw, sizeof(T));
    numbers[i] = static_cast<double>(number);
  }
  return numbers;
}

std::string lowered(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

class Arrays {
 public:
  Arrays(const VtkPoints& points, const SourceLocation& at) : points_(points), at_(at) {}

  /// The values of the first array of one of these names; null where there is none.
  const std::vector<double>* find(std::size_t components,
                                  std::initializer_list<std::string_view> names) const {
    for (const VtkPoints::Array& array : points_.arrays)
      if (array.components == components && std::count(names.begin(), names.end(), lowered(array.name))) {
        const std::size_t points = points_.coordinates.size() / 3;
        if (array.values.size() != points * components)
          throw ForeignError(
              at_, fmt::format("{} has {} numbers for {} points", array.name, array.values.size(), points));
        return &array.values;
      }
    return nullptr;
  }
  std::vector<Vec3d> vectors(const std::vector<double>* values) const {
    std::vector<Vec3d> list(values ? values->size() / 3 : 0);
    for (std::size_t i = 0; i < 3 * list.size(); ++i) list[i / 3][i % 3] = finite((*values)[i]);
    return list;
  }
  std::vector<double> scalars(const std::vector<double>* values, double factor) const {
    std::vector<double> list;
    if (values)
      for (double v : *values) list.push_back(finite(v) * factor);
    return list;
  }
  std::vector<std::int64_t> whole(const std::vector<double>* values) const {
    std::vector<std::int64_t> list;
    if (values)
      for (double v : *values) {
        constexpr double most = 0x1p53;  // up to which a double holds every whole number
        if (!(std::abs(v) < most) || v != std::floor(v))
          throw ForeignError(at_, fmt::format("{} is no id or type of a particle", v));
        list.push_back(static_cast<std::int64_t>(v));
      }
    return list;
  }

 private:
  double finite(double v) const {
    if (!std::isfinite(v)) throw ForeignError(at_, fmt::format("a particle has a number that is {}", v));
    return v;
  }

  const VtkPoints& points_;
  const SourceLocation& at_;
};

}  // namespace

VtkNumber vtkNumber(std::string_view name, const SourceLocation& at) {
  static const struct {
    std::string_view xml, legacy;
    VtkNumber kind;
  } known[] = {
      {"Float32", "float", {true, true, 4}},           {"Float64", "double", {true, true, 8}},
      {"Int8", "signed_char", {false, true, 1}},       {"Int8", "char", {false, true, 1}},
      {"UInt8", "unsigned_char", {false, false, 1}},   {"Int16", "short", {false, true, 2}},
      {"UInt16", "unsigned_short", {false, false, 2}}, {"Int32", "int", {false, true, 4}},
      {"Int32", "vtkIdType", {false, true, 4}},  // which legacy files hold as int
      {"UInt32", "unsigned_int", {false, false, 4}},   {"Int64", "long", {false, true, 8}},
      {"Int64", "vtktypeint64", {false, true, 8}},     {"UInt64", "unsigned_long", {false, false, 8}},
      {"UInt64", "vtktypeuint64", {false, false, 8}}};
  for (const auto& k : known)
    if (name == k.xml || name == k.legacy) return k.kind;
  throw ForeignError(at, fmt::format("'{}' is no kind of numbers that is read", name.substr(0, 40)));
}

std::vector<double> vtkNumbers(std::string_view bytes, VtkNumber kind, bool isSwapped) {
  if (kind.isFloat)
    return kind.size == 4 ? numbersOf<float>(bytes, isSwapped) : numbersOf<double>(bytes, isSwapped);
  switch (kind.size) {
    case 1:
      return kind.isSigned ? numbersOf<std::int8_t>(bytes, false) : numbersOf<std::uint8_t>(bytes, false);
    case 2:
      return kind.isSigned ? numbersOf<std::int16_t>(bytes, isSwapped)
                           : numbersOf<std::uint16_t>(bytes, isSwapped);
    case 4:
      return kind.isSigned ? numbersOf<std::int32_t>(bytes, isSwapped)
                           : numbersOf<std::uint32_t>(bytes, isSwapped);
    default:
      return kind.isSigned ? numbersOf<std::int64_t>(bytes, isSwapped)
                           : numbersOf<std::uint64_t>(bytes, isSwapped);
  }
}

ForeignFrame toFrame(const VtkPoints& points, const SourceLocation& at) {
  const Arrays arrays(points, at);
  ForeignFrame frame;
  frame.position = arrays.vectors(&points.coordinates);
  frame.velocity = arrays.vectors(arrays.find(3, {"velocity", "v"}));
  frame.angularVelocity = arrays.vectors(arrays.find(3, {"omega", "angular_velocity", "angularvelocity"}));
  const std::vector<double>* radius = arrays.find(1, {"radius"});
  frame.radius = radius ? arrays.scalars(radius, 1.0) : arrays.scalars(arrays.find(1, {"diameter"}), 0.5);
  frame.species = arrays.whole(arrays.find(1, {"type", "species"}));
  frame.id = arrays.whole(arrays.find(1, {"id"}));
  if (const auto id = repeatedId(frame.id))
    throw ForeignError(at, fmt::format("the id {} stands more than once", *id));
  return frame;
}

}  // namespace bedmix
