// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/gas/face_layout.h"
#include "engine/gas/gas_fields.h"
#include "engine/gas/member.h"
#include "engine/gas/momentum_kernel.h"

#include <array>
#include <vector>

namespace bedmix {

/// The gas momentum balance, Tian et al. (2007), Eq. (9), on the staggered volumes, with continuity
/// subtracted (so that a uniform flow stays uniform):
///   rho eps V (u - u_old)/dt + sum over sides a (u - u_side) = -eps A dp - K u + S + rho eps V g
/// with power-law convection (Patankar 1980), central diffusion of eps mu grad u, drag implicit. Convection
/// and diffusion are weighted between the time levels by theta (1/2 Crank-Nicolson, 1 implicit Euler).
/// All fields are per face but for pressures, which are frames. All members call its functions together; what
/// is handed in must be ready, what they change is their own rows and not waited for.
class MomentumSystem {
 public:
  MomentumSystem(const Scene& scene, const FaceLayout& layout);

  void setStep(double seconds) { step_ = seconds; }
  /// Fixes the old time level.
  void beginStep(Member& member, const std::vector<double>& velocity, const std::vector<double>& voidage);
  /// Sets up the equations for the new level around the present estimate, whose fluxes convect. `velocity`
  /// holds what enters at the floor.
  void assemble(Member& member, const std::vector<double>& velocity, const std::vector<double>& voidage,
                const std::vector<double>& pressure, const MomentumExchange& exchange);
  /// Under-relaxes the assembled equations by `factor` around the present velocity (SIMPLE).
  void relax(Member& member, const std::vector<double>& velocity, double factor);
  /// Sum of |residual| over sum of |diagonal * velocity|.
  double residual(Member& member, const std::vector<double>& velocity);
  /// Solves for the velocities by Jacobi sweeps. The diagonal dominates as long as the gas Courant number is
  /// moderate; each sweep then gains a digit and more.
  void solve(Member& member, std::vector<double>& velocity);

  /// Conductances of the faces for the pressure's equations: volume flux per pressure difference, m3/(s Pa),
  /// 0 where nothing is solved.
  void conductances(Member& member, std::vector<double>& conductance) const;
  /// Adds what a change of pressure does to the velocity by itself; writes that change.
  void correct(Member& member, const std::vector<double>& pressure, std::vector<double>& change,
               std::vector<double>& velocity) const;
  /// Adds sum of a_side * change of the neighbours over the diagonal: what a velocity correction changes
  /// through its neighbours (PISO's second corrector).
  void addNeighbourEffect(Member& member, const std::vector<double>& change,
                          std::vector<double>& velocity) const;

 private:
  Range faces(const Member& member, const FaceFamily& family) const;
  void updateSides(Member& member, const std::vector<double>& velocity, const std::vector<double>& voidage,
                   double share);
  void sweep(Member& member, const std::vector<double>& from, std::vector<double>& to) const;

  const FaceLayout& layout_;
  double density_, viscosity_, step_, theta_, gravity_;
  std::vector<double> spare_;                   // velocities between two sweeps
  std::array<std::vector<double>, 10> fields_;  // the kernel's
  MomentumKernel kernel_;
  struct Pair {
    double a = 0.0, b = 0.0;
  };
  RowReduction<Pair> reduction_;
};

}  // namespace bedmix
