// SPDX-License-Identifier: MIT
#include "render/draw_streamlines.h"

#include "engine/core/gas_grid.h"
#include "render/shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bedmix {

namespace {

/// The gas velocity anywhere in the open cells.
class Field {
 public:
  Field(const GasGrid& grid, const std::vector<Vec2f>& velocity) : grid_(grid), velocity_(velocity) {
    for (const Vec2f& v : velocity) fastest_ = std::max(fastest_, static_cast<double>(norm(v)));
  }

  /// Unit vector along the flow at `p`, m; none outside the open cells and where the gas stands still.
  std::optional<Vec2> direction(Vec2 p) const {
    const int column = stretch(grid_.x, p.x), row = stretch(grid_.y, p.y);
    if (column < 0 || row < 0 || !grid_.open(column, row)) return std::nullopt;
    const Share x = shareOf(grid_.x, column, p.x), y = shareOf(grid_.y, row, p.y);
    Vec2 sum;
    double weights = 0.0;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const int c = x.first + i, r = y.first + j;
        const double weight = (i ? x.second : 1.0 - x.second) * (j ? y.second : 1.0 - y.second);
        if (!(weight > 0.0) || !grid_.open(c, r)) continue;
        const Vec2f v = velocity_[grid_.cell(c, r)];
        sum += Vec2{static_cast<double>(v.x), static_cast<double>(v.y)} * weight;
        weights += weight;
      }
    const double speed = norm(sum);
    if (!(speed > 1e-3 * fastest_ * weights)) return std::nullopt;
    return sum * (1.0 / speed);
  }

 private:
  struct Share {
    int first = 0;        // of two neighbouring stretches
    double second = 0.0;  // weight of the next one
  };

  static int stretch(const std::vector<double>& faces, double at) {
    if (!(at >= faces.front() && at <= faces.back())) return -1;
    const auto above = std::upper_bound(faces.begin() + 1, faces.end() - 1, at);
    return static_cast<int>(above - faces.begin()) - 1;
  }
  static double middle(const std::vector<double>& faces, int i) {
    return 0.5 * (faces[static_cast<std::size_t>(i)] + faces[static_cast<std::size_t>(i) + 1]);
  }
  static Share shareOf(const std::vector<double>& faces, int own, double at) {
    const int first = at < middle(faces, own) ? own - 1 : own;
    if (first < 0 || first + 2 >= static_cast<int>(faces.size())) return {own, 0.0};
    const double from = middle(faces, first), to = middle(faces, first + 1);
    return {first, (at - from) / (to - from)};
  }

  const GasGrid& grid_;
  const std::vector<Vec2f>& velocity_;
  double fastest_ = 0.0;  // m/s
};

/// Points of the lines so far, in square cells as large as the spacing.
class Neighbours {
 public:
  Neighbours(double width, double height, double spacing)
      : spacing_(spacing),
        columns_(static_cast<int>(width / spacing) + 1),
        rows_(static_cast<int>(height / spacing) + 1),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  void add(Vec2 p) { cells_[cell(column(p), row(p))].push_back(p); }
  bool isNear(Vec2 p, double distance) const {
    for (int r = std::max(0, row(p) - 1); r <= std::min(rows_ - 1, row(p) + 1); ++r)
      for (int c = std::max(0, column(p) - 1); c <= std::min(columns_ - 1, column(p) + 1); ++c)
        for (const Vec2& other : cells_[cell(c, r)])
          if (norm(other - p) < distance) return true;
    return false;
  }

 private:
  int column(Vec2 p) const { return std::clamp(static_cast<int>(p.x / spacing_), 0, columns_ - 1); }
  int row(Vec2 p) const { return std::clamp(static_cast<int>(p.y / spacing_), 0, rows_ - 1); }
  std::size_t cell(int c, int r) const {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
  }

  double spacing_;
  int columns_, rows_;
  std::vector<std::vector<Vec2>> cells_;
};

constexpr double stepShare = 0.1;  // of the spacing
constexpr double closest = 0.5;    // of the spacing, where a line ends beside another
constexpr double shortest = 1.5;   // of the spacing, of a line that is kept
constexpr std::size_t mostSteps = 5000;

/// The way from `seed` (not included) down or up the flow by the midpoint rule.
std::vector<Vec2> follow(const Field& field, const Neighbours& others, Vec2 seed, double step,
                         double spacing) {
  std::vector<Vec2> points;
  Vec2 p = seed;
  while (points.size() < mostSteps) {
    const auto here = field.direction(p);
    const auto half = here ? field.direction(p + *here * (0.5 * step)) : std::nullopt;
    if (!half) break;
    const Vec2 next = p + *half * step;
    if (!field.direction(next) || others.isNear(next, closest * spacing)) break;
    // A line that has come round to its beginning.
    if (points.size() > 20 && norm(next - seed) < 0.9 * std::abs(step)) break;
    points.push_back(p = next);
  }
  return points;
}

}  // namespace

std::vector<std::vector<Vec2>> gasStreamlines(const Frame& frame, const Scene& scene) {
  const GasGrid grid = makeGasGrid(scene);
  const Field field(grid, frame.gas.velocity);
  const double width = grid.x.back(), height = grid.y.back();
  const double spacing = std::max(width / grid.columns, 0.01 * std::max(width, height));
  const double step = stepShare * spacing;
  Neighbours drawn(width, height, spacing);
  std::vector<std::vector<Vec2>> lines;
  const int columns = static_cast<int>(std::ceil(width / spacing - 1e-9));
  const int rows = static_cast<int>(std::ceil(height / spacing - 1e-9));
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const Vec2 seed{(c + 0.5) * width / columns, (r + 0.5) * height / rows};
      if (!field.direction(seed) || drawn.isNear(seed, 0.9 * spacing)) continue;
      std::vector<Vec2> line = follow(field, drawn, seed, -step, spacing);
      std::reverse(line.begin(), line.end());
      line.push_back(seed);
      const std::vector<Vec2> down = follow(field, drawn, seed, step, spacing);
      line.insert(line.end(), down.begin(), down.end());
      if (static_cast<double>(line.size() - 1) * stepShare < shortest) continue;
      for (const Vec2& p : line) drawn.add(p);
      lines.push_back(std::move(line));
    }
  return lines;
}

float streamlineWidth(float em) { return std::max(1.0f, 0.09f * em); }

void drawStreamlines(DrawList& list, const BedView& view) {
  const float width = streamlineWidth(view.em), head = std::max(4.0f, 0.5f * view.em);
  const std::size_t first = list.lines.size();
  for (const std::vector<Vec2>& line : gasStreamlines(view.frame, view.scene)) {
    Vec2f from = view.camera.toPixel(line.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec2f to = view.camera.toPixel(line[i]);
      list.lines.push_back({from, to, width, 0.0f, view.palette.gas});
      if (i == line.size() / 2) {
        const Vec2f along = (to - from) * (1.0f / norm(to - from));
        list.lines.push_back({to - along * head, to, width, head, view.palette.gas});
      }
      from = to;
    }
  }
  addRims(list, first, 0.06f * view.em, view.palette.ground);
}

}  // namespace bedmix
