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
  double gravity;  // m/s2, downward
  double step;     // s
  /// The particles' clock, which tells where walls are that move: `clockSteps` steps after `clockStart`, s.
  /// Counted, so that a step's time does not depend on how steps are grouped.
  double clockStart = 0.0;
  std::int64_t clockSteps = 0;
  double timeAfter(double steps) const {
    return clockStart + (static_cast<double>(clockSteps) + steps) * step;
  }
  ThreadTeam& team;
  DemSeconds seconds;

  /// With which a wall comes to meet a particle, m/s.
  double fastestWall() const;
  /// Puts the bodies where the particles are.
  void placeBodies();
  /// Where sides are periodic: moves who has left the bed to its other side, with all that is known of the
  /// place. `place(i)` tells where the i-th is.
  template <class Place>
  void comeIn(const Place& place) {
    const Period& period = contacts.period();
    if (!period.isOn()) return;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const double shift = period.shiftOf(place(i).x);
      if (shift == 0.0) continue;
      particles.position[i].x += shift;
      bodies[i].position.x += shift;
      if (!particles.foreseen.empty()) particles.foreseen[i].x += shift;
    }
  }
  /// Sorts the particles in space, for a new contact list; false where not all are at finite places. Loads
  /// are zero afterwards.
  bool sort();

  /// Particles go to `places` in memory, which ascend, or away where that is negative; newcomers stand behind
  /// them. Loads and what contacts remember go with them, lists have to be made anew.
  void exchange(const std::vector<std::int32_t>& places, const std::vector<PopulationChange::Newcomer>& come);

  /// With all of the particles, but lists, loads and budget only once the lists have been made (`begun`).
  void save(StateWriter& out, bool begun) const;
  /// Into a bed of the same scene whose lists have not been made. False where `in` is not what save() wrote
  /// of it.
  [[nodiscard]] bool load(StateReader& in, bool begun);
};

}  // namespace bedmix
