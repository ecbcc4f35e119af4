// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/models.h"
#include "engine/core/scene_reader.h"

#include <array>
#include <string_view>
#include <vector>

namespace bedmix {

/// A key and its value as TOML.
struct PresetKey {
  std::string_view path, value;
};

/// All numerics of a preset, the same keys in the same order in each. What they cost and what errors they
/// leave: assets/docs/accuracy.md.
using Preset = std::array<PresetKey, 7>;

namespace detail {

constexpr Preset preset(std::string_view integrator, std::string_view step, std::string_view error,
                        std::string_view gasStep, std::string_view gasError, std::string_view scheme,
                        std::string_view tolerance) {
  return {{{"time.integrator", integrator},
           {"time.step", step},
           {"time.error", error},
           {"gas.step", gasStep},
           {"gas.error", gasError},
           {"gas.scheme", scheme},
           {"gas.tolerance", tolerance}}};
}

}  // namespace detail

/// By Accuracy.
inline constexpr std::array presets{
    detail::preset("'verlet-onset'", "'auto'", "0.1", "'auto'", "0.4", "'projection'", "1e-4"),
    detail::preset("'verlet-onset'", "'auto'", "0.003", "'auto'", "0.015", "'projection'", "1e-6"),
    detail::preset("'rk4'", "1e-5", "0.003", "1e-4", "0.015", "'simple'", "1e-6"),
    detail::preset("'verlet-onset'", "'auto'", "2e-4", "'auto'", "0.005", "'projection'", "1e-8"),
};

constexpr const Preset& presetOf(Accuracy accuracy) { return presets[static_cast<std::size_t>(accuracy)]; }

/// What `--accuracy name` does to a scene: sets its key `accuracy` and removes what would win over it.
std::vector<Override> accuracyOverrides(const std::string& name);

}  // namespace bedmix
