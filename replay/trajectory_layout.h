// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

// What stands where in trajectory.h5, for its writer and its reader. T frames, N particles, gas cells in rows
// and columns. A time-dependent element is a group with `value` and the `step` and `time` that all of them
// share by hard links.
//
//   h5md                         version {1, 1}, author, creator
//   particles/all/box            dimension 2, boundary {"none", "none"}, edges {width, height}, m
//   particles/all/position       value[T][N][2] float, m
//   particles/all/velocity       value[T][N][2] float, m/s
//   particles/all/angular_velocity  value[T][N] float, rad/s; only with friction
//   particles/all/temperature    value[T][N] float, K; only with heat
//   particles/all/content        value[T][N] float, kg/kg; only with reaction
//   particles/all/species        [N], 1 = tracer
//   particles/all/id             [N]
//   particles/all/radius         [N] float, m; only where particles differ, like kind
//   particles/all/kind           [N] numbers of particleKinds()
//                                With a feed these four are value[T][N], too: N is then the most particles
//                                that there may be, who is there stands first, by id, and whoever is not has
//                                id -1
//   observables/...              value[T] double, NaN where undefined
//   parameters/scene             the scene as TOML, every default resolved
//   parameters/...               scene_name, seed, version, commit
//   bedmix/checkpoint/0, 1       bytes of the last two checkpoints, which are written by turns; see
//                                engine/checkpoint.h, and what follows one is left over from longer ones
//   bedmix/events/time           [events] double, s, when something happened to the run; see run_event.h
//   bedmix/events/kind, detail   [events] texts of fixed length
//   bedmix/gas/x, y              faces of the gas grid, m; only with gas, like all below
//   bedmix/gas/lowest_row        [columns], rows below are blocked
//   bedmix/gas/voidage           value[T][rows][columns] float
//   bedmix/gas/pressure          value[T][rows][columns] float, Pa above the outlet's
//   bedmix/gas/gas_velocity      value[T][rows][columns][2] float, m/s, interstitial
//   bedmix/gas/temperature       value[T][rows][columns] float, K; only with heat

namespace bedmix::layout {

inline constexpr const char* fileName = "trajectory.h5";

inline constexpr const char* particles = "particles/all";
inline constexpr const char* box = "particles/all/box";
inline constexpr const char* position = "particles/all/position";
inline constexpr const char* velocity = "particles/all/velocity";
inline constexpr const char* angularVelocity = "particles/all/angular_velocity";
inline constexpr const char* temperature = "particles/all/temperature";
inline constexpr const char* content = "particles/all/content";
inline constexpr const char* species = "particles/all/species";
inline constexpr const char* id = "particles/all/id";
inline constexpr const char* radius = "particles/all/radius";
inline constexpr const char* kind = "particles/all/kind";

inline constexpr const char* scene = "parameters/scene";
inline constexpr const char* sceneName = "parameters/scene_name";
inline constexpr const char* version = "parameters/version";
inline constexpr const char* commit = "parameters/commit";

inline constexpr const char* bedmix = "bedmix";
inline constexpr const char* checkpoint = "bedmix/checkpoint";
inline constexpr std::array checkpointSlots{"bedmix/checkpoint/0", "bedmix/checkpoint/1"};

inline constexpr const char* events = "bedmix/events";
inline constexpr const char* eventTime = "bedmix/events/time";
inline constexpr const char* eventKind = "bedmix/events/kind";
inline constexpr const char* eventDetail = "bedmix/events/detail";
inline constexpr std::size_t eventKindSize = 32, eventDetailSize = 480;  // bytes

inline constexpr const char* gas = "bedmix/gas";
inline constexpr const char* gasX = "bedmix/gas/x";
inline constexpr const char* gasY = "bedmix/gas/y";
inline constexpr const char* voidage = "bedmix/gas/voidage";
inline constexpr const char* pressure = "bedmix/gas/pressure";
inline constexpr const char* gasVelocity = "bedmix/gas/gas_velocity";
inline constexpr const char* gasTemperature = "bedmix/gas/temperature";

}  // namespace bedmix::layout
