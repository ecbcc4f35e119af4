// SPDX-License-Identifier: MIT
#pragma once

#include "render/panel/panel_action.h"
#include "render/panel/panel_model.h"

#include <imgui.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

// The sections of the panel, and what they are made of. Each draws its part of the model with Dear ImGui and
// adds what the person wants. Of this folder's own.

namespace bedmix {

using PanelActions = std::vector<PanelAction>;

void transportSection(const PanelModel& model, PanelActions& actions);
void gasSection(const PanelModel& model, PanelActions& actions);
void chartSection(const PanelModel& model, PanelActions& actions);
void pictureSection(const PanelModel& model, PanelActions& actions);
void samplingSection(const PanelModel& model, PanelActions& actions);
void tracerSection(const PanelModel& model, PanelActions& actions);
void particleSection(const PanelModel& model, PanelActions& actions);
void numbersSection(const PanelModel& model, PanelActions& actions);
void parametersSection(const PanelModel& model, PanelActions& actions);
void savingSection(const PanelModel& model, PanelActions& actions);

// Widgets that a script can find by their label (see ControlPanel::item); of "text###name", by the name.
/// Notes the last item of ImGui's own under a label.
void noteItem(const std::string& label);
bool button(const std::string& label, ImVec2 size = {});
bool checkBox(const std::string& label, bool* on);
bool section(const char* label, ImGuiTreeNodeFlags flags = 0);
/// As wide as the panel, without the label.
bool slider(const std::string& label, double* value, double low, double high, const char* format,
            ImGuiSliderFlags flags = 0);
/// With its label.
bool slider(const std::string& label, int* value, int low, int high);
/// Where they were drawn last, px: what `found` is told of, from now on.
void noteItemsIn(std::map<std::string, Box, std::less<>>* found);

/// The colour as ImGui wants it.
inline ImU32 packed(Rgba c) { return IM_COL32(c.r, c.g, c.b, c.a); }

/// What follows until endLocked() cannot be used where there is a reason, which the pointer brings up.
void beginLocked(std::string_view why);
void endLocked(std::string_view why);
/// A text that comes up over the last item.
void explain(std::string_view text);
/// Two columns of names and values.
void factTable(const char* id, const std::vector<PanelFact>& facts);
void text(std::string_view text);
/// In the colour of what is wrong, over several lines where it is long.
void troubleText(const std::string& text);

}  // namespace bedmix
