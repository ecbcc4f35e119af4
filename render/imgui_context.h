// SPDX-License-Identifier: MIT
#pragma once

#include "render/ui_mesh.h"

#include <imgui.h>

#include <mutex>
#include <span>

// Of the render folder's own: what the HUD and the panel have in common.

namespace bedmix {

/// A Dear ImGui of its own, without a clock, files or devices: the same input gives the same mesh. ImGui
/// knows its context by a global, so that painters in several threads take turns (see Turn).
class UiContext {
 public:
  /// Fonts of these heights, px: DejaVu Sans, or ImGui's own where that is not installed.
  explicit UiContext(std::span<const float> fontHeights);
  ~UiContext();
  UiContext(const UiContext&) = delete;
  UiContext& operator=(const UiContext&) = delete;

  const GlyphSheet& glyphs() const { return glyphs_; }

  /// For as long as it lives, ImGui's functions are about this context.
  class Turn {
   public:
    explicit Turn(const UiContext& context);

   private:
    std::unique_lock<std::mutex> lock_;
  };

  /// What ImGui::Render() has just made, in the context's turn. Valid until the next call.
  const UiMesh& collect();

 private:
  ImGuiContext* context_ = nullptr;
  GlyphSheet glyphs_;
  UiMesh mesh_;
};

}  // namespace bedmix
