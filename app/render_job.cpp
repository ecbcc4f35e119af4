// SPDX-License-Identifier: MIT
#include "app/render_job.h"

#include "app/interrupt.h"
#include "app/png_text.h"
#include "app/progress.h"
#include "render/film_kind.h"
#include "render/film_sink.h"
#include "render/sheet.h"

#include <fmt/core.h>

namespace bedmix {

Result<Ending> forFrames(const RenderJob& job, const std::function<Result<Done>(const Frame&)>& use) {
  for (const std::size_t index : job.selected) {
    if (stopRequested()) return Ending::stopped;
    const auto frame = job.reader.frame(index);
    if (!frame) return frame.problems;
    if (auto used = use(**frame); !used) return used.problems;
  }
  return Ending::complete;
}

namespace {

/// The rate of the film; says where that or its size is not what was asked for.
double filmRate(const RenderJob& job, double fps) {
  const FilmKind kind = *filmKindOf(job.output);
  const double rate = fittingRate(kind, fps);
  if (rate != fps)
    job.console.warn(fmt::format(
        "a GIF shows a picture for 2, 3, 4, ... hundredths of a second: {:.4g} pictures a second, "
        "not {:g}",
        rate, fps));
  const Size asked = job.paint.size, size = fittingSize(kind, asked);
  if (!(size == asked))
    job.console.warn(
        fmt::format("H.264 has even sizes: the film has {}x{} pixels, of which the last repeat "
                    "those before them",
                    size.width, size.height));
  return rate;
}

}  // namespace

ExitCode renderFilm(const RenderJob& job, double fps, double speed) {
  const auto& times = job.reader.times();
  const FilmOptions film{job.paint, filmRate(job, fps), speed, times[job.selected.front()],
                         times[job.selected.back()]};
  auto sink = FilmSink::create(job.reader.scene(), job.output, film);
  if (!sink) return job.console.fail(sink.problems);
  PictureProgress progress(job.console, picturesOf(film));
  const auto shown = forFrames(job, [&](const Frame& frame) -> Result<Done> {
    sink->accept(frame);
    if (sink->failed()) return sink->finish();
    progress.show(sink->pictures());
    return Done{};
  });
  if (!shown) return job.console.fail(shown.problems);
  if (*shown == Ending::stopped) {
    job.console.say(fmt::format("stopped after {} of {} pictures; {} is not kept", sink->pictures(),
                                picturesOf(film), job.output));
    return ExitCode::stopped;
  }
  if (const auto finished = sink->finish(); !finished) return job.console.fail(finished.problems);
  progress.show(sink->pictures());
  job.console.say(fmt::format("{}: {} pictures at {:.4g} a second", job.output, sink->pictures(), film.fps));
  return ExitCode::done;
}

ExitCode renderPicture(const RenderJob& job, std::optional<double> time) {
  const Scene& scene = job.reader.scene();
  FramesAt wanted({time.value_or(job.reader.times().back())});
  FrameSink* const sinks[]{&wanted};
  drain(job.reader, sinks);
  if (job.reader.failure()) return job.console.fail(*job.reader.failure());
  auto frames = wanted.frames();
  if (!frames) {
    for (Diagnostic& d : frames.problems) d.at.file = "--time";
    return job.console.fail(frames.problems);
  }
  auto painter = Painter::create(scene, job.paint);
  if (!painter) return job.console.fail(painter.problems);
  Image image;
  const Frame& frame = *frames->front();
  const auto painted = painter->paint(frame, image);
  if (!painted) return job.console.fail(painted.problems);
  const auto written = writePng(job.output, image, {.small = true, .text = pngText(scene, frame), .dpi = {}});
  if (!written) return job.console.fail(written.problems);
  job.console.say(fmt::format("{}: the bed at {:g} s, {} x {} pixels", job.output, frame.time,
                              image.size.width, image.size.height));
  return ExitCode::done;
}

}  // namespace bedmix
