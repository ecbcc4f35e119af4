// SPDX-License-Identifier: MIT
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <functional>
#include <limits>

namespace bedmix::test {
namespace {

/// A whole trajectory of 12 frames, to be spoiled.
class BadFile : public testing::Test {
 protected:
  void SetUp() override { record(path_, scene_, 12); }

  void edit(const std::function<void(hid_t)>& change) const {
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    change(file);
    ASSERT_GE(H5Fclose(file), 0);
  }
  void remove(const std::string& path) const {
    edit([&](hid_t file) { ASSERT_GE(H5Ldelete(file, path.c_str(), H5P_DEFAULT), 0) << path; });
  }
  /// Overwrites the first numbers of row `row`.
  void overwrite(const std::string& path, hsize_t row, double value) const {
    edit([&](hid_t file) {
      const hid_t dataset = H5Dopen2(file, path.c_str(), H5P_DEFAULT), space = H5Dget_space(dataset);
      hsize_t start[4] = {row}, count[4] = {1, 1, 1, 1};
      H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr);
      const hid_t one = H5Screate(H5S_SCALAR);
      EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, one, space, H5P_DEFAULT, &value), 0);
      H5Sclose(one), H5Sclose(space), H5Dclose(dataset);
    });
  }
  void setRows(const std::string& path, hsize_t rows) const {
    edit([&](hid_t file) {
      const hid_t dataset = H5Dopen2(file, path.c_str(), H5P_DEFAULT), space = H5Dget_space(dataset);
      hsize_t extent[4];
      H5Sget_simple_extent_dims(space, extent, nullptr);
      extent[0] = rows;
      EXPECT_GE(H5Dset_extent(dataset, extent), 0);
      H5Sclose(space), H5Dclose(dataset);
    });
  }
  /// The reader's message. All of them name the file and are troubles with a file.
  std::string message() const {
    const auto reader = TrajectoryReader::open(path_);
    if (reader) return "";
    EXPECT_EQ(reader.problems.front().trouble, Trouble::file);
    EXPECT_NE(toString(reader.problems.front()).find("trajectory.h5"), std::string::npos);
    return toString(reader.problems.front());
  }
  void expectMessage(const std::string& part) const {
    EXPECT_NE(message().find(part), std::string::npos) << "'" << part << "' is not in '" << message() << "'";
  }

  Scene scene_ = syntheticScene(true, true);
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "trajectory.h5";
};

TEST_F(BadFile, Missing) {
  std::filesystem::remove(path_);
  expectMessage("does not exist");
  EXPECT_FALSE(TrajectoryReader::open(folder_.path()));
}

TEST_F(BadFile, Foreign) {
  writeText(path_, "time,lacey\n");
  expectMessage("is no HDF5 file");
  writeText(path_, "");
  expectMessage("is empty");
}

TEST_F(BadFile, OtherHdf5) {
  remove("h5md");
  expectMessage("is HDF5 but not H5MD");
}

TEST_F(BadFile, H5mdOfSomeoneElse) {
  remove("parameters/scene");
  expectMessage("no run of bedmix");
}

TEST_F(BadFile, OtherVersion) {
  edit([](hid_t file) {
    const hid_t group = H5Gopen2(file, "h5md", H5P_DEFAULT), at = H5Aopen(group, "version", H5P_DEFAULT);
    const int version[] = {2, 0};
    EXPECT_GE(H5Awrite(at, H5T_NATIVE_INT, version), 0);
    H5Aclose(at), H5Gclose(group);
  });
  expectMessage("H5MD version 2");
}

TEST_F(BadFile, SpoiledScene) {
  edit([](hid_t file) {
    const hid_t dataset = H5Dopen2(file, "parameters/scene", H5P_DEFAULT), type = H5Dget_type(dataset);
    std::string text(H5Tget_size(type), '\0');
    H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
    text.replace(text.find("width"), 5, "widht");
    H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
    H5Tclose(type), H5Dclose(dataset);
  });
  expectMessage("trajectory.h5:parameters/scene:");
  expectMessage("widht");
}

TEST_F(BadFile, AnyMissingDataset) {
  for (const std::string dataset :
       {"particles/all/position/value", "particles/all/position/step", "particles/all/position/time",
        "particles/all/velocity/value", "particles/all/angular_velocity/value", "particles/all/species",
        "particles/all/id", "bedmix/gas/voidage/value", "bedmix/gas/pressure/value",
        "bedmix/gas/gas_velocity/value", "parameters/scene_name"}) {
    remove(dataset);
    expectMessage("cannot find " + dataset);
    record(path_, scene_, 3);
  }
}

TEST_F(BadFile, OtherNumberOfParticles) {
  remove("particles/all/species");
  edit([](hid_t file) {
    const hsize_t n = 59;
    const hid_t space = H5Screate_simple(1, &n, nullptr);
    H5Dclose(H5Dcreate2(file, "particles/all/species", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT,
                        H5P_DEFAULT));
    H5Sclose(space);
  });
  expectMessage("particles/all/species holds 59 where the scene asks for 60");
}

TEST_F(BadFile, UnknownSpecies) {
  edit([](hid_t file) {
    const hid_t dataset = H5Dopen2(file, "particles/all/species", H5P_DEFAULT);
    const std::vector<int> species(60, 2);
    H5Dwrite(dataset, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, species.data());
    H5Dclose(dataset);
  });
  expectMessage("particle 0 is of species 2");
}

