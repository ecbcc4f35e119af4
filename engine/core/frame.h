// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/vec2.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace bedmix {

/// Gas fields of a frame, one value a cell of the scene's gas grid, row-major, bottom row first; blocked
/// cells hold voidage 1, pressure 0, velocity 0 and the temperature that the gas began with. Velocity is
/// interstitial, averaged from the cell's faces.
struct GasFrame {
  std::vector<float> voidage;
  std::vector<float> pressure;          // Pa above the outlet's
  std::vector<Vec2f> velocity;          // m/s
  std::vector<float> temperature = {};  // K; empty where the scene has no heat
};

/// The bed at one instant, and the only thing the solver, the file, the indices and the pictures exchange.
/// Here, and nowhere else, double becomes float, so that a recorded frame and a live one are the same to
/// everything downstream. Rows are in the order of `id` and, in a run of bedmix, keep it from first to last.
struct Frame {
  std::int64_t step = 0;
  double time = 0.0;                   // s
  std::vector<Vec2f> position;         // m
  std::vector<Vec2f> velocity;         // m/s
  std::vector<float> angularVelocity;  // rad/s, counter-clockwise; empty where the scene has no friction
  std::vector<float> temperature;      // K; empty where the scene has no heat
  std::vector<float> content;          // kg/kg; empty where the scene has no reaction
  std::vector<std::uint8_t> species;   // 1 = tracer (black), 0 = the rest (green)
  std::vector<std::int32_t> id;        // other programs' particles enter and leave: follow them by it
  /// Of particles that are not all alike; else empty.
  std::vector<float> radius;       // m
  std::vector<std::uint8_t> kind;  // number of particleKinds()
  GasFrame gas;                    // empty where the scene has no gas

  std::size_t size() const { return position.size(); }
  bool hasGas() const { return !gas.voidage.empty(); }
};
using FramePtr = std::shared_ptr<const Frame>;

/// Where frames come from: a running simulation or a trajectory file. Null after the last.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual FramePtr next() = 0;
};

/// What is done with frames, in order: recording, indices, pictures.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void accept(const Frame& frame) = 0;
};

/// Feeds every frame of `from` to every sink.
inline void drain(FrameSource& from, std::span<FrameSink* const> into) {
  while (FramePtr frame = from.next())
    for (FrameSink* sink : into) sink->accept(*frame);
}

}  // namespace bedmix
