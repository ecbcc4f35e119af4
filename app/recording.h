// SPDX-License-Identifier: MIT
#pragma once

#include "app/resume.h"
#include "app/run_folder.h"
#include "app/series.h"
#include "render/film_sink.h"
#include "replay/trajectory_writer.h"

#include <optional>
#include <vector>

namespace bedmix {

/// All that is recorded of a run in its folder, open for writing: the trajectory, the series and the film.
class Recording {
 public:
  /// Makes the files anew; with a film where there are options for one.
  static Result<Recording> create(const RunFolder& folder, const Scene& scene,
                                  const std::optional<FilmOptions>& film);
  /// Goes on after the frames of `point`, from which series and film are derived anew.
  static Result<Recording> resume(const RunFolder& folder, const Scene& scene,
                                  const std::optional<FilmOptions>& film, ResumePoint& point);

  /// A row of a series follows its frame. Nothing happens after a failure.
  void accept(const Frame& frame);
  /// Keeps a checkpoint of the run at the last frame.
  void keep(std::span<const std::byte> checkpoint);
  void note(const RunEvent& event);
  /// Ends trajectory and film with the last frame.
  void finish();

  /// What could not be written, after which nothing is. A film is not missed that much.
  std::optional<Diagnostic> failure() const;
  const std::vector<Diagnostic>& filmProblems() const { return filmProblems_; }

 private:
  Recording(Series series, const RunFolder& folder, const Scene& scene,
            const std::optional<FilmOptions>& film);
  void derive(const Frame& frame);

  Series series_;
  std::optional<FilmSink> film_;
  std::optional<TrajectoryWriter> trajectory_;
  std::vector<Diagnostic> filmProblems_;
};

}  // namespace bedmix
