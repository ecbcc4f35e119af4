// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/live_tap.h"
#include "app/view/view_model.h"
#include "engine/live_run.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// A coupled solver that a person watches and steers.
class LiveModel final : public ViewModel {
 public:
  /// Recordings go into folders in `folder`. With a ticked pace each refresh is one frame of the run, if it
  /// plays.
  LiveModel(const Scene& scene, int threads, Pace pace, std::filesystem::path folder);
  ~LiveModel() override;

  void refresh(double seconds) override;
  void act(const PanelAction& action) override;
  void describe(PanelModel& panel) const override;
  const std::vector<ViewBed>& beds() const override { return beds_; }
  std::uint64_t version() const override { return now_->number; }
  std::string farewell() const override { return tap_.farewell(); }

  /// Ends a recording; what went wrong with it.
  std::optional<Diagnostic> stopRecording() { return tap_.stop(); }

 private:
  void followPath();
  void describeGas(PanelModel& panel) const;
  void switchGas(bool on);
  void tell(std::string notice);

  Pace pace_;
  LiveTap tap_;
  LiveRun run_;
  SnapshotPtr now_;
  std::vector<ViewBed> beds_;
  std::optional<PickedParticle> picked_;
  double speed_ = 0.0;            // asked for, 0 for none
  std::vector<Override> whenOn_;  // the inlets' velocities while the gas is off
  double fastestInlet_ = 0.0;     // m/s
  std::string notice_;
  std::uint64_t noticeOf_ = 0;  // the snapshot whose refusal has been told
};

}  // namespace bedmix
