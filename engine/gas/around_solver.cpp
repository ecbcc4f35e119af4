// SPDX-License-Identifier: MIT
#include "engine/gas/around_solver.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {

AroundSolver::Cut::Cut(const FaceLayout& around, int firstColumn, int members)
    : first(firstColumn),
      layout(cutOpen(around, firstColumn)),
      conductance(static_cast<std::size_t>(layout.faces())),
      multigrid(layout, members) {
  double width = 0.0, left = 0.0;
  for (const double w : layout.width) width += w;
  for (const double w : layout.width) {
    weight.push_back(static_cast<float>(std::sin(std::numbers::pi * (left + 0.5 * w) / width)));
    left += w;
  }
}

FaceLayout AroundSolver::cutOpen(const FaceLayout& around, int firstColumn) {
  FaceLayout cut;
  cut.columns = around.columns;
  cut.rows = around.rows;
  cut.stride = cut.columns + 1;
  cut.size = cut.stride * (cut.rows + 3);
  cut.height = around.height;
  cut.width = around.width;
  std::rotate(cut.width.begin(), cut.width.begin() + firstColumn, cut.width.end());
  cut.solved.assign(static_cast<std::size_t>(cut.faces()), 0.0);
  take(around, around.solved, firstColumn, cut, {0, static_cast<std::size_t>(cut.rows) + 1}, cut.solved);
  return cut;
}

void AroundSolver::take(const FaceLayout& around, const std::vector<double>& faces, int firstColumn,
                        const FaceLayout& cut, Range rows, std::vector<double>& to) {
  for (int j = static_cast<int>(rows.begin); j < static_cast<int>(rows.end); ++j)
    for (int i = 0; i < cut.columns; ++i) {
      const int from = (firstColumn + i) % cut.columns;
      if (i > 0 && j < cut.rows) to[cut.uFace(i, j)] = faces[around.uFace(from, j)];
      to[cut.vFace(i, j)] = faces[around.vFace(from, j)];
    }
}

AroundSolver::AroundSolver(const FaceLayout& layout, int members)
    : layout_(layout),
      cuts_{Cut(layout, 0, members), Cut(layout, layout.columns / 2, members)},
      reduction_(layout.rows) {
  for (auto* field : {&residual_, &direction_, &image_, &z_})
    field->assign(static_cast<std::size_t>(layout.size), 0.0);
}

/// Calls visit(place, column, row) for the cells in a member's rows.
template <class Visit>
void AroundSolver::forMine(const Member& member, Visit&& visit) const {
  const Range mine = member.share(layout_.rows);
  for (int j = static_cast<int>(mine.begin); j < static_cast<int>(mine.end); ++j)
    for (int i = 0; i < layout_.columns; ++i) visit(layout_.at(i, j), i, j);
}

/// Of all cells, row by row.
template <class OfPlace>
double AroundSolver::sum(Member& member, OfPlace&& ofPlace) {
  const auto ofRow = [&](int row) {
    double all = 0.0;
    for (int c = layout_.at(0, row); c < layout_.at(layout_.columns, row); ++c) all += ofPlace(c);
    return all;
  };
  return reduction_.overRows(member, ofRow, [](double a, double b) { return a + b; });
}

bool AroundSolver::prepare(Member& member, const std::vector<double>& conductance) {
  if (member.first()) conductance_ = &conductance;
  for (Cut& cut : cuts_) {
    take(layout_, conductance, cut.first, cut.layout, member.share(layout_.rows + 1), cut.conductance);
    member.wait();
    cut.multigrid.prepare(member, cut.conductance);
  }
  const double *west = conductance.data(), *south = west + layout_.size;
  const double all = sum(member, [=](int c) { return west[c] + south[c]; });
  return std::isfinite(all) && all > 0.0;
}

void AroundSolver::precondition(Member& member) {
  const auto columnOf = [this](const Cut& cut, int i) {
    return i >= cut.first ? i - cut.first : i - cut.first + layout_.columns;
  };
  for (Cut& cut : cuts_) {
    float* const asked = cut.multigrid.rightHandSide();
    forMine(member, [&](int c, int i, int j) {
      const int at = columnOf(cut, i);
      asked[cut.layout.at(at, j)] = cut.weight[at] * static_cast<float>(residual_[c]);
    });
  }
  member.wait();
  for (Cut& cut : cuts_) cut.multigrid.cycle(member);
  forMine(member, [&](int c, int i, int j) {
    double sum = 0.0;
    for (const Cut& cut : cuts_) {
      const int at = columnOf(cut, i);
      sum += static_cast<double>(cut.weight[at] * cut.multigrid.solution()[cut.layout.at(at, j)]);
    }
    z_[c] = sum;
  });
}

int AroundSolver::solve(Member& member, const std::vector<double>& b, std::vector<double>& p, double relative,
                        double absolute, int most) {
  const double *west = conductance_->data(), *south = west + layout_.size;
  const int n = layout_.stride;
  double* const x = p.data();
  double* const r = residual_.data();
  double* const d = direction_.data();
  double* const image = image_.data();
  const auto largest = [&] {
    double mine = 0.0;
    forMine(member, [&](int c, int, int) { mine = std::max(mine, std::abs(r[c])); });
    return reduction_.overShares(member, mine, [](double u, double v) { return std::max(u, v); });
  };
  forMine(member, [&](int c, int, int) {
    x[c] = d[c] = 0.0;
    r[c] = b[c];
  });
  double worst = largest(), before = 0.0;
  const double enough = std::max(relative * worst, absolute);
  int iterations = 0;
  for (; worst > enough && iterations < most; ++iterations) {
    precondition(member);
    const double now = sum(member, [&](int c) { return r[c] * z_[c]; });
    const double share = before > 0.0 ? now / before : 0.0;
    before = now;
    forMine(member, [&](int c, int, int) { d[c] = z_[c] + share * d[c]; });
    layout_.copyAround(d, member.share(layout_.rows));
    member.wait();
    const double curvature = sum(member, [&](int c) {
      image[c] = west[c] * (d[c] - d[c - 1]) + west[c + 1] * (d[c] - d[c + 1]) +
                 south[c] * (d[c] - d[c - n]) + south[c + n] * (d[c] - d[c + n]);
      return d[c] * image[c];
    });
    const double length = now / curvature;
    forMine(member, [&](int c, int, int) {
      x[c] += length * d[c];
      r[c] -= length * image[c];
    });
    worst = largest();
  }
  return worst <= enough ? iterations : -1;
}

}  // namespace bedmix
