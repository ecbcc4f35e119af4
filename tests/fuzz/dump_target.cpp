// SPDX-License-Identifier: MIT
#include "replay/foreign/lammps_dump.h"
#include "replay/foreign/vtk_series.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/mutations.h"
#include "tests/fuzz/still_sound.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <unistd.h>

// Files of other programs: the first byte says of which kind, the rest is the file. Opened, and all read that
// is in it.

namespace {

using namespace bedmix;
using namespace bedmix::fuzz;

constexpr const char* kinds[] = {".dump", ".vtp", ".vtk", ".pvd"};

/// Files of this process, removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(std::filesystem::temp_directory_path() / ("bedmix-fuzz-dump-" + std::to_string(getpid()))) {
    std::filesystem::create_directory(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

template <class Vector>
void requireLength(const Vector& list, std::size_t particles) {
  require(list.empty() || list.size() == particles, "what a file says it says of each particle");
}

void requireSound(const ForeignFrame& frame) {
  const std::size_t n = frame.position.size();
  requireLength(frame.velocity, n);
  requireLength(frame.angularVelocity, n);
  requireLength(frame.radius, n);
  requireLength(frame.species, n);
  requireLength(frame.id, n);
  for (const auto* vectors : {&frame.position, &frame.velocity, &frame.angularVelocity})
    for (const Vec3d& v : *vectors)
      for (const double number : v) require(std::isfinite(number), "numbers of a frame are finite");
  for (const double r : frame.radius) require(std::isfinite(r), "radii are finite");
}

template <class Number>
void requireIncreasing(const std::vector<Number>& list) {
  for (std::size_t i = 1; i < list.size(); ++i) require(list[i - 1] < list[i], "steps and times increase");
}

}  // namespace

namespace bedmix::fuzz {

const std::vector<std::string>& seeds() {
  static const std::vector<std::string> list = [] {
    const std::string step =
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff pp mm\n-1 3\n0 2\n-2 2\n";
    std::vector<std::string> texts{
        '\0' + step + "ITEM: ATOMS id type x y z vx vy vz radius\n1 1 0 1 2 3 4 5 .1\n2 1 6 5 4 3 2 1 .2\n" +
            "ITEM: TIME\n.5\nITEM: TIMESTEP\n9\nITEM: NUMBER OF ATOMS\n0\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 "
            "1\n0 1\n"
            "ITEM: ATOMS id type x y z vx vy vz radius\n",
        '\0' + step + "ITEM: ATOMS xs ys omegaz diameter\n0 1 2 3\n.5 .25 6 5\n",
        "\3<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" "
        "file=\"a.vtp\"/></Collection></VTKFile>"};
    for (const auto& entry :
         std::filesystem::directory_iterator(BEDMIX_SOURCE_DIR "/tests/replay/samples/vtk")) {
      std::ifstream in(entry.path(), std::ios::binary);
      texts.push_back((entry.path().extension() == ".vtk" ? '\2' : '\1') +
                      std::string(std::istreambuf_iterator<char>(in), {}));
    }
    std::sort(texts.begin(), texts.end());
    return texts;
  }();
  return list;
}

void mutate(std::string& input, Rng& rng) { mutateBytes(input, rng); }

}  // namespace bedmix::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const TemporaryFolder folder;
  if (size == 0) return 0;
  const std::size_t kind = data[0] % std::size(kinds);
  const std::vector paths{folder.path() / (std::string("input") + kinds[kind])};
  std::ofstream(paths.front(), std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  auto source = kind == 0 ? openLammpsDump(paths) : openVtkSeries(paths);
  if (!source) {
    require(!source.problems.empty() && !source.problems.front().message.empty(), "a refusal has a reason");
    return 0;
  }
  const std::size_t frames = (*source)->steps().size();
  require(frames > 0, "a file that opens has a frame");
  requireIncreasing((*source)->steps());
  requireIncreasing((*source)->times());
  for (std::size_t i = 0; i < frames; ++i) {
    const auto frame = (*source)->frame(i);
    if (frame)
      requireSound(*frame);
    else
      require(!frame.problems.front().message.empty(), "a refusal has a reason");
  }
  return 0;
}
