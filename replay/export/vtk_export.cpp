// SPDX-License-Identifier: MIT
#include "replay/export/vtk_export.h"

#include "engine/core/particle_list.h"
#include "engine/core/walls.h"
#include "replay/export/vtk_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace bedmix {

namespace {

template <class T>
std::span<const T> all(const std::vector<T>& values) {
  return values;
}

/// VTK knows three dimensions only.
std::vector<float> inSpace(const std::vector<Vec2f>& plane) {
  std::vector<float> space;
  space.reserve(3 * plane.size());
  for (const Vec2f v : plane) space.insert(space.end(), {v.x, v.y, 0.0f});
  return space;
}

std::vector<std::int32_t> counted(std::size_t size, std::int32_t from) {
  std::vector<std::int32_t> numbers(size);
  std::iota(numbers.begin(), numbers.end(), from);
  return numbers;
}

void points(VtkFile& file, const std::vector<float>& xyz) {
  file.xml("<Points>\n");
  file.array("Points", all(xyz), 3);
  file.xml("</Points>\n");
}

std::vector<float> diameters(const Frame& frame, const Scene& scene) {
  std::vector<float> values(frame.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(2.0 * radiusOf(scene, frame, i));
  return values;
}

std::string particleFile(const Frame& frame, const Scene& scene) {
  VtkFile file("PolyData");
  file.xml(">\n");
  file.time(frame.time);
  file.xml(fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\">\n", frame.size()));
  points(file, inSpace(frame.position));
  file.xml("<Verts>\n");  // without, points are not drawn
  file.array("connectivity", all(counted(frame.size(), 0)));
  file.array("offsets", all(counted(frame.size(), 1)));
  file.xml("</Verts>\n<PointData Scalars=\"species\" Vectors=\"velocity\">\n");
  file.array("velocity", all(inSpace(frame.velocity)), 3);
  if (!frame.angularVelocity.empty()) file.array("angular_velocity", all(frame.angularVelocity));
  if (!frame.temperature.empty()) file.array("temperature", all(frame.temperature));
  if (!frame.content.empty()) file.array("content", all(frame.content));
  file.array("species", all(frame.species));
  file.array("id", all(frame.id));
  file.array("diameter", all(diameters(frame, scene)));
  if (!frame.kind.empty()) file.array("kind", all(frame.kind));
  file.xml("</PointData>\n</Piece>\n");
  return file.bytes();
}

/// What tells VTK to leave out the cells that hold no gas: its flag HIDDENCELL.
std::vector<std::uint8_t> hiddenCells(const GasGrid& grid) {
  constexpr std::uint8_t hidden = 32;
  std::vector<std::uint8_t> flags(grid.cells());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      if (!grid.open(column, row)) flags[grid.cell(column, row)] = hidden;
  return flags;
}

std::string gasFile(const Frame& frame, const GasGrid& grid) {
  const std::string extent = fmt::format("0 {} 0 {} 0 0", grid.columns, grid.rows);
  VtkFile file("RectilinearGrid");
  file.xml(fmt::format(" WholeExtent=\"{}\">\n", extent));
  file.time(frame.time);
  file.xml(fmt::format("<Piece Extent=\"{}\">\n<Coordinates>\n", extent));
  file.array("x", all(grid.x));
  file.array("y", all(grid.y));
  file.array("z", std::span<const double>(std::array{0.0}));
  file.xml("</Coordinates>\n<CellData Scalars=\"voidage\" Vectors=\"gas_velocity\">\n");
  file.array("voidage", all(frame.gas.voidage));
  file.array("pressure", all(frame.gas.pressure));
  file.array("gas_velocity", all(inSpace(frame.gas.velocity)), 3);
  if (!frame.gas.temperature.empty()) file.array("temperature", all(frame.gas.temperature));
  file.array("vtkGhostType", all(hiddenCells(grid)));
  file.xml("</CellData>\n</Piece>\n");
  return file.bytes();
}

/// A circle as chords, a plate as its middle.
void addOutline(std::vector<WallSegment>& lines, const WallSegment& wall) {
  constexpr int chords = 64;
  if (!isCircle(wall)) return lines.push_back({wall.a, wall.b});
  const auto at = [&](int k) {
    const double angle = 2.0 * std::numbers::pi * k / chords;
    return wall.a + wall.radius * Vec2{std::cos(angle), std::sin(angle)};
  };
  for (int k = 0; k < chords; ++k) lines.push_back({at(k), at(k + 1)});
}

/// Lines, those of an open bed up to its height.
std::string wallFile(const Scene& scene) {
  std::vector<WallSegment> walls = bedWalls(scene);
  for (const WallSegment& wall : obstacleWalls(scene)) addOutline(walls, wall);
  std::vector<float> xyz;
  std::vector<std::int32_t> ends;
  for (const WallSegment& wall : walls) {
    for (const Vec2 end : {wall.a, wall.b})
      xyz.insert(xyz.end(),
                 {static_cast<float>(end.x), static_cast<float>(std::min(end.y, scene.bed.height)), 0.0f});
    ends.push_back(static_cast<std::int32_t>(xyz.size() / 3));
  }
  VtkFile file("PolyData");
  file.xml(
      fmt::format(">\n<Piece NumberOfPoints=\"{}\" NumberOfLines=\"{}\">\n", 2 * walls.size(), walls.size()));
  points(file, xyz);
  file.xml("<Lines>\n");
  file.array("connectivity", all(counted(2 * walls.size(), 0)));
  file.array("offsets", all(ends));
  file.xml("</Lines>\n</Piece>\n");
  return file.bytes();
}

Result<GrowingFile> openList(const std::filesystem::path& path) {
  return GrowingFile::create(path,
                             "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n"
                             "<Collection>\n",
                             "</Collection>\n</VTKFile>\n");
}

}  // namespace

