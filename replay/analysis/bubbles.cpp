// SPDX-License-Identifier: MIT
#include "replay/analysis/bubbles.h"

#include "engine/core/bed_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {

namespace {

constexpr int none = -1;
/// Cells of the smallest bubble that counts: smaller ones flicker rather than move from cell to cell.
constexpr std::size_t fewestCells = 4;

/// Superficial velocity of all inlets over the whole width, m/s.
double superficialVelocity(const Scene& scene) {
  double flow = 0.0;
  for (const Inlet& inlet : scene.gas->inlets) flow += inletVelocity(scene, inlet) * (inlet.to - inlet.from);
  return flow / scene.bed.width;
}

}  // namespace

Bubbles::Bubbles(const AnalysisInput& input)
    : scene_(input.scene),
      grid_(makeGasGrid(input.scene)),
      level_(input.scene.pictures.value_or(PictureSettings{}).bubbleVoidage),
      excess_(std::max(0.0, superficialVelocity(input.scene) - minimumFluidizationVelocity(input.scene))),
      spacing_(3.0 * input.scene.particles.diameter),
      stretches_(static_cast<std::size_t>(std::clamp(input.scene.bed.height / spacing_, 1.0, 1e4))),
      table_{{"time", "x", "y", "diameter", "rise"}, std::vector<Table::Column>(5)} {}

std::size_t Bubbles::stretchAt(double height) const {
  return static_cast<std::size_t>(
      std::clamp(height / spacing_, 0.0, static_cast<double>(stretches_.size() - 1)));
}

std::vector<Bubbles::Bubble> Bubbles::find(const Frame& frame) const {
  const auto empty = [&](int column, int row) {
    return grid_.open(column, row) &&
           static_cast<double>(frame.gas.voidage[grid_.cell(column, row)]) > level_;
  };
  // Columns are counted on beyond periodic sides.
  const auto inGrid = [&](int column) {
    return grid_.repeats ? (column % grid_.columns + grid_.columns) % grid_.columns : column;
  };
  const double width = scene_.bed.width;
  const double surface = bedHeight(frame, scene_);
  std::vector<bool> seen(grid_.cells());
  std::vector<Bubble> found;
  // From the outlet downward, so that what is connected with it goes first.
  for (int top = grid_.rows - 1; top >= 0; --top)
    for (int left = 0; left < grid_.columns; ++left) {
      if (seen[grid_.cell(left, top)] || !empty(left, top)) continue;
      Bubble bubble;
      std::vector<std::pair<int, int>> open{{left, top}};
      seen[grid_.cell(left, top)] = true;
      while (!open.empty()) {
        const auto [place, row] = open.back();
        open.pop_back();
        const int column = inGrid(place);
        const double beyond = static_cast<double>((place - column) / grid_.columns) * width;
        const double area = grid_.dx(column) * grid_.dy(row);
        bubble.cells.push_back(grid_.cell(column, row));
        bubble.area += area;
        bubble.centroid +=
            Vec2{grid_.x[column] + grid_.x[column + 1] + 2.0 * beyond, grid_.y[row] + grid_.y[row + 1]} *
            (0.5 * area);
        for (const auto& [next, r] : {std::pair{place - 1, row}, std::pair{place + 1, row},
                                      std::pair{place, row - 1}, std::pair{place, row + 1}}) {
          const int c = inGrid(next);
          if (c < 0 || r < 0 || c >= grid_.columns || r >= grid_.rows) continue;
          if (seen[grid_.cell(c, r)] || !empty(c, r)) continue;
          seen[grid_.cell(c, r)] = true;
          open.push_back({next, r});
        }
      }
      bubble.centroid *= 1.0 / bubble.area;
      if (grid_.repeats) bubble.centroid.x -= width * std::floor(bubble.centroid.x / width);
      const double height = bubble.centroid.y - floorHeight(scene_, bubble.centroid.x);
      if (top + 1 < grid_.rows && height < surface && bubble.cells.size() >= fewestCells)
        found.push_back(std::move(bubble));
    }
  return found;
}

