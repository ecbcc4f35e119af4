// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/models.h"
#include "engine/core/scene.h"
#include "engine/core/scene_reader.h"
#include "engine/simulation.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bedmix {

/// What there is to know of a run at one instant.
struct Snapshot {
  std::uint64_t number = 0;            // grows by one with each
  FramePtr frame;                      // null until the bed is arranged
  std::shared_ptr<const Scene> scene;  // as it has been steered
  bool isPlaying = false;
  double speed = 0.0;  // simulated s per wall s, of late; 0 at rest and where the pace is ticked
  std::int64_t contacts = 0;
  StageSeconds stages{};
  StepReport report;
  std::uint64_t stateHash = 0;  // see Simulation; 0 where the pace is free
  std::string trouble;          // why the run cannot go on; only a restart helps
  std::string refusal;          // why the last change was refused; empty after one that was not
};
using SnapshotPtr = std::shared_ptr<const Snapshot>;

/// Something that was done to the run, for its log.
struct Steering {
  double time = 0.0;                   // s, simulated
  std::string kind;                    // "set", "tracer", "restart"
  std::string detail;                  // "gas.inlets.0.velocity = 2.5", "left-half", ""
  std::shared_ptr<const Scene> scene;  // from then on
};

/// Takes every frame, and what was done before it, in their order; whoever gives them waits. That is the
/// solver's thread, but for the first frame, which comes from within LiveRun::setTap(). Times begin at 0
/// again after a restart, which is noted. Must not throw, nor call setTap().
class FrameTap {
 public:
  virtual ~FrameTap() = default;
  virtual void accept(const FramePtr& frame) = 0;
  virtual void note(const Steering& steering) = 0;
};

/// Who decides when the run goes on: itself, as fast as it may, or tick().
enum class Pace { free, ticked };

/// A run that a person steers: the solver in a thread of its own, which takes orders between frames and
/// leaves behind the newest of what it found, never waiting for who looks at it. Begins at rest and goes on
/// beyond the scene's duration. All members may be called from any thread and return at once, unless they
/// say otherwise; orders are carried out one after the other. Where the pace is ticked, two runs that get the
/// same calls are the same to the bit.
class LiveRun {
 public:
  /// `onNews` is called in the solver's thread after each snapshot but the first, which is there already.
  LiveRun(const Scene& scene, int threads, Pace pace, std::function<void()> onNews = {});
  ~LiveRun();  // stops and joins; no frame is cut short, nor is the arrangement of a bed

  /// Never null.
  SnapshotPtr newest() const;

  void play(bool on);
  /// One frame, then pause.
  void step();
  /// Arranges the scene as it has been steered anew, at 0 s, and plays on if it was playing.
  void restart();
  /// Simulated s per wall s, at most; infinity for none. Without effect where the pace is ticked.
  void limitSpeed(double most);
  /// Other values from the next step on: all of them or, where one is wrong, none (see Snapshot::refusal).
  /// Where the run cannot go on they wait for a restart.
  void change(std::vector<Override> changes);
  /// Chooses the tracer anew, from where the particles are; so does a restart, by the same rule.
  void tagTracer(TracerRule rule);
  /// Every frame from the present one on also goes to the tap; null: to none any more. Holds when it returns,
  /// which may take as long as the tap before takes for a frame. The tap must outlive its use.
  void setTap(FrameTap* tap);

  /// Where the pace is ticked: carries out the orders and, if playing, goes on by one frame. Returns when
  /// that is done.
  void tick();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
