// SPDX-License-Identifier: MIT
#include "replay/foreign/h5md_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <unordered_set>

namespace bedmix {

namespace {

/// Where the values of an element stand: it is a group where it changes with time.
std::string valuesOf(const Hdf5Input& in, const std::string& element) {
  return in.isGroup(element) ? element + "/value" : element;
}

/// The `step` or `time` of an element for so many frames: all of them or, where they are equally far apart,
/// the distance and an offset. Fewer where the file has fewer; empty where it has none.
template <class T>
std::vector<T> readAxis(const Hdf5Input& in, const std::string& path, hsize_t frames) {
  if (!in.has(path)) return {};
  if (in.extent(path).empty()) {
    T distance{};
    in.fixed(path, {}).readRow(0, &distance);
    const T offset = in.number<T>(path, "offset").value_or(T{});
    constexpr double most = 9e18;
    const double last = std::abs(static_cast<double>(offset)) +
                        std::abs(static_cast<double>(distance)) * static_cast<double>(frames);
    if (std::is_integral_v<T> && last > most) throw Hdf5Error(path + " counts further than 64 bits do");
    std::vector<T> axis(frames);
    for (std::size_t i = 0; i < frames; ++i) axis[i] = offset + static_cast<T>(i) * distance;
    return axis;
  }
  const Hdf5Values values = in.series(path, {});
  std::vector<T> axis(std::min(frames, values.rows()));
  if (!axis.empty()) values.readRows(axis.size(), axis.data());
  return axis;
}

template <class T>
void requireIncreasing(const std::vector<T>& axis, const std::string& what) {
  for (std::size_t i = 0; i < axis.size(); ++i) {
    if (!std::isfinite(static_cast<double>(axis[i])))
      throw Hdf5Error(fmt::format("the {} of frame {} is {}, no number", what, i, axis[i]));
    if (i > 0 && !(axis[i] > axis[i - 1]))
      throw Hdf5Error(fmt::format("frame {} at {} {} does not follow frame {} at {} {}", i, what, axis[i],
                                  i - 1, what, axis[i - 1]));
  }
}

/// A length along each axis: the first ones where they change with time, the diagonal of a matrix. None where
/// there are none or the matrix is that of a slanted box.
std::optional<Vec3d> readLengths(const Hdf5Input& in, const std::string& element, std::size_t dimensions) {
  if (!in.has(element)) return std::nullopt;
  const bool isSeries = in.isGroup(element);
  const std::string path = valuesOf(in, element);
  std::vector<hsize_t> row = in.extent(path);
  if (isSeries && !row.empty()) row.erase(row.begin());
  const bool isMatrix = row == std::vector<hsize_t>(2, dimensions);
  if (!isMatrix && row != std::vector<hsize_t>(1, dimensions)) return std::nullopt;
  const Hdf5Values values = isSeries ? in.series(path, row) : in.fixed(path, row);
  if (values.rows() == 0) return std::nullopt;
  std::vector<double> numbers(values.rowSize());
  values.readRow(0, numbers.data());
  Vec3d lengths{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i])) return std::nullopt;
    if (!isMatrix)
      lengths[i] = numbers[i];
    else if (i % (dimensions + 1) == 0)
      lengths[i / (dimensions + 1)] = numbers[i];
    else if (numbers[i] != 0.0)
      return std::nullopt;
  }
  return lengths;
}

void checkVersion(const Hdf5Input& in) {
  if (!in.has("h5md")) throw Hdf5Error("is HDF5 but not H5MD: it has no group h5md");
  const std::vector<std::int32_t> version = in.integers("h5md", "version");
  if (version.empty() || version[0] != 1)
    throw Hdf5Error("is of H5MD version " + (version.empty() ? "?" : std::to_string(version[0])) +
                    "; this bedmix reads version 1");
}

}  // namespace

H5mdInput::H5mdInput(const std::filesystem::path& file, const std::string& group) : in_(file) {
  checkVersion(in_);
  groups_ = chooseGroups(group);
  addPositions();
  readAxes();
  contents_.row.hasVelocity = addReals("velocity", contents_.row.dimensions);
  addSpin();
  contents_.row.hasRadius = addReals("radius", 1) || addReals("diameter", 1, 0.5);
  addSpecies();
  addIds();
  settleFrames();
  contents_.box = readBox(groups_.front() + "/box");
}

