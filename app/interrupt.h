// SPDX-License-Identifier: MIT
#pragma once

namespace bedmix {

/// From now on the first SIGINT or SIGTERM is noted, for stopRequested(); the next one ends the program at
/// once.
void catchInterrupts();

/// Whether a SIGINT or SIGTERM has come.
bool stopRequested();

}  // namespace bedmix
