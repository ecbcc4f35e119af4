// SPDX-License-Identifier: MIT
#pragma once

#include "render/panel/input_event.h"
#include "render/panel/panel_action.h"
#include "render/panel/panel_model.h"
#include "render/ui_mesh.h"

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace bedmix {

/// The Dear ImGui panel beside the bed, and what the pointer does to the bed. Knows the model it is shown and
/// answers with actions; the same models, events and times give the same meshes.
class ControlPanel {
 public:
  /// For pictures of `size` whose texts are laid out `scale` times as large.
  ControlPanel(Size size, float scale);
  ~ControlPanel();
  ControlPanel(ControlPanel&&) noexcept;
  ControlPanel& operator=(ControlPanel&&) noexcept;

  const GlyphSheet& glyphs() const;
  /// What the panel leaves of the picture, for the beds: it is beside them, or below in an upright picture.
  Box bedPart() const;

  /// What the events, in their order, and `seconds` of time make of it. A fast click is not lost: pressing
  /// and releasing are two steps of the interface.
  std::vector<PanelAction> update(const PanelModel& model, std::span<const InputEvent> events,
                                  double seconds);
  /// As it looks since then. Valid until the next update.
  const UiMesh& mesh() const;

  /// Where something with this label was drawn last, px; nothing where it is not. It may have to be scrolled
  /// into panelPart() before it is seen.
  std::optional<Box> item(std::string_view label) const;
  Box panelPart() const;

  /// CSS name of the pointer's shape.
  std::string_view cursor() const;
  /// Whether a text is being edited, for which a phone shows its keyboard.
  bool wantsKeyboard() const;
  /// Whether it still moves or blinks by itself.
  bool isRestless() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
