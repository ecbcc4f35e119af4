// SPDX-License-Identifier: MIT
#pragma once

// Before a loop whose turns do not depend on each other though it reads neighbours, which compilers cannot
// see: what it writes it reads nowhere but in the same place.
#if defined(__clang__)
#define BEDMIX_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define BEDMIX_INDEPENDENT _Pragma("GCC ivdep")
#else
#define BEDMIX_INDEPENDENT
#endif