std::vector<std::string> H5mdInput::chooseGroups(const std::string& group) const {
  const std::string all = "particles/";
  std::vector<std::string> names;
  if (in_.has("particles"))
    for (const std::string& name : in_.namesIn("particles"))
      if (in_.isGroup(all + name) && in_.has(all + name + "/position")) names.push_back(name);
  if (names.empty()) throw Hdf5Error("is H5MD but has no particles: no group particles/... with a position");
  if (!group.empty() && std::find(names.begin(), names.end(), group) == names.end())
    throw Hdf5Error(
        fmt::format("has no particles of the group \"{}\"; it has {}", group, fmt::join(names, ", ")));
  std::vector<std::string> chosen;
  for (const std::string& name : names)
    if (group.empty() || name == group) chosen.push_back(all + name);
  return chosen;
}

void H5mdInput::addPositions() {
  Column column;
  hsize_t dimensions = 0;
  for (const std::string& group : groups_) {
    const std::string path = valuesOf(in_, group + "/position");
    std::vector<hsize_t> row = in_.extent(path);
    const bool isSeries = in_.isGroup(group + "/position");
    if (isSeries && !row.empty()) row.erase(row.begin());
    if (row.size() != 2 || (row[1] != 2 && row[1] != 3))
      throw Hdf5Error(path + " does not hold places in two or three dimensions, particle by particle");
    if (dimensions != 0 && row[1] != dimensions)
      throw Hdf5Error(fmt::format("{} has {} dimensions, other groups {}; name one with --group", path,
                                  row[1], dimensions));
    dimensions = row[1];
    sizes_.push_back(row[0]);
    column.of.emplace_back(isSeries ? in_.series(path, row) : in_.fixed(path, row));
    if (column.of.back()->rows() == 0) throw Hdf5Error("holds no whole frame of " + path);
  }
  contents_.row.dimensions = static_cast<int>(dimensions);
  contents_.row.particles = std::accumulate(sizes_.begin(), sizes_.end(), std::size_t{0});
  column.components = dimensions;
  columns_.push_back(std::move(column));
}

void H5mdInput::readAxes() {
  auto& [row, steps, times, box] = contents_;
  const auto& positions = columns_.front().of;
  const auto moving =
      std::find_if(positions.begin(), positions.end(), [](const auto& p) { return p->isSeries(); });
  if (moving == positions.end()) {
    steps = {0};
    times = {0.0};
    return;
  }
  const std::string of = groups_[static_cast<std::size_t>(moving - positions.begin())] + "/position/";
  const hsize_t frames = (*moving)->rows();
  steps = readAxis<std::int64_t>(in_, of + "step", frames);
  times = readAxis<double>(in_, of + "time", frames);
  if (!in_.has(of + "step")) {
    steps.resize(in_.has(of + "time") ? times.size() : frames);
    std::iota(steps.begin(), steps.end(), 0);
  }
  if (in_.has(of + "time")) steps.resize(std::min(steps.size(), times.size()));
}

std::optional<Hdf5Values> H5mdInput::find(std::size_t group, const std::string& element,
                                          int components) const {
  const std::string path = groups_[group] + '/' + element;
  if (!in_.has(path)) return std::nullopt;
  std::vector<hsize_t> row{sizes_[group]};
  if (components > 1) row.push_back(static_cast<hsize_t>(components));
  return in_.isGroup(path) ? in_.series(path + "/value", row) : in_.fixed(path, row);
}

bool H5mdInput::allHave(const std::string& element) const {
  return std::all_of(groups_.begin(), groups_.end(),
                     [&](const std::string& group) { return in_.has(group + '/' + element); });
}

bool H5mdInput::addReals(const std::string& element, int components, double unit) {
  if (!allHave(element)) return false;
  Column column{Column::Kind::real, static_cast<std::size_t>(components), unit, {}};
  for (std::size_t g = 0; g < groups_.size(); ++g) column.of.push_back(find(g, element, components));
  columns_.push_back(std::move(column));
  return true;
}

void H5mdInput::addSpin() {
  const std::string element = "angular_velocity";
  if (!allHave(element)) return;
  const std::string path = groups_.front() + '/' + element;
  const std::size_t scalarRank = in_.isGroup(path) ? 2 : 1;
  const int components = in_.extent(valuesOf(in_, path)).size() == scalarRank ? 1 : 3;
  if (components == 1 && contents_.row.dimensions == 3) return;  // about which axis?
  addReals(element, components);
  contents_.row.spinComponents = components;
}

