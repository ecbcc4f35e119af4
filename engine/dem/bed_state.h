// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"
#include "engine/dem/contact_list.h"
#include "engine/dem/particles.h"

#include <chrono>
#include <vector>

namespace bedmix {

/// Wall seconds by stage.
struct DemSeconds {
  double neighbours = 0.0;
  double contacts = 0.0;
  double integrate = 0.0;
};

/// Adds the time since the last lap to a stage.
class LapTimer {
 public:
  void lap(double& stage) {
    const Clock::time_point now = Clock::now();
    stage += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

/// What integrators advance.
struct BedState {
  BedState(const Scene& scene, Particles start, const std::vector<WallSegment>& walls, ThreadTeam& team);

  Particles particles;
  ContactList contacts;
  std::vector<Load> loads;  // of contacts, at the last evaluation
  /// What contacts are evaluated at: within advance() positions stand here, and velocities and spins
  /// predicted to the end of the step.
  std::vector<Body> bodies;
  std::vector<double> spinAhead;
  SkinBudget budget;
  double gravity;     // m/s2, downward
  double step;        // s
  double time = 0.0;  // s, of the particles; asked for where walls move
  ThreadTeam& team;
  DemSeconds seconds;

  /// With which a wall comes to meet a particle, m/s.
  double fastestWall() const;
  /// Puts the bodies where the particles are.
  void placeBodies();
  /// Sorts the particles in space, for a new contact list; false where not all are at finite places. Loads
  /// are zero afterwards.
  bool sort();

  /// With all of the particles, but lists, loads and budget only once the lists have been made (`begun`).
  void save(StateWriter& out, bool begun) const;
  /// Into a bed of the same scene whose lists have not been made. False where `in` is not what save() wrote
  /// of it.
  [[nodiscard]] bool load(StateReader& in, bool begun);
};

}  // namespace bedmix
