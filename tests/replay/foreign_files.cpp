// SPDX-License-Identifier: MIT
#include "tests/replay/foreign_files.h"

namespace bedmix::test {

void ForeignFiles::SetUp() {
  if (!std::filesystem::exists(FOREIGN_FOLDER)) GTEST_SKIP() << "no python3-h5py when the tests were built";
  std::filesystem::copy(FOREIGN_FOLDER, folder_.path());
}

std::unique_ptr<RecordedFrames> ForeignFiles::open(const std::string& name,
                                                   const ForeignOptions& options) const {
  auto recording = openRecording(folder_ / (name + ".h5"), options);
  if (recording) return std::move(recording->frames);
  ADD_FAILURE() << toString(recording.problems.front());
  return nullptr;
}

std::string ForeignFiles::message(const std::string& name, const ForeignOptions& options) const {
  auto recording = openRecording(folder_ / (name + ".h5"), options);
  if (!recording) {
    EXPECT_FALSE(recording.problems.front().message.empty());
    return toString(recording.problems.front());
  }
  while (recording->frames->next()) continue;
  return recording->frames->failure() ? toString(*recording->frames->failure()) : "";
}

void ForeignFiles::edit(const std::string& name, const std::function<void(hid_t)>& change) const {
  const hid_t file = H5Fopen((folder_ / (name + ".h5")).c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  change(file);
  ASSERT_GE(H5Fclose(file), 0);
}

void ForeignFiles::overwrite(const std::string& name, const std::string& dataset, std::vector<hsize_t> at,
                             double value) const {
  edit(name, [&](hid_t file) {
    const hid_t values = H5Dopen2(file, dataset.c_str(), H5P_DEFAULT), space = H5Dget_space(values);
    const hid_t one = H5Screate(H5S_SCALAR);
    if (!at.empty()) H5Sselect_elements(space, H5S_SELECT_SET, 1, at.data());
    EXPECT_GE(H5Dwrite(values, H5T_NATIVE_DOUBLE, one, at.empty() ? one : space, H5P_DEFAULT, &value), 0);
    H5Sclose(one), H5Sclose(space), H5Dclose(values);
  });
}

}  // namespace bedmix::test
