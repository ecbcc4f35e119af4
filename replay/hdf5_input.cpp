// SPDX-License-Identifier: MIT
#include "replay/hdf5_input.h"

#include "replay/hdf5_layout.h"
#include "replay/salvage_driver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace bedmix {

namespace {

H5 openFile(const std::filesystem::path& path, Reading reading) {
  quietHdf5();
  if (std::filesystem::file_size(path) == 0)
    throw Hdf5Error("is empty: its run ended before the first frame was written");
  if (H5Fis_hdf5(path.c_str()) <= 0)
    throw Hdf5Error("is no HDF5 file; name a trajectory.h5 or the folder of a run");
  const H5 access(H5Pcreate(H5P_FILE_ACCESS), "set up the file");
  H5Pset_file_locking(access, false, true);
  if (reading == Reading::remains) useSalvageDriver(access);
  try {
    return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), "open it"};
  } catch (const Hdf5Error& e) {
    if (std::string(e.what()).find("truncated file") == std::string::npos) throw;
    throw Hdf5Error("is cut off at " + std::to_string(std::filesystem::file_size(path)) +
                    " bytes, perhaps by an interrupted copy; copy it once more, or save what is there with "
                    "bedmix recover");
  }
}

H5 openDataset(hid_t file, const std::string& path) {
  return {H5Dopen2(file, path.c_str(), H5P_DEFAULT), "find " + path};
}

std::string toText(const std::vector<hsize_t>& extent) {
  std::string text;
  for (hsize_t n : extent) text += (text.empty() ? "" : " x ") + std::to_string(n);
  return text.empty() ? "one value" : text;
}

constexpr std::size_t mostIntegers = 16;  // of an attribute

bool isNumber(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_FLOAT || kind == H5T_INTEGER || kind == H5T_ENUM;
}

hsize_t sizeOf(hid_t file) {
  hsize_t size = 0;
  checkHdf5(H5Fget_filesize(file, &size), "find the size of the file");
  return size;
}

/// Bytes that a dataset has in the file: no more than that holds, whatever it says.
hsize_t storedBytes(hid_t file, hid_t dataset) {
  return std::min(H5Dget_storage_size(dataset), sizeOf(file));
}

/// Bytes that those in the file can stand for. Of one, deflate makes at most 1032 (https://zlib.net).
hsize_t explainedBytes(hid_t file, hid_t dataset, const std::string& path) {
  const H5 creation(H5Dget_create_plist(dataset), "read the layout of " + path);
  const bool isPacked = H5Pget_layout(creation) == H5D_CHUNKED && H5Pget_nfilters(creation) > 0;
  return storedBytes(file, dataset) * (isPacked ? 1032 : 1);
}

/// Opens a dataset whose chunks hold parts of many rows each, as h5py's do, again with room for all the
/// chunks of a row: else each of them would be unpacked anew for each row.
H5 keepingChunks(hid_t file, H5 dataset, const std::string& path) {
  constexpr double usual = 1 << 20, atLeast = 32 << 20;  // bytes
  const H5 creation(H5Dget_create_plist(dataset), "read the layout of " + path);
  if (H5Pget_layout(creation) != H5D_CHUNKED) return dataset;
  const std::vector<hsize_t> extent = extentOf(dataset, path);
  std::vector<hsize_t> chunk(extent.size());
  checkHdf5(H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data()),
            "read the chunks of " + path);
  const H5 type(H5Dget_type(dataset), "read the type of " + path);
  double bytes = static_cast<double>(H5Tget_size(type)), chunks = 1.0;
  for (std::size_t i = 0; i < chunk.size(); ++i) {
    bytes *= static_cast<double>(chunk[i]);
    if (i > 0) chunks *= std::ceil(static_cast<double>(extent[i]) / static_cast<double>(chunk[i]));
  }
  if (chunk.empty() || chunk[0] <= 1 || !(bytes * chunks > usual)) return dataset;

  hsize_t fileSize = 0;
  checkHdf5(H5Fget_filesize(file, &fileSize), "find the size of the file");
  const double room = std::min(bytes * chunks, atLeast + 0.5 * static_cast<double>(fileSize));
  const double slots = std::min(10.0 * chunks + 1.0, 1e6);
  const H5 access(H5Pcreate(H5P_DATASET_ACCESS), "set up " + path);
  checkHdf5(H5Pset_chunk_cache(access, static_cast<std::size_t>(slots), static_cast<std::size_t>(room), 1.0),
            "set up " + path);
  dataset = H5();
  return {H5Dopen2(file, path.c_str(), access), "find " + path};
}

}  // namespace

