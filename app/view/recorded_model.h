// SPDX-License-Identifier: MIT
#pragma once

#include "app/recorded_runs.h"
#include "app/view/run_scan.h"
#include "app/view/view_model.h"
#include "engine/live_run.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// Recorded runs, played side by side by one clock.
class RecordedModel final : public ViewModel {
 public:
  /// `runs` are opened from `names` with the options. With a ticked pace pictures wait for what is derived
  /// from all frames, so that they are the same each time.
  RecordedModel(std::vector<RecordedRun> runs, const std::vector<std::string>& names,
                const RecordingOptions& options, Pace pace);

  void refresh(double seconds) override;
  void act(const PanelAction& action) override;
  void describe(PanelModel& panel) const override;
  const std::vector<ViewBed>& beds() const override { return beds_; }
  std::uint64_t version() const override { return version_; }

 private:
  struct Source {
    RecordedRun run;
    std::unique_ptr<RunScan> scan;
    std::shared_ptr<const RunScan::Found> found;
    std::shared_ptr<const Retagging> tags;
    std::size_t shown = static_cast<std::size_t>(-1);  // frame
  };
  void seek(double time);
  void show(Source& source, ViewBed& bed);
  void step(int frames);
  void mark();
  void retag(TracerRule rule);
  void resample(const PanelAction::Resample& cells);
  void ask();

  std::vector<Source> sources_;
  std::vector<ViewBed> beds_;
  std::optional<PickedParticle> picked_;
  double time_ = 0.0, begin_ = 0.0, end_ = 0.0, speed_ = 1.0;  // s
  bool isPlaying_ = false, loops_ = false;
  Pace pace_;
  std::vector<double> marks_;
  std::string trouble_;
  std::uint64_t version_ = 0;
};

}  // namespace bedmix
