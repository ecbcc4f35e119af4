// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_scene.h"
#include "replay/foreign/foreign_tracer.h"
#include "replay/recorded_frames.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace bedmix {

/// Frames of another program's file as those of a bed in the plane: its lower left corner is the origin, what
/// lies along the line of sight is left out, and rows are in order of id. Velocities are 0 where the file has
/// none: differences of places would be means over an interval. Particles may enter and leave.
class ForeignFrames final : public RecordedFrames {
 public:
  /// `file` is what messages call it. Fails on a file that the options say too little of.
  static Result<ForeignFrames> make(std::unique_ptr<ForeignSource> source, const std::filesystem::path& file,
                                    const ForeignOptions& options);

  const Scene& scene() const override { return made_.scene; }
  const Provenance& provenance() const override { return provenance_; }
  const std::vector<RunEvent>& events() const override { return events_; }
  const std::vector<double>& times() const override { return times_; }
  /// Fails, too, where a particle is there twice, or the file cannot be told in the precision of frames.
  Result<FramePtr> frame(std::size_t index) override;

 private:
  ForeignFrames(std::unique_ptr<ForeignSource> source, std::string file, std::vector<double> times,
                ForeignScene made, ForeignTracer tracer);

  std::unique_ptr<ForeignSource> source_;
  std::string file_;
  std::vector<double> times_;  // s
  ForeignScene made_;
  ForeignTracer tracer_;
  Provenance provenance_;
  std::vector<RunEvent> events_;
};

}  // namespace bedmix
