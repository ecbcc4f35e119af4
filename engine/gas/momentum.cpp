// SPDX-License-Identifier: MIT
#include "engine/gas/momentum.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// Of the largest velocity, change per sweep. A step changes velocities by a percent or more and is itself
// exact to some 1e-4; the pressure correction closes continuity whatever is left.
constexpr double sweepTolerance = 1e-6;
constexpr int mostSweeps = 200;
constexpr double tiny = 1e-300;

/// Diffusion that is left at a mass flux, after Patankar's power law: D max(0, 1 - |F| / (10 D))^5.
inline double powerLaw(double diffusion, double flux) {
  const double rest = diffusion - 0.1 * std::abs(flux);
  const double left = 0.5 * (rest + std::abs(rest)) / (diffusion + tiny);
  const double squared = left * left;
  return diffusion * (squared * squared * left);
}
inline double positive(double x) { return 0.5 * (x + std::abs(x)); }

}  // namespace

MomentumSystem::MomentumSystem(const Scene& scene, const FaceLayout& layout)
    : layout_(layout),
      density_(scene.gas->density),
      viscosity_(scene.gas->viscosity),
      step_(scene.gas->step),
      theta_(scene.gas->timeScheme == TimeScheme::crankNicolson ? 0.5 : 1.0),
      gravity_(scene.gravity),
      reduction_(layout.rows + 1) {
  for (auto* field : {&flux_, &inertia_, &oldPart_, &sides_.before, &sides_.behind, &sides_.below,
                      &sides_.above, &rhs_, &perDiagonal_, &pull_, &spare_})
    field->assign(static_cast<std::size_t>(layout.faces()), 0.0);
}

Range MomentumSystem::places(const Member& member, const FaceFamily& family) const {
  const Range rows = member.share(family.rows);
  const auto first = static_cast<std::size_t>(family.first),
             stride = static_cast<std::size_t>(layout_.stride);
  return {first + (rows.begin + 1) * stride, first + (rows.end + 1) * stride};
}

void MomentumSystem::updateSides(Member& member, const std::vector<double>& velocity,
                                 const std::vector<double>& voidage, double share) {
  const double *u = velocity.data(), *eps = voidage.data(), *area = layout_.faceArea.data();
  const double* solved = layout_.solved.data();
  const double *alongSide = layout_.alongSide.data(), *acrossSide = layout_.acrossSide.data();
  double* flux = flux_.data();
  for (const FaceFamily& family : layout_.families) {
    const Range mine = places(member, family);
#pragma GCC ivdep
    for (std::size_t f = mine.begin; f < mine.end; ++f) flux[f] = density_ * eps[f] * u[f] * area[f];
  }
  member.wait();
  double *before = sides_.before.data(), *behind = sides_.behind.data();
  double *below = sides_.below.data(), *above = sides_.above.data();
  const double diffusivity = 0.5 * viscosity_;
  for (int k = 0; k < 2; ++k) {
    const FaceFamily& family = layout_.families[k];
    const std::ptrdiff_t along = family.along, across = family.across;
    const std::ptrdiff_t other = layout_.families[1 - k].first - family.first;
    const Range mine = places(member, family);
#pragma GCC ivdep
    for (auto f = static_cast<std::ptrdiff_t>(mine.begin); f < static_cast<std::ptrdiff_t>(mine.end); ++f) {
      const double through = 0.5 * (flux[f - along] + flux[f]);
      const double rest = powerLaw(diffusivity * (eps[f - along] + eps[f]) * alongSide[f], through);
      before[f] = share * solved[f] * (rest + positive(through));
      behind[f - along] = share * solved[f - along] * (rest + positive(-through));
      const double sideways = 0.5 * (flux[f + other - along] + flux[f + other]);
      const double left = powerLaw(diffusivity * (eps[f - across] + eps[f]) * acrossSide[f], sideways);
      below[f] = share * solved[f] * (left + positive(sideways));
      above[f - across] = share * solved[f - across] * (left + positive(-sideways));
    }
  }
  member.wait();
}

