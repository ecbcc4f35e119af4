// SPDX-License-Identifier: MIT
#include "engine/gas/momentum_kernel.h"

#include "engine/gas/independent.h"

#include <cmath>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/gas/momentum_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

HWY_INLINE std::ptrdiff_t first(Range faces) { return static_cast<std::ptrdiff_t>(faces.begin); }
HWY_INLINE std::ptrdiff_t last(Range faces) { return static_cast<std::ptrdiff_t>(faces.end); }

constexpr double tiny = 1e-300;

HWY_INLINE double positive(double x) { return 0.5 * (x + std::abs(x)); }

/// Diffusion that is left at a mass flux, after Patankar's power law: D max(0, 1 - |F| / (10 D))^5.
HWY_INLINE double powerLaw(double diffusion, double flux) {
  const double left = positive(diffusion - 0.1 * std::abs(flux)) / (diffusion + tiny);
  const double squared = left * left;
  return diffusion * (squared * squared * left);
}

void updateFlux(const MomentumKernel& k, double density, const double* velocity, const double* voidage,
                Range faces) {
  double* const flux = k.flux;
  const double* const area = k.area;
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t f = first(faces); f < last(faces); ++f)
    flux[f] = density * voidage[f] * velocity[f] * area[f];
}

void updateSides(const MomentumKernel& k, const FaceFamily& family, std::ptrdiff_t other, double viscosity,
                 double share, const double* voidage, Range faces) {
  const std::ptrdiff_t along = family.along, across = family.across;
  const double *flux = k.flux, *solved = k.solved, *alongSide = k.alongSide, *acrossSide = k.acrossSide;
  double *before = k.before, *behind = k.behind, *below = k.below, *above = k.above;
  const double half = 0.5 * viscosity;
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t f = first(faces); f < last(faces); ++f) {
    const double through = 0.5 * (flux[f - along] + flux[f]);
    const double rest = powerLaw(half * (voidage[f - along] + voidage[f]) * alongSide[f], through);
    before[f] = share * solved[f] * (rest + positive(through));
    behind[f - along] = share * solved[f - along] * (rest + positive(-through));
    const double sideways = 0.5 * (flux[f + other - along] + flux[f + other]);
    const double left = powerLaw(half * (voidage[f - across] + voidage[f]) * acrossSide[f], sideways);
    below[f] = share * solved[f] * (left + positive(sideways));
    above[f - across] = share * solved[f - across] * (left + positive(-sideways));
  }
}

void setOldLevel(const MomentumKernel& k, const FaceFamily& family, double densityPerStep, double friction,
                 const double* velocity, const double* voidage, Range faces) {
  const std::ptrdiff_t along = family.along, across = family.across;
  const double *u = velocity, *volume = k.volume, *wall = k.wall;
  const double *before = k.before, *behind = k.behind, *below = k.below, *above = k.above;
  double *inertia = k.inertia, *oldPart = k.oldPart;
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t f = first(faces); f < last(faces); ++f) {
    inertia[f] = densityPerStep * voidage[f] * volume[f];
    oldPart[f] = inertia[f] * u[f] + before[f] * (u[f - along] - u[f]) + behind[f] * (u[f + along] - u[f]) +
                 below[f] * (u[f - across] - u[f]) + above[f] * (u[f + across] - u[f]) -
                 friction * voidage[f] * wall[f] * u[f];
  }
}

void assemble(const MomentumKernel& k, const FaceFamily& family, double friction, double weight,
              const double* voidage, const double* pressure, const double* coefficient, const double* source,
              Range faces) {
  const std::ptrdiff_t along = family.along;
  const double *p = pressure - family.first, *area = k.area, *volume = k.volume, *solved = k.solved;
  const double *wall = k.wall, *inertia = k.inertia, *oldPart = k.oldPart;
  const double *before = k.before, *behind = k.behind, *below = k.below, *above = k.above;
  double *rhs = k.rhs, *perDiagonal = k.perDiagonal, *pull = k.pull;
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t f = first(faces); f < last(faces); ++f) {
    const double sides = (before[f] + behind[f]) + (below[f] + above[f]) + friction * voidage[f] * wall[f];
    pull[f] = voidage[f] * area[f] * solved[f];
    perDiagonal[f] = solved[f] / (inertia[f] + sides + coefficient[f]);
    rhs[f] = oldPart[f] + source[f] - weight * voidage[f] * volume[f] + pull[f] * (p[f - along] - p[f]);
  }
}

