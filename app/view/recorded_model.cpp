// SPDX-License-Identifier: MIT
#include "app/view/recorded_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bedmix {

namespace {

/// The last frame at or before a time; the first where there is none.
std::size_t frameAt(const std::vector<double>& times, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time + 1e-9);
  return after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
}

}  // namespace

RecordedModel::RecordedModel(std::vector<RecordedRun> runs, const std::vector<std::string>& names,
                             const RecordingOptions& options, Pace pace)
    : beds_(runs.size()), begin_(runs.front().begin()), end_(runs.front().end()), pace_(pace) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    begin_ = std::min(begin_, runs[i].begin());
    end_ = std::max(end_, runs[i].end());
    for (const RunEvent& event : runs[i].reader->events()) marks_.push_back(event.time);
    beds_[i].scene = std::make_shared<const Scene>(runs[i].scene());
    beds_[i].name = runs[i].name;
    auto scan = std::make_unique<RunScan>(names[i], options);
    auto found = scan->found();
    sources_.push_back({std::move(runs[i]), std::move(scan), std::move(found), {}, {}});
  }
  for (Source& source : sources_) source.shown = static_cast<std::size_t>(-1);
  ask();
  seek(begin_);
}

void RecordedModel::ask() {
  for (std::size_t i = 0; i < sources_.size(); ++i)
    sources_[i].scan->ask({samplingGrid(*beds_[i].scene), sources_[i].tags,
                           picked_ && picked_->bed == i ? std::optional(picked_->id) : std::nullopt});
}

void RecordedModel::show(Source& source, ViewBed& bed) {
  const std::size_t index = frameAt(source.run.reader->times(), time_);
  if (index == source.shown) return;
  source.shown = index;
  const auto frame = source.run.reader->frame(index);
  if (!frame) {
    trouble_ = toString(frame.problems.front());
    isPlaying_ = false;
    return;
  }
  bed.frame = source.tags ? std::make_shared<const Frame>(source.tags->applied(**frame)) : *frame;
}

void RecordedModel::seek(double time) {
  time_ = std::clamp(time, begin_, end_);
  trouble_.clear();
  for (std::size_t i = 0; i < sources_.size(); ++i) show(sources_[i], beds_[i]);
  ++version_;
}

void RecordedModel::refresh(double seconds) {
  if (pace_ == Pace::ticked)
    for (const Source& source : sources_) source.scan->finish();
  for (std::size_t i = 0; i < sources_.size(); ++i)
    if (auto found = sources_[i].scan->found(); found != sources_[i].found) {
      sources_[i].found = std::move(found);
      beds_[i].path = sources_[i].found->path;
      ++version_;
    }
  if (!isPlaying_ || seconds <= 0.0) return;
  const double next = time_ + seconds * speed_;
  if (next >= end_ && !loops_) isPlaying_ = false;
  seek(next > end_ && loops_ ? begin_ + std::fmod(next - end_, std::max(end_ - begin_, 1e-9)) : next);
}

void RecordedModel::step(int frames) {
  isPlaying_ = false;
  const std::vector<double>& times = sources_.front().run.reader->times();
  const auto last = static_cast<std::int64_t>(times.size()) - 1;
  const std::int64_t at = static_cast<std::int64_t>(frameAt(times, time_)) + frames;
  seek(times[static_cast<std::size_t>(std::clamp<std::int64_t>(at, 0, last))]);
}

/// Near another one, within a hundredth of the run, that one goes.
void RecordedModel::mark() {
  const double near = 0.01 * (end_ - begin_);
  const auto other =
      std::find_if(marks_.begin(), marks_.end(), [&](double time) { return std::abs(time - time_) <= near; });
  if (other == marks_.end())
    marks_.push_back(time_);
  else
    marks_.erase(other);
  ++version_;
}

void RecordedModel::retag(TracerRule rule) {
  const auto choice = TracerChoice::parse(std::string(modelName(rule)));
  for (std::size_t i = 0; choice && i < sources_.size(); ++i) {
    if (!beds_[i].frame) continue;
    auto tags = choice->tag(*beds_[i].frame, *beds_[i].scene);
    if (!tags) continue;
    sources_[i].tags = std::make_shared<const Retagging>(*beds_[i].frame, std::move(*tags));
    sources_[i].shown = static_cast<std::size_t>(-1);
  }
  ask();
  seek(time_);
}

void RecordedModel::resample(const PanelAction::Resample& cells) {
  for (ViewBed& bed : beds_) {
    auto scene = std::make_shared<Scene>(*bed.scene);
    scene->sampling.columns = cells.columns;
    scene->sampling.rows = cells.rows;
    scene->sampling.minParticles = cells.minParticles;
    bed.scene = std::move(scene);
  }
  ask();
  ++version_;
}

void RecordedModel::act(const PanelAction& action) {
  if (const auto* play = std::get_if<PanelAction::Play>(&action.what)) {
    isPlaying_ = play->on;
    if (isPlaying_ && time_ >= end_) seek(begin_);
    ++version_;
  }
  if (const auto* steps = std::get_if<PanelAction::Step>(&action.what)) step(steps->frames);
  if (const auto* to = std::get_if<PanelAction::Seek>(&action.what)) seek(to->time);
  if (const auto* speed = std::get_if<PanelAction::Speed>(&action.what)) speed_ = speed->speed;
  if (const auto* loop = std::get_if<PanelAction::Loop>(&action.what)) loops_ = loop->on;
  if (std::holds_alternative<PanelAction::Mark>(action.what)) mark();
  if (const auto* tag = std::get_if<PanelAction::Tag>(&action.what)) retag(tag->rule);
  if (const auto* cells = std::get_if<PanelAction::Resample>(&action.what)) resample(*cells);
  if (const auto* pick = std::get_if<PanelAction::Pick>(&action.what); pick && pick->particle != picked_) {
    picked_ = pick->particle;
    for (ViewBed& bed : beds_) bed.path.clear();
    ask();
    ++version_;
  }
}

void RecordedModel::describe(PanelModel& panel) const {
  const Source& first = sources_.front();
  panel.isLive = false;
  for (const ViewBed& bed : beds_) panel.title += (panel.title.empty() ? "" : "  |  ") + bed.name;
  panel.isPlaying = isPlaying_;
  panel.time = time_;
  panel.begin = begin_;
  panel.end = end_;
  panel.speed = panel.reached = speed_;
  panel.frame = frameAt(first.run.reader->times(), time_);
  panel.frames = first.run.reader->times().size();
  panel.loops = loops_;
  panel.keyTimes = marks_;
  panel.trouble = trouble_;
  panel.grid = samplingGrid(*beds_.front().scene);
  panel.picked = picked_;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    panel.indicesDone = std::min(panel.indicesDone, sources_[i].found->done);
    for (PanelChart chart : sources_[i].found->charts) {
      if (sources_.size() > 1) chart.label = beds_[i].name;
      panel.charts.push_back(std::move(chart));
    }
  }
}

}  // namespace bedmix