void MomentumSystem::beginStep(Member& member, const std::vector<double>& velocity,
                               const std::vector<double>& voidage) {
  const double share = 1.0 - theta_;
  if (share > 0.0) updateSides(member, velocity, voidage, share);
  const double *u = velocity.data(), *eps = voidage.data(), *volume = layout_.volume.data();
  const double* wall = layout_.wall.data();
  const double *before = sides_.before.data(), *behind = sides_.behind.data();
  const double *below = sides_.below.data(), *above = sides_.above.data();
  double *inertia = inertia_.data(), *oldPart = oldPart_.data();
  const double perStep = density_ / step_, friction = share * viscosity_;
  for (const FaceFamily& family : layout_.families) {
    const std::ptrdiff_t along = family.along, across = family.across;
    const Range mine = places(member, family);
    if (share == 0.0) {
      for (std::size_t f = mine.begin; f < mine.end; ++f) {
        inertia[f] = perStep * eps[f] * volume[f];
        oldPart[f] = inertia[f] * u[f];
      }
      continue;
    }
#pragma GCC ivdep
    for (auto f = static_cast<std::ptrdiff_t>(mine.begin); f < static_cast<std::ptrdiff_t>(mine.end); ++f) {
      inertia[f] = perStep * eps[f] * volume[f];
      oldPart[f] = inertia[f] * u[f] + before[f] * (u[f - along] - u[f]) + behind[f] * (u[f + along] - u[f]) +
                   below[f] * (u[f - across] - u[f]) + above[f] * (u[f + across] - u[f]) -
                   friction * eps[f] * wall[f] * u[f];
    }
  }
}

void MomentumSystem::assemble(Member& member, const std::vector<double>& velocity,
                              const std::vector<double>& voidage, const std::vector<double>& pressure,
                              const MomentumExchange& exchange) {
  updateSides(member, velocity, voidage, theta_);
  const double *eps = voidage.data(), *p = pressure.data();
  const double *area = layout_.faceArea.data(), *volume = layout_.volume.data();
  const double *solved = layout_.solved.data(), *wall = layout_.wall.data();
  const double *before = sides_.before.data(), *behind = sides_.behind.data();
  const double *below = sides_.below.data(), *above = sides_.above.data();
  const double *inertia = inertia_.data(), *oldPart = oldPart_.data();
  const double *coefficient = exchange.coefficient.data(), *source = exchange.source.data();
  double *rhs = rhs_.data(), *perDiagonal = perDiagonal_.data(), *pull = pull_.data();
  const double friction = theta_ * viscosity_;
  for (int k = 0; k < 2; ++k) {
    const FaceFamily& family = layout_.families[k];
    const double weight = k == 1 ? density_ * gravity_ : 0.0;
    const std::ptrdiff_t along = family.along, first = family.first;
    const Range mine = places(member, family);
#pragma GCC ivdep
    for (auto f = static_cast<std::ptrdiff_t>(mine.begin); f < static_cast<std::ptrdiff_t>(mine.end); ++f) {
      const double sides = (before[f] + behind[f]) + (below[f] + above[f]) + friction * eps[f] * wall[f];
      pull[f] = eps[f] * area[f] * solved[f];
      perDiagonal[f] = solved[f] / (inertia[f] + sides + coefficient[f]);
      rhs[f] = oldPart[f] + source[f] - weight * eps[f] * volume[f] +
               pull[f] * (p[f - first - along] - p[f - first]);
    }
  }
  // What enters at the floor is given.
  const Range level = places(member, layout_.families[1]);
  for (const FloorFace& floor : layout_.floor) {
    const auto f = static_cast<std::size_t>(floor.face);
    if (f < level.begin || f >= level.end) continue;
    perDiagonal[f] = 1.0;
    rhs[f] = velocity[f];
  }
}

void MomentumSystem::relax(Member& member, const std::vector<double>& velocity, double factor) {
  for (const FaceFamily& family : layout_.families) {
    const Range mine = places(member, family);
    for (std::size_t f = mine.begin; f < mine.end; ++f) {
      if (layout_.solved[f] == 0.0) continue;
      rhs_[f] += (1.0 / factor - 1.0) / perDiagonal_[f] * velocity[f];
      perDiagonal_[f] *= factor;
    }
  }
}

