// SPDX-License-Identifier: MIT
#include "app/view/live_model.h"

#include "engine/core/steering.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace bedmix {

namespace {

constexpr std::size_t longestPath = 4096;  // points
constexpr double gasRange = 3.0;           // of the sliders over the scene's fastest inlet
constexpr double leastRange = 5.0;         // u_mf

double fastestOf(const Scene& scene) {
  if (!scene.gas) return 0.0;
  double fastest = leastRange * minimumFluidizationVelocity(scene) / gasRange;
  for (const Inlet& inlet : scene.gas->inlets) fastest = std::max(fastest, inletVelocity(scene, inlet));
  return gasRange * fastest;
}

bool hasInflow(const Scene& scene) {
  return scene.gas && std::any_of(scene.gas->inlets.begin(), scene.gas->inlets.end(),
                                  [&](const Inlet& inlet) { return inletVelocity(scene, inlet) > 0.0; });
}

/// What sets an inlet's velocity, m/s.
std::vector<Override> velocityOf(std::size_t inlet, double velocity) {
  return {{fmt::format("gas.inlets.{}.velocity_umf", inlet), ""},
          {fmt::format("gas.inlets.{}.velocity", inlet), fmt::format("{:.9g}", velocity)}};
}

std::vector<PanelFact> stageFacts(const StageSeconds& stages) {
  double all = 0.0;
  for (const double seconds : stages) all += seconds;
  std::vector<PanelFact> facts;
  for (std::size_t i = 0; i < stages.size(); ++i)
    facts.push_back({std::string(stageNames[i]), fmt::format("{:.2f} s", stages[i]),
                     all > 0.0 ? static_cast<float>(stages[i] / all) : 0.0f});
  return facts;
}

std::vector<PanelFact> numberFacts(const Snapshot& now) {
  const StepReport& report = now.report;
  std::vector<PanelFact> facts{{"contacts", fmt::format("{}", now.contacts)},
                               {"largest overlap", fmt::format("{:.3g} d", report.largestOverlap)},
                               {"largest speed", fmt::format("{:.3g} m/s", report.largestSpeed)}};
  if (!now.scene->gas) return facts;
  facts.push_back({"lowest voidage", fmt::format("{:.3f}", report.lowestVoidage)});
  facts.push_back({"largest Courant number", fmt::format("{:.2f}", report.largestCourant)});
  facts.push_back({"gas steps not converged", fmt::format("{}", report.gasStepsNotConverged)});
  return facts;
}

}  // namespace

LiveModel::LiveModel(const Scene& scene, int threads, Pace pace, std::filesystem::path folder)
    : pace_(pace),
      tap_(scene, std::move(folder)),
      run_(scene, threads, pace),
      now_(run_.newest()),
      beds_(1),
      fastestInlet_(fastestOf(scene)) {
  beds_[0].scene = now_->scene;
  run_.setTap(&tap_);
  run_.play(true);
}

LiveModel::~LiveModel() {
  tap_.stop();
  run_.setTap(nullptr);
}

void LiveModel::refresh(double seconds) {
  if (pace_ == Pace::ticked && seconds > 0.0) run_.tick();
  now_ = run_.newest();
  beds_[0].scene = now_->scene;
  beds_[0].frame = now_->frame;
  if (noticeOf_ != now_->number && !now_->refusal.empty()) tell(now_->refusal);
  if (const auto trouble = tap_.failure()) tell(toString(*trouble));
  noticeOf_ = now_->number;
  followPath();
}

/// The picked particle's places since then; of a long path every second one is kept.
void LiveModel::followPath() {
  std::vector<Vec2f>& path = beds_[0].path;
  if (!picked_ || !now_->frame) return path.clear();
  const auto& ids = now_->frame->id;
  const auto found = std::lower_bound(ids.begin(), ids.end(), picked_->id);
  if (found == ids.end() || *found != picked_->id) return;
  const Vec2f at = now_->frame->position[static_cast<std::size_t>(found - ids.begin())];
  if (!path.empty() && path.back() == at) return;
  path.push_back(at);
  if (path.size() < longestPath) return;
  for (std::size_t i = 0; 2 * i < path.size(); ++i) path[i] = path[2 * i];
  path.resize((path.size() + 1) / 2);
}

