// SPDX-License-Identifier: MIT
#include "app/report/run_film.h"

#include "app/progress.h"
#include "render/draw_list.h"
#include "render/film_sink.h"
#include "render/scales.h"

#include <algorithm>
#include <tuple>

namespace bedmix {

namespace {

constexpr double shortest = 8.0;  // s
constexpr double fps = 25.0;

/// Half of a size, even, as films are.
Size half(Size size) { return {size.width / 4 * 2, size.height / 4 * 2}; }

/// A frame that is shown.
struct Shown {
  double time;  // s
  std::size_t run, index;

  friend bool operator<(const Shown& a, const Shown& b) {
    return std::tie(a.time, a.run) < std::tie(b.time, b.run);
  }
};

/// Those of all runs, in order of time.
std::vector<Shown> shownFrames(std::span<RecordedRun> runs, const FilmOptions& options) {
  std::vector<Shown> frames;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::vector<double>& times = runs[r].reader->times();
    std::vector<double> wanted;
    for (std::int64_t n = 0; n < picturesOf(options); ++n) {
      const double time = options.from + static_cast<double>(n) * options.speed / fps;
      if (time >= times.front() && time <= times.back()) wanted.push_back(time);
    }
    wanted.push_back(times.back());
    auto indices = *framesAt(times, wanted);  // none lies outside
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    for (const std::size_t index : indices) frames.push_back({times[index], r, index});
  }
  std::sort(frames.begin(), frames.end());
  return frames;
}

}  // namespace

double filmSpeed(double duration) { return duration > 0.0 ? roundDown(duration / shortest) : 1.0; }

Result<Done> filmForPage(std::span<RecordedRun> runs, const std::filesystem::path& mp4,
                         const Console& console) {
  FilmOptions options;
  options.from = runs.front().reader->times().front();
  options.to = runs.front().end();
  std::vector<PaintedBed> beds;
  std::vector<Scene> scenes;
  for (const RecordedRun& run : runs) {
    options.from = std::min(options.from, run.reader->times().front());
    options.to = std::max(options.to, run.end());
    beds.push_back({run.scene(), run.name});
    scenes.push_back(run.scene());
  }
  options.fps = fps;
  options.speed = filmSpeed(options.to - options.from);
  options.paint.style.layers.add(Layer::curve);
  options.paint.size = half(defaultSize(scenes, options.paint.style));

  auto film = FilmSink::create(std::move(beds), mp4, options);
  if (!film) return film.problems;
  PictureProgress progress(console, picturesOf(options));
  for (const Shown& shown : shownFrames(runs, options)) {
    const auto frame = runs[shown.run].reader->frame(shown.index);
    if (!frame) return frame.problems;
    film->accept(shown.run, **frame);
    progress.show(film->pictures());
  }
  const auto finished = film->finish();
  if (finished) progress.show(film->pictures());
  return finished;
}

}  // namespace bedmix
