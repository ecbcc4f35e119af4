// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/view_model.h"
#include "render/draw_list.h"
#include "render/layout.h"

#include <optional>
#include <vector>

namespace bedmix {

/// Draws the path of the picked particle, and a ring around it, as the only content of the list.
void drawParticleMarks(DrawList& list, const std::vector<ViewBed>& beds, const PictureLayout& layout,
                       const std::optional<PickedParticle>& picked);

/// What the panel says of a particle; nothing where it is not there.
std::vector<PanelFact> particleFacts(const ViewBed& bed, std::int32_t id);

}  // namespace bedmix
