// SPDX-License-Identifier: MIT
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/mutations.h"

#include <algorithm>
#include <cstring>

// Lets libFuzzer search with the target's own mutations and seeds, instead of fuzz_driver.cpp.

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  using namespace bedmix;
  Rng rng(seed);
  std::string input(reinterpret_cast<const char*>(data), size);
  if (size < 2 || fuzz::below(64, rng) == 0) input = fuzz::oneOf(fuzz::seeds(), rng);
  fuzz::mutate(input, rng);
  size = std::min(input.size(), most);
  std::memcpy(data, input.data(), size);
  return size;
}
