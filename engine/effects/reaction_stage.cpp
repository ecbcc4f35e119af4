// SPDX-License-Identifier: MIT
#include "engine/effects/reaction_stage.h"

#include "engine/dem/particle_solver.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr double gasConstant = 8.314462618;  // J/(mol K)

}  // namespace

std::unique_ptr<EffectStage> ReactionStage::make(const EffectContext& context) {
  if (!context.scene.effects.find<ReactionSettings>()) return nullptr;
  return std::make_unique<ReactionStage>(context);
}

ReactionStage::ReactionStage(const EffectContext& context)
    : context_(context),
      settings_(*context.scene.effects.find<ReactionSettings>()),
      content_(context.solver.particles().size(), settings_.content) {}

void ReactionStage::follow(const PopulationChange& change) {
  change.apply(content_, [this](const PopulationChange::Newcomer&) { return settings_.content; });
  newcomers_ = change.come.size();
}

void ReactionStage::act(double passed, double) {
  std::vector<double>& temperature = context_.temperature;
  const HeatSettings* heat = context_.scene.effects.find<HeatSettings>();
  const double overR = settings_.activationEnergy / gasConstant,
               perReference = 1.0 / settings_.referenceTemperature;
  const double warming = heat ? settings_.heat / heat->heatCapacity : 0.0;  // K
  for (std::size_t i = 0; i + newcomers_ < content_.size(); ++i) {
    double rate = settings_.rate;
    if (heat) rate *= std::exp(overR * (perReference - 1.0 / std::max(temperature[i], 1.0)));
    const double left = settings_.model == ReactionModel::firstOrder
                            ? content_[i] * std::exp(-rate * passed)
                            : std::max(0.0, content_[i] - rate * passed);
    if (heat) temperature[i] += warming * (content_[i] - left);
    content_[i] = left;
  }
  newcomers_ = 0;
}

void ReactionStage::fill(Frame& frame) const { frame.content.assign(content_.begin(), content_.end()); }
void ReactionStage::hashInto(StateHash& hash) const { hash.add(content_); }
void ReactionStage::save(StateWriter& out) const { out.putAll(content_); }

bool ReactionStage::load(StateReader& in) {
  return in.getAll(content_) &&
         std::all_of(content_.begin(), content_.end(), [](double x) { return x >= 0.0; });
}

}  // namespace bedmix
