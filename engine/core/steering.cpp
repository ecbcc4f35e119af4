// SPDX-License-Identifier: MIT
#include "engine/core/steering.h"

#include "engine/core/scene_keys.h"
#include "engine/effects/effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

namespace bedmix {

namespace {

struct Fixed {
  std::string_view path;  // a key, or a table with all that is in it
  std::string_view reason;
};

constexpr std::string_view arranged = "the bed has been arranged with it";
constexpr std::string_view built = "the walls and the cells of the gas have been built of it";
constexpr std::string_view filled = "the bed has been filled with them";
constexpr std::string_view reached = "neighbours have been looked for within its range";
constexpr std::string_view counted = "times are counted in it";

/// All that is fixed; whatever else there is may change.
constexpr std::array fixedSettings{
    Fixed{"seed", arranged},
    Fixed{"accuracy", "it gives the values that a scene leaves open, and none is"},
    Fixed{"bed", built},
    Fixed{"floor", built},
    Fixed{"obstacles", built},
    Fixed{"contacts.pairs.first", filled},
    Fixed{"contacts.pairs.second", filled},
    Fixed{"contacts.rolling.model", "what contacts keep from step to step is its own"},
    Fixed{"cohesion.van_der_waals.cutoff", reached},
    Fixed{"cohesion.liquid_bridge.volume", reached},
    Fixed{"cohesion.liquid_bridge.contact_angle_deg", reached},
    Fixed{"particles", filled},
    Fixed{"time.duration", "a run that is steered goes on until it is ended"},
    Fixed{"time.step", counted},
    Fixed{"time.integrator", "what contacts keep from step to step is its own"},
    Fixed{"start", arranged},
    Fixed{"tracer", "it chose the tracer when the run began; choose that anew from where the particles are"},
    Fixed{"gas.step", counted},
    Fixed{"gas.grid", "the cells of the gas have been built of it"},
    Fixed{"sampling.interval", "frames fall on it"},
    Fixed{"heat.temperature", "the particles have begun with it"},
    Fixed{"heat.tracer_temperature", "the tracer has begun with it"},
    Fixed{"reaction.content", "the particles have begun with it"},
    Fixed{"feed.most", "room has been made for as many"},
    Fixed{"feed.streams.species", filled},
};

std::string fixedText(std::string_view path) {
  const std::string_view reason = reasonFixed(path);
  return reason.empty() ? "" : fmt::format("{} is fixed while a run goes on: {}", path, reason);
}

std::string switchText(const EffectInfo& effect, bool isOn) {
  return fmt::format("[{}] is fixed while a run goes on: this one has {}{}, which is part of its state",
                     effect.table, isOn ? "" : "no ", effect.name);
}

/// Why no value at all can be set there or removed; empty where one may.
std::string refusal(const Scene& scene, const Override& change) {
  for (const EffectInfo& effect : effectTable()) {
    const bool isOn = effect.isOn(scene), removes = change.path == effect.table && change.value.empty();
    if (isOn ? removes : isAtOrBelow(change.path, effect.table)) return switchText(effect, isOn);
  }
  return fixedText(change.path);
}

std::size_t streamsOf(const Scene& scene) {
  const FeedSettings* feed = scene.effects.find<FeedSettings>();
  return feed ? feed->streams.size() : 0;
}

/// What a change of a whole table or list has changed that must not be; empty where all may.
std::string refusal(const Scene& before, const Scene& after) {
  for (const EffectInfo& effect : effectTable())
    if (effect.isOn(before) != effect.isOn(after)) return switchText(effect, effect.isOn(before));
  if (before.gas && before.gas->inlets.size() != after.gas->inlets.size())
    return fmt::format("the number of inlets is fixed while a run goes on: there are {}, not {}",
                       before.gas->inlets.size(), after.gas->inlets.size());
  if (streamsOf(before) != streamsOf(after))
    return fmt::format("the number of streams is fixed while a run goes on: there are {}, not {}",
                       streamsOf(before), streamsOf(after));
  const std::vector<SceneSetting> then = sceneSettings(before), now = sceneSettings(after);
  const auto firstFixed = [](const std::vector<SceneSetting>& these,
                             const std::vector<SceneSetting>& others) {
    for (const SceneSetting& setting : these)
      if (std::find(others.begin(), others.end(), setting) == others.end())
        if (std::string text = fixedText(setting.path); !text.empty()) return text;
    return std::string();
  };
  std::string text = firstFixed(now, then);
  return text.empty() ? firstFixed(then, now) : text;
}

/// Of changes that together are wrong: the only one, or none of them.
SourceLocation placeOf(const std::vector<Override>& changes) {
  return changes.size() == 1 ? placeOf(changes.front()) : SourceLocation{};
}

}  // namespace

std::string_view reasonFixed(std::string_view path) {
  const std::string key = withoutNumbers(path);
  for (const Fixed& fixed : fixedSettings)
    if (isAtOrBelow(key, fixed.path)) return fixed.reason;
  return "";
}

Result<Scene> steeredScene(const Scene& scene, const std::vector<Override>& changes) {
  std::vector<Diagnostic> refused;
  for (const Override& change : changes)
    if (std::string why = refusal(scene, change); !why.empty())
      refused.push_back({placeOf(change), std::move(why)});
  if (!refused.empty()) return refused;

  // Its text is nobody's file: what is wrong there is so because of the changes.
  Result<Scene> steered = readScene(writeScene(scene), "", changes);
  for (Diagnostic& problem : steered.problems)
    if (problem.at.line > 0 || problem.at.file.empty()) problem.at = placeOf(changes);
  if (!steered) return steered;
  if (std::string why = refusal(scene, *steered); !why.empty())
    return Diagnostic{placeOf(changes), std::move(why)};
  steered->name = scene.name;
  steered->refinement = scene.refinement;
  steered->tickKept = tick(scene);
  return steered;
}

}  // namespace bedmix
