// SPDX-License-Identifier: MIT
#include "app/render_job.h"

#include "app/interrupt.h"
#include "app/png_text.h"
#include "app/progress.h"
#include "render/film_kind.h"
#include "render/film_sink.h"

#include <fmt/core.h>

#include <algorithm>

namespace bedmix {

std::vector<PaintedBed> RenderJob::beds() const {
  std::vector<PaintedBed> beds;
  for (const RecordedRun& run : runs) beds.push_back({run.scene(), run.name});
  return beds;
}

namespace {

/// The frames that are wanted of a run, and how far they have been handed on.
class Frames {
 public:
  Frames(RecordedRun& run, const std::vector<std::size_t>& selected, bool fromTheStart)
      : run_(run), selected_(selected), index_(fromTheStart ? 0 : selected.front()), all_(fromTheStart) {}

  bool atEnd() const { return next_ == selected_.size(); }
  double time() const { return run_.reader->times()[index_]; }
  bool isSelected() const { return index_ == selected_[next_]; }
  Result<FramePtr> read() { return run_.reader->frame(index_); }
  void advance() {
    if (isSelected()) ++next_;
    if (!atEnd()) index_ = all_ ? index_ + 1 : selected_[next_];
  }

 private:
  RecordedRun& run_;
  const std::vector<std::size_t>& selected_;
  std::size_t index_, next_ = 0;
  bool all_;
};

}  // namespace

Result<Ending> forFrames(const RenderJob& job, const FrameUse& use) {
  std::vector<Frames> runs;
  for (std::size_t i = 0; i < job.runs.size(); ++i)
    runs.emplace_back(job.runs[i], job.selected[i], job.paint.style.showsHistory());
  for (;;) {
    std::size_t first = runs.size();
    for (std::size_t i = runs.size(); i-- > 0;)
      if (!runs[i].atEnd() && (first == runs.size() || runs[i].time() < runs[first].time())) first = i;
    if (first == runs.size()) return Ending::complete;
    if (stopRequested()) return Ending::stopped;
    const auto frame = runs[first].read();
    if (!frame) return frame.problems;
    if (auto used = use(first, **frame, runs[first].isSelected()); !used) return used.problems;
    runs[first].advance();
  }
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
  FilmOptions film{job.paint, filmRate(job, fps), speed, job.runs[0].reader->times()[job.selected[0].front()],
                   0.0};
  for (std::size_t i = 0; i < job.runs.size(); ++i)
    film.to = std::max(film.to, job.runs[i].reader->times()[job.selected[i].back()]);
  auto sink = FilmSink::create(job.beds(), job.output, film);
  if (!sink) return job.console.fail(sink.problems);
  PictureProgress progress(job.console, picturesOf(film));
  const auto shown = forFrames(job, [&](std::size_t bed, const Frame& frame, bool) -> Result<Done> {
    sink->accept(bed, frame);
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

ExitCode renderPicture(const RenderJob& job) {
  auto painter = Painter::create(job.beds(), job.paint);
  if (!painter) return job.console.fail(painter.problems);
  LastFrames last(job.runs.size());
  const auto read = forFrames(job, [&](std::size_t bed, const Frame& frame, bool) -> Result<Done> {
    painter->observe(bed, frame);
    last.keep(bed, frame);
    return Done{};
  });
  if (!read) return job.console.fail(read.problems);
  if (*read == Ending::stopped) return ExitCode::stopped;
  Image image;
  const auto painted = painter->paint(last.frames(), image);
  if (!painted) return job.console.fail(painted.problems);
  const Frame& frame = *last.frames().front();
  const PngOptions png{.small = true, .text = withFrame(pngText(job.runs), frame), .dpi = {}};
  if (const auto written = writePng(job.output, image, png); !written)
    return job.console.fail(written.problems);
  job.console.say(fmt::format("{}: the bed at {:g} s, {} x {} pixels", job.output, frame.time,
                              image.size.width, image.size.height));
  return ExitCode::done;
}

}  // namespace bedmix
