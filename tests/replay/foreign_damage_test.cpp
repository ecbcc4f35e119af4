// SPDX-License-Identifier: MIT
#include "engine/core/rng.h"
#include "tests/replay/foreign_files.h"

#include <cmath>
#include <limits>

// Files of other programs that are damaged, or that are something else than they seem.

namespace bedmix::test {
namespace {

class ForeignDamage : public ForeignFiles {
 protected:
  void expect(const std::string& part, const std::string& name, const ForeignOptions& options = {}) const {
    const std::string found = message(name, options);
    EXPECT_NE(found.find(part), std::string::npos) << "'" << part << "' is not in '" << found << "'";
    EXPECT_NE(found.find(name + ".h5"), std::string::npos) << found;
  }
};

TEST_F(ForeignDamage, NaNIsNamedByFrameAndParticle) {
  overwrite("flat", "particles/grains/position/value", {3, 7, 1}, std::nan(""));
  expect("frame 3: the position of particle 53 is no number", "flat");
  overwrite("flat", "particles/grains/position/value", {3, 7, 1}, 1e300);
  expect("frame 3: the position of particle 53 is no number", "flat");
  overwrite("slab", "particles/fine/velocity/value", {2, 7, 1}, std::numeric_limits<double>::infinity());
  expect("frame 2: the velocity of particle", "slab");
}

TEST_F(ForeignDamage, TooFarForSinglePrecision) {
  for (const hsize_t axis : {0, 1, 2})
    overwrite("slab", "particles/fine/position/value", {4, 999, axis}, 1e39);
  overwrite("slab", "particles/fine/id/value", {4, 999}, 5000);
  expect("frame 4: particle 10001 is too far away", "slab");
}

TEST_F(ForeignDamage, TimesThatDoNotIncrease) {
  overwrite("flat", "particles/grains/position/time", {2}, 0.1);
  expect("frame 2 at time 0.1 does not follow frame 1 at time 0.1", "flat");
  overwrite("flat", "particles/grains/position/time", {2}, std::nan(""));
  expect("the time of frame 2 is nan, no number", "flat");
  overwrite("slab", "particles/coarse/position/time", {}, 0.0);
  expect("frame 1 at time 0.02 does not follow", "slab");
}

TEST_F(ForeignDamage, ElementsAtOtherSteps) {
  overwrite("slab", "particles/fine/velocity/step", {}, 100);
  expect("particles/fine/velocity was not recorded at the steps that the position was", "slab");
}

TEST_F(ForeignDamage, AParticleThatIsThereTwice) {
  overwrite("flat", "particles/grains/id", {4}, 3);
  expect("frame 0: particle 3 is there twice", "flat");
  overwrite("flat", "particles/grains/id", {4}, 3e9);
  expect("frame 0: there is a particle 3000000000", "flat");
}

TEST_F(ForeignDamage, AChosenTracerLeavesAllOtherSpeciesTheRest) {
  ForeignOptions options;
  options.tracerSpecies = 0;
  overwrite("snapshot", "particles/all/species", {2}, 1e9);
  EXPECT_EQ(message("snapshot", options), "");
}

TEST_F(ForeignDamage, NotWhatItSeems) {
  edit("bare", [](hid_t file) { H5Ldelete(file, "particles/all", H5P_DEFAULT); });
  expect("has no particles", "bare");
  edit("flat", [](hid_t file) { H5Ldelete(file, "particles/grains/position/value", H5P_DEFAULT); });
  expect("particles/grains/position/value", "flat");
  edit("snapshot", [](hid_t file) { H5Ldelete(file, "h5md", H5P_DEFAULT); });
  expect("is HDF5 but not H5MD", "snapshot");
  writeText(folder_ / "slab.h5", "");
  expect("is empty", "slab");
  writeText(folder_ / "slab.h5", "time,lacey\n");
  expect("is no recording", "slab");
  std::filesystem::remove(folder_ / "slab.h5");
  expect("does not exist", "slab");
}

TEST_F(ForeignDamage, CutOffAnywhere) {
  for (const char* name : {"flat", "snapshot"}) {
    const auto path = folder_ / (name + std::string(".h5"));
    const std::string whole = fileText(path);
    for (std::size_t size = 1; size < whole.size(); size += whole.size() / 12) {
      writeText(path, whole.substr(0, size));
      EXPECT_NE(message(name), "") << size;
    }
  }
}

TEST_F(ForeignDamage, FlippedBytesAreNoCrash) {
  Rng rng(3);
  const auto path = folder_ / "flat.h5";
  const std::string whole = fileText(path);
  for (int i = 0; i < 60; ++i) {
    std::string bytes = whole;
    const auto at = static_cast<std::size_t>(rng.uniform(0.0, static_cast<double>(bytes.size())));
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << (i % 8)));
    writeText(path, bytes);
    message("flat");
  }
}

}  // namespace
}  // namespace bedmix::test
