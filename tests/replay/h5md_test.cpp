// SPDX-License-Identifier: MIT
#include "engine/core/bed_statistics.h"
#include "engine/core/mixing.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>

// The file as a reader sees it that knows H5MD 1.1 and nothing of bedmix.

namespace bedmix::test {
namespace {

class H5md : public testing::Test {
 protected:
  void SetUp() override {
    record(folder_ / "trajectory.h5", scene_, frames);
    file_ = H5Fopen((folder_ / "trajectory.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    ASSERT_GE(file_, 0);
  }
  void TearDown() override { H5Fclose(file_); }

  std::vector<hsize_t> extent(const std::string& path) const {
    const hid_t dataset = H5Dopen2(file_, path.c_str(), H5P_DEFAULT), space = H5Dget_space(dataset);
    std::vector<hsize_t> dims(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, dims.data(), nullptr);
    H5Sclose(space);
    H5Dclose(dataset);
    return dims;
  }
  std::vector<double> numbers(const std::string& path) const {
    std::size_t count = 1;
    for (hsize_t n : extent(path)) count *= n;
    std::vector<double> values(count);
    const hid_t dataset = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    EXPECT_GE(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << path;
    H5Dclose(dataset);
    return values;
  }
  /// A fixed-length text attribute, its elements one after the other.
  std::string textAttribute(const std::string& path, const char* name) const {
    const hid_t at = H5Aopen_by_name(file_, path.c_str(), name, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(at);
    EXPECT_EQ(H5Tget_class(type), H5T_STRING);
    EXPECT_EQ(H5Tis_variable_str(type), 0);
    std::string text(H5Aget_storage_size(at), '\0');
    H5Aread(at, type, text.data());
    H5Tclose(type);
    H5Aclose(at);
    return text;
  }
  std::vector<int> integerAttribute(const std::string& path, const char* name) const {
    const hid_t at = H5Aopen_by_name(file_, path.c_str(), name, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space = H5Aget_space(at);
    std::vector<int> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Aread(at, H5T_NATIVE_INT, values.data());
    H5Sclose(space);
    H5Aclose(at);
    return values;
  }
  haddr_t address(const std::string& path) const {
    H5O_info_t info;
    EXPECT_GE(H5Oget_info_by_name(file_, path.c_str(), &info, H5P_DEFAULT), 0) << path;
    return info.addr;
  }

  static constexpr int frames = 12;
  Scene scene_ = syntheticScene(true, true);
  TemporaryFolder folder_;
  hid_t file_ = -1;
};

TEST_F(H5md, SaysWhatItIs) {
  EXPECT_EQ(integerAttribute("h5md", "version"), (std::vector<int>{1, 1}));
  EXPECT_EQ(textAttribute("h5md/creator", "name"), "bedmix");
  EXPECT_EQ(textAttribute("h5md/creator", "version"), "0.1.0");
  EXPECT_FALSE(textAttribute("h5md/author", "name").empty());
}

TEST_F(H5md, BoxLiesInsideTheParticles) {
  EXPECT_EQ(integerAttribute("particles/all/box", "dimension"), (std::vector<int>{2}));
  EXPECT_EQ(textAttribute("particles/all/box", "boundary"), "nonenone");
  EXPECT_EQ(numbers("particles/all/box/edges"), (std::vector<double>{0.048, 0.12}));
}

TEST_F(H5md, ElementsHaveTheirShapes) {
  using Extent = std::vector<hsize_t>;
  EXPECT_EQ(extent("particles/all/position/value"), (Extent{frames, 60, 2}));
  EXPECT_EQ(extent("particles/all/velocity/value"), (Extent{frames, 60, 2}));
  EXPECT_EQ(extent("particles/all/angular_velocity/value"), (Extent{frames, 60}));
  EXPECT_EQ(extent("particles/all/species"), (Extent{60}));
  EXPECT_EQ(extent("particles/all/id"), (Extent{60}));
  EXPECT_EQ(extent("bedmix/gas/voidage/value"), (Extent{frames, 10, 4}));
  EXPECT_EQ(extent("bedmix/gas/pressure/value"), (Extent{frames, 10, 4}));
  EXPECT_EQ(extent("bedmix/gas/gas_velocity/value"), (Extent{frames, 10, 4, 2}));
  EXPECT_EQ(extent("bedmix/gas/x"), (Extent{5}));
  EXPECT_EQ(extent("bedmix/gas/y"), (Extent{11}));
  EXPECT_EQ(extent("parameters/seed"), Extent{});
  EXPECT_EQ(numbers("particles/all/species")[3], 1.0);
  EXPECT_EQ(numbers("particles/all/species")[4], 0.0);
}

TEST_F(H5md, AllElementsShareStepAndTime) {
  for (const char* element :
       {"particles/all/velocity", "particles/all/angular_velocity", "observables/lacey", "observables/ashton",
        "observables/stddev", "observables/flux", "observables/pressure_drop", "observables/bed_height",
        "bedmix/gas/voidage", "bedmix/gas/pressure", "bedmix/gas/gas_velocity"})
    for (const char* axis : {"/step", "/time"})
      EXPECT_EQ(address(element + std::string(axis)), address("particles/all/position" + std::string(axis)))
          << element;
  EXPECT_EQ(numbers("particles/all/position/step")[7], 7000.0);
  EXPECT_EQ(numbers("particles/all/position/time")[7], 0.07);
}

TEST_F(H5md, ObservablesAreThoseOfTheFrames) {
  const GasGrid grid = makeGasGrid(scene_);
  for (int i = 0; i < frames; ++i) {
    const Frame frame = syntheticFrame(scene_, i);
    const MixingSample mixing = mixingSample(frame, samplingGrid(scene_));
    const auto row = static_cast<std::size_t>(i);
    EXPECT_EQ(numbers("observables/lacey/value")[row], mixing.lacey);
    EXPECT_EQ(numbers("observables/ashton/value")[row], mixing.ashton);
    EXPECT_EQ(numbers("observables/stddev/value")[row], mixing.stddev);
    EXPECT_EQ(numbers("observables/flux/value")[row], solidsFlux(frame, scene_));
    EXPECT_EQ(numbers("observables/pressure_drop/value")[row], pressureDrop(frame, grid));
    EXPECT_EQ(numbers("observables/bed_height/value")[row], bedHeight(frame, scene_));
  }
}

TEST(H5mdWithoutEffects, AbsentEffectsLeaveNoTrace) {
  Scene scene = syntheticScene(false, false);
  scene.flux.reset();
  scene.sampling.minParticles = 1000;  // so that no cell is used
  const TemporaryFolder folder;
  record(folder / "trajectory.h5", scene, 2);
  const hid_t file = H5Fopen((folder / "trajectory.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  for (const char* path :
       {"bedmix/gas", "particles/all/angular_velocity", "observables/flux", "observables/pressure_drop"})
    EXPECT_EQ(H5Lexists(file, path, H5P_DEFAULT), 0) << path;
  double lacey[2] = {0.0, 0.0};
  const hid_t dataset = H5Dopen2(file, "observables/lacey/value", H5P_DEFAULT);
  H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, lacey);
  EXPECT_TRUE(std::isnan(lacey[0]) && std::isnan(lacey[1]));
  H5Dclose(dataset);
  H5Fclose(file);
}

TEST_F(H5md, NothingTellsTheTimeOfDay) {
  const auto timeless = [](hid_t, const char* name, const H5O_info_t* info, void*) -> herr_t {
    EXPECT_EQ(info->ctime, 0) << name;
    return 0;
  };
  EXPECT_GE(H5Ovisit2(file_, H5_INDEX_NAME, H5_ITER_NATIVE, timeless, nullptr, H5O_INFO_TIME), 0);
}

}  // namespace
}  // namespace bedmix::test
