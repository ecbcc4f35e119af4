// SPDX-License-Identifier: MIT
#pragma once

namespace bedmix {

extern const char* const programVersion;  // "0.1.0"
extern const char* const programCommit;   // abbreviated hash, with "-dirty" where the tree was changed

}  // namespace bedmix
