// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace bedmix {

/// Adds --gl to a command that draws: where its OpenGL comes from.
void addGlOption(CLI::App& command);

}  // namespace bedmix
