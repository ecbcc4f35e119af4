// SPDX-License-Identifier: MIT
#include "app/view/view_session.h"

#include "app/view/particle_marks.h"
#include "app/view/view_files.h"
#include "render/layers.h"

#include <utility>

namespace bedmix {

struct ViewSession::State {
  std::unique_ptr<ViewModel> model;
  Style style;
  Size size;
  float scale;
  ViewFiles files;
  ControlPanel panel;
  Painter painter;
  std::vector<std::shared_ptr<const Scene>> painted;  // the scenes the painter knows
  std::vector<std::string> missing;                   // by Layer
  std::string spinMissing, notice;
  std::vector<SavedFile> saved;
  DrawList marks;
  std::uint64_t shown = 0;  // version of the model
  bool isFirst = true;

  std::vector<PaintedBed> beds() const {
    std::vector<PaintedBed> all;
    for (const ViewBed& bed : model->beds()) all.push_back({*bed.scene, bed.name});
    return all;
  }
  PaintOptions options() const { return {size, style, 0, panel.bedPart()}; }

  void noteMissing();
  bool repaintWith(const Style& wanted);
  bool followScenes();
  void resize(Size to, float by);
  PanelModel describe() const;
  void act(const PanelAction& action);
  void report(const Result<SavedFile>& file);
  void paint(Image& image);
};

namespace {

std::string whyNot(const std::vector<ViewBed>& beds, const Style& style) {
  for (const ViewBed& bed : beds)
    if (const auto problems = missingFor(*bed.scene, style); !problems.empty())
      return problems.front().message;
  return {};
}

}  // namespace

/// Why a layer, or the colour of spins, cannot be shown.
void ViewSession::State::noteMissing() {
  missing.clear();
  for (std::size_t i = 0; i < modelTable<Layer>.size(); ++i)
    missing.push_back(whyNot(model->beds(), Style{static_cast<Layer>(i)}));
  Style spins{Layer::particles};
  spins.color = ParticleColor::spin;
  spinMissing = whyNot(model->beds(), spins);
  painted.clear();
  for (const ViewBed& bed : model->beds()) painted.push_back(bed.scene);
}

/// What the beds cannot be shown with is not taken, and said.
bool ViewSession::State::repaintWith(const Style& wanted) {
  const Style before = std::exchange(style, wanted);
  if (const auto changed = painter.change(beds(), options()); !changed) {
    notice = changed.problems.front().message;
    style = before;
    return false;
  }
  noteMissing();
  return true;
}

/// Whether a scene is another than the painter knows, which it then does.
bool ViewSession::State::followScenes() {
  const std::vector<ViewBed>& now = model->beds();
  bool same = true;
  for (std::size_t i = 0; i < now.size(); ++i) same = same && now[i].scene == painted[i];
  if (!same && !repaintWith(style)) {
    Style plain = style;
    plain.layers = defaultLayers;
    repaintWith(plain);
  }
  return !same;
}

void ViewSession::State::resize(Size to, float by) {
  size = to;
  scale = by;
  panel = ControlPanel(size, scale);
  painter.setPanelGlyphs(panel.glyphs());
  repaintWith(style);
}

PanelModel ViewSession::State::describe() const {
  PanelModel shows;
  model->describe(shows);
  if (!notice.empty()) shows.notice = notice;
  shows.style = style;
  shows.missing = missing;
  shows.colorMissing = spinMissing;
  const std::vector<ViewBed>& beds = model->beds();
  for (std::size_t i = 0; i < beds.size(); ++i)
    shows.beds.push_back({beds[i].scene.get(), beds[i].frame.get(), painter.layout().beds[i]});
  if (shows.picked) shows.particle = particleFacts(beds[shows.picked->bed], shows.picked->id);
  shows.saved = files.names();
  return shows;
}

void ViewSession::State::report(const Result<SavedFile>& file) {
  if (file)
    saved.push_back(*file);
  else
    notice = toString(file.problems.front());
}

void ViewSession::State::act(const PanelAction& action) {
  notice.clear();
  if (const auto* restyle = std::get_if<PanelAction::Restyle>(&action.what))
    repaintWith(restyle->style);
  else if (std::holds_alternative<PanelAction::SavePicture>(action.what))
    report(files.savePicture(model->beds(), style));
  else if (std::holds_alternative<PanelAction::SaveScene>(action.what))
    report(files.saveScene(*model->beds().front().scene, style));
  else
    model->act(action);
}

void ViewSession::State::paint(Image& image) {
  const std::vector<ViewBed>& beds = model->beds();
  std::vector<Frame> empty(beds.size());  // while a bed is being arranged
  std::vector<const Frame*> frames;
  for (std::size_t i = 0; i < beds.size(); ++i)
    frames.push_back(beds[i].frame ? beds[i].frame.get() : &empty[i]);
  PanelModel shows;
  model->describe(shows);
  drawParticleMarks(marks, beds, painter.layout(), shows.picked);
  const PaintOverlay overlay{&marks, &panel.mesh()};
  if (painter.paint(frames, image, overlay)) return;
  // What a frame lacks its scene promised: another program's file, or a bed that is not there yet.
  Style plain = style;
  plain.layers = Layers{Layer::walls};
  for (const ViewBed& bed : beds)
    if (bed.frame) plain.layers.add(Layer::particles);
  const Style wanted = std::exchange(style, plain);
  if (painter.change(this->beds(), options())) (void)painter.paint(frames, image, overlay);
  style = wanted;
  painted.assign(beds.size(), nullptr);
}

ViewSession::ViewSession(std::unique_ptr<State> state) : state_(std::move(state)) {}
ViewSession::~ViewSession() = default;
ViewSession::ViewSession(ViewSession&&) noexcept = default;
ViewSession& ViewSession::operator=(ViewSession&&) noexcept = default;

Result<ViewSession> ViewSession::create(std::unique_ptr<ViewModel> model, const SessionOptions& options) {
  ControlPanel panel(options.size, options.scale);
  std::vector<PaintedBed> beds;
  for (const ViewBed& bed : model->beds()) beds.push_back({*bed.scene, bed.name});
  auto painter =
      Painter::create(std::move(beds), {options.size, options.style, options.threads, panel.bedPart()});
  if (!painter) return painter.problems;
  painter->setPanelGlyphs(panel.glyphs());
  auto state = std::make_unique<State>(State{std::move(model),
                                             options.style,
                                             options.size,
                                             options.scale,
                                             ViewFiles(options.folder),
                                             std::move(panel),
                                             std::move(*painter),
                                             {},
                                             {},
                                             {},
                                             {},
                                             {},
                                             {}});
  state->noteMissing();
  return ViewSession(std::move(state));
}

bool ViewSession::draw(std::span<const InputEvent> events, double seconds, Image& image) {
  State& s = *state_;
  bool isNew = std::exchange(s.isFirst, false) || !events.empty() || s.panel.isRestless();
  for (const InputEvent& event : events)
    if (event.kind == InputEvent::Kind::size && !(event.size == s.size && event.scale == s.scale))
      s.resize(event.size, event.scale);
  s.model->refresh(seconds);
  isNew = s.followScenes() || isNew || s.model->version() != s.shown;
  if (!isNew) return false;
  const std::vector<PanelAction> actions = s.panel.update(s.describe(), events, seconds);
  for (const PanelAction& action : actions) s.act(action);
  if (!actions.empty()) {  // their effect is part of this picture already
    s.model->refresh(0.0);
    s.followScenes();
    s.panel.update(s.describe(), {}, 0.0);
  }
  s.shown = s.model->version();
  s.paint(image);
  return true;
}

ViewModel& ViewSession::model() { return *state_->model; }
const ControlPanel& ViewSession::panel() const { return state_->panel; }
Size ViewSession::size() const { return state_->size; }
std::string_view ViewSession::cursor() const { return state_->panel.cursor(); }
bool ViewSession::wantsKeyboard() const { return state_->panel.wantsKeyboard(); }
std::vector<SavedFile> ViewSession::takeSaved() { return std::exchange(state_->saved, {}); }

}  // namespace bedmix
