// SPDX-License-Identifier: MIT
#include "replay/hdf5_output.h"

#include "replay/commit_driver.h"
#include "replay/hdf5_layout.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace bedmix {

namespace {

/// A fixed-length UTF-8 text type: readers of H5MD stumble over those of variable length.
H5 textType(std::size_t length) {
  H5 type(H5Tcopy(H5T_C_S1), "make a text type");
  H5Tset_size(type, std::max<std::size_t>(length, 1));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

/// A scalar for one value, as h5py and H5MD's own readers like it, else a list.
H5 space(std::size_t count) {
  if (count == 1) return {H5Screate(H5S_SCALAR), "make a data space"};
  const hsize_t dims = count;
  return {H5Screate_simple(1, &dims, nullptr), "make a data space"};
}

H5 openFile(const std::filesystem::path& path, Origin origin) {
  quietHdf5();
  // The earliest format is the one that opens again after its writer was killed.
  H5 access(H5Pcreate(H5P_FILE_ACCESS), "set up the file");
  H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18);
  if (origin == Origin::rehearsed)
    useRehearsalDriver(access);
  else
    useCommitDriver(access);
  if (origin == Origin::made)
    return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), "make the file"};
  return {H5Fopen(path.c_str(), H5F_ACC_RDWR, access), "open it for writing"};
}

/// Settings of a new dataset: without the time of day, which would tell two files of one run apart.
H5 datasetSettings(const std::string& path) {
  H5 settings(H5Pcreate(H5P_DATASET_CREATE), "set up " + path);
  checkHdf5(H5Pset_obj_track_times(settings, false), "set up " + path);
  return settings;
}

/// A dataset of so many dimensions that can grow along the first.
H5 createGrowing(hid_t file, const std::string& path, hid_t type, const std::vector<hsize_t>& extent,
                 const std::vector<hsize_t>& chunk) {
  std::vector<hsize_t> largest = extent;
  largest[0] = H5S_UNLIMITED;
  const int dimensions = static_cast<int>(extent.size());
  const H5 dataSpace(H5Screate_simple(dimensions, extent.data(), largest.data()), "make a data space");
  const H5 settings = datasetSettings(path);
  checkHdf5(H5Pset_chunk(settings, dimensions, chunk.data()), "set up " + path);
  return {H5Dcreate2(file, path.c_str(), type, dataSpace, H5P_DEFAULT, settings, H5P_DEFAULT),
          "make " + path};
}

/// Of the same extents but for the first.
H5 findGrowing(hid_t file, const std::string& path, std::vector<hsize_t> extent) {
  H5 dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), "find " + path);
  const std::vector<hsize_t> found = extentOf(dataset, path);
  if (!found.empty()) extent[0] = found[0];
  if (found != extent) throw Hdf5Error(path + " has other extents than the scene asks for");
  checkChunks(dataset, path);
  return dataset;
}

H5 openSeries(hid_t file, const std::string& path, hid_t type, const std::vector<hsize_t>& row,
              Origin origin) {
  // A number a frame shares a chunk with its neighbours in time; anything bigger has its own.
  constexpr hsize_t numbersPerChunk = 128;
  const bool isNumber = row.empty() && H5Tget_size(type) <= sizeof(double);
  std::vector<hsize_t> extent{0}, chunk{isNumber ? numbersPerChunk : 1};
  for (hsize_t n : row) {
    extent.push_back(n);
    chunk.push_back(std::max<hsize_t>(n, 1));
  }
  return origin == Origin::made ? createGrowing(file, path, type, extent, chunk)
                                : findGrowing(file, path, extent);
}

}  // namespace

TimeSeries::TimeSeries(hid_t file, std::string path, H5 type, std::vector<hsize_t> row, Origin origin)
    : path_(std::move(path)),
      type_(std::move(type)),
      row_(std::move(row)),
      rowBytes_(std::accumulate(row_.begin(), row_.end(), H5Tget_size(type_), std::multiplies<>())),
      dataset_(openSeries(file, path_, type_, row_, origin)) {}

TimeSeries::Selection TimeSeries::select(hsize_t index) const {
  std::vector<hsize_t> start{index}, count{1};
  start.resize(row_.size() + 1);
  count.insert(count.end(), row_.begin(), row_.end());
  Selection row{
      H5(H5Dget_space(dataset_), "find a row of " + path_),
      H5(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), "find a row of " + path_)};
  checkHdf5(H5Sselect_hyperslab(row.inFile, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
            "find a row of " + path_);
  return row;
}

void TimeSeries::append(hsize_t index, std::span<const std::byte> row) {
  if (row.size() != rowBytes_)
    throw Hdf5Error("cannot write " + path_ + ": a frame brings " + std::to_string(row.size()) +
                    " bytes where the scene asks for " + std::to_string(rowBytes_));
  std::vector<hsize_t> extent{index + 1};
  extent.insert(extent.end(), row_.begin(), row_.end());
  checkHdf5(H5Dset_extent(dataset_, extent.data()), "extend " + path_);
  const Selection at = select(index);
  checkHdf5(H5Dwrite(dataset_, type_, at.inMemory, at.inFile, H5P_DEFAULT, row.data()), "write " + path_);
}