Hdf5Values::Hdf5Values(hid_t file, std::string path, std::vector<hsize_t> row, bool isSeries, Reading reading)
    : path_(std::move(path)),
      row_(std::move(row)),
      isSeries_(isSeries),
      reading_(reading),
      dataset_(keepingChunks(file, openDataset(file, path_), path_)) {
  std::vector<hsize_t> extent = extentOf(dataset_, path_);
  std::vector<hsize_t> expected = row_;
  if (isSeries_) {
    rows_ = extent.empty() ? 0 : extent[0];
    expected.insert(expected.begin(), rows_);
  }
  if (extent != expected)
    throw Hdf5Error(path_ + " holds " + toText(extent) + " where the scene asks for " + toText(expected));

  const H5 type(H5Dget_type(dataset_), "read the type of " + path_);
  if (!isNumber(type)) throw Hdf5Error(path_ + " does not hold numbers");
  const hsize_t rowBytes = rowSize() * H5Tget_size(type);
  const bool isWhole = reading_ == Reading::whole;
  if (rowBytes > 0) {
    // A kill can leave the extent ahead of the data. Of remains the list of what is there may be damaged.
    const hsize_t most = isWhole || !isSeries_ ? explainedBytes(file, dataset_, path_) : sizeOf(file);
    rows_ = std::min(rows_, most / rowBytes);
  }
  if (!isSeries_ && rows_ == 0) throw Hdf5Error(path_ + " is damaged: it has fewer bytes than it says");
  if (isWhole || !isSeries_) checkLayout(dataset_, rows_ * rowBytes, path_);
}

void Hdf5Values::expectChunks(hsize_t from, hsize_t count) const {
  const H5 creation(H5Dget_create_plist(dataset_), "read the layout of " + path_);
  const H5 type(H5Dget_type(dataset_), "read the type of " + path_);
  std::vector<hsize_t> chunk(row_.size() + 1), at(chunk.size(), 0);
  if (H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data()) !=
          static_cast<int>(chunk.size()) ||
      !std::equal(row_.begin(), row_.end(), chunk.begin() + 1) || chunk[0] == 0)
    throw Hdf5Error(path_ + " is not in chunks of whole rows");
  const hsize_t bytes = chunk[0] * rowSize() * H5Tget_size(type);
  for (at[0] = from / chunk[0] * chunk[0]; at[0] < from + count; at[0] += chunk[0]) {
    hsize_t found = 0;
    checkHdf5(H5Dget_chunk_storage_size(dataset_, at.data(), &found), "find a row of " + path_);
    if (found != bytes) throw Hdf5Error(fmt::format("row {} of {} is lost", at[0], path_));
  }
}

std::size_t Hdf5Values::rowSize() const {
  return std::accumulate(row_.begin(), row_.end(), std::size_t{1}, std::multiplies<>());
}

void Hdf5Values::read(hsize_t from, hsize_t count, hid_t type, void* into) const {
  if (reading_ == Reading::remains && isSeries_) expectChunks(from, count);
  std::vector<hsize_t> start(row_.size(), 0), counts = row_;
  if (isSeries_) {
    start.insert(start.begin(), from);
    counts.insert(counts.begin(), count);
  }
  if (counts.empty()) {  // one value
    checkHdf5(H5Dread(dataset_, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, into), "read " + path_);
    return;
  }
  const H5 fileSpace(H5Dget_space(dataset_), "read " + path_);
  const H5 rowSpace(H5Screate_simple(static_cast<int>(counts.size()), counts.data(), nullptr),
                    "read " + path_);
  checkHdf5(H5Sselect_hyperslab(fileSpace, H5S_SELECT_SET, start.data(), nullptr, counts.data(), nullptr),
            "read " + path_);
  checkHdf5(H5Dread(dataset_, type, rowSpace, fileSpace, H5P_DEFAULT, into), "read " + path_);
}

Hdf5Input::Hdf5Input(const std::filesystem::path& path, Reading reading)
    : reading_(reading), file_(openFile(path, reading)) {}

