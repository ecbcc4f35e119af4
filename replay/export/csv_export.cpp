// SPDX-License-Identifier: MIT
#include "replay/export/csv_export.h"

#include "engine/core/particle_list.h"

#include <fmt/format.h>

#include <iterator>

namespace bedmix {

namespace {

std::string particleRows(const Frame& frame) {
  std::string rows;
  const auto out = std::back_inserter(rows);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec2f at = frame.position[i], v = frame.velocity[i];
    fmt::format_to(out, "{},{},{},{},{},{},{}", frame.time, frame.id[i], frame.species[i], at.x, at.y, v.x,
                   v.y);
    if (!frame.angularVelocity.empty()) fmt::format_to(out, ",{}", frame.angularVelocity[i]);
    if (!frame.temperature.empty()) fmt::format_to(out, ",{}", frame.temperature[i]);
    if (!frame.content.empty()) fmt::format_to(out, ",{}", frame.content[i]);
    if (!frame.radius.empty()) fmt::format_to(out, ",{},{}", frame.radius[i], frame.kind[i]);
    rows += "\n";
  }
  return rows;
}

std::string gasRows(const Frame& frame, const GasGrid& grid) {
  std::string rows;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.open(column, row)) continue;
      const std::size_t cell = grid.cell(column, row);
      const auto [u, v] = frame.gas.velocity[cell];
      fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},{}", frame.time,
                     grid.x[static_cast<std::size_t>(column)] + grid.dx(column) / 2,
                     grid.y[static_cast<std::size_t>(row)] + grid.dy(row) / 2, frame.gas.voidage[cell],
                     frame.gas.pressure[cell], u, v);
      if (!frame.gas.temperature.empty())
        fmt::format_to(std::back_inserter(rows), ",{}", frame.gas.temperature[cell]);
      rows += '\n';
    }
  return rows;
}

}  // namespace

Result<std::unique_ptr<Export>> CsvExport::open(const ExportInput& input) {
  const char* const spin = input.scene.contacts.friction ? ",omega" : "";
  const bool heat = input.scene.effects.find<HeatSettings>() != nullptr;
  const char* const warm = heat ? ",temperature" : "";
  const char* const holds = input.scene.effects.find<ReactionSettings>() ? ",content" : "";
  const char* const size = isMixed(input.scene) ? ",radius,kind" : "";
  auto particles =
      GrowingFile::create(input.folder / "particles.csv",
                          fmt::format("time,id,species,x,y,vx,vy{}{}{}{}\n", spin, warm, holds, size));
  if (!particles) return std::move(particles.problems);
  std::optional<Gas> gas;
  if (input.scene.gas) {
    auto file = GrowingFile::create(
        input.folder / "gas.csv",
        fmt::format("time,x,y,voidage,pressure,gas_vx,gas_vy{}\n", heat ? ",gas_temperature" : ""));
    if (!file) return std::move(file.problems);
    gas.emplace(Gas{makeGasGrid(input.scene), std::move(*file)});
  }
  return std::unique_ptr<Export>(new CsvExport(std::move(*particles), std::move(gas)));
}

std::vector<std::filesystem::path> CsvExport::files() const {
  std::vector<std::filesystem::path> list{particles_.path()};
  if (gas_) list.push_back(gas_->file.path());
  return list;
}

std::optional<Diagnostic> CsvExport::write(const Frame& frame) {
  if (auto problem = particles_.append(particleRows(frame))) return problem;
  return gas_ ? gas_->file.append(gasRows(frame, gas_->grid)) : std::nullopt;
}

}  // namespace bedmix
