// SPDX-License-Identifier: MIT
#include "render/panel/panel_parts.h"

namespace bedmix {

void noteItem(const std::string& label) {
  auto* const found = static_cast<std::map<std::string, Box, std::less<>>*>(ImGui::GetIO().UserData);
  const std::size_t id = label.find("###");
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  (*found)[id == std::string::npos ? label : label.substr(id + 3)] = {low.x, low.y, high.x, high.y};
}

void noteItemsIn(std::map<std::string, Box, std::less<>>* found) { ImGui::GetIO().UserData = found; }

bool button(const std::string& label, ImVec2 size) {
  const bool pressed = ImGui::Button(label.c_str(), size);
  noteItem(label);
  return pressed;
}

bool checkBox(const std::string& label, bool* on) {
  const bool pressed = ImGui::Checkbox(label.c_str(), on);
  noteItem(label);
  return pressed;
}

bool section(const char* label, ImGuiTreeNodeFlags flags) {
  const bool isOpen = ImGui::CollapsingHeader(label, flags);
  noteItem(label);
  return isOpen;
}

bool slider(const std::string& label, double* value, double low, double high, const char* format,
            ImGuiSliderFlags flags) {
  ImGui::SetNextItemWidth(-1.0f);
  const bool moved =
      ImGui::SliderScalar(("##" + label).c_str(), ImGuiDataType_Double, value, &low, &high, format, flags);
  noteItem(label);
  return moved;
}

bool slider(const std::string& label, int* value, int low, int high) {
  ImGui::SetNextItemWidth(-7.0f * ImGui::GetFontSize());
  const bool moved = ImGui::SliderInt(label.c_str(), value, low, high, "%d", ImGuiSliderFlags_AlwaysClamp);
  noteItem(label);
  return moved;
}

void beginLocked(std::string_view why) { ImGui::BeginDisabled(!why.empty()); }

void endLocked(std::string_view why) {
  ImGui::EndDisabled();
  if (!why.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
    ImGui::BeginTooltip();
    text(why);
    ImGui::EndTooltip();
  }
}

void explain(std::string_view what) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(22.0f * ImGui::GetFontSize());
  text(what);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void factTable(const char* id, const std::vector<PanelFact>& facts) {
  if (facts.empty() || !ImGui::BeginTable(id, 2)) return;
  for (const PanelFact& fact : facts) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text(fact.name);
    ImGui::TableNextColumn();
    if (fact.share >= 0.0f)
      ImGui::ProgressBar(fact.share, {-1.0f, ImGui::GetFontSize()}, fact.value.c_str());
    else
      text(fact.value);
  }
  ImGui::EndTable();
}

void text(std::string_view what) { ImGui::TextUnformatted(what.data(), what.data() + what.size()); }

void troubleText(const std::string& what) {
  ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 130, 90, 255));
  ImGui::PushTextWrapPos(0.0f);
  text(what);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

}  // namespace bedmix
