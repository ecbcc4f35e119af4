// SPDX-License-Identifier: MIT
#include "tests/bench/memory.h"

#include <fstream>
#include <malloc.h>
#include <stdexcept>
#include <string>

namespace bedmix::bench {

namespace {

/// A line of /proc/self/status, see proc(5).
double bytesOf(const std::string& key) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;)
    if (word == key) {
      double kibibytes = 0.0;
      file >> kibibytes;
      return 1024.0 * kibibytes;
    }
  throw std::runtime_error("bench: /proc/self/status has no " + key);
}

}  // namespace

double memoryNow() {
  malloc_trim(0);
  return bytesOf("VmRSS:");
}

double peakMemory() { return bytesOf("VmHWM:"); }

void forgetPeakMemory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace bedmix::bench
