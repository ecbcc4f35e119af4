// SPDX-License-Identifier: MIT
#include "engine/gas/pressure_solver.h"

#include "engine/gas/sums.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr int largestDirect = 4096;  // cells
constexpr int mostIterations = 200;

}  // namespace

PressureSolver::Iteration::Iteration(const FaceLayout& layout) : multigrid(layout) {
  for (auto* field : {&residual, &direction, &image})
    field->assign(static_cast<std::size_t>(layout.size), 0.0);
}

PressureSolver::PressureSolver(const FaceLayout& layout) : layout_(layout), reduction_(layout.rows) {
  if (layout.columns * layout.rows < largestDirect)
    band_.emplace(layout);
  else
    iteration_.emplace(layout);
}

Range PressureSolver::places(const Member& member) const {
  const Range rows = member.share(layout_.rows);
  return {static_cast<std::size_t>(layout_.at(0, static_cast<int>(rows.begin))),
          static_cast<std::size_t>(layout_.at(0, static_cast<int>(rows.end)))};
}

template <class OfPlaces>
double PressureSolver::sum(Member& member, OfPlaces&& of) {
  const auto ofRow = [&](int row) { return of(layout_.at(0, row), layout_.at(0, row + 1)); };
  return reduction_(member, ofRow, [](double a, double b) { return a + b; });
}

template <class OfPlaces>
double PressureSolver::largest(Member& member, OfPlaces&& of) {
  const auto ofRow = [&](int row) { return of(layout_.at(0, row), layout_.at(0, row + 1)); };
  return reduction_(member, ofRow, [](double a, double b) { return std::max(a, b); });
}

bool PressureSolver::prepare(Member& member, const std::vector<double>& coefficient) {
  if (band_) {
    if (member.first()) sound_ = band_->prepare(coefficient);
    member.wait();
    return sound_;
  }
  coefficient_ = &coefficient;
  iteration_->multigrid.prepare(member, coefficient);
  const double all = sum(member, [&](int begin, int end) {
    return total(&coefficient[begin], end - begin) + total(&coefficient[layout_.size + begin], end - begin);
  });
  return std::isfinite(all) && all > 0.0;
}

int PressureSolver::solve(Member& member, const std::vector<double>& b, std::vector<double>& p,
                          Tolerance tolerance) {
  if (!band_) return iterate(member, b, p, tolerance);
  if (member.first()) band_->solve(b, p);
  member.wait();
  return 0;
}

int PressureSolver::iterate(Member& member, const std::vector<double>& b, std::vector<double>& p,
                            Tolerance tolerance) {
  Iteration& it = *iteration_;
  const double *west = coefficient_->data(), *south = west + layout_.size;
  const int n = layout_.stride;
  double *r = it.residual.data(), *d = it.direction.data(), *q = it.image.data(), *x = p.data();
  float* asked = it.multigrid.rightHandSide();
  const float* z = it.multigrid.solution();

  double worst = largest(member, [&](int begin, int end) {
    for (int c = begin; c < end; ++c) {
      x[c] = 0.0;
      d[c] = 0.0;
      r[c] = b[c];
      asked[c] = static_cast<float>(r[c]);
    }
    return largestSize(r + begin, end - begin);
  });
  const double enough = std::max(tolerance.relative * worst, tolerance.absolute);
  double before = 0.0;
  int iterations = 0;
  while (worst > enough && iterations < mostIterations) {
    ++iterations;
    it.multigrid.cycle(member);
    const double now =
        sum(member, [&](int begin, int end) { return product(r + begin, z + begin, end - begin); });
    const double share = before > 0.0 ? now / before : 0.0;
    before = now;
    const Range mine = places(member);
    for (std::size_t c = mine.begin; c < mine.end; ++c) d[c] = static_cast<double>(z[c]) + share * d[c];
    member.wait();
    const double curvature = sum(member, [&](int begin, int end) {
#pragma GCC ivdep
      for (int c = begin; c < end; ++c)
        q[c] = west[c] * (d[c] - d[c - 1]) + west[c + 1] * (d[c] - d[c + 1]) + south[c] * (d[c] - d[c - n]) +
               south[c + n] * (d[c] - d[c + n]);
      return product(d + begin, q + begin, end - begin);
    });
    const double length = now / curvature;
    worst = largest(member, [&](int begin, int end) {
#pragma GCC ivdep
      for (int c = begin; c < end; ++c) {
        x[c] += length * d[c];
        r[c] -= length * q[c];
        asked[c] = static_cast<float>(r[c]);
      }
      return largestSize(r + begin, end - begin);
    });
  }
  return iterations;
}

}  // namespace bedmix
