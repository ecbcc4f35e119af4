// SPDX-License-Identifier: MIT
#include "render/imgui_context.h"

#include <bit>
#include <filesystem>

namespace bedmix {

namespace {

/// From the Debian package fonts-dejavu-core.
constexpr const char* fontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

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

UiContext::Turn::Turn(const UiContext& context) : lock_(imguiMutex()) {
  ImGui::SetCurrentContext(context.context_);
}

UiContext::UiContext(std::span<const float> fontHeights) {
  const std::lock_guard lock(imguiMutex());
  context_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.DeltaTime = 1.0f / 60.0f;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  std::error_code missing;
  for (const float height : fontHeights) {
    if (std::filesystem::exists(fontFile, missing)) {
      io.Fonts->AddFontFromFileTTF(fontFile, height);
    } else {
      ImFontConfig config;
      config.SizePixels = height;
      io.Fonts->AddFontDefault(&config);
    }
  }
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  glyphs_ = {{width, height}, {pixels, pixels + static_cast<std::size_t>(width) * height}};
}

UiContext::~UiContext() {
  const std::lock_guard lock(imguiMutex());
  ImGui::DestroyContext(context_);
}

const UiMesh& UiContext::collect() {
  mesh_.vertices.clear();
  mesh_.indices.clear();
  mesh_.commands.clear();
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int i = 0; i < data.CmdListsCount; ++i) append(mesh_, *data.CmdLists[i]);
  return mesh_;
}

}  // namespace bedmix
