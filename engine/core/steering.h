// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"
#include "engine/core/scene_reader.h"

#include <string>
#include <string_view>
#include <vector>

// What of a scene may change while its run goes on.

namespace bedmix {

/// Why a key (dotted, elements of lists by number or not) is as it is for the whole run; empty where it may
/// change. Known from one table, for keys and whole tables.
std::string_view reasonFixed(std::string_view path);

/// The scene with other values, checked as a scene file is. Fails, too, on a key that is fixed while a run
/// goes on, with the reason, and on a value that would switch an effect on or off.
Result<Scene> steeredScene(const Scene& scene, const std::vector<Override>& changes);

}  // namespace bedmix
