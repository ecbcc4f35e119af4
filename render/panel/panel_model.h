// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/color.h"
#include "engine/core/frame.h"
#include "engine/core/sampling_grid.h"
#include "engine/core/scene_values.h"
#include "render/layout.h"
#include "render/style.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Everything the panel shows, free of where it comes from: a run that goes on or one that was recorded.

namespace bedmix {

/// A curve over time; its gaps are NaN.
struct PanelCurve {
  std::string_view name;
  Rgba color;
  std::vector<Vec2f> points;  // s and value
};
struct PanelChart {
  std::string_view title;
  std::vector<PanelCurve> curves;
  float low = 0.0f, high = 0.0f;  // of the axis; equal: as the curves need
  std::string label = {};         // whose they are, where there are several beds
};

/// A line of a table.
struct PanelFact {
  std::string name, value;
  float share = -1.0f;  // of a bar behind the value; none below 0
};

struct PanelInlet {
  std::string name;       // "0 to 96 mm"
  double velocity = 0.0;  // m/s, superficial
  double inUmf = 0.0;     // the same in multiples of u_mf
};

/// A key of the scene; `fixed` says why it cannot change now, and is empty where it can.
struct PanelParameter {
  SceneValue value;
  std::string_view fixed;
};

/// A bed as it is on the picture, for what is done to it there.
struct PanelBed {
  const Scene* scene = nullptr;
  const Frame* frame = nullptr;  // null where there is none yet
  Layout layout;
};

struct PickedParticle {
  std::size_t bed = 0;
  std::int32_t id = 0;
  friend bool operator==(PickedParticle, PickedParticle) = default;
};

struct PanelModel {
  bool isLive = true;
  std::string title;

  bool isPlaying = false;
  double time = 0.0, begin = 0.0, end = 0.0;  // s; of a live run, end is now
  double speed = 1.0;                         // simulated s per wall s: asked for, 0 for all there is
  double reached = 0.0;                       // the same of late
  std::size_t frame = 0, frames = 0;          // of a recorded run
  bool loops = false;
  std::vector<double> keyTimes;  // s, of marks and of what happened in the run

  std::string trouble;  // the run cannot go on
  std::string notice;   // what came of the last action

  std::vector<PanelInlet> inlets;  // none where there is no gas, or it cannot be changed
  double fastestInlet = 0.0;       // m/s, end of the sliders
  bool isGasOn = true;

  Style style;
  std::vector<std::string> missing;  // by Layer: why it cannot be shown, or empty
  std::string_view colorMissing;     // of ParticleColor::spin
  SamplingGrid grid;
  double indicesDone = 1.0;  // share of the frames the curves have seen

  std::vector<PanelChart> charts;
  std::vector<PanelFact> stages, numbers;
  std::vector<PanelParameter> parameters;

  std::vector<PanelBed> beds;
  std::optional<PickedParticle> picked;
  std::vector<PanelFact> particle;  // of it

  bool canRecord = false, isRecording = false;
  std::string recording;           // where to
  std::vector<std::string> saved;  // names of files, the newest last
};

}  // namespace bedmix
