// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

namespace bedmix::fuzz {

/// The bundled scene "tiny" with a dozen particles that drop; with its gas and friction, or without.
Scene smallScene(bool effects);

}  // namespace bedmix::fuzz
