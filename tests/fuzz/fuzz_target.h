// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/rng.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// What a fuzz target is made of. The driver (fuzz_driver.cpp) and libFuzzer (libfuzzer_hooks.cpp) feed it.

/// Reads the bytes as the program would, and aborts where something comes out that must not.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace bedmix::fuzz {

/// Valid inputs to start from; the same in every process.
const std::vector<std::string>& seeds();

/// Changes the input in one place, by something typical of what goes wrong with its kind.
void mutate(std::string& input, Rng& rng);

}  // namespace bedmix::fuzz
