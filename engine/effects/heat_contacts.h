// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/particle_solver.h"
#include "engine/effects/heat_laws.h"

#include <optional>
#include <vector>

namespace bedmix {

/// Heat that particles pass on to those they touch and to walls, at their places in memory. What one of a
/// pair gives the other gets, and sums do not depend on the number of threads.
class ContactHeat {
 public:
  explicit ContactHeat(const Scene& scene);  // with heat

  /// Sets the flow to each particle, W, from the temperatures, K.
  void evaluate(const ParticleSolver& solver, const std::vector<double>& temperature,
                std::vector<double>& flow, ThreadTeam& team);

 private:
  void ownContacts(const ContactBlock& block, const ParticleSolver& solver,
                   const std::vector<double>& temperature, std::vector<double>& crossing,
                   std::vector<double>& flow) const;
  void wallContacts(const ContactBlock& block, const ParticleSolver& solver,
                    const std::vector<double>& temperature, std::vector<double>& flow) const;

  ConductionLaw law_;
  std::optional<double> wallTemperature_;      // K
  std::vector<std::vector<double>> crossing_;  // per block: what the first of each crossing contact gets, W
};

}  // namespace bedmix
