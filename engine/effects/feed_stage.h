// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/particle_list.h"
#include "engine/dem/room.h"
#include "engine/effects/effect_stage.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace bedmix {

/// Continuous operation: particles come in by the streams of [feed] and are taken out by its outlets, as
/// often as nobody falls far meanwhile: each time needs a new list of neighbours. A stream owes so many as
/// its rate says; each comes in at a random place of its line where it touches neither particles nor walls,
/// and waits where there is none. Ids count up, so that they tell who came when; nobody gets that of another.
/// What comes or goes within the gas changes places with as much of it: neither makes it flow.
class FeedStage final : public EffectStage {
 public:
  static std::unique_ptr<EffectStage> make(const EffectContext& context);
  explicit FeedStage(const EffectContext& context);

  double longestStep() const override { return interval_; }
  PopulationChange exchange(double passed) override;

  std::int64_t waiting() const override;

  void hashInto(StateHash& hash) const override;
  void save(StateWriter& out) const override;
  [[nodiscard]] bool load(StateReader& in) override;

 private:
  struct Stream {
    double owed = 0.0;        // particles
    std::uint64_t tries = 0;  // at finding room, so far
  };
  using Newcomer = PopulationChange::Newcomer;
  void findGone(PopulationChange& change) const;
  void letIn(std::size_t stream, PopulationChange& change);
  bool findRoom(std::size_t stream, const PopulationChange& change, Newcomer& newcomer);
  bool isWithinBed(const Newcomer& newcomer) const;
  void exchangeInGas(const PopulationChange& change);

  EffectContext context_;
  const FeedSettings& feed_;
  std::vector<ParticleKind> kinds_;
  Room room_;
  double interval_;     // s, at least, from one exchange to the next
  double since_ = 0.0;  // s, since the last one
  std::vector<Stream> streams_;
  std::int32_t next_;           // id
  std::vector<double> before_;  // voidage, per cell
};

}  // namespace bedmix
