// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <algorithm>
#include <iterator>

namespace bedmix {

/// A file as a driver of ours keeps it; drivers add to it.
struct DriverFile {
  H5FD_t base{};  // first, as HDF5 knows a file by it
  int descriptor = -1;
  haddr_t allocated = 0;  // end of what HDF5 has given out
};

/// The File, a DriverFile, that HDF5 means.
template <class File>
File& fileOf(H5FD_t* base) {
  return static_cast<File&>(*reinterpret_cast<DriverFile*>(base));
}
template <class File>
const File& fileOf(const H5FD_t* base) {
  return static_cast<const File&>(*reinterpret_cast<const DriverFile*>(base));
}

/// What all our drivers have in common; opening, closing, the end of the file, reading and writing are
/// theirs.
template <class File>
H5FD_class_t commonDriver(const char* name) {
  H5FD_class_t driver{};
  driver.name = name;
  driver.maxaddr = HADDR_MAX / 2;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.query = [](const H5FD_t*, unsigned long* features) -> herr_t { return *features = 0, 0; };
  driver.get_eoa = [](const H5FD_t* file, H5FD_mem_t) { return fileOf<File>(file).allocated; };
  driver.set_eoa = [](H5FD_t* file, H5FD_mem_t, haddr_t end) -> herr_t {
    return fileOf<File>(file).allocated = end, 0;
  };
  std::fill(std::begin(driver.fl_map), std::end(driver.fl_map), H5FD_MEM_SUPER);
  return driver;
}

}  // namespace bedmix
