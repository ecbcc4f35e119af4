// SPDX-License-Identifier: MIT
#include "app/report/report.h"

#include "app/check_report.h"
#include "app/curves.h"
#include "app/report/html_page.h"
#include "app/report/run_film.h"
#include "app/report/run_numbers.h"
#include "app/report/run_record.h"
#include "engine/core/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

constexpr double plotWidth = 140.0;  // mm
constexpr double momentShown = 1.0;  // s, of velocities and cells, as in Tian et al. (2007), Fig. 9

class Report {
 public:
  Report(std::vector<RecordedRun>& runs, const fs::path& folder, const Console& console)
      : runs_(runs), folder_(folder), console_(console), titles_(runTitles(runs)), page_(title()) {
    for (const RecordedRun& run : runs) paths_.push_back(run.folder.string());
  }

  Result<Done> write() {
    for (const auto section : {&Report::beginning, &Report::numbers, &Report::snapshots, &Report::mixing,
                               &Report::flux, &Report::velocities, &Report::cells, &Report::pressure,
                               &Report::film, &Report::records, &Report::scenes})
      if (auto done = (this->*section)(); !done) return done;
    const fs::path file = folder_ / "report.html";
    auto written = page_.write(file);
    if (written) console_.say(fmt::format("{}: the page, with all of it inside", file.string()));
    return written;
  }

 private:
  std::string title() const {
    return several() ? fmt::format("{} runs compared", runs_.size()) : titles_.front();
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

  /// Which runs these are, by the names the page goes on to call them.
  Result<Done> beginning() {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const std::string which =
          fmt::format("scene {}, seed {}, {:g} to {:g} s", runs_[i].scene().name, runs_[i].scene().seed,
                      runs_[i].reader->times().front(), runs_[i].end());
      page_.paragraph(several() ? fmt::format("{}: {} ({})", runs_[i].name, titles_[i], which)
                                : fmt::format("Run {}: {}", runs_[i].name, which));
    }
    return Done{};
  }

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
    page_.heading("Snapshots");
    return beds(runs_, {}, sheetLayers, folder_ / "sheet.png", title(),
                "The bed at the times above the panels: tracer black, the rest green; arrows below: gas.");
  }

  Result<Done> mixing() {
    page_.heading("Mixing");
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto done = curves(std::span(paths_).subspan(i, 1), "mixing", fileOf(runs_[i], "mixing.png"),
                               about(runs_[i], "Lacey's and Ashton's indices of mixing over time."));
      if (!done) return done;
    }
    if (!several()) return Done{};
    return curves(paths_, "compare", folder_ / "compare.png", "Ashton's index of the runs.");
  }
  Result<Done> flux() {
    page_.heading("Solids flux");
    return curves(paths_, "flux", folder_ / "flux.png",
                  "Solids flux through the scene's window, positive leftward.");
  }
  Result<Done> pressure() {
    page_.heading("Pressure drop");
    return curves(
        paths_, "pressure", folder_ / "pressure.png",
        "Pressure drop of the gas over the bed; dashed, where drawn: the weight of the particles per area.");
  }

  /// The plot of those of the runs that have something to draw, if any.
  Result<Done> curves(std::span<const std::string> runs, const char* kindName, const fs::path& file,
                      const std::string& caption) {
    const PlotKind& kind = **findPlotKind(kindName);
    std::vector<std::string> with;
    for (const std::string& run : runs)
      if (hasSeries(run, kind)) with.push_back(run);
    const auto drawn = curvesOf(with, kind);
    if (!drawn) return drawn.problems;
    if (!hasValues(*drawn)) return Done{};
    if (auto done = writePlot(file, kind, *drawn, levelsOf(with, kind)); !done) return done;
    say(file);
    return page_.picture(file, plotWidth, caption, caption);
  }

  Result<Done> velocities() {
    page_.heading("Velocities");
    return moments({Layer::sampling, Layer::flow, Layer::walls}, "velocity.png",
                   "Mean velocity of the particles in each sampling cell");
  }
  Result<Done> cells() {
    page_.heading("Sampling");
    return moments(
        {Layer::particles, Layer::sampling, Layer::counts, Layer::walls}, "sampling.png",
        "The cells in which tracer is counted, with the particles and the tracer fraction of those in use");
  }

  /// Each run at the moment of velocities and cells, or at its end.
  Result<Done> moments(const Style& style, const char* name, const char* what) {
    for (RecordedRun& run : runs_) {
      const double time = std::clamp(momentShown, run.begin(), run.end());
      const std::string caption = about(run, fmt::format("{} at {:g} s.", what, time));
      if (auto done =
              beds(std::span(&run, 1), {time}, style, fileOf(run, name), titles_[indexOf(run)], caption);
          !done)
        return done;
    }
    return Done{};
  }

  /// A sheet of runs.
  Result<Done> beds(std::span<RecordedRun> runs, std::vector<double> times, const Style& style,
                    const fs::path& file, const std::string& of, const std::string& caption) {
    const auto image = sheetOf(runs, std::move(times), style);
    if (!image) return image.problems;
    if (auto done = writePng(file, *image, sheetPng(runs)); !done) return done;
    say(file);
    return page_.picture(file, image->size.width / sheetDpi * 25.4, fmt::format("{}: {}", of, caption),
                         caption);
  }

  Result<Done> film() {
    const fs::path file = folder_ / "film.mp4";
    if (auto done = filmForPage(runs_, file, console_); !done) return done;
    say(file);
    double from = runs_.front().reader->times().front(), to = runs_.front().end();
    for (const RecordedRun& run : runs_) {
      from = std::min(from, run.reader->times().front());
      to = std::max(to, run.end());
    }
    const std::string caption = fmt::format("{}: {:g} to {:g} s, {:g} simulated seconds a second.",
                                            file.filename().string(), from, to, filmSpeed(to - from));
    page_.heading("Film");
    return page_.film(file, fmt::format("{}, film: {}", title(), caption), caption);
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
      page_.paragraph(run.isForeign
                          ? "Every setting that was made of the file, or given for it; its density and "
                            "contacts mean nothing:"
                          : "Every setting, as it was run:");
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
