// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_source.h"
#include "replay/hdf5_input.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// What HDF5 finds in an H5MD file (https://www.nongnu.org/h5md/h5md.html, version 1.1). It happens in a
// process of its own, see h5md_source.h. Failures throw Hdf5Error.

namespace bedmix {

/// Which numbers there are of a frame. They lie one after the other, all groups' of a kind together: position
/// and velocity [dimensions a particle], spin [spinComponents], radius as double; species and id as int64.
struct H5mdRow {
  int dimensions = 3;
  std::size_t particles = 0;  // rows of all groups, those of absent particles (id < 0) among them
  bool hasVelocity = false, hasRadius = false, hasSpecies = false;
  int spinComponents = 0;  // 1 where the file has two dimensions, 3, or none

  std::size_t doubles() const {
    return particles *
           static_cast<std::size_t>(dimensions * (hasVelocity ? 2 : 1) + spinComponents + hasRadius);
  }
  std::size_t bytes() const { return 8 * (doubles() + particles * (hasSpecies ? 2 : 1)); }
  bool operator==(const H5mdRow&) const = default;
};

/// What an H5MD file says once.
struct H5mdContents {
  H5mdRow row;
  std::vector<std::int64_t> steps;
  std::vector<double> times;  // s; as many, or none
  std::optional<ForeignBox> box;
};

class H5mdInput {
 public:
  /// Finds the particles of a group, or those of all of them, in the order of their names, where it is empty.
  /// Then the species of a particle is the number of its group where not all groups have one; and its id is
  /// its own where ids stay as they are and no two groups have the same, else id * groups + the group's
  /// number. Rows are numbered where a group has no ids.
  H5mdInput(const std::filesystem::path& file, const std::string& group);

  const H5mdContents& contents() const { return contents_; }
  /// The numbers of a row that do not change with time, and those that do. `into` must have room for
  /// row.bytes().
  void readFixed(std::byte* into) const { read(0, false, into); }
  void readFrame(std::size_t index, std::byte* into) const { read(index, true, into); }

 private:
  /// One kind of numbers of all groups. A group that lacks the element has integers of its own: its number as
  /// species, those of its rows as ids.
  struct Column {
    enum class Kind { real, species, id } kind = Kind::real;
    std::size_t components = 1;                 // of a particle
    double unit = 1.0;                          // what is read is multiplied by
    std::vector<std::optional<Hdf5Values>> of;  // each group
  };

  std::vector<std::string> chooseGroups(const std::string& group) const;
  void addPositions();
  /// False, and nothing added, where a group lacks the element.
  bool addReals(const std::string& element, int components, double unit = 1.0);
  void addSpin();
  void addSpecies();
  void addIds();
  std::optional<Hdf5Values> find(std::size_t group, const std::string& element, int components) const;
  bool allHave(const std::string& element) const;
  void readAxes();
  void settleFrames();
  std::optional<ForeignBox> readBox(const std::string& path) const;
  void read(std::size_t index, bool series, std::byte* into) const;

  Hdf5Input in_;
  std::vector<std::string> groups_;  // paths
  std::vector<std::size_t> sizes_;   // their rows
  std::vector<Column> columns_;      // in the order of H5mdRow
  bool mixesIds_ = false;            // id * groups + the group's number
  H5mdContents contents_;
};

}  // namespace bedmix