void H5mdInput::addSpecies() {
  if (groups_.size() == 1 && !allHave("species")) return;
  Column column{Column::Kind::species, 1, 1.0, {}};
  const bool own = allHave("species");
  for (std::size_t g = 0; g < groups_.size(); ++g)
    column.of.push_back(own ? find(g, "species", 1) : std::nullopt);
  columns_.push_back(std::move(column));
  contents_.row.hasSpecies = true;
}

void H5mdInput::addIds() {
  Column column{Column::Kind::id, 1, 1.0, {}};
  for (std::size_t g = 0; g < groups_.size(); ++g) column.of.push_back(find(g, "id", 1));
  const bool change =
      std::any_of(column.of.begin(), column.of.end(), [](const auto& e) { return e && e->isSeries(); });
  columns_.push_back(std::move(column));
  if (groups_.size() == 1) return;
  mixesIds_ = change;
  std::unordered_set<std::int64_t> seen;
  for (std::size_t g = 0; g < groups_.size() && !mixesIds_; ++g) {
    std::vector<std::int64_t> ids(sizes_[g]);
    std::iota(ids.begin(), ids.end(), 0);
    if (columns_.back().of[g] && !ids.empty()) columns_.back().of[g]->readRow(0, ids.data());
    for (const std::int64_t id : ids)
      if (id >= 0 && !seen.insert(id).second) mixesIds_ = true;
  }
}

void H5mdInput::settleFrames() {
  auto& [row, steps, times, box] = contents_;
  for (const Column& column : columns_) {
    for (const std::optional<Hdf5Values>& values : column.of) {
      if (!values || !values->isSeries()) continue;
      steps.resize(std::min(steps.size(), std::size_t{values->rows()}));
      const std::string element = values->path().substr(0, values->path().rfind('/'));
      if (!in_.has(element + "/step")) continue;
      const auto own = readAxis<std::int64_t>(in_, element + "/step", steps.size());
      steps.resize(own.size());
      if (own != steps)
        throw Hdf5Error(element +
                        " was not recorded at the steps that the position was; record both together" +
                        (groups_.size() > 1 ? ", or name one of the groups with --group" : ""));
    }
  }
  if (steps.empty()) throw Hdf5Error("holds no whole frame");
  times.resize(std::min(times.size(), steps.size()));
  requireIncreasing(steps, "step");
  requireIncreasing(times, "time");
}

std::optional<ForeignBox> H5mdInput::readBox(const std::string& path) const {
  const auto d = static_cast<std::size_t>(contents_.row.dimensions);
  const std::optional<Vec3d> edges = readLengths(in_, path + "/edges", d);
  if (!edges) return std::nullopt;
  ForeignBox box{readLengths(in_, path + "/offset", d).value_or(Vec3d{}), {}};
  for (std::size_t i = 0; i < d; ++i) {
    if (!((*edges)[i] > 0.0)) return std::nullopt;
    box.high[i] = box.low[i] + (*edges)[i];
  }
  return box;
}

void H5mdInput::read(std::size_t index, bool series, std::byte* into) const {
  for (const Column& column : columns_) {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      std::byte* const at = into;
      const std::optional<Hdf5Values>& values = column.of[g];
      const std::size_t numbers = sizes_[g] * column.components;
      into += sizeof(double) * numbers;
      if ((values && values->isSeries()) != series || numbers == 0) continue;
      if (column.kind == Column::Kind::real) {
        auto* const reals = reinterpret_cast<double*>(at);
        values->readRow(index, reals);
        if (column.unit != 1.0) std::for_each(reals, reals + numbers, [&](double& v) { v *= column.unit; });
        continue;
      }
      auto* const integers = reinterpret_cast<std::int64_t*>(at);
      if (values)
        values->readRow(index, integers);
      else if (column.kind == Column::Kind::species)
        std::fill_n(integers, numbers, static_cast<std::int64_t>(g));
      else
        std::iota(integers, integers + numbers, std::int64_t{0});
      if (column.kind != Column::Kind::id || !mixesIds_) continue;
      const auto groups = static_cast<std::int64_t>(groups_.size());
      for (std::int64_t& id : std::span(integers, numbers)) {
        if (id > std::numeric_limits<std::int64_t>::max() / groups - 1)
          throw Hdf5Error(fmt::format("{}: the id {} of frame {} is too large", groups_[g], id, index));
        if (id >= 0) id = id * groups + static_cast<std::int64_t>(g);
      }
    }
  }
}

}  // namespace bedmix
