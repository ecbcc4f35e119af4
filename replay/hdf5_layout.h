// SPDX-License-Identifier: MIT
#pragma once

#include "replay/hdf5_handle.h"

#include <string>
#include <vector>

// What reading and writing have to know of a dataset that is there.

namespace bedmix {

std::vector<hsize_t> extentOf(hid_t dataset, const std::string& path);

// HDF5 believes the sizes a file gives, and reads and writes past the end of what is smaller.

/// Throws where the chunks of a dataset, in their index, are not all as large as it says, or where it has
/// none.
void checkChunks(hid_t dataset, const std::string& path);
/// The same where there are chunks without filters; a compact dataset, which lies in its header, must have
/// `bytes`.
void checkLayout(hid_t dataset, hsize_t bytes, const std::string& path);

}  // namespace bedmix
