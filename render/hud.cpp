// SPDX-License-Identifier: MIT
#include "render/hud.h"

#include <imgui.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <filesystem>
#include <limits>
#include <mutex>

namespace bedmix {

namespace {

/// From the Debian package fonts-dejavu-core.
constexpr const char* fontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

/// ImGui knows its context by a global; painters in several threads take turns.
std::mutex& imguiMutex() {
  static std::mutex mutex;
  return mutex;
}

void append(UiMesh& mesh, const ImDrawList& list) {
  const std::size_t firstVertex = mesh.vertices.size(), firstIndex = mesh.indices.size();
  for (const ImDrawVert& v : list.VtxBuffer)
    mesh.vertices.push_back({{v.pos.x, v.pos.y}, {v.uv.x, v.uv.y}, std::bit_cast<Rgba>(v.col)});
  mesh.indices.insert(mesh.indices.end(), list.IdxBuffer.begin(), list.IdxBuffer.end());
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const ImVec4& clip = command.ClipRect;
    mesh.commands.push_back({{clip.x, clip.y, clip.z, clip.w},
                             static_cast<std::uint32_t>(firstIndex + command.IdxOffset),
                             command.ElemCount,
                             static_cast<std::uint32_t>(firstVertex + command.VtxOffset)});
  }
}

}  // namespace

struct Hud::State {
  ImGuiContext* context = nullptr;
  GlyphSheet glyphs;
  UiMesh mesh;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    const std::lock_guard lock(imguiMutex());
    ImGui::DestroyContext(context);
  }
};

Hud::Hud(float em) : state_(std::make_unique<State>()) {
  const std::lock_guard lock(imguiMutex());
  state_->context = ImGui::CreateContext();
  ImGui::SetCurrentContext(state_->context);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.DeltaTime = 1.0f / 60.0f;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  // The second font keeps small texts sharp: glyphs are not scaled to less than half their size.
  std::error_code missing;
  for (const float size : {std::round(em), std::round(0.5f * em)}) {
    if (std::filesystem::exists(fontFile, missing)) {
      io.Fonts->AddFontFromFileTTF(fontFile, size);
    } else {
      ImFontConfig config;
      config.SizePixels = size;
      io.Fonts->AddFontDefault(&config);
    }
  }
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  state_->glyphs = {{width, height}, {pixels, pixels + static_cast<std::size_t>(width) * height}};
}

Hud::~Hud() = default;
Hud::Hud(Hud&&) noexcept = default;
Hud& Hud::operator=(Hud&&) noexcept = default;

const GlyphSheet& Hud::glyphs() const { return state_->glyphs; }

float Hud::width(const std::string& text) const {
  const std::lock_guard lock(imguiMutex());
  ImGui::SetCurrentContext(state_->context);
  const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
  return font.CalcTextSizeA(font.FontSize, std::numeric_limits<float>::max(), 0.0f, text.c_str()).x;
}

const UiMesh& Hud::mesh(Size picture, std::span<const Text> texts) {
  const std::lock_guard lock(imguiMutex());
  ImGui::SetCurrentContext(state_->context);
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

  UiMesh& mesh = state_->mesh;
  mesh.vertices.clear();
  mesh.indices.clear();
  mesh.commands.clear();
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int i = 0; i < data.CmdListsCount; ++i) append(mesh, *data.CmdLists[i]);
  return mesh;
}

}  // namespace bedmix
