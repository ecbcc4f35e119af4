// SPDX-License-Identifier: MIT
#include "replay/hdf5_layout.h"

namespace bedmix {

std::vector<hsize_t> extentOf(hid_t dataset, const std::string& path) {
  const H5 space(H5Dget_space(dataset), "read the extents of " + path);
  std::vector<hsize_t> extent(
      static_cast<std::size_t>(checkHdf5(H5Sget_simple_extent_ndims(space), "read the extents of " + path)));
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  return extent;
}

namespace {

void expectStored(hid_t dataset, hsize_t bytes, const std::string& path) {
  if (H5Dget_storage_size(dataset) != bytes)
    throw Hdf5Error(path + " is damaged: it has not as many bytes as it says");
}

}  // namespace

void checkChunks(hid_t dataset, const std::string& path) {
  const H5 creation(H5Dget_create_plist(dataset), "read the layout of " + path);
  const H5 space(H5Dget_space(dataset), "read the extents of " + path);
  const H5 type(H5Dget_type(dataset), "read the type of " + path);
  std::vector<hsize_t> chunk(extentOf(dataset, path).size());
  checkHdf5(H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data()),
            "read the chunks of " + path);
  hsize_t bytes = 0;
  checkHdf5(H5Dget_num_chunks(dataset, space, &bytes), "read the chunks of " + path);
  for (const hsize_t n : chunk) bytes *= n;
  expectStored(dataset, bytes * H5Tget_size(type), path);
}

void checkLayout(hid_t dataset, hsize_t bytes, const std::string& path) {
  const H5 creation(H5Dget_create_plist(dataset), "read the layout of " + path);
  const H5D_layout_t layout = H5Pget_layout(creation);
  if (layout == H5D_CHUNKED && H5Pget_nfilters(creation) == 0) checkChunks(dataset, path);
  if (layout == H5D_COMPACT) expectStored(dataset, bytes, path);
}

}  // namespace bedmix
