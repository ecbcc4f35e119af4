// SPDX-License-Identifier: MIT
#include "app/report/run_film.h"

#include "app/progress.h"
#include "render/draw_list.h"
#include "render/film_sink.h"
#include "render/sheet.h"

#include <algorithm>

namespace bedmix {

namespace {

constexpr double shortest = 8.0;  // s
constexpr double fps = 25.0;

/// Half of a size, even, as films are.
Size half(Size size) { return {size.width / 4 * 2, size.height / 4 * 2}; }

}  // namespace

double filmSpeed(double duration) { return duration > 0.0 ? roundDown(duration / shortest) : 1.0; }

Result<Done> filmForPage(TrajectoryReader& reader, const std::filesystem::path& mp4, const Console& console) {
  const double from = reader.times().front(), to = reader.times().back();
  FilmOptions options;
  options.paint.size = half(defaultSize(reader.scene()));
  options.fps = fps;
  options.speed = filmSpeed(to - from);
  options.from = from;
  options.to = to;
  std::vector<double> shown;
  for (int n = 0; from + n * options.speed / fps <= to; ++n) shown.push_back(from + n * options.speed / fps);
  shown.push_back(to);
  auto indices = framesAt(reader.times(), shown);
  if (!indices) return indices.problems;
  indices->erase(std::unique(indices->begin(), indices->end()), indices->end());

  auto film = FilmSink::create(reader.scene(), mp4, options);
  if (!film) return film.problems;
  Progress progress(console, to);
  for (const std::size_t index : *indices) {
    const auto frame = reader.frame(index);
    if (!frame) return frame.problems;
    film->accept(**frame);
    progress.accept(**frame);
  }
  return film->finish();
}

}  // namespace bedmix
