// SPDX-License-Identifier: MIT
#include "replay/analysis/mechanisms.h"

#include "replay/analysis/by_id.h"

#include <algorithm>
#include <utility>

namespace bedmix {

namespace {

Vec2 times(Vec2 a, Vec2 b) { return {a.x * b.x, a.y * b.y}; }

/// The linear field of displacements of a cell.
struct CellField {
  int n = 0;
  Vec2 centroid{}, mean{};
  double xx = 0.0, xy = 0.0, yy = 0.0;  // moments of places about the centroid
  Vec2 xu{}, yu{};                      // and of places and displacements
  Vec2 alongX{}, alongY{};              // gradient

  void solve() {
    const double determinant = xx * yy - xy * xy, trace = xx + yy;
    if (!(determinant > 1e-9 * trace * trace)) return;  // on one line: no gradient can be told
    alongX = (yy * xu - xy * yu) * (1.0 / determinant);
    alongY = (xx * yu - xy * xu) * (1.0 / determinant);
  }
};

}  // namespace

Mechanisms::Mechanisms(const AnalysisInput& input)
    : grid_(samplingGrid(input.scene)),
      period_(input.scene),
      width_(input.scene.bed.width),
      table_{{"time", "total", "convective", "shear", "diffusive", "counted_fraction"},
             std::vector<Table::Column>(6)} {}

void Mechanisms::accept(const Frame& frame) {
  if (started_) sum(split(frame));
  started_ = true;
  previous_.time = frame.time;
  previous_.position = frame.position;
  previous_.id = frame.id;
}

Mechanisms::Moves Mechanisms::split(const Frame& frame) {
  std::vector<std::int32_t> cellOfRow(previous_.size(), -1);
  forParticlesInCells(previous_, grid_, [&](std::size_t cell, std::size_t i) {
    cellOfRow[i] = static_cast<std::int32_t>(cell);
  });
  struct Mover {
    CellField* cell;  // null outside the grid
    Vec2 from, by;
  };
  std::vector<CellField> cells(grid_.cells());
  std::vector<Mover> movers;
  movers.reserve(previous_.size());
  Moves moves;
  moves.duration = frame.time - previous_.time;
  moves.id.reserve(previous_.size());
  forParticlesInBoth(previous_.id, frame.id, [&](std::size_t i, std::size_t j) {
    CellField* cell = cellOfRow[i] < 0 ? nullptr : &cells[static_cast<std::size_t>(cellOfRow[i])];
    const Vec2 from = toDouble(previous_.position[i]),
               by = period_.nearest(toDouble(frame.position[j]) - from);
    movers.push_back({cell, from, by});
    moves.id.push_back(previous_.id[i]);
    if (!cell) return;
    ++cell->n;
    cell->centroid += from;
    cell->mean += by;
  });
  for (CellField& c : cells) {
    c.centroid *= 1.0 / std::max(c.n, 1);
    c.mean *= 1.0 / std::max(c.n, 1);
  }
  for (const Mover& m : movers) {
    if (!m.cell) continue;
    const Vec2 r = m.from - m.cell->centroid, u = m.by - m.cell->mean;
    m.cell->xx += r.x * r.x;
    m.cell->xy += r.x * r.y;
    m.cell->yy += r.y * r.y;
    m.cell->xu += r.x * u;
    m.cell->yu += r.y * u;
  }
  for (CellField& c : cells) c.solve();

  std::array<double, 3> squares{};
  double total = 0.0;
  int counted = 0;
  moves.parts.reserve(movers.size());
  for (const Mover& m : movers) {
    Parts& parts = moves.parts.emplace_back();
    if (!m.cell || m.cell->n < grid_.minParticles) {
      parts[dilute] = m.by;
      continue;
    }
    const Vec2 r = m.from - m.cell->centroid;
    parts[convective] = m.cell->mean;
    parts[shear] = r.x * m.cell->alongX + r.y * m.cell->alongY;
    parts[diffusive] = m.by - parts[convective] - parts[shear];
    for (std::size_t p = 0; p < squares.size(); ++p) squares[p] += dot(parts[p], parts[p]);
    total += dot(m.by, m.by);
    ++counted;
  }
  const double scale = 1.0 / (moves.duration * moves.duration * counted);
  const auto mean = [&](double sum) { return counted > 0 ? std::optional(sum * scale) : std::nullopt; };
  table_.append(
      {frame.time, mean(total), mean(squares[convective]), mean(squares[shear]), mean(squares[diffusive]),
       frame.size() > 0 ? std::optional(counted / static_cast<double>(frame.size())) : std::nullopt});
  return moves;
}

void Mechanisms::sum(Moves moves) {
  for (std::size_t k = 0;; ++k) {
    if (k == lags_.size()) lags_.emplace_back();
    Lag& lag = lags_[k];
    ++lag.windows;
    lag.duration += moves.duration;
    lag.paths += static_cast<double>(moves.parts.size());
    for (const Parts& parts : moves.parts) {
      Vec2 whole{};
      for (const Vec2& part : parts) whole += part;
      lag.square += times(whole, whole);
      for (std::size_t p = 0; p < parts.size(); ++p) lag.products[p] += times(parts[p], whole);
    }
    if (!lag.waiting) {
      lag.waiting = std::move(moves);
      return;
    }
    Moves longer;
    longer.duration = lag.waiting->duration + moves.duration;
    longer.id.reserve(moves.id.size());
    longer.parts.reserve(moves.parts.size());
    forParticlesInBoth(lag.waiting->id, moves.id, [&](std::size_t i, std::size_t j) {
      longer.id.push_back(moves.id[j]);
      Parts& parts = longer.parts.emplace_back(lag.waiting->parts[i]);
      for (std::size_t p = 0; p < parts.size(); ++p) parts[p] += moves.parts[j][p];
    });
    lag.waiting.reset();
    moves = std::move(longer);
  }
}

Table Mechanisms::lagTable() const {
  Table table{{"lag", "msd_x", "convective_x", "shear_x", "diffusive_x", "dilute_x", "msd_y", "convective_y",
               "shear_y", "diffusive_y", "dilute_y"},
              std::vector<Table::Column>(11)};
  for (const Lag& lag : lags_) {
    if (lag.windows < 4 || lag.paths == 0.0) break;  // of fewer there is no mean
    std::vector<std::optional<double>> row{lag.duration / lag.windows};
    for (double Vec2::*axis : {&Vec2::x, &Vec2::y}) {
      row.push_back(lag.square.*axis / lag.paths);
      for (const Vec2& product : lag.products) row.push_back(product.*axis / lag.paths);
    }
    table.append(row);
  }
  return table;
}

std::vector<NamedTable> Mechanisms::tables() const {
  return {{"mechanisms", table_}, {"mechanisms_lag", lagTable()}};
}

std::vector<FoundNumber> Mechanisms::findings() const {
  std::vector<FoundNumber> found;
  const auto ratio = [](std::optional<double> part, std::optional<double> of) {
    return part && of && *of > 0.0 ? std::optional(*part / *of) : std::nullopt;
  };
  constexpr std::array names{"convective", "shear", "diffusive", "dilute"};
  for (std::size_t p = 0; p < 3; ++p)
    found.push_back({std::string("motion_") + names[p],
                     ratio(meanOf(table_.columns[2 + p]), meanOf(table_.columns[1])), ""});
  // Where the particles have gone a quarter of the bed's width: far enough to mix, not yet held up by walls.
  const Table lags = lagTable();
  std::optional<std::size_t> row;
  for (std::size_t r = 0; r < lags.rows(); ++r) {
    row = r;
    if (*lags.columns[1][r] >= width_ * width_ / 16.0) break;
  }
  found.push_back({"mixing_lag", row ? lags.columns[0][*row] : std::nullopt, "s"});
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t p = 0; p < 4; ++p) {
      const std::size_t msd = 1 + 5 * axis;
      found.push_back({std::string("mixing_") + names[p] + (axis == 0 ? "_x" : "_y"),
                       row ? ratio(lags.columns[msd + 1 + p][*row], lags.columns[msd][*row]) : std::nullopt,
                       ""});
    }
  return found;
}

}  // namespace bedmix
