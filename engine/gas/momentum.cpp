// SPDX-License-Identifier: MIT
#include "engine/gas/momentum.h"

#include "engine/gas/frame_kernel.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// Of the largest velocity, change per sweep. A step changes velocities by a percent or more and is itself
// exact to some 1e-4; the pressure correction closes continuity whatever is left.
constexpr double sweepTolerance = 1e-6;
constexpr int mostSweeps = 200;

}  // namespace

MomentumSystem::MomentumSystem(const Scene& scene, const FaceLayout& layout)
    : layout_(layout),
      density_(scene.gas->density),
      viscosity_(scene.gas->viscosity),
      step_(scene.gas->step.valueOr(longestGasStep(scene))),
      theta_(scene.gas->timeScheme == TimeScheme::crankNicolson ? 0.5 : 1.0),
      gravity_(scene.gravity),
      spare_(static_cast<std::size_t>(layout.faces())),
      reduction_(layout.rows + 1) {
  kernel_.area = layout.faceArea.data();
  kernel_.volume = layout.volume.data();
  kernel_.solved = layout.solved.data();
  kernel_.wall = layout.wall.data();
  kernel_.alongSide = layout.alongSide.data();
  kernel_.acrossSide = layout.acrossSide.data();
  double** const fields[] = {&kernel_.flux,        &kernel_.inertia, &kernel_.oldPart, &kernel_.before,
                             &kernel_.behind,      &kernel_.below,   &kernel_.above,   &kernel_.rhs,
                             &kernel_.perDiagonal, &kernel_.pull};
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    fields_[i].assign(spare_.size(), 0.0);
    *fields[i] = fields_[i].data();
  }
}

Range MomentumSystem::faces(const Member& member, const FaceFamily& family) const {
  const Range frame = layout_.places(member.share(family.rows));
  const auto first = static_cast<std::size_t>(family.first);
  return {first + frame.begin, first + frame.end};
}

void MomentumSystem::updateSides(Member& member, const std::vector<double>& velocity,
                                 const std::vector<double>& voidage, double share) {
  for (const FaceFamily& family : layout_.families)
    kernel_.updateFlux(density_, velocity.data(), voidage.data(), faces(member, family));
  member.wait();
  const auto& [upright, level] = layout_.families;
  const std::ptrdiff_t other = level.first - upright.first;
  kernel_.updateSides(upright, other, viscosity_, share, voidage.data(), faces(member, upright));
  kernel_.updateSides(level, -other, viscosity_, share, voidage.data(), faces(member, level));
  member.wait();
}

void MomentumSystem::beginStep(Member& member, const std::vector<double>& velocity,
                               const std::vector<double>& voidage) {
  const double share = 1.0 - theta_;
  updateSides(member, velocity, voidage, share);
  for (const FaceFamily& family : layout_.families)
    kernel_.setOldLevel(family, density_ / step_, share * viscosity_, velocity.data(), voidage.data(),
                        faces(member, family));
}

void MomentumSystem::assemble(Member& member, const std::vector<double>& velocity,
                              const std::vector<double>& voidage, const std::vector<double>& pressure,
                              const MomentumExchange& exchange) {
  updateSides(member, velocity, voidage, theta_);
  const auto& [upright, level] = layout_.families;
  for (const FaceFamily& family : layout_.families)
    kernel_.assemble(family, theta_ * viscosity_, &family == &level ? density_ * gravity_ : 0.0,
                     voidage.data(), pressure.data(), exchange.coefficient.data(), exchange.source.data(),
                     faces(member, family));
  // What enters at the floor is given.
  const Range mine = faces(member, level);
  for (const FloorFace& floor : layout_.floor) {
    const auto f = static_cast<std::size_t>(floor.face);
    if (f < mine.begin || f >= mine.end) continue;
    kernel_.perDiagonal[f] = 1.0;
    kernel_.rhs[f] = velocity[f];
  }
}

