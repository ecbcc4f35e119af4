// SPDX-License-Identifier: MIT
#include "render/panel/panel_parts.h"

namespace bedmix {

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
