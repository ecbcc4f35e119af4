// SPDX-License-Identifier: MIT
#include "app/frame_folder.h"
#include "app/png_text.h"
#include "app/progress.h"
#include "app/render_job.h"
#include "engine/core/thread_team.h"
#include "render/picture_workers.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

namespace bedmix {

namespace {

/// As many as cores, as long as the pictures on their way take no more than this.
int writersFor(Size picture) {
  constexpr std::int64_t mostBytes = std::int64_t{2} << 30;
  const std::int64_t bytes = std::int64_t{4} * picture.width * picture.height;
  return static_cast<int>(std::clamp<std::int64_t>(mostBytes / bytes, 1, availableCores()));
}

}  // namespace

ExitCode renderFolder(const RenderJob& job, bool force) {
  const std::size_t total = job.selected.front().size();
  auto painter = Painter::create(job.beds(), job.paint);
  if (!painter) return job.console.fail(painter.problems);
  auto folder = FrameFolder::open(job.output, total, force);
  if (!folder) return job.console.fail(folder.problems);

  PictureWorkers writers(writersFor(painter->size()));
  PictureProgress progress(job.console, static_cast<std::int64_t>(total));
  LastFrames last(job.runs.size());
  const PngText source = pngText(job.runs);
  std::size_t number = 0, kept = 0;
  const auto drawn =
      forFrames(job, [&](std::size_t bed, const Frame& frame, bool isSelected) -> Result<Done> {
        painter->observe(bed, frame);
        last.keep(bed, frame);
        if (bed > 0 || !isSelected) return Done{};
        const std::size_t n = number++;
        PngOptions png{.text = withFrame(source, frame), .dpi = {}};
        const auto there = folder->holds(n, painter->size(), png.text);
        if (!there) return there.problems;
        if (*there) ++kept;
        if (!*there || folder->besideGap(n)) {
          Image& image = writers.next();
          if (auto painted = painter->paint(last.frames(), image); !painted) return painted;
          if (*there) {
            if (auto same = folder->expect(n, image); !same) return same;
          } else {
            writers.submit([file = folder->file(n), png = std::move(png)](const Image& picture) {
              return writePng(file, picture, png);
            });
          }
        }
        if (writers.failed()) return writers.finish();
        progress.show(static_cast<std::int64_t>(number), static_cast<std::int64_t>(kept));
        return Done{};
      });
  const auto written = writers.finish();
  if (!drawn) return job.console.fail(drawn.problems);
  if (!written) return job.console.fail(written.problems);
  if (*drawn == Ending::stopped) {
    job.console.say(fmt::format("stopped after {} of {} pictures; the same command goes on", number, total));
    return ExitCode::stopped;
  }
  job.console.say(fmt::format("{}: {} pictures{}", job.output, total,
                              kept > 0 ? fmt::format(", {} of them were there", kept) : ""));
  return ExitCode::done;
}

}  // namespace bedmix
