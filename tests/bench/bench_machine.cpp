// SPDX-License-Identifier: MIT
#include "engine/core/simd.h"
#include "engine/core/thread_team.h"
#include "tests/bench/machine_kernels.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <vector>

// What this machine can do at most, as CSV: bandwidth of STREAM's triad in each cache and in memory (24 bytes
// an element: what a store reads first is not counted), and double-precision arithmetic in registers.

namespace bedmix::bench {

namespace {

double secondsOf(ThreadTeam& team, auto&& body) {
  const auto start = std::chrono::steady_clock::now();
  team.run(body);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The best of several turns, operations or bytes per second, all threads together. `work(member, times)`
/// returns what a member did.
double best(ThreadTeam& team, auto&& work) {
  double rate = 0.0;
  std::size_t times = 1;
  for (int turn = 0; turn < 8;) {
    std::vector<double> done(static_cast<std::size_t>(team.size()));
    const double seconds = secondsOf(team, [&](int member) { done[member] = work(member, times); });
    if (seconds < 0.05) {
      times *= 2;
      continue;
    }
    double all = 0.0;
    for (const double d : done) all += d;
    rate = std::max(rate, all / seconds);
    ++turn;
  }
  return rate;
}

struct alignas(64) Line {
  double values[8];
};

/// Three arrays of together `bytes` a thread.
double triadRate(ThreadTeam& team, std::size_t bytes) {
  // Apart by no power of two, or loads wait for stores whose addresses look the same.
  const std::size_t n = bytes / 24, apart = n + 40;
  std::vector<std::vector<Line>> arrays(static_cast<std::size_t>(team.size()));
  team.run([&](int member) { arrays[member].resize(3 * apart / 8); });
  return best(team, [&](int member, std::size_t times) {
    double* const a = arrays[member].front().values;
    for (std::size_t t = 0; t < times; ++t) triad(a, a + apart, a + 2 * apart, 0.5, n);
    return 24.0 * static_cast<double>(n * times);
  });
}

double arithmeticRate(ThreadTeam& team, Arithmetic (*kernel)(std::size_t)) {
  return best(team, [kernel](int, std::size_t times) {
    const Arithmetic done = kernel(1000 * times);
    return std::isfinite(done.result) ? done.operations : 0.0;
  });
}

void measure(SimdLevel level, int threads) {
  ThreadTeam team(threads);
  const auto row = [&](std::string_view what, double rate, std::string_view unit) {
    std::cout << fmt::format("{},{},{},{:.1f},{}\n", simdLevelNames()[static_cast<std::size_t>(level)],
                             threads, what, 1e-9 * rate, unit)
              << std::flush;
  };
  for (const std::size_t kibibytes : {24, 384, 6144, 393216})
    row(fmt::format("triad {} KiB a thread", kibibytes), triadRate(team, 1024 * kibibytes), "GB/s");
  row("products and sums", arithmeticRate(team, productsAndSums), "Gflop/s");
  row("fused", arithmeticRate(team, fused), "Gflop/s");
}

}  // namespace

}  // namespace bedmix::bench

int main() {
  using namespace bedmix;
  std::cout << "simd,threads,what,value,unit\n";
  for (const std::string_view name : simdLevelsHere()) {
    const SimdLevel level = *simdLevelNamed(name);
    useSimdLevel(level);
    bench::measure(level, 1);
    if (availableCores() > 1) bench::measure(level, availableCores());
  }
}
