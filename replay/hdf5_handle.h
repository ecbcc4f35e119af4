// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <hdf5.h>

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

// The little of HDF5 that the writer and the reader share. Inside replay/ a call that fails throws Hdf5Error;
// the public functions turn it into a Diagnostic.

namespace bedmix {

/// A failed HDF5 call, in one line: what was tried and the innermost reason HDF5 gives.
struct Hdf5Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// To be called before HDF5 is used: it neither prints nor does anything at exit, where it would once more
/// try to write what a full disk has refused. Every frame is flushed before.
void quietHdf5();

/// Passes an identifier or a status on; throws "cannot `what`: reason" where it is negative.
hid_t checkHdf5(hid_t result, const std::string& what);

/// Owns an HDF5 identifier of any kind.
class H5 {
 public:
  H5() = default;
  H5(hid_t id, const std::string& what) : id_(checkHdf5(id, what)) {}
  H5(H5&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  H5& operator=(H5&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~H5() {
    if (id_ >= 0) H5Idec_ref(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_ = H5I_INVALID_HID;
};

/// The type in memory of what files hold.
template <class T>
hid_t h5Type();
template <>
inline hid_t h5Type<float>() {
  return H5T_NATIVE_FLOAT;
}
template <>
inline hid_t h5Type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t h5Type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}
template <>
inline hid_t h5Type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
inline hid_t h5Type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
inline hid_t h5Type<std::uint64_t>() {
  return H5T_NATIVE_UINT64;
}

}  // namespace bedmix
