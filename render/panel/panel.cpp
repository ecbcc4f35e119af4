// SPDX-License-Identifier: MIT
#include "render/panel/panel.h"

#include "render/imgui_context.h"
#include "render/panel/bed_pointer.h"
#include "render/panel/panel_input.h"
#include "render/panel/panel_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace bedmix {

namespace {

// In pixels before they are scaled.
constexpr float fontHeight = 14.0f;
constexpr float panelWidth = 330.0f;
constexpr float narrowest = 640.0f;  // picture with the panel beside the bed
// Of the picture.
constexpr float widestShare = 0.5f, heightShare = 0.48f;

void setLook(float scale) {
  ImGuiStyle& look = ImGui::GetStyle();
  ImGui::StyleColorsDark(&look);
  look.WindowRounding = look.WindowBorderSize = 0.0f;
  look.FrameRounding = 3.0f;
  look.FramePadding = {6.0f, 4.0f};
  look.ItemSpacing = {6.0f, 5.0f};
  look.ScrollbarSize = 13.0f;
  look.GrabMinSize = 14.0f;
  look.Colors[ImGuiCol_WindowBg] = {0.11f, 0.125f, 0.15f, 1.0f};
  look.ScaleAllSizes(scale);
}

}  // namespace

struct ControlPanel::State {
  Box part, bed;  // of the picture: the panel's and the rest
  UiContext context;
  PanelInput input;
  BedPointer bedPointer;
  const UiMesh* mesh = nullptr;
  std::string_view cursor = "default";
  bool isTyping = false, isScrolled = false;
  std::map<std::string, Box, std::less<>> items;  // by label

  State(Size size, float scale) : context(std::array{std::round(fontHeight * scale)}) {
    const Box whole = wholeOf(size);
    part = bed = whole;
    if (whole.width() >= narrowest * scale || whole.width() > 1.4f * whole.height())
      part.left = bed.right = whole.right - std::min(panelWidth * scale, widestShare * whole.width());
    else
      part.top = bed.bottom = std::round(whole.bottom - heightShare * whole.height());
    const UiContext::Turn turn(context);
    PanelInput::mapKeys();
    noteItemsIn(&items);
    setLook(scale);
    ImGui::GetIO().DisplaySize = {whole.right, whole.bottom};
  }

  /// A finger drags the panel's ground to scroll it.
  void scrollByFinger() {
    const bool drags = input.isTouch() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, -1.0f);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) isScrolled = false;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
      isScrolled = input.isTouch() && ImGui::IsWindowHovered() && !ImGui::IsAnyItemHovered();
    if (drags && isScrolled) ImGui::SetScrollY(ImGui::GetScrollY() - ImGui::GetIO().MouseDelta.y);
  }

  void build(const PanelModel& model, PanelActions& actions) {
    items.clear();
    ImGui::SetNextWindowPos({part.left, part.top});
    ImGui::SetNextWindowSize({part.width(), part.height()});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    for (const auto section :
         {transportSection, gasSection, chartSection, particleSection, pictureSection, samplingSection,
          tracerSection, savingSection, numbersSection, parametersSection})
      section(model, actions);
    scrollByFinger();
    ImGui::End();
    pointBed(model, actions);
  }

  void pointBed(const PanelModel& model, PanelActions& actions) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const bool isOurs = !io.WantCaptureMouse;
    bedPointer.update(model,
                      {{io.MousePos.x, io.MousePos.y},
                       isOurs && ImGui::IsMouseClicked(ImGuiMouseButton_Left),
                       isOurs && ImGui::IsMouseDown(ImGuiMouseButton_Left),
                       (input.isTouch() ? 1.2f : 0.4f) * ImGui::GetFontSize()},
                      actions);
  }

  void noteState() {
    const ImGuiIO& io = ImGui::GetIO();
    isTyping = io.WantTextInput;
    switch (ImGui::GetMouseCursor()) {
      case ImGuiMouseCursor_TextInput:
        cursor = "text";
        break;
      case ImGuiMouseCursor_Hand:
        cursor = "pointer";
        break;
      default:
        cursor = "default";
    }
    if (!io.WantCaptureMouse && !bedPointer.cursor().empty()) cursor = bedPointer.cursor();
  }
};

ControlPanel::ControlPanel(Size size, float scale) : state_(std::make_unique<State>(size, scale)) {}
ControlPanel::~ControlPanel() = default;
ControlPanel::ControlPanel(ControlPanel&&) noexcept = default;
ControlPanel& ControlPanel::operator=(ControlPanel&&) noexcept = default;

const GlyphSheet& ControlPanel::glyphs() const { return state_->context.glyphs(); }
Box ControlPanel::bedPart() const { return state_->bed; }

std::vector<PanelAction> ControlPanel::update(const PanelModel& model, std::span<const InputEvent> events,
                                              double seconds) {
  constexpr float moment = 1e-3f;  // s; ImGui wants time to pass
  State& s = *state_;
  PanelActions actions;
  const UiContext::Turn turn(s.context);
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = std::max(static_cast<float>(seconds), moment);
  // What input makes of the layout shows one frame later.
  for (bool isLast = events.empty(), goesOn = true; goesOn; goesOn = !isLast, isLast = events.empty()) {
    events = s.input.take(events);
    ImGui::NewFrame();
    s.build(model, actions);
    ImGui::Render();
    io.DeltaTime = moment;
  }
  s.noteState();
  s.mesh = &s.context.collect();
  return actions;
}

const UiMesh& ControlPanel::mesh() const { return *state_->mesh; }
Box ControlPanel::panelPart() const { return state_->part; }
std::optional<Box> ControlPanel::item(std::string_view label) const {
  const auto found = state_->items.find(label);
  return found == state_->items.end() ? std::nullopt : std::optional(found->second);
}

std::string_view ControlPanel::cursor() const { return state_->cursor; }
bool ControlPanel::wantsKeyboard() const { return state_->isTyping; }
bool ControlPanel::isRestless() const { return state_->isTyping; }

}  // namespace bedmix