double MomentumSystem::residual(Member& member, const std::vector<double>& velocity) {
  const auto ofRow = [&](int row) {
    Change sum;  // here: residual, scale
    for (const FaceFamily& family : layout_.families) {
      if (row >= family.rows) continue;
      const int first = family.first + layout_.at(0, row);
      for (int f = first; f < first + layout_.columns; ++f) {
        if (layout_.solved[f] == 0.0) continue;
        const double own = velocity[f] / perDiagonal_[f];
        sum.ofSweep += std::abs(rhs_[f] + sides_.before[f] * velocity[f - family.along] +
                                sides_.behind[f] * velocity[f + family.along] +
                                sides_.below[f] * velocity[f - family.across] +
                                sides_.above[f] * velocity[f + family.across] - own);
        sum.largest += std::abs(own);
      }
    }
    return sum;
  };
  const Change all = reduction_(member, ofRow, [](Change a, Change b) {
    return Change{a.ofSweep + b.ofSweep, a.largest + b.largest};
  });
  return all.largest > 0.0 ? all.ofSweep / all.largest : all.ofSweep;
}

void MomentumSystem::sweep(Member& member, const std::vector<double>& from, std::vector<double>& to) const {
  const double *u = from.data(), *rhs = rhs_.data(), *perDiagonal = perDiagonal_.data();
  const double *before = sides_.before.data(), *behind = sides_.behind.data();
  const double *below = sides_.below.data(), *above = sides_.above.data();
  double* updated = to.data();
  for (const FaceFamily& family : layout_.families) {
    const std::ptrdiff_t along = family.along, across = family.across;
    const Range mine = places(member, family);
#pragma GCC ivdep
    for (auto f = static_cast<std::ptrdiff_t>(mine.begin); f < static_cast<std::ptrdiff_t>(mine.end); ++f)
      updated[f] = perDiagonal[f] * (rhs[f] + before[f] * u[f - along] + behind[f] * u[f + along] +
                                     below[f] * u[f - across] + above[f] * u[f + across]);
  }
  member.wait();
}

void MomentumSystem::solve(Member& member, std::vector<double>& velocity) {
  for (int sweeps = 0; sweeps < mostSweeps; sweeps += 2) {
    sweep(member, velocity, spare_);
    sweep(member, spare_, velocity);
    const auto ofRow = [&](int row) {
      Change change;
      for (const FaceFamily& family : layout_.families) {
        const int first = family.first + layout_.at(0, row);
        for (int f = first; f < first + layout_.stride; ++f) {
          change.ofSweep = std::max(change.ofSweep, std::abs(velocity[f] - spare_[f]));
          change.largest = std::max(change.largest, std::abs(velocity[f]));
        }
      }
      return change;
    };
    const Change all = reduction_(member, ofRow, [](Change a, Change b) {
      return Change{std::max(a.ofSweep, b.ofSweep), std::max(a.largest, b.largest)};
    });
    if (all.ofSweep <= sweepTolerance * all.largest) return;
  }
}

void MomentumSystem::addNeighbourEffect(Member& member, const std::vector<double>& change,
                                        std::vector<double>& velocity) const {
  const double *v = change.data(), *perDiagonal = perDiagonal_.data();
  const double *before = sides_.before.data(), *behind = sides_.behind.data();
  const double *below = sides_.below.data(), *above = sides_.above.data();
  double* u = velocity.data();
  for (const FaceFamily& family : layout_.families) {
    const std::ptrdiff_t along = family.along, across = family.across;
    const Range mine = places(member, family);
#pragma GCC ivdep
    for (auto f = static_cast<std::ptrdiff_t>(mine.begin); f < static_cast<std::ptrdiff_t>(mine.end); ++f)
      u[f] += perDiagonal[f] * (before[f] * v[f - along] + behind[f] * v[f + along] +
                                below[f] * v[f - across] + above[f] * v[f + across]);
  }
}

}  // namespace bedmix
