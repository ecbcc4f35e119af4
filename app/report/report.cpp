// SPDX-License-Identifier: MIT
#include "app/report/report.h"

#include "app/check_report.h"
#include "app/curves.h"
#include "app/png_text.h"
#include "app/report/html_page.h"
#include "app/report/run_film.h"
#include "app/report/run_numbers.h"
#include "app/report/run_record.h"
#include "engine/core/scene_reader.h"
#include "render/painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

// Widths in print, mm.
constexpr double pageWidth = 190.0, plotWidth = 140.0, bedWidth = 80.0;
constexpr double bedDpi = 300.0;
constexpr double momentShown = 1.0;  // s, of velocities and cells, as in Tian et al. (2007), Fig. 9

class Report {
 public:
  Report(std::vector<RecordedRun>& runs, const fs::path& folder, const Console& console)
      : runs_(runs), folder_(folder), console_(console), titles_(runTitles(runs)), page_(title()) {
    for (const RecordedRun& run : runs) paths_.push_back(run.folder.string());
  }

  Result<Done> write() {
    for (const auto section :
         {&Report::numbers, &Report::snapshots, &Report::mixing, &Report::flux, &Report::velocities,
          &Report::cells, &Report::pressure, &Report::films, &Report::records, &Report::scenes})
      if (auto done = (this->*section)(); !done) return done;
    const fs::path file = folder_ / "report.html";
    auto written = page_.write(file);
    if (written) console_.say(fmt::format("{}: the page, with all of it inside", file.string()));
    return written;
  }

 private:
  std::string title() const {
    std::string text;
    for (const std::string& run : titles_) text += (text.empty() ? "" : " | ") + run;
    return text;
  }
  bool several() const { return runs_.size() > 1; }

  /// A file of one run's, or of all.
  fs::path fileOf(const RecordedRun& run, const char* name) const {
    if (!several()) return folder_ / name;
    std::string prefix = run.name;
    std::replace(prefix.begin(), prefix.end(), '/', '-');
    return folder_ / fmt::format("{}-{}", prefix, name);
  }

  /// A caption that names its run where there are several.
  std::string about(const RecordedRun& run, const std::string& text) const {
    return several() ? fmt::format("{}: {}", titles_[indexOf(run)], text) : text;
  }
  std::size_t indexOf(const RecordedRun& run) const { return static_cast<std::size_t>(&run - runs_.data()); }

