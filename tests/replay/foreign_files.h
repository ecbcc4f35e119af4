// SPDX-License-Identifier: MIT
#pragma once

#include "replay/open_recording.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>
#include <string>

namespace bedmix::test {

/// Copies of the files that foreign_h5md.py writes, for the test to read or to spoil.
class ForeignFiles : public testing::Test {
 protected:
  /// Skips the test where they could not be made.
  void SetUp() override;

  std::unique_ptr<RecordedFrames> open(const std::string& name, const ForeignOptions& options = {}) const;
  /// Why it does not open, or which frame cannot be read; empty where all is well.
  std::string message(const std::string& name, const ForeignOptions& options = {}) const;
  void edit(const std::string& name, const std::function<void(hid_t)>& change) const;
  /// Overwrites the number at this place.
  void overwrite(const std::string& name, const std::string& dataset, std::vector<hsize_t> at,
                 double value) const;

  TemporaryFolder folder_;
};

}  // namespace bedmix::test
