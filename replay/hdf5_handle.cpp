// SPDX-License-Identifier: MIT
#include "replay/hdf5_handle.h"

namespace bedmix {

namespace {

/// Keeps the innermost entry of the error stack.
herr_t keepFirst(unsigned n, const H5E_error2_t* error, void* into) {
  if (n == 0) *static_cast<std::string*>(into) = error->desc;
  return 0;
}

/// HDF5's reason in one line. Its low-level text lists times and addresses around the system's own message,
/// which is what people know.
std::string lastReason() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keepFirst, &text);
  const std::string mark = "error message = '";
  if (const auto at = text.find(mark); at != std::string::npos) {
    const auto from = at + mark.size();
    text = text.substr(from, text.find('\'', from) - from);
  }
  return text.empty() ? "no reason given" : text;
}

}  // namespace

void quietHdf5() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // of this thread
}

hid_t checkHdf5(hid_t result, const std::string& what) {
  if (result < 0) throw Hdf5Error("cannot " + what + ": " + lastReason());
  return result;
}

}  // namespace bedmix
