// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"
#include "engine/core/scene_reader.h"

#include <string_view>
#include <vector>

// What of a scene may change while its run goes on.

namespace bedmix {

/// Why a key or table (dotted, elements of lists by number or not) is as it is for the whole run, as the end
/// of "... is fixed while a run goes on: "; empty where it may change.
std::string_view reasonFixed(std::string_view path);

/// The scene with other values, checked as a scene file is; times are counted as before. Fails, too, on a key
/// that is fixed while a run goes on, with the reason, and on values that would switch the gas or friction on
/// or off, or let inlets come or go. Located as "--set path" or at the override's origin.
Result<Scene> steeredScene(const Scene& scene, const std::vector<Override>& changes);

}  // namespace bedmix
