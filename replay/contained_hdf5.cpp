// SPDX-License-Identifier: MIT
#include "replay/contained_hdf5.h"

#include "replay/child_process.h"

#include <new>

namespace bedmix {

void allowWorkOn(const std::filesystem::path& file) {
  constexpr std::uintmax_t bytesPerSecond = 20'000'000, atLeast = 256'000'000;
  const std::uintmax_t size = std::filesystem::file_size(file);
  ChildProcess::allowMemory(atLeast + 4 * size);
  ChildProcess::allowComputing(std::chrono::seconds(5 + size / bytesPerSecond));
}

std::string troubleOf(const std::function<void()>& work) {
  try {
    work();
    return "";
  } catch (const std::bad_alloc&) {
    return "asks for more memory than a file of its size can need; copy it once more from where it was "
           "recorded";
  } catch (const std::exception& e) {
    return e.what();
  }
}

std::string damageShownBy(const std::string& end) {
  return "is damaged: the HDF5 library fails on it (" + end +
         "); copy it once more from where it was recorded";
}

}  // namespace bedmix