bool Hdf5Input::has(const std::string& path) const {
  // Each part on its own: H5Lexists fails where a part before the last is missing.
  for (std::size_t end = path.find('/');; end = path.find('/', end + 1)) {
    const std::string part = path.substr(0, end);
    if (checkHdf5(H5Lexists(file_, part.c_str(), H5P_DEFAULT), "look for " + part) == 0) return false;
    if (end == std::string::npos) return true;
  }
}

bool Hdf5Input::isGroup(const std::string& path) const {
  const H5 object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), "open " + path);
  return H5Iget_type(object) == H5I_GROUP;
}

std::vector<std::string> Hdf5Input::namesIn(const std::string& group) const {
  const H5 opened(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), "open " + group);
  const auto note = [](hid_t, const char* name, const H5L_info_t*, void* into) -> herr_t {
    static_cast<std::vector<std::string>*>(into)->emplace_back(name);
    return 0;
  };
  std::vector<std::string> names;
  checkHdf5(H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, note, &names), "list " + group);
  return names;
}

std::vector<hsize_t> Hdf5Input::extent(const std::string& dataset) const {
  return extentOf(openDataset(file_, dataset), dataset);
}

std::string Hdf5Input::text(const std::string& path) const {
  const H5 dataset = openDataset(file_, path);
  const H5 type(H5Dget_type(dataset), "read the type of " + path);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || !extentOf(dataset, path).empty())
    throw Hdf5Error(path + " does not hold one text of fixed length");
  const std::size_t size = H5Tget_size(type);
  if (size > storedBytes(file_, dataset)) throw Hdf5Error(path + " is damaged: it is longer than the file");
  std::string text(size, '\0');
  const H5 inMemory(H5Tcopy(type), "read " + path);
  checkHdf5(H5Dread(dataset, inMemory, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), "read " + path);
  text.resize(std::min(text.size(), text.find('\0')));
  return text;
}

std::vector<std::string> Hdf5Input::texts(const std::string& path) const {
  const H5 dataset = openDataset(file_, path);
  const H5 type(H5Dget_type(dataset), "read the type of " + path);
  const std::vector<hsize_t> extent = extentOf(dataset, path);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || extent.size() != 1)
    throw Hdf5Error(path + " does not hold texts of fixed length");
  const std::size_t size = H5Tget_size(type);
  if (size == 0 || extent[0] > storedBytes(file_, dataset) / size)
    throw Hdf5Error(path + " is damaged: it is longer than the file");
  checkLayout(dataset, extent[0] * size, path);
  std::string all(extent[0] * size, '\0');
  const H5 inMemory(H5Tcopy(type), "read " + path);
  if (!all.empty())
    checkHdf5(H5Dread(dataset, inMemory, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()), "read " + path);
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < all.size(); at += size) {
    const std::string text = all.substr(at, size);
    texts.push_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

std::vector<std::int32_t> Hdf5Input::integers(const std::string& path, const char* attribute) const {
  const std::string what = "read " + path + '.' + attribute;
  const H5 at(H5Aopen_by_name(file_, path.c_str(), attribute, H5P_DEFAULT, H5P_DEFAULT), what);
  const H5 type(H5Aget_type(at), what);
  const H5 space(H5Aget_space(at), what);
  if (H5Tget_class(type) != H5T_INTEGER) throw Hdf5Error("cannot " + what + ": it is no integer");
  const auto count = static_cast<std::size_t>(checkHdf5(H5Sget_simple_extent_npoints(space), what));
  if (count > mostIntegers) throw Hdf5Error("cannot " + what + ": it holds too many");
  std::vector<std::int32_t> values(count);
  checkHdf5(H5Aread(at, H5T_NATIVE_INT32, values.data()), what);
  return values;
}

bool Hdf5Input::readNumber(const std::string& path, const char* attribute, hid_t type, void* into) const {
  const std::string what = "read " + path + '.' + attribute;
  if (checkHdf5(H5Aexists_by_name(file_, path.c_str(), attribute, H5P_DEFAULT), what) == 0) return false;
  const H5 at(H5Aopen_by_name(file_, path.c_str(), attribute, H5P_DEFAULT, H5P_DEFAULT), what);
  const H5 space(H5Aget_space(at), what), stored(H5Aget_type(at), what);
  if (!isNumber(stored) || checkHdf5(H5Sget_simple_extent_npoints(space), what) != 1)
    throw Hdf5Error("cannot " + what + ": it is not one number");
  checkHdf5(H5Aread(at, type, into), what);
  return true;
}

}  // namespace bedmix
