// SPDX-License-Identifier: MIT
#include "replay/foreign/foreign_frames.h"
#include "replay/foreign/h5md_source.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/mutations.h"
#include "tests/fuzz/still_sound.h"
#include "tests/fuzz/temporary_file.h"

#include <algorithm>
#include <iterator>

// H5MD files of other programs: opened, and all frames made those of a bed. The corpus are files of
// tests/replay/foreign_h5md.py.

namespace bedmix::fuzz {

const std::vector<std::string>& seeds() {
  static const std::vector<std::string> written = [] {
    std::vector<std::string> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(BEDMIX_SOURCE_DIR "/tests/fuzz/corpus/foreign")) {
      std::ifstream in(entry.path(), std::ios::binary);
      files.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    std::sort(files.begin(), files.end());
    return files;
  }();
  return written;
}

void mutate(std::string& input, Rng& rng) { mutateBytes(input, rng); }

}  // namespace bedmix::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace bedmix;
  using namespace bedmix::fuzz;
  writeTemporary(data, size);
  ForeignOptions options;
  options.diameter = 0.002;
  options.timeStep = 1e-3;
  auto source = H5mdSource::open(temporaryPath(), "");
  if (!source) {
    require(!source.problems.empty() && !source.problems.front().message.empty(), "a refusal has a reason");
    return 0;
  }
  auto frames = ForeignFrames::make(std::move(*source), temporaryPath(), options);
  if (!frames) {
    require(!frames.problems.empty() && !frames.problems.front().message.empty(), "a refusal has a reason");
    return 0;
  }
  std::size_t read = 0;
  for (; const FramePtr frame = frames->next(); ++read) {
    requireFinite(*frame);
    require(std::is_sorted(frame->id.begin(), frame->id.end()), "rows are in order of id");
    require(frame->velocity.size() == frame->size() && frame->species.size() == frame->size(),
            "particles have all their numbers");
  }
  require(read == frames->times().size() || frames->failure(), "a frame that is missing has a reason");
  return 0;
}
