// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

namespace bedmix {

/// Makes files opened with `access`, for reading only, look as long as their superblock says, and closed in
/// peace. What is missing is bytes of 0xff: no number as a float, no address, no signature of HDF5, so that
/// nothing can pass for what was lost.
void useSalvageDriver(hid_t access);

}  // namespace bedmix