void LiveModel::tell(std::string notice) { notice_ = std::move(notice); }

void LiveModel::switchGas(bool on) {
  std::vector<Override> changes = std::exchange(whenOn_, {});
  const auto& inlets = now_->scene->gas->inlets;
  if (!on) {
    changes.clear();
    for (std::size_t i = 0; i < inlets.size(); ++i) {
      for (Override& change : velocityOf(i, inletVelocity(*now_->scene, inlets[i])))
        whenOn_.push_back(std::move(change));
      for (Override& change : velocityOf(i, 0.0)) changes.push_back(std::move(change));
    }
  }
  if (!changes.empty()) run_.change(std::move(changes));
}

void LiveModel::act(const PanelAction& action) {
  notice_.clear();
  if (const auto* play = std::get_if<PanelAction::Play>(&action.what)) run_.play(play->on);
  if (std::holds_alternative<PanelAction::Step>(action.what)) run_.step();
  if (std::holds_alternative<PanelAction::Restart>(action.what)) {
    beds_[0].path.clear();
    run_.restart();
  }
  if (const auto* speed = std::get_if<PanelAction::Speed>(&action.what)) {
    speed_ = speed->speed;
    run_.limitSpeed(speed_ > 0.0 ? speed_ : std::numeric_limits<double>::infinity());
  }
  if (const auto* change = std::get_if<PanelAction::Change>(&action.what)) run_.change(change->values);
  if (const auto* gas = std::get_if<PanelAction::GasOn>(&action.what); gas && now_->scene->gas)
    switchGas(gas->on);
  if (const auto* tag = std::get_if<PanelAction::Tag>(&action.what)) run_.tagTracer(tag->rule);
  if (const auto* cells = std::get_if<PanelAction::Resample>(&action.what))
    run_.change({{"sampling.columns", fmt::format("{}", cells->columns)},
                 {"sampling.rows", fmt::format("{}", cells->rows)},
                 {"sampling.min_particles", fmt::format("{}", cells->minParticles)}});
  if (const auto* pick = std::get_if<PanelAction::Pick>(&action.what)) {
    if (pick->particle != picked_) beds_[0].path.clear();
    picked_ = pick->particle;
  }
  if (const auto* record = std::get_if<PanelAction::Record>(&action.what))
    if (const auto begun = tap_.record(record->film); !begun) tell(toString(begun.problems.front()));
  if (std::holds_alternative<PanelAction::StopRecording>(action.what))
    if (const auto trouble = tap_.stop()) tell(toString(*trouble));
}

void LiveModel::describeGas(PanelModel& panel) const {
  const Scene& scene = *now_->scene;
  if (!scene.gas) return;
  panel.fastestInlet = fastestInlet_;
  panel.isGasOn = whenOn_.empty() || hasInflow(scene);
  const double umf = minimumFluidizationVelocity(scene);
  for (const Inlet& inlet : scene.gas->inlets)
    panel.inlets.push_back({fmt::format("{:.4g} to {:.4g} mm", 1e3 * inlet.from, 1e3 * inlet.to),
                            inletVelocity(scene, inlet), inletVelocity(scene, inlet) / umf});
}

void LiveModel::describe(PanelModel& panel) const {
  const Snapshot& now = *now_;
  panel.isLive = true;
  panel.title = now.scene->title.empty() ? now.scene->name : now.scene->title;
  panel.isPlaying = now.isPlaying;
  panel.time = panel.end = now.frame ? now.frame->time : 0.0;
  panel.speed = speed_;
  panel.reached = now.speed;
  panel.trouble = now.trouble;
  panel.notice = now.frame || !now.trouble.empty() ? notice_ : "settling the bed ...";
  describeGas(panel);
  panel.grid = samplingGrid(*now.scene);
  panel.charts = tap_.charts();
  panel.stages = stageFacts(now.stages);
  panel.numbers = numberFacts(now);
  for (SceneValue& value : sceneValues(*now.scene)) {
    const std::string_view fixed = reasonFixed(value.path);
    panel.parameters.push_back({std::move(value), fixed});
  }
  panel.picked = picked_;
  panel.canRecord = now.frame != nullptr;
  panel.recording = tap_.recording();
  panel.isRecording = !panel.recording.empty();
}

}  // namespace bedmix