TEST_F(BadFile, TimesThatDoNotIncrease) {
  overwrite("particles/all/position/time", 5, 0.04);
  expectMessage("frame 5 at 0.04 s, step 5000 does not follow frame 4 at 0.04 s, step 4000");
  overwrite("particles/all/position/time", 5, std::numeric_limits<double>::quiet_NaN());
  expectMessage("the time of frame 5");
  overwrite("particles/all/position/time", 5, 0.05);
  EXPECT_EQ(message(), "");
  overwrite("particles/all/position/step", 5, 7000.0);
  expectMessage("frame 6");
}

TEST_F(BadFile, NoNumberInAFrame) {
  for (const std::string element : {"particles/all/position", "particles/all/velocity",
                                    "particles/all/angular_velocity", "bedmix/gas/pressure"}) {
    record(path_, scene_, 12);
    overwrite(element + "/value", 7, INFINITY);
    auto reader = TrajectoryReader::open(path_);
    ASSERT_TRUE(reader);
    int frames = 0;
    while (reader->next()) ++frames;
    EXPECT_EQ(frames, 7);
    ASSERT_TRUE(reader->failure());
    EXPECT_NE(toString(*reader->failure()).find("frame 7 holds inf in " + element), std::string::npos);
    EXPECT_FALSE(reader->next());
    EXPECT_TRUE(reader->frame(8));
  }
}

TEST_F(BadFile, NoParticlesThatComeAndGo) {
  addFeed(scene_);
  const std::tuple<const char*, double, const char*> cases[] = {
      {"particles/all/id/value", 4000.0, "the id"},          {"particles/all/id/value", -7.0, "the id -7"},
      {"particles/all/species/value", 2.0, "the species 2"}, {"particles/all/kind/value", 9.0, "the kind 9"},
      {"particles/all/radius/value", 0.0, "the radius 0"},
  };
  for (const auto& [path, value, part] : cases) {
    std::filesystem::remove(path_);
    record(path_, scene_, 12);
    overwrite(path, 5, value);
    auto reader = TrajectoryReader::open(path_);
    ASSERT_TRUE(reader) << path;
    const auto frame = reader->frame(5);
    ASSERT_FALSE(frame) << path;
    EXPECT_NE(frame.problems.front().message.find(part), std::string::npos) << frame.problems.front().message;
    EXPECT_TRUE(reader->frame(6)) << path;
  }
  remove("particles/all/id/value");
  expectMessage("particles/all/id/value");
}

TEST_F(BadFile, AnUnfinishedLastFrameIsNotCounted) {
  setRows("particles/all/position/value", 13);
  EXPECT_EQ(playBack(path_, scene_).frames, 12u);
  setRows("particles/all/velocity/value", 11);
  EXPECT_EQ(playBack(path_, scene_).frames, 11u);
  setRows("particles/all/position/step", 10);
  EXPECT_EQ(playBack(path_, scene_).frames, 10u);
  setRows("bedmix/gas/voidage/value", 0);
  expectMessage("holds no whole frame");
}

TEST_F(BadFile, TruncatedAnywhere) {
  const std::string whole = fileText(path_);
  for (std::size_t size = 107; size < whole.size(); size += 211) {
    writeText(path_, whole.substr(0, size));
    expectMessage("is cut off at " + std::to_string(size) + " bytes");
  }
}

TEST_F(BadFile, WritersSayWhereTheyCannotWrite) {
  for (const auto& [path, part] : {std::pair{folder_ / "nowhere/t.h5", "No such file or directory"},
                                   std::pair{path_ / "t.h5", "Not a directory"}}) {
    const auto writer = TrajectoryWriter::create(path, scene_, {"0.1.0", "abc"});
    ASSERT_FALSE(writer);
    EXPECT_EQ(writer.problems.front().trouble, Trouble::file);
    EXPECT_NE(toString(writer.problems.front()).find(part), std::string::npos)
        << toString(writer.problems.front());
  }
}

TEST_F(BadFile, ASecondWriterIsRefusedAndSpoilsNothing) {
  auto first = TrajectoryWriter::create(path_, scene_, {"0.1.0", "abc"});
  ASSERT_TRUE(first);
  for (int i = 0; i < 4; ++i) first->accept(syntheticFrame(scene_, i));
  const auto second = TrajectoryWriter::create(path_, scene_, {"0.1.0", "abc"});
  ASSERT_FALSE(second);
  EXPECT_NE(toString(second.problems.front()).find("another program is writing it"), std::string::npos)
      << toString(second.problems.front());
  first->accept(syntheticFrame(scene_, 4));
  EXPECT_EQ(playBack(path_, scene_).frames, 5u);
}

TEST_F(BadFile, FramesThatDoNotFitTheSceneAreRefused) {
  for (const auto& spoil : std::vector<std::function<void(Frame&)>>{
           [](Frame& f) { f.position.pop_back(); }, [](Frame& f) { f.gas.voidage.clear(); },
           [](Frame& f) { f.species[0] = 0; }, [](Frame& f) { f.id[3] = 77; }}) {
    {
      auto writer = TrajectoryWriter::create(path_, scene_, {"0.1.0", "abc"});
      ASSERT_TRUE(writer);
      for (int i = 0; i < 5; ++i) {
        Frame frame = syntheticFrame(scene_, i);
        if (i == 3) spoil(frame);
        writer->accept(frame);
      }
      ASSERT_TRUE(writer->failure());
    }
    EXPECT_EQ(playBack(path_, scene_).frames, 3u);
  }
}

}  // namespace
}  // namespace bedmix::test
