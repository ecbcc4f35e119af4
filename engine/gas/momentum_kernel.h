// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"
#include "engine/gas/face_layout.h"

namespace bedmix {

/// The loops of MomentumSystem over faces of one family, in vectors; see there for what they compute. All
/// pointers are to one value a face, numbered as in FaceLayout.
struct MomentumKernel {
  // Geometry, from the layout.
  const double *area = nullptr, *volume = nullptr, *solved = nullptr, *wall = nullptr;
  const double *alongSide = nullptr, *acrossSide = nullptr;

  double* flux = nullptr;     // mass flux, kg/s
  double* inertia = nullptr;  // rho eps V / dt of the old level, kg/s
  double* oldPart = nullptr;  // what the old level contributes, N
  // Coefficients of the neighbours, kg/s: two along the velocity, two across it.
  double *before = nullptr, *behind = nullptr, *below = nullptr, *above = nullptr;
  double *rhs = nullptr, *perDiagonal = nullptr;
  double* pull = nullptr;  // force per pressure difference, m2

  void updateFlux(double density, const double* velocity, const double* voidage, Range faces) const;
  /// Each face sees to its lower sides, and so to two coefficients of its own and one of each face beyond
  /// them; all times `share`. `other` is how far the other family's faces are.
  void updateSides(const FaceFamily& family, std::ptrdiff_t other, double viscosity, double share,
                   const double* voidage, Range faces) const;
  /// `share` is that of the sides.
  void setOldLevel(const FaceFamily& family, double densityPerStep, double friction, const double* velocity,
                   const double* voidage, Range faces) const;
  /// `weight` is that of a volume of gas, N/m3; `pressure` a frame.
  void assemble(const FaceFamily& family, double friction, double weight, const double* voidage,
                const double* pressure, const double* coefficient, const double* source, Range faces) const;
  void sweep(const FaceFamily& family, const double* from, double* to, Range faces) const;
  void addNeighbourEffect(const FaceFamily& family, const double* change, double* velocity,
                          Range faces) const;
  /// Writes the change of velocity that a change of pressure, a frame, makes by itself, and adds it.
  void correct(const FaceFamily& family, const double* pressure, double* change, double* velocity,
               Range faces) const;
};

}  // namespace bedmix
