// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/thread_team.h"
#include "engine/coupling/drag_laws.h"
#include "engine/coupling/exchange_kernel.h"
#include "engine/coupling/voidage.h"
#include "engine/dem/particles.h"
#include "engine/gas/gas_solver.h"

#include <cstdint>
#include <vector>

namespace bedmix {

/// Momentum between gas and particles, once a gas step. A particle's drag is B (u - v), B = V_p beta/(1-eps)
/// (Tian et al. 2007, Eq. 2), u interpolated bilinearly from the staggered faces. B and u are held over the
/// particle steps of one gas step, v is the particle's own at any time: however strong the drag, it relaxes
/// to the gas and does not overshoot. The gas is charged beforehand, as if v stayed what it is, by the same B
/// and the same weights; where the particle then comes out elsewhere than foreseen, the difference B (x -
/// foreseen) is settled in the next gas step. So what one phase gives is what the other gets, to round-off,
/// one gas step later. The pressure force -V_p grad p takes grad p from the cells by the shares of the
/// voidage, for the same reason.
class Exchange {
 public:
  /// What is given by reference must outlive the exchange.
  Exchange(const Scene& scene, const GasSolver& gas, const VoidageField& voidage, ThreadTeam& team);

  /// Length of the gas step that comes, s; the scene's until this is called.
  void setStep(double seconds) { step_ = seconds; }
  /// Sets the particles' drag coefficients by the present gas velocity and a voidage that is up to date;
  /// fills the gas's exchange. The particles must have external forces.
  void evaluateDrag(Particles& particles, MomentumExchange& exchange);
  /// Sets the particles' external forces from the gas as it is after its step.
  void applyForces(Particles& particles);
  /// The loops over the particles, with the gas velocity that one of these two has seen last.
  ExchangeKernel kernel(Particles& particles) const;
  /// Adds blocks' sums to the gas's exchange, in their order, at the points in a part of the grid's columns.
  void addToFaces(const std::vector<BlockSum<FaceSums>>& sums, Range columns,
                  MomentumExchange& exchange) const;

 private:
  /// Weights of the two faces of a cell in its pressure gradient along one axis: their mean; at a boundary
  /// face, which has no gradient of its own, the other one alone.
  struct FaceWeights {
    float before = 0.0f, after = 0.0f;
  };
  static FaceWeights weights(bool before, bool after);
  void copyVelocity(Range points);
  void copyPressure(Range rows);
  void findGradient(Range columns);

  const GasSolver& gas_;
  const VoidageField& voidage_;
  const CouplingGrid& grid_;
  ThreadTeam& team_;
  DragLaw law_;
  DragProperties properties_;
  double step_;  // of the gas, s
  std::vector<BlockSum<FaceSums>> sums_;
  // Per point of the grid: gas velocity, m/s, and pressure, Pa, with its gradient, Pa/m.
  std::vector<double> uprightVelocity_, levelVelocity_, pressure_;
  std::vector<Vec2> gradient_;
  std::vector<std::int32_t> uprightFace_, levelFace_;  // per point: its owners in the gas's numbering
  std::vector<FaceWeights> across_, up_;               // per cell
  std::vector<double> perDistanceX_, perDistanceY_;  // per face: of the centres beside it, 1/m; to the outlet
};

}  // namespace bedmix
