// SPDX-License-Identifier: MIT
#include "tests/fuzz/mutations.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

namespace bedmix::fuzz {

namespace {

/// Of 1, 2, 4 or 8 bytes, at a multiple of their number more often than not.
void overwriteNumber(std::string& input, Rng& rng) {
  using Double = std::numeric_limits<double>;
  static const std::uint64_t numbers[] = {0,
                                          1,
                                          ~std::uint64_t{0},
                                          0x7fffffffffffffff,
                                          0x8000000000000000,
                                          0x7fffffff,
                                          0x80000000,
                                          std::bit_cast<std::uint64_t>(-1.0),
                                          std::bit_cast<std::uint64_t>(Double::max()),
                                          std::bit_cast<std::uint64_t>(Double::denorm_min()),
                                          std::bit_cast<std::uint64_t>(Double::infinity()),
                                          std::bit_cast<std::uint64_t>(Double::quiet_NaN()),
                                          rng.next()};
  const std::size_t size = std::size_t{1} << below(4, rng);
  if (input.size() < size) return;
  std::size_t at = below(input.size() - size + 1, rng);
  if (below(4, rng) != 0) at -= at % size;
  const std::uint64_t number = oneOf(numbers, rng);
  std::memcpy(input.data() + at, &number, size);
}

}  // namespace

std::size_t below(std::size_t n, Rng& rng) { return static_cast<std::size_t>(rng.next() % n); }

void mutateBytes(std::string& input, Rng& rng) {
  if (input.empty()) return input.push_back(static_cast<char>(rng.next()));
  const std::size_t at = below(input.size(), rng);
  const std::size_t length = 1 + below(std::min<std::size_t>(input.size() - at, 512), rng);
  switch (below(8, rng)) {
    case 0:
      return input.resize(at);
    case 1:
      input.insert(at, input.substr(at, length));
      return;
    case 2:
      input.erase(at, length);
      return;
    case 3:
      input.replace(below(input.size(), rng), length, input.substr(at, length));
      return;
    case 4:
    case 5:
      return overwriteNumber(input, rng);
    default:
      input[at] = static_cast<char>(input[at] ^ (1 << below(8, rng)));
  }
}

std::string splice(const std::string& first, const std::string& last, Rng& rng) {
  return first.substr(0, below(first.size() + 1, rng)) + last.substr(below(last.size() + 1, rng));
}

}  // namespace bedmix::fuzz
