// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/image.h"
#include "render/style.h"

#include <optional>
#include <span>
#include <vector>

namespace bedmix {

/// Keeps, for each wanted time, the last frame at or before it.
class FramesAt final : public FrameSink {
 public:
  explicit FramesAt(std::vector<double> times);  // s; in any order
  void accept(const Frame& frame) override;
  /// One frame a time, in the order of the times. A time before the first frame, or more than half a frame
  /// interval after the last one, is outside the run.
  Result<std::vector<FramePtr>> frames() const;

 private:
  std::vector<double> times_;
  std::vector<FramePtr> frames_;
  std::optional<double> last_;  // time of the newest frame
  double interval_ = 0.0;       // to the one before it
};

/// Times of a sheet that shows a run of this length, s: the paper's 0, 0.5, 1, 2, 3, ... as far as the run
/// goes, at most nine; evenly spaced ones for a run shorter than a second.
std::vector<double> defaultSheetTimes(double duration);

/// Contact sheet like Tian et al. (2007), Figs 4 and 8: the frames side by side, up to nine in a row, each
/// under its time; one camera for all, cropped to what the particles reach; one scale bar; white ground.
/// Drawn for a print 190 mm wide at 300 dpi: write it with PngOptions::dpi = sheetDpi.
Result<Image> drawSheet(const Scene& scene, std::span<const FramePtr> frames,
                        Layers layers = {Layer::particles, Layer::walls});
inline constexpr double sheetDpi = 300.0;

}  // namespace bedmix
