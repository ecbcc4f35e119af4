// SPDX-License-Identifier: MIT
#include "app/recording.h"

#include "app/version.h"

#include <utility>

namespace bedmix {

Recording::Recording(Series series, const RunFolder& folder, const Scene& scene,
                     const std::optional<FilmOptions>& film)
    : series_(std::move(series)) {
  if (!film) return;
  auto sink = FilmSink::create(scene, folder.video(), *film);
  if (sink)
    film_.emplace(std::move(*sink));
  else
    filmProblems_ = sink.problems;
}

Result<Recording> Recording::create(const RunFolder& folder, const Scene& scene,
                                    const std::optional<FilmOptions>& film) {
  auto series = openSeries(folder, scene);
  if (!series) return series.problems;
  Recording recording(std::move(*series), folder, scene, film);
  auto trajectory = TrajectoryWriter::create(folder.trajectory(), scene, {programVersion, programCommit});
  if (!trajectory) return trajectory.problems;
  recording.trajectory_.emplace(std::move(*trajectory));
  return recording;
}

Result<Recording> Recording::resume(const RunFolder& folder, const Scene& scene,
                                    const std::optional<FilmOptions>& film, ResumePoint& point) {
  auto series = openSeries(folder, scene);
  if (!series) return series.problems;
  Recording recording(std::move(*series), folder, scene, film);
  for (std::size_t i = 0; i < point.frames; ++i) {
    const auto frame = point.recorded->frame(i);
    if (!frame) return frame.problems;
    recording.derive(**frame);
    if (const auto failure = recording.failure()) return *failure;
  }
  Scene kept = scene;  // the one thing that need not be the recorded run's stays what it is in the file
  kept.pictures = point.recorded->scene().pictures;
  point.recorded.reset();  // before the file is written
  auto trajectory = TrajectoryWriter::resume(folder.trajectory(), kept, point.frames, point.slot);
  if (!trajectory) return trajectory.problems;
  recording.trajectory_.emplace(std::move(*trajectory));
  return recording;
}

void Recording::derive(const Frame& frame) {
  for (const auto& file : series_) file->accept(frame);
  if (film_) film_->accept(frame);
}

void Recording::accept(const Frame& frame) {
  trajectory_->accept(frame);
  if (!failure()) derive(frame);
}

void Recording::keep(std::span<const std::byte> checkpoint) {
  if (!failure()) trajectory_->keep(checkpoint);
}

void Recording::note(const RunEvent& event) { trajectory_->note(event); }

void Recording::finish() {
  trajectory_->finish();
  if (!film_) return;
  if (const auto finished = film_->finish(); !finished) filmProblems_ = finished.problems;
}

std::optional<Diagnostic> Recording::failure() const {
  if (trajectory_ && trajectory_->failure()) return trajectory_->failure();
  for (const auto& file : series_)
    if (file->failure()) return file->failure();
  return std::nullopt;
}

}  // namespace bedmix
