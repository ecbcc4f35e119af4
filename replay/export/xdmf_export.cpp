// SPDX-License-Identifier: MIT
#include "replay/export/xdmf_export.h"

#include "engine/core/gas_grid.h"
#include "engine/core/particle_list.h"
#include "replay/trajectory_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace bedmix {

namespace {

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      default:
        xml += c;
    }
  return xml;
}

std::string words(const std::vector<std::size_t>& numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

/// A frame in the trajectory.
struct Place {
  std::string file;  // as XML
  std::size_t frame, frames;

  /// A dataset that does not change with time.
  std::string fixed(const char* path, const char* type, std::size_t size) const {
    return fmt::format("<DataItem Format=\"HDF\" {} Dimensions=\"{}\">{}:/{}</DataItem>\n", type, size, file,
                       path);
  }
  /// The frame's row, of these extents, of a series of floats.
  std::string row(const char* path, const std::vector<std::size_t>& extent) const {
    std::vector<std::size_t> start(extent.size() + 1, 0), stride(start.size(), 1), count(start.size(), 1);
    start[0] = frame;
    std::copy(extent.begin(), extent.end(), count.begin() + 1);
    std::vector<std::size_t> whole = count;
    whole[0] = frames;
    return fmt::format(
        "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{}\">"
        "<DataItem Format=\"XML\" Dimensions=\"3 {}\">{} {} {}</DataItem>"
        "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"4\" "
        "Dimensions=\"{}\">{}:/{}/value</DataItem>"
        "</DataItem>\n",
        words(extent), whole.size(), words(start), words(stride), words(count), words(whole), file, path);
  }
};

std::string attribute(const char* name, const char* kind, const char* center, const std::string& data) {
  return fmt::format("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">\n{}</Attribute>\n", name,
                     kind, center, data);
}

std::string particleGrid(const Place& at, const Scene& scene, double time) {
  const auto n = static_cast<std::size_t>(scene.particles.count);
  std::string xml = fmt::format(
      "<Grid Name=\"particles\">\n<Time Value=\"{}\"/>\n"
      "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\"/>\n"
      "<Geometry GeometryType=\"XY\">\n{}</Geometry>\n",
      time, n, at.row(layout::position, {n, 2}));
  xml += attribute("velocity", "Vector", "Node", at.row(layout::velocity, {n, 2}));
  if (scene.contacts.friction)
    xml += attribute("angular_velocity", "Scalar", "Node", at.row(layout::angularVelocity, {n}));
  if (scene.effects.find<HeatSettings>())
    xml += attribute("temperature", "Scalar", "Node", at.row(layout::temperature, {n}));
  if (scene.effects.find<ReactionSettings>())
    xml += attribute("content", "Scalar", "Node", at.row(layout::content, {n}));
  xml += attribute("species", "Scalar", "Node",
                   at.fixed(layout::species, "NumberType=\"UChar\" Precision=\"1\"", n));
  xml += attribute("id", "Scalar", "Node", at.fixed(layout::id, "NumberType=\"Int\" Precision=\"4\"", n));
  if (isMixed(scene)) {
    xml += attribute("radius", "Scalar", "Node",
                     at.fixed(layout::radius, "NumberType=\"Float\" Precision=\"4\"", n));
    xml += attribute("kind", "Scalar", "Node",
                     at.fixed(layout::kind, "NumberType=\"UChar\" Precision=\"1\"", n));
  }
  return xml + "</Grid>\n";
}

std::string gasGrid(const Place& at, const Scene& scene, const GasGrid& grid, double time) {
  const auto rows = static_cast<std::size_t>(grid.rows), columns = static_cast<std::size_t>(grid.columns);
  const char* const face = "NumberType=\"Float\" Precision=\"8\"";
  std::string xml = fmt::format(
      "<Grid Name=\"gas\">\n<Time Value=\"{}\"/>\n<Topology TopologyType=\"2DRectMesh\" Dimensions=\"{} "
      "{}\"/>\n"
      "<Geometry GeometryType=\"VXVY\">\n{}{}</Geometry>\n",
      time, rows + 1, columns + 1, at.fixed(layout::gasX, face, columns + 1),
      at.fixed(layout::gasY, face, rows + 1));
  xml += attribute("voidage", "Scalar", "Cell", at.row(layout::voidage, {rows, columns}));
  xml += attribute("pressure", "Scalar", "Cell", at.row(layout::pressure, {rows, columns}));
  xml += attribute("gas_velocity", "Vector", "Cell", at.row(layout::gasVelocity, {rows, columns, 2}));
  if (scene.effects.find<HeatSettings>())
    xml += attribute("temperature", "Scalar", "Cell", at.row(layout::gasTemperature, {rows, columns}));
  return xml + "</Grid>\n";
}

Result<GrowingFile> openCollection(const std::filesystem::path& path) {
  return GrowingFile::create(path,
                             "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.2\">\n<Domain>\n"
                             "<Grid GridType=\"Collection\" CollectionType=\"Temporal\">\n",
                             "</Grid>\n</Domain>\n</Xdmf>\n");
}

}  // namespace

Result<std::unique_ptr<Export>> XdmfExport::open(const ExportInput& input) {
  if (input.isForeign)
    return Diagnostic{{input.trajectory.string()},
                      "is another program's file, and XDMF points into trajectories of bedmix; take vtk"};
  if (input.scene.effects.find<FeedSettings>())
    return Diagnostic{{input.trajectory.string()},
                      "has particles that come and go, which XDMF cannot leave out; take vtk"};
  auto particles = openCollection(input.folder / "particles.xmf");
  if (!particles) return std::move(particles.problems);
  std::unique_ptr<XdmfExport> made(new XdmfExport(input, std::move(*particles)));
  if (input.scene.gas) {
    auto gas = openCollection(input.folder / "gas.xmf");
    if (!gas) return std::move(gas.problems);
    made->gas_.emplace(std::move(*gas));
  }
  return std::unique_ptr<Export>(std::move(made));
}

XdmfExport::XdmfExport(const ExportInput& input, GrowingFile particles)
    : input_(input),
      file_(escaped(std::filesystem::proximate(input.trajectory, input.folder).string())),
      particles_(std::move(particles)) {}

std::vector<std::filesystem::path> XdmfExport::files() const {
  std::vector<std::filesystem::path> list{particles_.path()};
  if (gas_) list.push_back(gas_->path());
  return list;
}

std::optional<Diagnostic> XdmfExport::write(const Frame& frame) {
  const Place at{file_, input_.selected[next_++], input_.recorded};
  if (auto problem = particles_.append(particleGrid(at, input_.scene, frame.time))) return problem;
  if (!gas_) return std::nullopt;
  return gas_->append(gasGrid(at, input_.scene, makeGasGrid(input_.scene), frame.time));
}

}  // namespace bedmix
