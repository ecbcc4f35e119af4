// SPDX-License-Identifier: MIT
#include "engine/gas/pressure_solver.h"

#include "engine/gas/frame_kernel.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// Where a band is factorized: cells along the short side, for width^2 is what it costs, and cells, for it
// keeps one thread busy only.
constexpr int widestDirect = 16, largestDirect = 4096;
// Between periodic sides, where iterations cost more.
constexpr int widestDirectAround = 48;

}  // namespace

PressureSolver::Iteration::Iteration(const FaceLayout& layout, int members)
    : multigrid(layout, members), lastResort(layout) {
  for (auto* field : {&residual, &direction, &image})
    field->assign(static_cast<std::size_t>(layout.size), 0.0);
}

PressureSolver::PressureSolver(const FaceLayout& layout, int members)
    : layout_(layout), reduction_(layout.rows) {
  const int width = std::min(layout.columns, layout.repeats ? 2 * layout.rows : layout.rows);
  const bool isSmall = width <= (layout.repeats ? widestDirectAround : widestDirect) &&
                       layout.columns * layout.rows < largestDirect;
  if (isSmall)
    band_.emplace(layout);
  else if (layout.repeats)
    around_.emplace(layout, members);
  else
    iteration_.emplace(layout, members);
}

template <class OfRow>
double PressureSolver::sum(Member& member, OfRow&& ofRow) {
  const auto ofPlaces = [&](int row) {
    const auto r = static_cast<std::size_t>(row);
    return ofRow(layout_.places({r, r + 1}));
  };
  return reduction_.overRows(member, ofPlaces, [](double a, double b) { return a + b; });
}

double PressureSolver::largest(Member& member, double mine) {
  return reduction_.overShares(member, mine, [](double a, double b) { return std::max(a, b); });
}

bool PressureSolver::prepare(Member& member, const std::vector<double>& conductance) {
  if (band_) {
    if (member.first()) sound_ = band_->prepare(conductance);
    member.wait();
    return sound_;
  }
  if (member.first()) conductance_ = &conductance;
  if (around_) return around_->solver.prepare(member, conductance);
  iteration_->multigrid.prepare(member, conductance);
  const double *west = conductance.data(), *south = west + layout_.size;
  const double all = sum(member, [=](Range row) { return total(west, row) + total(south, row); });
  return std::isfinite(all) && all > 0.0;
}

int PressureSolver::solve(Member& member, const std::vector<double>& b, std::vector<double>& p,
                          Tolerance tolerance) {
  if (around_) return goAround(member, b, p, tolerance);
  if (!band_) return iterate(member, b, p, tolerance);
  if (member.first()) band_->solve(b, p);
  member.wait();
  return 0;
}

int PressureSolver::goAround(Member& member, const std::vector<double>& b, std::vector<double>& p,
                             Tolerance tolerance) {
  const int iterations =
      around_->solver.solve(member, b, p, tolerance.relative, tolerance.absolute, mostIterations);
  if (iterations >= 0) return iterations;
  member.wait();
  if (member.first()) around_->lastResort.solve(*conductance_, b, p);
  member.wait();
  return mostIterations;
}

int PressureSolver::iterate(Member& member, const std::vector<double>& b, std::vector<double>& p,
                            Tolerance tolerance) {
  Iteration& it = *iteration_;
  const Range mine = layout_.places(member.share(layout_.rows));
  const FrameOperator a{conductance_->data(), conductance_->data() + layout_.size, layout_.stride};
  double *r = it.residual.data(), *direction = it.direction.data(), *image = it.image.data(), *x = p.data();
  float* asked = it.multigrid.rightHandSide();
  const float* z = it.multigrid.solution();

  for (std::size_t c = mine.begin; c < mine.end; ++c) {
    x[c] = 0.0;
    direction[c] = 0.0;
    r[c] = b[c];
    asked[c] = static_cast<float>(b[c]);
  }
  double worst = largest(member, largestSize(r, mine));
  const double enough = std::max(tolerance.relative * worst, tolerance.absolute);
  double before = 0.0;
  int iterations = 0;
  while (worst > enough && iterations < mostIterations) {
    ++iterations;
    it.multigrid.cycle(member);
    const double now = sum(member, [=](Range row) { return product(r, z, row); });
    turn(before > 0.0 ? now / before : 0.0, z, direction, mine);
    before = now;
    member.wait();
    const double curvature = sum(member, [=](Range row) { return apply(a, direction, image, row); });
    worst = largest(member, advance(now / curvature, direction, image, x, r, asked, mine));
  }
  if (!(worst <= enough)) {
    member.wait();
    if (member.first()) it.lastResort.solve(*conductance_, b, p);
    member.wait();
  }
  return iterations;
}

}  // namespace bedmix
