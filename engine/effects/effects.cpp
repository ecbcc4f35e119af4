// SPDX-License-Identifier: MIT
#include "engine/effects/effects.h"

#include "engine/core/particle_list.h"

#include <fmt/format.h>

#include <array>
#include <numbers>

namespace bedmix {

namespace {

bool hasGas(const Scene& scene) { return scene.gas.has_value(); }
std::string gasNote(const Scene& scene) {
  const auto& gas = scene.gas;
  if (!gas) return "no table [gas]";
  return fmt::format("{}, {}, drag {}", modelName(gas->scheme), modelName(gas->timeScheme),
                     modelName(gas->drag));
}

bool hasFriction(const Scene& scene) { return scene.contacts.friction.has_value(); }
std::string frictionNote(const Scene& scene) {
  const auto& friction = scene.contacts.friction;
  if (!friction) return "no table [contacts.friction]; no rotation either";
  return fmt::format("coefficient {:g}; particles rotate", friction->coefficient);
}

bool hasHertz(const Scene& scene) { return scene.contacts.hertz.has_value(); }
std::string hertzNote(const Scene& scene) {
  const auto& hertz = scene.contacts.hertz;
  if (!hertz) return "no table [contacts.hertz]; springs are linear";
  return fmt::format("Young's modulus {:g} Pa", hertz->youngsModulus);
}

bool hasRolling(const Scene& scene) { return scene.contacts.rolling.has_value(); }
std::string rollingNote(const Scene& scene) {
  const auto& rolling = scene.contacts.rolling;
  if (!rolling) return "no table [contacts.rolling]";
  return fmt::format("{}, coefficient {:g}", modelName(rolling->model), rolling->coefficient);
}

std::string mixedNote(const Scene& scene) {
  if (!isMixed(scene)) return "all particles are alike; no [particles.size] or [[particles.species]]";
  const ParticleRange range = particleRange(scene);
  return fmt::format("kinds: {}, diameters from {:.3g} to {:.3g} m", particleKinds(scene).size(),
                     range.smallest, range.largest);
}

bool hasCohesion(const Scene& scene) { return scene.effects.find<CohesionSettings>() != nullptr; }
std::string cohesionNote(const Scene& scene) {
  const CohesionSettings* cohesion = scene.effects.find<CohesionSettings>();
  if (!cohesion) return "no table [cohesion]";
  const char* law = cohesion->vanDerWaals    ? "van der Waals"
                    : cohesion->liquidBridge ? "liquid bridges"
                                             : "by area";
  return fmt::format("{}, up to gaps of {:.3g} m", law, cohesionRange(scene));
}

bool hasHeat(const Scene& scene) { return scene.effects.find<HeatSettings>() != nullptr; }
std::string heatNoteOf(const Scene& scene) { return hasHeat(scene) ? heatNote(scene) : "no table [heat]"; }

bool hasReaction(const Scene& scene) { return scene.effects.find<ReactionSettings>() != nullptr; }
std::string reactionNote(const Scene& scene) {
  const ReactionSettings* reaction = scene.effects.find<ReactionSettings>();
  if (!reaction) return "no table [reaction]";
  return fmt::format("content {:g}, {}, rate {:g} 1/s", reaction->content, modelName(reaction->model),
                     reaction->rate);
}

bool hasFeed(const Scene& scene) { return scene.effects.find<FeedSettings>() != nullptr; }
std::string feedNote(const Scene& scene) {
  const FeedSettings* feed = scene.effects.find<FeedSettings>();
  if (!feed) return "no table [feed]";
  return fmt::format("{:g} 1/s in by {} streams, {} outlets, at most {} particles", feedRate(scene),
                     feed->streams.size(), feed->outlets.size(), feed->most);
}

bool hasLift(const Scene& scene) { return scene.effects.find<LiftSettings>() != nullptr; }
std::string liftNote(const Scene& scene) {
  const LiftSettings* lift = scene.effects.find<LiftSettings>();
  if (!lift) return "no table [lift]";
  return fmt::format("by shear: {}, by spin: {}", modelName(lift->shear), modelName(lift->spin));
}

bool hasVirtualMass(const Scene& scene) { return scene.effects.find<VirtualMassSettings>() != nullptr; }
std::string virtualMassNote(const Scene& scene) {
  const VirtualMassSettings* settings = scene.effects.find<VirtualMassSettings>();
  if (!settings) return "no table [virtual_mass]";
  return fmt::format("{:g} of the gas displaced, crowding {}", settings->coefficient,
                     modelName(settings->crowding));
}

bool hasObstacles(const Scene& scene) { return !scene.obstacles.empty(); }
std::string obstaclesNote(const Scene& scene) {
  if (scene.obstacles.empty()) return "no tables [[obstacles]]";
  std::size_t turning = 0;
  for (const ObstacleSettings& o : scene.obstacles) turning += o.spinRpm.value_or(0.0) != 0.0;
  return fmt::format("{} of them, {} turning", scene.obstacles.size(), turning);
}

bool isPeriodic(const Scene& scene) { return scene.bed.sides == BedSides::periodic; }
std::string sidesNote(const Scene& scene) {
  if (!isPeriodic(scene)) return "bed.sides is \"walls\"";
  return fmt::format("what leaves at x = {:g} m comes in at x = 0", scene.bed.width);
}

bool vibrates(const Scene& scene) { return scene.floor.vibration.has_value(); }
std::string vibrationNote(const Scene& scene) {
  const auto& vibration = scene.floor.vibration;
  if (!vibration) return "no table [floor.vibration]";
  const double rate = 2.0 * std::numbers::pi * vibration->frequency;
  const double acceleration = vibration->amplitude * rate * rate;
  return scene.gravity > 0.0 ? fmt::format("acceleration up to {:.3g} m/s2, {:.3g} g", acceleration,
                                           acceleration / scene.gravity)
                             : fmt::format("acceleration up to {:.3g} m/s2", acceleration);
}

constexpr std::array table{
    EffectInfo{"bed.sides", "periodic sides", isPeriodic, sidesNote},
    EffectInfo{"floor.vibration", "vibration of the floor", vibrates, vibrationNote},
    EffectInfo{"obstacles", "obstacles", hasObstacles, obstaclesNote},
    EffectInfo{"particles.size", "sizes", [](const Scene& s) { return s.particles.size.has_value(); },
               mixedNote},
    EffectInfo{"particles.species", "species", [](const Scene& s) { return !s.particles.species.empty(); },
               mixedNote},
    EffectInfo{"gas", "gas", hasGas, gasNote},
    EffectInfo{"contacts.hertz", "Hertzian contacts", hasHertz, hertzNote},
    EffectInfo{"contacts.friction", "friction", hasFriction, frictionNote},
    EffectInfo{"contacts.rolling", "rolling resistance", hasRolling, rollingNote},
    EffectInfo{"cohesion", "cohesion", hasCohesion, cohesionNote},
    EffectInfo{"heat", "heat", hasHeat, heatNoteOf},
    EffectInfo{"reaction", "reaction", hasReaction, reactionNote},
    EffectInfo{"feed", "feed", hasFeed, feedNote},
    EffectInfo{"lift", "lift", hasLift, liftNote},
    EffectInfo{"virtual_mass", "virtual mass", hasVirtualMass, virtualMassNote},
};

}  // namespace

std::span<const EffectInfo> effectTable() { return table; }

}  // namespace bedmix
