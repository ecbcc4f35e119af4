// SPDX-License-Identifier: MIT
#include "engine/core/neighbour_index.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

struct Point {
  Vec2 at;
  bool tracer = false;
  bool isImage = false;
};

/// Points by square cells over the box that holds all but the outermost hundredth on each side; those outside
/// are in the cells at its edge, so that few far away do not coarsen it.
class PointCells {
 public:
  explicit PointCells(const std::vector<Point>& points) {
    const auto [left, right] = bulk(points, &Vec2::x);
    const auto [bottom, top] = bulk(points, &Vec2::y);
    const double width = right - left, height = top - bottom, n = static_cast<double>(points.size());
    constexpr double perCell = 3.0;  // of few neighbours most are then in a cell or next to it
    size_ = std::max(std::sqrt(width * height * perCell / n), std::max(width, height) * perCell / n);
    if (!(size_ > 0.0)) size_ = 1.0;  // all at one place
    low_ = {left, bottom};
    columns_ = static_cast<int>(width / size_) + 1;
    rows_ = static_cast<int>(height / size_) + 1;

    start_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (const Point& p : points) ++start_[cellOf(p.at)];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    points_.resize(points.size());
    for (const Point& p : points) points_[--start_[cellOf(p.at)]] = p;
  }

  const std::vector<Point>& points() const { return points_; }

  /// Calls `use(point)` for those `ring` cells away from the cell of `at`, in x or in y, and not more.
  template <class Use>
  void forRing(Vec2 at, int ring, const Use& use) const {
    const int column = place(at.x - low_.x, columns_), row = place(at.y - low_.y, rows_);
    const int left = std::max(column - ring, 0), right = std::min(column + ring, columns_ - 1);
    for (int y = std::max(row - ring, 0); y <= std::min(row + ring, rows_ - 1); ++y) {
      const bool whole = std::abs(y - row) == ring;
      if (whole) {
        forCells(y, left, right, use);
      } else {
        if (column - ring >= 0) forCells(y, left, left, use);
        if (column + ring < columns_) forCells(y, right, right, use);
      }
    }
  }
  /// No point beyond the cells `rings` away is nearer.
  double reach(Vec2 at, int rings) const {
    const auto toSide = [this](double x, int n) {
      const double inside = std::clamp(x, 0.0, n * size_) - place(x, n) * size_;
      return std::max(std::min(inside, size_ - inside), 0.0);
    };
    return rings * size_ + std::min(toSide(at.x - low_.x, columns_), toSide(at.y - low_.y, rows_));
  }
  bool holdsAll(int rings) const { return rings >= std::max(columns_, rows_); }

 private:
  static std::pair<double, double> bulk(const std::vector<Point>& points, double Vec2::*axis) {
    std::vector<double> values;
    for (const Point& p : points) values.push_back(p.at.*axis);
    const auto low = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 100);
    const auto high = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / 100);
    std::nth_element(values.begin(), low, values.end());
    const double least = *low;
    std::nth_element(values.begin(), high, values.end());
    return {least, *high};
  }
  int place(double x, int n) const { return static_cast<int>(std::clamp(x / size_, 0.0, n - 1.0)); }
  std::size_t cellOf(Vec2 at) const {
    return static_cast<std::size_t>(place(at.y - low_.y, rows_)) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(place(at.x - low_.x, columns_));
  }
  template <class Use>
  void forCells(int row, int left, int right, const Use& use) const {
    const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    for (std::uint32_t i = start_[first + left]; i < start_[first + right + 1]; ++i) use(points_[i]);
  }

  Vec2 low_;
  double size_ = 0.0;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> start_;  // of each cell in points_, and the end
  std::vector<Point> points_;
};

/// Unlike points among the nearest ones: `whole` of them, and a share of those that are as far as the last.
struct Unlike {
  std::int64_t whole = 0;
  double shared = 0.0;
};

}  // namespace

std::optional<double> neighbourIndex(const Frame& frame, int neighbours, const Period& period) {
  std::vector<Point> points;
  std::int64_t tracer = 0;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec2f at = frame.position[i];
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) continue;
    points.push_back({{static_cast<double>(at.x), static_cast<double>(at.y)}, frame.species[i] == 1});
    tracer += points.back().tracer;
  }
  const auto n = static_cast<std::int64_t>(points.size());
  if (tracer == 0 || tracer == n) return std::nullopt;
  const std::size_t k = static_cast<std::size_t>(std::min<std::int64_t>(neighbours, n - 1));
  if (period.isOn())
    for (std::int64_t i = 0; i < 2 * n; ++i) {
      const Point p = points[static_cast<std::size_t>(i / 2)];
      const double shift = i % 2 == 0 ? -period.length : period.length;
      points.push_back({{p.at.x + shift, p.at.y}, p.tracer, true});
    }

  struct Near {
    double squared;  // distance, m2
    bool unlike;
  };
  const PointCells cells(points);
  std::vector<Near> near;
  Unlike unlike;
  for (const Point& p : cells.points()) {
    if (p.isImage) continue;
    near.clear();
    const auto look = [&](const Point& q) {
      const Vec2 apart = q.at - p.at;
      // Of the images of a point the nearest.
      if (period.isOn() && !(-0.5 * period.length <= apart.x && apart.x < 0.5 * period.length)) return;
      if (&q != &p) near.push_back({dot(apart, apart), q.tracer != p.tracer});
    };
    cells.forRing(p.at, 0, look);
    for (int ring = 1;; ++ring) {
      cells.forRing(p.at, ring, look);
      if (near.size() < k) continue;
      std::nth_element(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(k - 1), near.end(),
                       [](const Near& a, const Near& b) { return a.squared < b.squared; });
      const double reach = cells.reach(p.at, ring);
      if (near[k - 1].squared < reach * reach || cells.holdsAll(ring)) break;
    }
    const double last = near[k - 1].squared;
    std::int64_t nearer = 0, asFar = 0, unlikeAsFar = 0;
    for (const Near& q : near) {
      nearer += q.squared < last;
      asFar += q.squared == last;
      unlike.whole += q.unlike && q.squared < last;
      unlikeAsFar += q.unlike && q.squared == last;
    }
    const std::int64_t left = static_cast<std::int64_t>(k) - nearer;
    if (asFar == left)
      unlike.whole += unlikeAsFar;
    else
      unlike.shared += static_cast<double>(left * unlikeAsFar) / static_cast<double>(asFar);
  }
  const double pairs = static_cast<double>(n) * static_cast<double>(n - 1);
  const double expected = 2.0 * static_cast<double>(tracer) * static_cast<double>(n - tracer) / pairs;
  return (static_cast<double>(unlike.whole) + unlike.shared) /
         (static_cast<double>(k) * static_cast<double>(n) * expected);
}

}  // namespace bedmix
