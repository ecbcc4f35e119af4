// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/gas/gas_fields.h"

#include <array>
#include <vector>

namespace bedmix {

/// The gas momentum balance, Tian et al. (2007), Eq. (9), on the staggered volumes, with continuity
/// subtracted (so that a uniform flow stays uniform):
///   rho eps V (u - u_old)/dt + sum over sides a (u - u_side) = -eps A dp - K u + S + rho eps V g
/// with power-law convection (Patankar 1980), central diffusion of eps mu grad u, drag implicit. Convection
/// and diffusion are weighted between the time levels by theta (1/2 Crank-Nicolson, 1 implicit Euler).
class MomentumSystem {
 public:
  MomentumSystem(const Scene& scene, const FaceLayout& layout);

  /// Fixes the old time level: `gas` holds velocity and face voidage at the start of the step.
  void beginStep(const GasFields& gas);
  /// Sets up the equations for the new level; `gas` holds the present estimate of it, whose fluxes convect.
  void assemble(const GasFields& gas, const MomentumExchange& exchange);
  /// Under-relaxes the assembled equations by `factor` around the present velocity (SIMPLE).
  void relax(const GasFields& gas, double factor);
  /// Sum of |residual| over sum of |diagonal * velocity|, for the pressure in `gas`.
  double residual(const GasFields& gas) const;
  /// Solves for the velocities at the pressure in `gas` by Gauss-Seidel sweeps in alternating order; the
  /// diagonal dominates as long as the gas Courant number is moderate. Returns the number of sweeps.
  int solve(GasFields& gas) const;
  /// sum of a_side * change of the neighbours over the diagonal, per volume: what a velocity correction
  /// changes through its neighbours (PISO's second corrector).
  void neighbourEffect(const std::vector<double>& change, std::vector<double>& effect) const;

  /// Velocity change per pressure difference, -du / d(p_plus - p_minus), per volume.
  double mobility(std::size_t volume) const { return mobility_[volume]; }

 private:
  double pressureForce(std::size_t k, const GasFields& gas) const;
  void sideCoefficients(const GasFields& gas, std::vector<std::array<double, 4>>& a) const;

  const FaceLayout& layout_;
  double density_, viscosity_, step_, theta_, gravity_;
  std::vector<double> flux_;  // mass flux per face, kg/s
  std::vector<double> oldVelocity_, oldVoidage_;
  std::vector<double> oldPart_;  // explicit share of convection and diffusion, N
  std::vector<std::array<double, 4>> side_;
  std::vector<double> diagonal_, rhs_, mobility_;
};

}  // namespace bedmix