Result<std::unique_ptr<Export>> VtkExport::open(const ExportInput& input) {
  auto particles = openList(input.folder / "particles.pvd");
  if (!particles) return std::move(particles.problems);
  std::unique_ptr<VtkExport> made(new VtkExport(input, std::move(*particles)));
  if (input.scene.gas) {
    auto gas = openList(input.folder / "gas.pvd");
    if (!gas) return std::move(gas.problems);
    made->gas_.emplace(std::move(*gas));
    made->grid_ = makeGasGrid(input.scene);
  }
  if (auto problem = writeNewFile(input.folder / "walls.vtp", wallFile(input.scene))) return *problem;
  return std::unique_ptr<Export>(std::move(made));
}

VtkExport::VtkExport(const ExportInput& input, GrowingFile particles)
    : folder_(input.folder),
      selected_(input.selected),
      scene_(input.scene),
      particles_(std::move(particles)) {}

std::vector<std::filesystem::path> VtkExport::files() const {
  std::vector<std::filesystem::path> list{particles_.path()};
  if (gas_) list.push_back(gas_->path());
  list.push_back(folder_ / "walls.vtp");
  return list;
}

std::optional<Diagnostic> VtkExport::add(GrowingFile& list, const std::string& name, double time,
                                         const std::string& bytes) {
  if (auto problem = writeNewFile(folder_ / name, bytes)) return problem;
  return list.append(fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", time, name));
}

std::optional<Diagnostic> VtkExport::write(const Frame& frame) {
  const std::size_t index = selected_[next_++];
  if (auto problem =
          add(particles_, fmt::format("particles_{:06}.vtp", index), frame.time, particleFile(frame, scene_)))
    return problem;
  if (!gas_) return std::nullopt;
  return add(*gas_, fmt::format("gas_{:06}.vtr", index), frame.time, gasFile(frame, *grid_));
}

}  // namespace bedmix