void sweep(const MomentumKernel& k, const FaceFamily& family, const double* from, double* to, Range faces) {
  const std::ptrdiff_t along = family.along, across = family.across;
  const double *before = k.before, *behind = k.behind, *below = k.below, *above = k.above;
  const double *rhs = k.rhs, *perDiagonal = k.perDiagonal;
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t f = first(faces); f < last(faces); ++f)
    to[f] = perDiagonal[f] * (rhs[f] + before[f] * from[f - along] + behind[f] * from[f + along] +
                              below[f] * from[f - across] + above[f] * from[f + across]);
}

void addNeighbourEffect(const MomentumKernel& k, const FaceFamily& family, const double* change,
                        double* velocity, Range faces) {
  const std::ptrdiff_t along = family.along, across = family.across;
  const double *before = k.before, *behind = k.behind, *below = k.below, *above = k.above;
  const double* perDiagonal = k.perDiagonal;
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t f = first(faces); f < last(faces); ++f)
    velocity[f] += perDiagonal[f] * (before[f] * change[f - along] + behind[f] * change[f + along] +
                                     below[f] * change[f - across] + above[f] * change[f + across]);
}

void correct(const MomentumKernel& k, const FaceFamily& family, const double* pressure, double* change,
             double* velocity, Range faces) {
  const std::ptrdiff_t along = family.along;
  const double *p = pressure - family.first, *perDiagonal = k.perDiagonal, *pull = k.pull;
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t f = first(faces); f < last(faces); ++f) {
    change[f] = pull[f] * perDiagonal[f] * (p[f - along] - p[f]);
    velocity[f] += change[f];
  }
}

}  // namespace

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(updateFlux);
HWY_EXPORT(updateSides);
HWY_EXPORT(setOldLevel);
HWY_EXPORT(assemble);
HWY_EXPORT(sweep);
HWY_EXPORT(addNeighbourEffect);
HWY_EXPORT(correct);

void MomentumKernel::updateFlux(double density, const double* velocity, const double* voidage,
                                Range faces) const {
  HWY_DYNAMIC_DISPATCH(updateFlux)(*this, density, velocity, voidage, faces);
}
void MomentumKernel::updateSides(const FaceFamily& family, std::ptrdiff_t other, double viscosity,
                                 double share, const double* voidage, Range faces) const {
  HWY_DYNAMIC_DISPATCH(updateSides)(*this, family, other, viscosity, share, voidage, faces);
}
void MomentumKernel::setOldLevel(const FaceFamily& family, double densityPerStep, double friction,
                                 const double* velocity, const double* voidage, Range faces) const {
  HWY_DYNAMIC_DISPATCH(setOldLevel)(*this, family, densityPerStep, friction, velocity, voidage, faces);
}
void MomentumKernel::assemble(const FaceFamily& family, double friction, double weight, const double* voidage,
                              const double* pressure, const double* coefficient, const double* source,
                              Range faces) const {
  HWY_DYNAMIC_DISPATCH(assemble)
  (*this, family, friction, weight, voidage, pressure, coefficient, source, faces);
}
void MomentumKernel::sweep(const FaceFamily& family, const double* from, double* to, Range faces) const {
  HWY_DYNAMIC_DISPATCH(sweep)(*this, family, from, to, faces);
}
void MomentumKernel::addNeighbourEffect(const FaceFamily& family, const double* change, double* velocity,
                                        Range faces) const {
  HWY_DYNAMIC_DISPATCH(addNeighbourEffect)(*this, family, change, velocity, faces);
}
void MomentumKernel::correct(const FaceFamily& family, const double* pressure, double* change,
                             double* velocity, Range faces) const {
  HWY_DYNAMIC_DISPATCH(correct)(*this, family, pressure, change, velocity, faces);
}

}  // namespace bedmix
#endif  // HWY_ONCE