std::vector<const Bubbles::Bubble*> Bubbles::follow(const std::vector<Bubble>& now) const {
  std::vector<int> owner(grid_.cells(), none);
  for (std::size_t b = 0; b < previous_.size(); ++b)
    for (std::size_t cell : previous_[b].cells) owner[cell] = static_cast<int>(b);
  struct Best {
    int other = none;
    double area = 0.0;
  };
  std::vector<Best> before(now.size()), after(previous_.size());
  std::vector<double> shared(previous_.size());
  for (std::size_t b = 0; b < now.size(); ++b) {
    std::fill(shared.begin(), shared.end(), 0.0);
    for (std::size_t cell : now[b].cells) {
      const int column = static_cast<int>(cell) % grid_.columns, row = static_cast<int>(cell) / grid_.columns;
      if (owner[cell] != none)
        shared[static_cast<std::size_t>(owner[cell])] += grid_.dx(column) * grid_.dy(row);
    }
    for (std::size_t p = 0; p < shared.size(); ++p) {
      if (shared[p] > before[b].area) before[b] = {static_cast<int>(p), shared[p]};
      if (shared[p] > after[p].area) after[p] = {static_cast<int>(b), shared[p]};
    }
  }
  std::vector<const Bubble*> was(now.size(), nullptr);
  for (std::size_t b = 0; b < now.size(); ++b) {
    const int p = before[b].other;
    if (p != none && after[static_cast<std::size_t>(p)].other == static_cast<int>(b))
      was[b] = &previous_[static_cast<std::size_t>(p)];
  }
  return was;
}

void Bubbles::accept(const Frame& frame) {
  if (frame.gas.voidage.size() != grid_.cells()) return;
  std::vector<Bubble> now = find(frame);
  const std::vector<const Bubble*> was = follow(now);
  const double interval = time_ ? frame.time - *time_ : 0.0;
  for (std::size_t b = 0; b < now.size(); ++b) {
    const Vec2 at = now[b].centroid;
    const double height = at.y - floorHeight(scene_, at.x);
    const double diameter = std::sqrt(4.0 * now[b].area / std::numbers::pi);
    Stretch& s = stretches_[stretchAt(height)];
    s.bubbles += 1.0;
    s.diameter += diameter;
    s.darton +=
        0.54 * std::pow(excess_, 0.4) * std::pow(std::max(height, 0.0), 0.8) * std::pow(scene_.gravity, -0.2);
    s.isolated += 0.711 * std::sqrt(scene_.gravity * diameter);
    std::optional<double> rise;
    if (was[b]) {
      rise = (at.y - was[b]->centroid.y) / interval;
      s.followed += 1.0;
      s.rise += *rise;
      const double from = was[b]->centroid.y - floorHeight(scene_, was[b]->centroid.x);
      for (std::size_t i = stretchAt(from); i <= stretchAt(height); ++i) {
        const double middle = (static_cast<double>(i) + 0.5) * spacing_;
        if (from < middle && height >= middle) stretches_[i].passed += 1.0;
      }
    }
    table_.append({frame.time, at.x, at.y, diameter, rise});
  }
  previous_ = std::move(now);
  time_ = frame.time;
  duration_ += interval;
  frames_ += 1.0;
}

Table Bubbles::profile() const {
  Table table{{"height", "bubbles", "diameter", "rise", "frequency", "diameter_darton", "rise_isolated",
               "rise_davidson"},
              std::vector<Table::Column>(8)};
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    const Stretch& s = stretches_[i];
    const auto mean = [](double sum, double n) { return n > 0.0 ? std::optional(sum / n) : std::nullopt; };
    table.append({(static_cast<double>(i) + 0.5) * spacing_, mean(s.bubbles, frames_),
                  mean(s.diameter, s.bubbles), mean(s.rise, s.followed), mean(s.passed, duration_),
                  mean(s.darton, s.bubbles), mean(s.isolated, s.bubbles),
                  mean(s.isolated + s.bubbles * excess_, s.bubbles)});
  }
  return table;
}

std::vector<FoundNumber> Bubbles::findings() const {
  Stretch all;
  for (const Stretch& s : stretches_) {
    all.bubbles += s.bubbles;
    all.diameter += s.diameter;
    all.followed += s.followed;
    all.rise += s.rise;
    all.passed = std::max(all.passed, s.passed);
    all.darton += s.darton;
    all.isolated += s.isolated;
  }
  const auto mean = [](double sum, double n) { return n > 0.0 ? std::optional(sum / n) : std::nullopt; };
  return {{"bubbles", mean(all.bubbles, frames_), ""},
          {"bubble_diameter", mean(all.diameter, all.bubbles), "m"},
          {"bubble_diameter_darton", mean(all.darton, all.bubbles), "m"},
          {"bubble_rise", mean(all.rise, all.followed), "m/s"},
          {"bubble_rise_isolated", mean(all.isolated, all.bubbles), "m/s"},
          {"bubble_rise_davidson", mean(all.isolated + all.bubbles * excess_, all.bubbles), "m/s"},
          {"bubble_frequency", mean(all.passed, duration_), "1/s"}};
}

}  // namespace bedmix