void MomentumSystem::relax(Member& member, const std::vector<double>& velocity, double factor) {
  for (const FaceFamily& family : layout_.families) {
    const Range mine = faces(member, family);
    for (std::size_t f = mine.begin; f < mine.end; ++f) {
      if (layout_.solved[f] == 0.0) continue;
      kernel_.rhs[f] += (1.0 / factor - 1.0) / kernel_.perDiagonal[f] * velocity[f];
      kernel_.perDiagonal[f] *= factor;
    }
  }
}

double MomentumSystem::residual(Member& member, const std::vector<double>& velocity) {
  const MomentumKernel& k = kernel_;
  member.wait();  // rows of both families are shared out together here
  const auto ofRow = [&](int row) {
    Pair sum;  // residual, scale
    for (const FaceFamily& family : layout_.families) {
      if (row >= family.rows) continue;
      const int first = family.first + layout_.at(0, row);
      for (int f = first; f < first + layout_.columns; ++f) {
        if (layout_.solved[f] == 0.0) continue;
        const double own = velocity[f] / k.perDiagonal[f];
        sum.a += std::abs(
            k.rhs[f] + k.before[f] * velocity[f - family.along] + k.behind[f] * velocity[f + family.along] +
            k.below[f] * velocity[f - family.across] + k.above[f] * velocity[f + family.across] - own);
        sum.b += std::abs(own);
      }
    }
    return sum;
  };
  const Pair all = reduction_.overRows(member, ofRow, [](Pair x, Pair y) {
    return Pair{x.a + y.a, x.b + y.b};
  });
  return all.b > 0.0 ? all.a / all.b : all.a;
}

void MomentumSystem::sweep(Member& member, const std::vector<double>& from, std::vector<double>& to) const {
  for (const FaceFamily& family : layout_.families)
    kernel_.sweep(family, from.data(), to.data(), faces(member, family));
  layout_.copyAround(member, to);
  member.wait();
}

void MomentumSystem::solve(Member& member, std::vector<double>& velocity) {
  for (int sweeps = 0; sweeps < mostSweeps; sweeps += 2) {
    sweep(member, velocity, spare_);
    sweep(member, spare_, velocity);
    Pair mine;  // change, size
    for (const FaceFamily& family : layout_.families) {
      const Range f = faces(member, family);
      mine.a = std::max(mine.a, largestDifference(velocity.data(), spare_.data(), f));
      mine.b = std::max(mine.b, largestSize(velocity.data(), f));
    }
    const auto larger = [](Pair x, Pair y) { return Pair{std::max(x.a, y.a), std::max(x.b, y.b)}; };
    const Pair all = reduction_.overShares(member, mine, larger);
    if (all.a <= sweepTolerance * all.b) return;
  }
}

void MomentumSystem::conductances(Member& member, std::vector<double>& conductance) const {
  for (const FaceFamily& family : layout_.families) {
    const Range mine = faces(member, family);
    for (std::size_t f = mine.begin; f < mine.end; ++f)
      conductance[f] = kernel_.pull[f] * kernel_.pull[f] * kernel_.perDiagonal[f];
  }
  layout_.copyAround(member, conductance);
}

void MomentumSystem::correct(Member& member, const std::vector<double>& pressure, std::vector<double>& change,
                             std::vector<double>& velocity) const {
  for (const FaceFamily& family : layout_.families)
    kernel_.correct(family, pressure.data(), change.data(), velocity.data(), faces(member, family));
  layout_.copyAround(member, change);
  layout_.copyAround(member, velocity);
}

void MomentumSystem::addNeighbourEffect(Member& member, const std::vector<double>& change,
                                        std::vector<double>& velocity) const {
  for (const FaceFamily& family : layout_.families)
    kernel_.addNeighbourEffect(family, change.data(), velocity.data(), faces(member, family));
  layout_.copyAround(member, velocity);
}

}  // namespace bedmix