hsize_t TimeSeries::rows() const { return extentOf(dataset_, path_)[0]; }

bool TimeSeries::holds(hsize_t index, std::span<const std::byte> row) const {
  std::vector<std::byte> found(rowBytes_);
  const Selection at = select(index);
  checkHdf5(H5Dread(dataset_, type_, at.inMemory, at.inFile, H5P_DEFAULT, found.data()), "read " + path_);
  return std::equal(row.begin(), row.end(), found.begin(), found.end());
}

void TimeSeries::cut(hsize_t rows) {
  std::vector<hsize_t> extent = extentOf(dataset_, path_);
  if (extent[0] <= rows) return;
  extent[0] = rows;
  checkHdf5(H5Dset_extent(dataset_, extent.data()), "shorten " + path_);
}

ByteStore::ByteStore(hid_t file, std::string path, hsize_t chunk, Origin origin)
    : path_(std::move(path)),
      dataset_(origin == Origin::made ? createGrowing(file, path_, H5T_STD_U8LE, {0}, {chunk})
                                      : findGrowing(file, path_, {0})) {}

void ByteStore::write(std::span<const std::byte> bytes) {
  const hsize_t start = 0, count = bytes.size();
  if (extentOf(dataset_, path_)[0] < count) checkHdf5(H5Dset_extent(dataset_, &count), "extend " + path_);
  const H5 fileSpace(H5Dget_space(dataset_), "extend " + path_);
  const H5 byteSpace(H5Screate_simple(1, &count, nullptr), "write " + path_);
  checkHdf5(H5Sselect_hyperslab(fileSpace, H5S_SELECT_SET, &start, nullptr, &count, nullptr),
            "write " + path_);
  checkHdf5(H5Dwrite(dataset_, H5T_NATIVE_UINT8, byteSpace, fileSpace, H5P_DEFAULT, bytes.data()),
            "write " + path_);
}

Hdf5Output::Hdf5Output(const std::filesystem::path& path, Origin origin)
    : origin_(origin), file_(openFile(path, origin)) {}

void Hdf5Output::group(const std::string& path) const {
  H5(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "make " + path);
}

void Hdf5Output::text(const std::string& path, const std::string& value) const {
  const H5 type = textType(value.size());
  const H5 dataset(
      H5Dcreate2(file_, path.c_str(), type, space(1), H5P_DEFAULT, datasetSettings(path), H5P_DEFAULT),
      "make " + path);
  checkHdf5(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.c_str()), "write " + path);
}

void Hdf5Output::replaceText(const std::string& path, const std::string& value) const {
  const H5 dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), "find " + path);
  const H5 type(H5Dget_type(dataset), "read the type of " + path);
  if (H5Tget_size(type) != value.size())
    throw Hdf5Error(path + " is of another length than what replaces it");
  checkHdf5(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.c_str()), "write " + path);
}

TimeSeries Hdf5Output::texts(const std::string& path, std::size_t size) const {
  return {file_, path, textType(size), {}, origin_};
}

void Hdf5Output::attribute(const std::string& path, const char* name,
                           const std::vector<std::string>& values) const {
  std::size_t length = 0;
  for (const std::string& v : values) length = std::max(length, v.size());
  std::string block;
  for (std::string v : values) v.resize(std::max<std::size_t>(length, 1)), block += v;
  const H5 type = textType(length);
  const H5 at(H5Acreate_by_name(file_, path.c_str(), name, type, space(values.size()), H5P_DEFAULT,
                                H5P_DEFAULT, H5P_DEFAULT),
              "make " + path + '.' + name);
  checkHdf5(H5Awrite(at, type, block.data()), "write " + path + '.' + name);
}

void Hdf5Output::attribute(const std::string& path, const char* name,
                           std::span<const std::int32_t> values) const {
  const H5 at(H5Acreate_by_name(file_, path.c_str(), name, H5T_STD_I32LE, space(values.size()), H5P_DEFAULT,
                                H5P_DEFAULT, H5P_DEFAULT),
              "make " + path + '.' + name);
  checkHdf5(H5Awrite(at, H5T_NATIVE_INT32, values.data()), "write " + path + '.' + name);
}

void Hdf5Output::fixed(const std::string& path, hid_t type, const std::vector<hsize_t>& extent,
                       const void* values) const {
  const H5 dataSpace(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
                     "make " + path);
  const H5 dataset(
      H5Dcreate2(file_, path.c_str(), type, dataSpace, H5P_DEFAULT, datasetSettings(path), H5P_DEFAULT),
      "make " + path);
  checkHdf5(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write " + path);
}

void Hdf5Output::link(const std::string& from, const std::string& to) const {
  checkHdf5(H5Lcreate_hard(file_, from.c_str(), file_, to.c_str(), H5P_DEFAULT, H5P_DEFAULT), "link " + to);
}

void Hdf5Output::flush() const { checkHdf5(H5Fflush(file_, H5F_SCOPE_GLOBAL), "write the file"); }

}  // namespace bedmix
