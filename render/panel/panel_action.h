// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene_reader.h"
#include "render/panel/panel_model.h"

#include <optional>
#include <variant>
#include <vector>

namespace bedmix {

/// What a person wants, as the panel understood it.
struct PanelAction {
  struct Play {
    bool on = true;
  };
  struct Step {  // by so many frames; a live run only goes forward
    int frames = 1;
  };
  struct Restart {};
  struct Seek {
    double time = 0.0;  // s
  };
  struct Speed {
    double speed = 0.0;  // simulated s per wall s, 0 for all there is
  };
  struct Loop {
    bool on = true;
  };
  struct Mark {};  // the present time
  struct Change {  // of the scene
    std::vector<Override> values;
  };
  struct GasOn {
    bool on = true;
  };
  struct Tag {
    TracerRule rule{};
  };
  struct Restyle {
    Style style;
  };
  struct Resample {
    int columns = 1, rows = 1, minParticles = 1;
  };
  struct Pick {
    std::optional<PickedParticle> particle;
  };
  struct Record {
    bool film = false;
  };
  struct StopRecording {};
  struct SavePicture {};
  struct SaveScene {};

  std::variant<Play, Step, Restart, Seek, Speed, Loop, Mark, Change, GasOn, Tag, Restyle, Resample, Pick,
               Record, StopRecording, SavePicture, SaveScene>
      what;
};

}  // namespace bedmix
