// SPDX-License-Identifier: MIT
#include <cstdint>

// Highway's library measures the resolution of a timer when it is loaded, with an instruction (RDTSCP) that
// valgrind claims to know and, on machines without it, does not run. No loop of ours asks for it, so that
// this stands in its place wherever instructions are counted.
namespace hwy::platform {

std::uint64_t TimerResolution();
std::uint64_t TimerResolution() { return 1; }

}  // namespace hwy::platform
