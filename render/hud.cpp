// SPDX-License-Identifier: MIT
#include "render/hud.h"

#include "render/imgui_context.h"

#include <array>
#include <cfloat>
#include <cmath>

namespace bedmix {

namespace {

/// The second font keeps small texts sharp: glyphs are not scaled to less than half their size.
std::array<float, 2> fontHeights(float em) { return {std::round(em), std::round(0.5f * em)}; }

}  // namespace

struct Hud::State {
  UiContext context;

  explicit State(float em) : context(fontHeights(em)) {}
};

Hud::Hud(float em) : state_(std::make_unique<State>(em)) {}
Hud::~Hud() = default;
Hud::Hud(Hud&&) noexcept = default;
Hud& Hud::operator=(Hud&&) noexcept = default;

const GlyphSheet& Hud::glyphs() const { return state_->context.glyphs(); }

float Hud::width(const std::string& text) const {
  const UiContext::Turn turn(state_->context);
  const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
  return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0f, text.c_str()).x;
}

const UiMesh& Hud::mesh(Size picture, std::span<const Text> texts) {
  const UiContext::Turn turn(state_->context);
  ImGui::GetIO().DisplaySize = {static_cast<float>(picture.width), static_cast<float>(picture.height)};
  ImGui::NewFrame();
  for (const Text& text : texts) {
    const auto& fonts = ImGui::GetIO().Fonts->Fonts;
    const float height = text.size > 0.0f ? text.size : fonts[0]->FontSize;
    ImFont* font = fonts[height > fonts[1]->FontSize ? 0 : 1];
    const ImVec2 size = font->CalcTextSizeA(height, FLT_MAX, 0.0f, text.text.c_str());
    const ImVec2 at{std::round(text.at.x - text.anchor.x * size.x),
                    std::round(text.at.y - text.anchor.y * size.y)};
    ImGui::GetBackgroundDrawList()->AddText(font, height, at,
                                            IM_COL32(text.color.r, text.color.g, text.color.b, text.color.a),
                                            text.text.c_str());
  }
  ImGui::Render();
  return state_->context.collect();
}

}  // namespace bedmix
