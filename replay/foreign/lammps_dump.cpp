// SPDX-License-Identifier: MIT
#include "replay/foreign/lammps_dump.h"

#include "replay/foreign/foreign_error.h"
#include "replay/foreign/lammps_columns.h"
#include "replay/foreign/lammps_index.h"
#include "replay/foreign/packed_file.h"
#include "replay/foreign/repeated_id.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

struct IndexedFile {
  std::filesystem::path path;
  LammpsIndex index;

  std::int64_t firstStep() const { return index.snapshots.front().step; }
};

/// The files that hold a whole snapshot, by the step of their first.
std::vector<IndexedFile> indexed(std::span<const std::filesystem::path> paths) {
  std::vector<IndexedFile> files;
  for (const std::filesystem::path& path : paths)
    if (LammpsIndex index = indexLammpsDump(path); !index.snapshots.empty())
      files.push_back({path, std::move(index)});
  if (files.empty())
    throw ForeignError(paths.empty() ? "" : paths.front(), "holds no whole snapshot of a LAMMPS dump");

  std::stable_sort(files.begin(), files.end(),
                   [](const IndexedFile& a, const IndexedFile& b) { return a.firstStep() < b.firstStep(); });
  for (std::size_t i = 1; i < files.size(); ++i) {
    const IndexedFile &a = files[i - 1], &b = files[i];
    if (a.firstStep() == b.firstStep())
      throw ForeignError(b.path,
                         fmt::format("begins with step {}, as does {}; name the files of one run only",
                                     b.firstStep(), a.path.string()));
    if (a.index.columns != b.index.columns)
      throw ForeignError(b.index.columnsAt, "the columns are others than in " + a.path.string());
  }
  return files;
}

class LammpsDump final : public ForeignSource {
 public:
  explicit LammpsDump(const std::vector<IndexedFile>& files)
      : columns_(files.front().index.columns, files.front().index.columnsAt) {
    for (std::size_t file = 0; file < files.size(); ++file) {
      paths_.push_back(files[file].path);
      for (LammpsSnapshot snapshot : files[file].index.snapshots) {
        while (!snapshots_.empty() && snapshots_.back().step >= snapshot.step) snapshots_.pop_back();
        snapshot.file = file;
        snapshots_.push_back(snapshot);
      }
    }
    for (const LammpsSnapshot& s : snapshots_) steps_.push_back(s.step);
    if (std::all_of(snapshots_.begin(), snapshots_.end(), [](const LammpsSnapshot& s) { return s.time; }))
      takeTimes();
  }

  int dimensions() const override { return columns_.dimensions(); }
  const std::vector<std::int64_t>& steps() const override { return steps_; }
  const std::vector<double>& times() const override { return times_; }

  /// All boxes together, for one that is fitted to the particles changes.
  std::optional<ForeignBox> box() const override {
    ForeignBox all = snapshots_.front().box;
    for (const LammpsSnapshot& s : snapshots_)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        all.low[axis] = std::min(all.low[axis], s.box.low[axis]);
        all.high[axis] = std::max(all.high[axis], s.box.high[axis]);
      }
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!(all.low[axis] < all.high[axis])) return std::nullopt;
    return all;
  }

  Result<ForeignFrame> frame(std::size_t index) override {
    const LammpsSnapshot& snapshot = snapshots_[index];
    const SourceLocation at{paths_[snapshot.file].string(), static_cast<int>(snapshot.line), 1};
    try {
      if (!file_ || openFile_ != snapshot.file) file_.emplace(paths_[openFile_ = snapshot.file]);
      ForeignFrame frame =
          columns_.read(file_->text(snapshot.offset, snapshot.size), snapshot.particles, snapshot.box, at);
      if (const auto id = repeatedId(frame.id))
        throw ForeignError(at, fmt::format("the id {} stands more than once in step {}", *id, snapshot.step));
      return frame;
    } catch (const ForeignError& e) {
      return e.why;
    }
  }

 private:
  void takeTimes() {
    for (const LammpsSnapshot& s : snapshots_) {
      if (!times_.empty() && !(*s.time > times_.back()))
        throw ForeignError(
            {paths_[s.file].string(), static_cast<int>(s.line), 1},
            fmt::format("step {} has the time {} s, the one before it {} s", s.step, *s.time, times_.back()));
      times_.push_back(*s.time);
    }
  }

  std::vector<std::filesystem::path> paths_;
  std::vector<LammpsSnapshot> snapshots_;
  std::vector<std::int64_t> steps_;
  std::vector<double> times_;
  LammpsColumns columns_;
  std::optional<PackedFile> file_;  // the one read last
  std::size_t openFile_ = 0;
};

}  // namespace

Result<std::unique_ptr<ForeignSource>> openLammpsDump(std::span<const std::filesystem::path> paths) {
  try {
    return std::unique_ptr<ForeignSource>(std::make_unique<LammpsDump>(indexed(paths)));
  } catch (const ForeignError& e) {
    return e.why;
  }
}

}  // namespace bedmix
