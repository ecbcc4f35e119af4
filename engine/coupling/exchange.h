// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/thread_team.h"
#include "engine/core/vec2.h"
#include "engine/coupling/drag_laws.h"
#include "engine/coupling/voidage.h"
#include "engine/dem/particles.h"
#include "engine/gas/gas_solver.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bedmix {

/// Momentum between gas and particles, once a gas step. A particle's drag is B (u - v), B = V_p beta/(1-eps)
/// (Tian et al. 2007, Eq. 2), u interpolated bilinearly from the staggered faces; the same B and the same
/// weights make the gas's implicit coefficient and source, so that what one phase gives is what the other
/// gets, to round-off. The pressure force -V_p grad p takes grad p from the cells by the shares of the
/// voidage, for the same reason. Both forces are then held over the particle steps of one gas step.
class Exchange {
 public:
  /// What is given by reference must outlive the exchange.
  Exchange(const Scene& scene, const GasSolver& gas, const VoidageField& voidage, ThreadTeam& team);

  /// Drag coefficients at the present particles and gas velocity; fills the gas's exchange.
  void evaluateDrag(const Particles& particles, MomentumExchange& exchange);
  /// Sets the particles' external force from the gas as it is after its step.
  void applyForces(Particles& particles);

 private:
  /// Bilinear interpolation from four upright and four level faces.
  struct FaceWeights {
    std::array<std::int32_t, 4> u{}, v{};
    std::array<double, 4> uWeight{}, vWeight{};
  };
  FaceWeights weightsAt(double x, double y) const;
  Vec2 gasVelocity(const FaceWeights& w) const;
  double dragCoefficient(std::size_t i, Vec2 velocity) const;
  /// Mean of a cell's two faces; at a boundary face, which has no gradient of its own, the other one alone.
  void updatePressureGradient();

  const GasSolver& gas_;
  const VoidageField& voidage_;
  ThreadTeam& team_;
  GridAxis columns_, rows_;
  DragFunction drag_;
  DragProperties properties_;
  double particleVolume_;
  std::vector<FaceWeights> weights_;  // per particle
  std::vector<double> coefficient_;   // per particle: B times its coupling, kg/s
  std::vector<char> solved_;          // per face: 0 at walls, risers and inlets
  std::vector<double> faceGradient_;  // of the pressure, Pa/m, at solved faces
  std::vector<Vec2> gradient_;        // of the pressure, per cell, Pa/m
};

}  // namespace bedmix
