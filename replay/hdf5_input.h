// SPDX-License-Identifier: MIT
#pragma once

#include "replay/hdf5_handle.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// How a file is taken: as a whole one, or as what is left of one, of which each row is looked at by itself.
enum class Reading { whole, remains };

/// A dataset in a file that may be damaged. `row` are the extents it must have, beside its first one, time,
/// where it is a series.
class Hdf5Values {
 public:
  /// Fails where there is none, and on other extents, values that are no numbers, or fewer bytes in the file
  /// than one row can be packed into.
  Hdf5Values(hid_t file, std::string path, std::vector<hsize_t> row, bool isSeries, Reading reading);

  bool isSeries() const { return isSeries_; }
  /// Rows that are there as a whole; 1 where there is no time. Of remains as many as it says: each can fail.
  hsize_t rows() const { return rows_; }
  /// Numbers in a row.
  std::size_t rowSize() const;
  const std::string& path() const { return path_; }

  /// Numbers of one row.
  template <class T>
  void readRow(hsize_t index, T* into) const {
    read(index, 1, h5Type<T>(), into);
  }
  /// Numbers of the first `count` rows.
  template <class T>
  void readRows(hsize_t count, T* into) const {
    read(0, count, h5Type<T>(), into);
  }

 private:
  void read(hsize_t from, hsize_t count, hid_t type, void* into) const;
  void expectChunks(hsize_t from, hsize_t count) const;

  std::string path_;
  std::vector<hsize_t> row_;
  bool isSeries_;
  Reading reading_;
  H5 dataset_;
  hsize_t rows_ = 1;
};

/// An HDF5 file being read; a run may still be writing it.
class Hdf5Input {
 public:
  explicit Hdf5Input(const std::filesystem::path& path, Reading reading = Reading::whole);

  Reading reading() const { return reading_; }
  bool has(const std::string& path) const;
  bool isGroup(const std::string& path) const;
  /// Names of what is in a group, in their order.
  std::vector<std::string> namesIn(const std::string& group) const;
  std::vector<hsize_t> extent(const std::string& dataset) const;
  std::string text(const std::string& path) const;
  /// A list of texts of fixed length.
  std::vector<std::string> texts(const std::string& path) const;
  std::vector<std::int32_t> integers(const std::string& path, const char* attribute) const;
  /// An attribute that is one number; none where there is no such attribute.
  template <class T>
  std::optional<T> number(const std::string& path, const char* attribute) const {
    T value{};
    if (!readNumber(path, attribute, h5Type<T>(), &value)) return std::nullopt;
    return value;
  }
  Hdf5Values fixed(const std::string& path, std::vector<hsize_t> extent) const {
    return {file_, path, std::move(extent), false, reading_};
  }
  Hdf5Values series(const std::string& path, std::vector<hsize_t> row) const {
    return {file_, path, std::move(row), true, reading_};
  }

 private:
  bool readNumber(const std::string& path, const char* attribute, hid_t type, void* into) const;

  Reading reading_;
  H5 file_;
};

}  // namespace bedmix
