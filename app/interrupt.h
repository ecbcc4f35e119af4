// SPDX-License-Identifier: MIT
#pragma once

namespace bedmix {

/// From now on the first SIGINT and the first SIGTERM are noted, for stopRequested(); the second of a kind
/// ends the program at once. So is any SIGUSR1, for checkpointRequested().
void catchInterrupts();

/// Whether a SIGINT or SIGTERM has come.
bool stopRequested();

/// Whether a SIGUSR1 has come since this was asked last.
bool checkpointRequested();

}  // namespace bedmix
