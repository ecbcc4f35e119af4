// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "engine/core/scene.h"
#include "engine/core/state_bytes.h"
#include "engine/core/thread_team.h"
#include "engine/gas/face_layout.h"
#include "engine/gas/gas_fields.h"
#include "engine/gas/member.h"
#include "engine/gas/momentum.h"
#include "engine/gas/pressure_solver.h"

#include <cstdint>
#include <vector>

namespace bedmix {

/// How one gas step went.
struct GasStepReport {
  bool solved = true;         // false: the equations are no longer finite
  bool converged = true;      // false: the outer loop met its limit (SIMPLE)
  double massResidual = 0.0;  // largest |imbalance| of a cell over the total inflow
  double courant = 0.0;       // largest |velocity| times the step over the size of the cell
};

/// Incompressible gas in the voids: volume-averaged continuity and momentum, Tian et al. (2007), Eqs (8) and
/// (9), on a staggered grid. No slip at the walls, given flux at the floor, zero gradient and zero pressure
/// at the top.
class GasSolver {
 public:
  /// Gas at rest, voidage 1. The team, which must outlive the solver, shares the steps of large grids;
  /// results do not depend on its size.
  GasSolver(const Scene& scene, ThreadTeam& team);

  const GasGrid& grid() const { return grid_; }
  const FaceLayout& layout() const { return layout_; }
  const GasFields& fields() const { return fields_; }
  /// Of each face, at the last step: times area and velocity the flow that satisfies continuity.
  const std::vector<double>& faceVoidage() const { return faceVoidage_; }
  MomentumExchange& exchange() { return exchange_; }
  const MomentumExchange& exchange() const { return exchange_; }

  /// Changes what enters, one superficial velocity a column, m/s, as in GasGrid::inletFlux; from the next
  /// step on.
  void setInletFlux(const std::vector<double>& superficial);
  /// Sets the voidage the gas starts with, so that the first step sees no jump.
  void startWith(const std::vector<double>& voidage);
  /// Where solids have come or gone at once, from the one voidage to the other (per cell): gas has changed
  /// places with them, so that none has to flow.
  void replaceSolids(const std::vector<double>& before, const std::vector<double>& after);
  /// Length of the steps from the next one on, s; the scene's until this is called.
  void setStep(double seconds);
  /// One step to the time at which `voidage` holds, with the particles' exchange() at that time. Where steps
  /// differ in length, voids have grown since the last one, but momentum is exchanged for as long as the
  /// particles will then feel it, which is this one's: what one phase gives is what the other gets.
  GasStepReport advance(const std::vector<double>& voidage);

  /// What the next step starts from, what enters included.
  void save(StateWriter& out) const;
  /// Into a solver of the same scene. False where `in` is not what save() wrote of one.
  [[nodiscard]] bool load(StateReader& in);

 private:
  GasStepReport step(Member& member, const std::vector<double>& voidage);
  GasStepReport project(Member& member);
  GasStepReport simple(Member& member);
  void takeVoidage(Member& member, const std::vector<double>& voidage);
  void updateFaceVoidage(Member& member);
  /// b of the pressure correction: minus each cell's imbalance, m3/s.
  void updateImbalance(Member& member);
  /// Its largest magnitude over the inflow; not a number where one is none.
  double massResidual(Member& member);
  double courant(Member& member);
  [[nodiscard]] bool preparePressure(Member& member);
  /// Solves for a pressure correction that closes continuity but for a share of `left`, and applies it to the
  /// velocities, and `pressureShare` of it to the pressure.
  void correct(Member& member, double pressureShare, double left);
  void publish(Member& member);

  GasGrid grid_;
  FaceLayout layout_;
  GasFields fields_;
  MomentumExchange exchange_;
  MomentumSystem momentum_;
  PressureSolver pressureSolver_;
  ThreadTeam* team_;  // null where the grid is too small to share
  GasScheme scheme_;
  double step_, sinceLast_, tolerance_;  // s, s, -
  std::int64_t maxIterations_;
  double inflow_ = 0.0;                                     // m3/s
  std::vector<double> faceVoidage_, conductance_, change_;  // per face
  std::vector<double> voidage_, growth_;                    // frames; growth of the voids in m3/s
  std::vector<double> pressure_, imbalance_, correction_;   // frames
  struct Residual {
    double largest = 0.0, sum = 0.0;
  };
  RowReduction<Residual> reduction_;
};

}  // namespace bedmix
