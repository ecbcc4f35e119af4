// SPDX-License-Identifier: MIT
#pragma once

#include "replay/hdf5_handle.h"

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace bedmix {

/// Whether a file and what stands in it is made anew; or is there already; or is there, and stays as it is
/// whatever is written.
enum class Origin { made, found, rehearsed };

/// One dataset that grows by a row a frame. Chunks are whole rows, so that a row is written once.
class TimeSeries {
 public:
  /// Fails where the one that is found has other extents.
  TimeSeries(hid_t file, std::string path, H5 type, std::vector<hsize_t> row, Origin origin);

  /// Writes row `index` and makes it the last one. `row` must have the size the series was made with.
  void append(hsize_t index, std::span<const std::byte> row);
  hsize_t rows() const;
  /// Whether row `index`, which must be there, is the same to the bit.
  bool holds(hsize_t index, std::span<const std::byte> row) const;
  /// Leaves no more than the first `rows`.
  void cut(hsize_t rows);
  std::size_t rowBytes() const { return rowBytes_; }

 private:
  /// Row `index` as HDF5 wants it told.
  struct Selection {
    H5 inFile, inMemory;
  };
  Selection select(hsize_t index) const;

  std::string path_;
  H5 type_;
  std::vector<hsize_t> row_;  // extents of a row
  std::size_t rowBytes_;
  H5 dataset_;
};

/// Bytes that are replaced as a whole. What is shorter than what it replaces is followed by the rest of that.
class ByteStore {
 public:
  /// In chunks of that many bytes, where it is made.
  ByteStore(hid_t file, std::string path, hsize_t chunk, Origin origin);
  void write(std::span<const std::byte> bytes);

 private:
  std::string path_;
  H5 dataset_;
};

/// An HDF5 file being written. Paths are absolute; a group is made before what lies in it.
class Hdf5Output {
 public:
  /// Makes the file anew, or opens the one that is there.
  Hdf5Output(const std::filesystem::path& path, Origin origin);

  void group(const std::string& path) const;
  void text(const std::string& path, const std::string& value) const;
  void attribute(const std::string& path, const char* name, const std::vector<std::string>& values) const;
  void attribute(const std::string& path, const char* name, std::span<const std::int32_t> values) const;
  void number(const std::string& path, std::uint64_t value) const {
    fixed(path, h5Type<std::uint64_t>(), {}, &value);
  }
  /// A list that is written once.
  template <class T>
  void fixed(const std::string& path, std::span<const T> values) const {
    fixed(path, h5Type<T>(), {values.size()}, values.data());
  }
  /// A dataset that grows, its `row` having these extents ({} for a number a frame). Like bytes(), made or
  /// found as the file is.
  template <class T>
  TimeSeries series(const std::string& path, std::vector<hsize_t> row) const {
    return {file_, path, {H5Tcopy(h5Type<T>()), "copy a type"}, std::move(row), origin_};
  }
  /// One of texts of `size` bytes, padded with zeros.
  TimeSeries texts(const std::string& path, std::size_t size) const;
  ByteStore bytes(const std::string& path, hsize_t chunk) const { return {file_, path, chunk, origin_}; }
  /// Writes other text of the same length over one that is there.
  void replaceText(const std::string& path, const std::string& value) const;
  /// The same object under a second path.
  void link(const std::string& from, const std::string& to) const;
  /// Hands everything to the system, which then keeps it whatever becomes of this program.
  void flush() const;

 private:
  void fixed(const std::string& path, hid_t type, const std::vector<hsize_t>& extent,
             const void* values) const;

  Origin origin_;
  H5 file_;
};

}  // namespace bedmix
