// SPDX-License-Identifier: MIT
#include "render/film_sink.h"

#include "render/film_kind.h"
#include "render/last_frames.h"
#include "render/picture_workers.h"

#include <fmt/format.h>

#include <algorithm>

namespace bedmix {

namespace {

/// Forgives the rounding of n speed/fps, which is to meet the frames' times; s.
constexpr double rounding = 5e-7;

}  // namespace

std::int64_t picturesOf(const FilmOptions& options) {
  const double last = (options.to - options.from + rounding) * options.fps / options.speed;
  return static_cast<std::int64_t>(last) + 1;
}

struct FilmSink::State {
  FilmOptions options;
  std::string file;  // for messages
  Painter painter;
  std::unique_ptr<PictureWriter> film;
  PictureWorkers encoder{1};  // ends before the film it writes to
  LastFrames last;            // shown until the time of the next one
  double now = 0.0;           // s, time of the newest of them
  std::int64_t pictures = 0;
  std::vector<Diagnostic> problems;

  State(const FilmOptions& o, std::string name, Painter p, std::unique_ptr<PictureWriter> writer)
      : options(o),
        file(std::move(name)),
        painter(std::move(p)),
        film(std::move(writer)),
        last(painter.beds()) {}

  double filmTime() const {
    return options.from + static_cast<double>(pictures) * options.speed / options.fps;
  }
  /// Shows the last frames before `time` (or at it), as far as the film goes.
  void showUntil(double time);
};

void FilmSink::State::showUntil(double time) {
  if (!last.areComplete() || !problems.empty() || encoder.failed()) return;
  const std::int64_t before = pictures;
  while (filmTime() <= std::min(time, options.to + rounding)) ++pictures;
  if (pictures == before) return;
  if (Result<Done> done = painter.paint(last.frames(), encoder.next()); !done) {
    problems = done.problems;
    return;
  }
  encoder.submit([this](const Image& picture) { return film->add(picture); }, pictures - before);
}

FilmSink::FilmSink(std::unique_ptr<State> state) : state_(std::move(state)) {}
FilmSink::~FilmSink() = default;
FilmSink::FilmSink(FilmSink&&) noexcept = default;
FilmSink& FilmSink::operator=(FilmSink&&) noexcept = default;

Result<FilmSink> FilmSink::create(std::vector<PaintedBed> beds, const std::filesystem::path& path,
                                  const FilmOptions& options) {
  if (!(options.fps > 0.0 && options.fps <= 1000.0))
    return Diagnostic{
        {}, fmt::format("{:g} frames/s make no film; give more than 0 and at most 1000", options.fps)};
  if (!(options.speed > 0.0))
    return Diagnostic{
        {},
        fmt::format("a speed of {:g} simulated s per s of film never ends; give more than 0", options.speed)};
  Result<Painter> painter = Painter::create(std::move(beds), options.paint);
  if (!painter) return painter.problems;
  auto film = createFilm(path, painter->size(), options.fps);
  if (!film) return film.problems;
  return FilmSink(std::make_unique<State>(options, path.string(), std::move(*painter), std::move(*film)));
}

Result<FilmSink> FilmSink::create(const Scene& scene, const std::filesystem::path& path,
                                  const FilmOptions& options) {
  return create({{scene, ""}}, path, options);
}

void FilmSink::accept(std::size_t bed, const Frame& frame) {
  State& s = *state_;
  s.showUntil(frame.time - rounding);
  s.painter.observe(bed, frame);
  s.last.keep(bed, frame);
  s.now = frame.time;
}

Result<Done> FilmSink::finish() {
  State& s = *state_;
  s.showUntil(s.now + rounding);
  if (!s.problems.empty()) return s.problems;
  if (s.pictures == 0)
    return Diagnostic{{s.file},
                      fmt::format("no frame lies between {:g} and {:g} s; the last one is at {:g} s",
                                  s.options.from, s.options.to, s.now)};
  if (Result<Done> done = s.encoder.finish(); !done) return done;
  return s.film->finish();
}

std::int64_t FilmSink::pictures() const { return state_->pictures; }

bool FilmSink::failed() const { return !state_->problems.empty() || state_->encoder.failed(); }

}  // namespace bedmix
