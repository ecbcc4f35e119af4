// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/hash.h"
#include "engine/core/scene.h"
#include "engine/core/walls.h"
#include "engine/dem/contact_law.h"
#include "engine/dem/integrator.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace bedmix {

/// Why a bed cannot be advanced further.
struct DemTrouble {
  /// Something is not finite; overlaps above the scene's limit; moves further in a step than
  /// furthestInAStep.
  enum class Kind { nonFinite, overlap, speed };
  std::int64_t particle = -1;
  double value = 0.0;  // the value that is not finite; overlap or way in a step, in diameters
  Kind kind = Kind::overlap;
  const char* stage = "";  // where it was noticed: "start", "drag", "contacts" or "integrate"
  std::int64_t steps = 0;  // of the call to advance() that had been taken by then
};

/// Diameters. Who goes through a wall at this or less is within reach of it, and seen to overlap it by more
/// than a tenth of a diameter, in one step at least.
inline constexpr double furthestInAStep = 0.5;

/// Soft spheres after Tian et al. (2007), Eqs (1) and (5) to (7), advanced in time under gravity, contacts
/// and external forces. Contact law and integrator are composed when the solver is made. Two solvers of the
/// same start are the same to the bit, whatever the number of threads.
class ParticleSolver {
 public:
  /// `start` may overlap; it is not moved before the first advance(). `team` must outlive the solver.
  static std::unique_ptr<ParticleSolver> make(const Scene& scene, Particles start,
                                              const std::vector<WallSegment>& walls,
                                              ThreadTeam& team = oneThread());
  virtual ~ParticleSolver() = default;

  /// Length of the steps from now on, s; the scene's until this is called. save() leaves it out.
  void setStep(double seconds) {
    setTime(bed_.timeAfter(0.0));
    bed_.step = seconds;
  }
  /// What the time is, by which walls move; without moving ones it need not be told: so many steps (of the
  /// present length) after `seconds`. advance() goes on from it. save() leaves it out.
  void setTime(double seconds, std::int64_t steps = 0) {
    bed_.clockStart = seconds;
    bed_.clockSteps = steps;
  }
  /// Takes `steps` steps. Empty when all is well; else the bed must not be advanced
  /// further.
  [[nodiscard]] virtual std::optional<DemTrouble> advance(std::int64_t steps) = 0;

  /// Lets particles go and others come, between calls of advance().
  void exchange(const PopulationChange& change);
  /// Who is there.
  const Roster& roster() const { return roster_; }

  /// External forces, spins and the inertia of virtual mass may be changed between calls of advance(),
  /// everything else only before the first. The
  /// order in memory changes from call to call.
  Particles& particles() { return bed_.particles; }
  const Particles& particles() const { return bed_.particles; }
  /// Who may touch whom, by places in memory; from the first advance() on.
  const ContactList& contacts() const { return bed_.contacts; }
  /// One of their walls, where it is now.
  WallShape wallNow(std::size_t wall) const { return bed_.contacts.walls()[wall].at(bed_.timeAfter(0.0)); }

  /// Deepest contact since the start, of the smallest diameter, and the id of one whose it was (-1 without
  /// any).
  double largestOverlap() const { return deepestOverlap(bed_) / smallest_; }
  std::int64_t largestOverlapParticle() const;
  /// The largest speed after the last call of advance(), m/s, and whose it was.
  struct Fastest {
    std::int64_t particle = -1;
    double speed = 0.0;
  };
  Fastest fastest() const { return fastest_; }
  /// The hardest impact, m/s, that is going on or may begin within `span` (s), see closing_speed.h; infinite
  /// where the bed cannot be advanced.
  double closingSpeed(double span);
  /// Touching pairs and wall contacts at the last step.
  std::int64_t contactCount() const;
  std::int64_t neighbourBuilds() const { return bed_.contacts.builds(); }
  /// Wall seconds since the start.
  const DemSeconds& seconds() const { return bed_.seconds; }

  double kineticEnergy() const;    // J, with rotation
  double elasticEnergy() const;    // J, normal and tangential springs; from the first advance() on
  double potentialEnergy() const;  // J, of gravity, above y = 0

  /// Everything the future depends on but the external forces: positions, velocities, spins and tangential
  /// springs, the springs in the order of the ids of those that touch.
  void hashInto(StateHash& hash) const;

  /// Everything the future depends on to the last bit, the order in memory and the age of the lists included.
  void save(StateWriter& out) const;
  /// Into a solver of the same scene, walls and number of particles that has not been advanced. False where
  /// `in` is not what save() wrote of one; then the solver must not be used.
  [[nodiscard]] bool load(StateReader& in);

 protected:
  ParticleSolver(const Scene& scene, Particles start, const std::vector<WallSegment>& walls,
                 ThreadTeam& team);

  BedState bed_;
  Fastest fastest_;
  bool begun_ = false;  // lists have been made

 private:
  virtual void goOn() = 0;
  virtual void relist() = 0;

  SpringDashpot pairLaw_, wallLaw_;
  std::optional<ContactEffects> effects_;
  Roster roster_;
  double smallest_;  // diameter, m
};

}  // namespace bedmix
