// SPDX-License-Identifier: MIT
#pragma once

#include "render/draw_list.h"
#include "render/ui_mesh.h"

#include <memory>
#include <span>
#include <string>

namespace bedmix {

/// Dear ImGui in the pictures: sets texts in DejaVu Sans, or in ImGui's own font where that is not installed.
/// No clock and no input: the same texts give the same mesh.
class Hud {
 public:
  /// `em`: height of the text, px.
  explicit Hud(float em);
  ~Hud();
  Hud(Hud&&) noexcept;
  Hud& operator=(Hud&&) noexcept;

  const GlyphSheet& glyphs() const;
  /// How wide a text is, px.
  float width(const std::string& text) const;
  /// Valid until the next call.
  const UiMesh& mesh(Size picture, std::span<const Text> texts);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