  Result<Done> numbers() {
    std::vector<std::string> head{""};
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      head.push_back(several() ? runs_[i].name : "value");
      const auto ofRun = runNumbers(runs_[i].folder, runs_[i].scene());
      if (!ofRun) return ofRun.problems;
      for (const RunNumber& number : *ofRun) {
        auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r[0] == number.name; });
        if (row == rows.end()) row = rows.insert(row, std::vector{number.name});
        row->resize(i + 1);
        row->push_back(number.value);
      }
    }
    for (auto& row : rows) row.resize(head.size());
    page_.heading("Key numbers");
    page_.table(head, rows);
    return Done{};
  }

  Result<Done> snapshots() {
    const auto image = sheetOf(runs_, {}, sheetStyle);
    if (!image) return image.problems;
    const fs::path file = folder_ / "sheet.png";
    if (auto done = writePng(file, *image, sheetPng(runs_)); !done) return done;
    say(file);
    page_.heading("Snapshots");
    return page_.picture(
        file, std::min(pageWidth, image->size.width / sheetDpi * 25.4),
        fmt::format("The bed at several times: {}", title()),
        "The bed at the times above the panels: tracer black, the rest green; arrows below: gas.");
  }

  Result<Done> mixing() {
    const PlotKind& kind = **findPlotKind("mixing");
    page_.heading("Mixing");
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto done = curves(std::span(paths_).subspan(i, 1), kind, fileOf(runs_[i], "mixing.png"),
                               about(runs_[i], "Lacey's and Ashton's indices of mixing over time."));
      if (!done) return done;
    }
    if (!several()) return Done{};
    return curves(paths_, **findPlotKind("compare"), folder_ / "compare.png", "Ashton's index of the runs.");
  }

  Result<Done> flux() {
    return overTime("flux", "Solids flux",
                    "Solids flux through the window on the bed's centre line, positive leftward.");
  }
  Result<Done> pressure() {
    return overTime(
        "pressure", "Pressure drop",
        "Pressure drop of the gas over the bed; dashed, where drawn: the weight of the particles per area.");
  }

  /// The plot of those of the runs that have such a series.
  Result<Done> overTime(const char* name, const char* heading, const char* caption) {
    const PlotKind& kind = **findPlotKind(name);
    std::vector<std::string> with;
    for (const std::string& path : paths_)
      if (hasSeries(path, kind)) with.push_back(path);
    if (with.empty()) return Done{};
    page_.heading(heading);
    return curves(with, kind, folder_ / fmt::format("{}.png", name), caption);
  }

  Result<Done> curves(std::span<const std::string> runs, const PlotKind& kind, const fs::path& file,
                      const std::string& caption) {
    const auto drawn = curvesOf(runs, kind);
    if (!drawn) return drawn.problems;
    if (auto done = writePlot(file, kind, *drawn, levelsOf(runs, kind)); !done) return done;
    say(file);
    return page_.picture(file, plotWidth, caption, caption);
  }

  Result<Done> velocities() {
    page_.heading("Velocities");
    return moments({Layer::velocity, Layer::walls, Layer::hud}, "velocity.png",
                   "mean velocity of the particles");
  }
  Result<Done> cells() {
    page_.heading("Sampling");
    return moments({Layer::particles, Layer::sampling, Layer::walls, Layer::hud}, "sampling.png",
                   "the cells in which tracer is counted");
  }

  /// A picture of each run at one moment.
  Result<Done> moments(Layers layers, const char* name, const char* what) {
    for (RecordedRun& run : runs_) {
      const auto index = framesAt(run.reader.times(), std::array{std::min(momentShown, run.end())});
      if (!index) return index.problems;
      const auto frame = run.reader.frame(index->front());
      if (!frame) return frame.problems;
      PaintOptions paint;
      const Size usual = defaultSize(run.scene());
      paint.size = {2 * usual.width, 2 * usual.height};
      paint.style = layers;
      auto painter = Painter::create(run.scene(), paint);
      if (!painter) return painter.problems;
      Image image;
      if (auto done = painter->paint(**frame, image); !done) return done;
      const fs::path file = fileOf(run, name);
      if (auto done =
              writePng(file, image, {.small = true, .text = withFrame(pngText(run.scene()), **frame), .dpi = bedDpi});
          !done)
        return done;
      say(file);
      const std::string caption = about(run, fmt::format("{} at {:g} s.", what, (*frame)->time));
      if (auto done = page_.picture(file, bedWidth, caption, caption); !done) return done;
    }
    return Done{};
  }

  Result<Done> films() {
    page_.heading("Film");
    for (RecordedRun& run : runs_) {
      const fs::path file = fileOf(run, "film.mp4");
      if (auto done = filmForPage(run.reader, file, console_); !done) return done;
      say(file);
      const double from = run.reader.times().front();
      const std::string caption = about(run, fmt::format("{:g} to {:g} s, {:g} simulated seconds a second.",
                                                         from, run.end(), filmSpeed(run.end() - from)));
      if (auto done = page_.film(file, "Film of the bed, " + caption, caption); !done) return done;
    }
    return Done{};
  }

  Result<Done> records() {
    page_.heading(several() ? "Runs" : "Run");
    for (const RecordedRun& run : runs_) {
      if (several()) page_.subheading(titles_[indexOf(run)]);
      if (auto done = addRecord(page_, run); !done) return done;
    }
    return Done{};
  }

  Result<Done> scenes() {
    page_.heading(several() ? "Scenes" : "Scene");
    for (const RecordedRun& run : runs_) {
      if (several()) page_.subheading(titles_[indexOf(run)]);
      std::vector<std::vector<std::string>> effects;
      for (const CheckRow& row : effectRows(run.scene()))
        effects.push_back({row.name, std::get<std::string>(row.value), row.note});
      page_.table({"effect", "", ""}, effects);
      page_.paragraph("Every setting, as it was run:");
      page_.verbatim(writeScene(run.scene()));
    }
    return Done{};
  }

  void say(const fs::path& file) const { console_.say(file.string()); }

  std::vector<RecordedRun>& runs_;
  const fs::path& folder_;
  const Console& console_;
  std::vector<std::string> titles_, paths_;
  HtmlPage page_;
};

}  // namespace

Result<Done> writeReport(std::vector<RecordedRun>& runs, const fs::path& folder, const Console& console) {
  return Report(runs, folder, console).write();
}

}  // namespace bedmix
