// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace bedmix {

/// Which particles are tracer, chosen anew from a recorded frame, as a user writes it:
///   left-half, lower-half, ...  a rule of `[tracer]`, see TracerRule
///   strips=N                    every other one of N upright strips of the bed's width, the leftmost first
///   layers=N                    every other one of N layers with as many particles each, the lowest first
///   an expression               that is not 0 for tracer, of x, y (m), vx, vy (m/s), id, species, width,
///   height
///                               (m): "x < width/3 && y > 0.02"
class TracerChoice {
 public:
  /// Fails on what is none of these; says where an expression is wrong.
  static Result<TracerChoice> parse(const std::string& text);

  /// 1 = tracer, a row each. Fails where the expression has no value for a particle.
  Result<std::vector<std::uint8_t>> tag(const Frame& frame, const Scene& scene) const;

 private:
  struct Strips {
    int count;
  };
  struct Layers {
    int count;
  };
  using Expression = std::string;
  using Kind = std::variant<TracerRule, Strips, Layers, Expression>;
  explicit TracerChoice(Kind kind) : kind_(std::move(kind)) {}

  Kind kind_;
};

/// The tracer as it was chosen at one instant, put into any frame: particles keep the colour they had then by
/// their ids; those that were not there are no tracer.
class Retagging {
 public:
  Retagging(const Frame& chosenAt, std::vector<std::uint8_t> tags);

  Frame applied(Frame frame) const;

 private:
  std::vector<std::int32_t> id_;  // increasing
  std::vector<std::uint8_t> tag_;
};

}  // namespace bedmix
