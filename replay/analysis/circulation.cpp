// SPDX-License-Identifier: MIT
#include "replay/analysis/circulation.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

SamplingGrid fineGrid(const Scene& scene) {
  SamplingGrid grid = samplingGrid(scene);
  const double size = 2.0 * scene.particles.diameter;
  grid.columns = static_cast<int>(std::clamp(std::round(grid.width / size), 1.0, 1e3));
  grid.rows = static_cast<int>(std::clamp(std::round(grid.height / size), 1.0, 1e3));
  return grid;
}

}  // namespace

Circulation::Circulation(const AnalysisInput& input)
    : particleMass_(particleMass(input.scene)),
      particleVolume_(particleVolume(input.scene)),
      thickness_(input.scene.bed.thickness),
      fine_{fineGrid(input.scene), {}},
      coarse_{samplingGrid(input.scene), {}} {
  for (Field* field : {&fine_, &coarse_}) field->sums.resize(field->grid.cells());
}

void Circulation::accept(const Frame& frame) {
  frames_ += 1.0;
  particles_ += static_cast<double>(frame.size());
  for (Field* field : {&fine_, &coarse_})
    forParticlesInCells(frame, field->grid, [&](std::size_t cell, std::size_t i) {
      Sum& sum = field->sums[cell];
      sum.n += 1.0;
      sum.velocity +=
          Vec2{static_cast<double>(frame.velocity[i].x), static_cast<double>(frame.velocity[i].y)};
    });
}

Table Circulation::tableOf(const Field& field) const {
  Table table{{"x", "y", "particles", "u", "v", "solids_fraction"}, std::vector<Table::Column>(6)};
  const double dx = field.grid.width / field.grid.columns, dy = field.grid.height / field.grid.rows;
  for (int row = 0; row < field.grid.rows; ++row)
    for (int column = 0; column < field.grid.columns; ++column) {
      const Sum& s = field.sums[static_cast<std::size_t>(row) * field.grid.columns + column];
      const auto mean = [&](double sum) { return s.n > 0.0 ? std::optional(sum / s.n) : std::nullopt; };
      const double particles = s.n / std::max(frames_, 1.0);
      table.append({dx * (column + 0.5), dy * (row + 0.5), particles, mean(s.velocity.x), mean(s.velocity.y),
                    particles * particleVolume_ / (dx * dy * thickness_)});
    }
  return table;
}

std::vector<NamedTable> Circulation::tables() const {
  return {{"circulation", tableOf(fine_)}, {"circulation_cells", tableOf(coarse_)}};
}

std::vector<FoundNumber> Circulation::findings() const {
  const double dy = fine_.grid.height / fine_.grid.rows;
  double least = 0.0, most = 0.0;  // of the stream function, kg/s
  for (int row = 0; row < fine_.grid.rows; ++row) {
    double psi = 0.0;
    for (int column = 0; column < fine_.grid.columns; ++column) {
      const Sum& s = fine_.sums[static_cast<std::size_t>(row) * fine_.grid.columns + column];
      psi += particleMass_ * s.velocity.y / (std::max(frames_, 1.0) * dy);
      least = std::min(least, psi);
      most = std::max(most, psi);
    }
  }
  const double rate = most - least;
  std::optional<double> turnover;
  if (rate > 0.0) turnover = particles_ / frames_ * particleMass_ / rate;
  return {{"circulation_rate", rate, "kg/s"}, {"circulation_turnover", turnover, "s"}};
}

}  // namespace bedmix
