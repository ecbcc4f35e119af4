// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"

#include <string>
#include <string_view>
#include <vector>

// What an accuracy study tries: ways to compute one scene.

namespace bedmix {

/// One of them. Two settings of one name are the same.
struct Setting {
  std::string name;  // what makes it of the scene: arguments of `run --set`; sceneItself where nothing does
  Scene scene;
};
inline constexpr std::string_view sceneItself = "the scene itself";

/// A knob turned step by step, all else being equal: a line in the diagrams.
struct Sweep {
  struct Turn {
    double value;  // of the knob
    std::string setting;
  };
  std::string knob;       // "time.step, rk4"
  std::string unit;       // of the value; empty where it is none that an order could be fitted over
  std::string reference;  // the setting whose particles those of the others are compared with
  std::vector<Turn> turns;
};

struct Design {
  std::vector<Setting> settings;  // the scene itself first
  std::vector<Sweep> sweeps;
  std::vector<std::string> statistics;  // settings whose statistics are taken
  std::vector<std::string> presets;     // those of them that are compared most closely
  struct Refused {
    std::string setting, why;
  };
  std::vector<Refused> refused;                  // presets that do not fit the scene
  std::string standard = "accuracy=standard";    // what costs are compared with
  std::string paper = "accuracy=paper";          // may be refused
  std::string reference = "accuracy=reference";  // what statistics are compared with

  const Setting& find(std::string_view name) const;
  /// Whether it differs from the scene itself in how contacts are advanced.
  bool turnsContacts(std::string_view name) const;
};

/// The designed set for a scene: integrators and steps, gas step, scheme and tolerance, stiffness, grid,
/// presets. Settings other than presets are made without the rules of the
/// scene reader, so that those which fail are tried, too.
/// Fails where `standard` or `reference` do not fit it.
Result<Design> designFor(const Scene& scene);

/// What `run --set` takes to make `changed` of `scene`, keys that differ only: "gas.step=2e-05 ...".
std::string settingName(const Scene& scene, const Scene& changed);

}  // namespace bedmix
