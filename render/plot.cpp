// SPDX-License-Identifier: MIT
#include "render/plot.h"

#include "render/part_file.h"
#include "render/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

namespace bedmix {

namespace {

constexpr std::array mixingColumns{PlotColumn{"lacey", "Lacey"}, PlotColumn{"ashton", "Ashton"}};
constexpr std::array compareColumns{PlotColumn{"ashton", "Ashton"}};
constexpr std::array fluxColumns{PlotColumn{"flux", "solids flux"}};
constexpr std::array pressureColumns{PlotColumn{"pressure_drop", "pressure drop"}};

const std::array kinds{
    PlotKind{"mixing", "mixing.csv", mixingColumns, "mixing index", 0.0, 1.4},
    PlotKind{"compare", "mixing.csv", compareColumns, "Ashton index", 0.0, 1.4},
    PlotKind{"flux", "flux.csv", fluxColumns, "solids flux leftward, kg/(m\u00b2 s)"},
    PlotKind{"pressure", "pressure.csv", pressureColumns, "pressure drop, Pa"},
};

/// Dark to light in grey, apart for the colour-blind (Okabe and Ito), and apart by dashes in print.
constexpr std::array colors{"#000000", "#009E73", "#0072B2", "#E69F00", "#56B4E9", "#CC79A7"};

/// gnuplot's terminal for a file name, or nothing.
std::string_view terminalFor(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".png") return "pngcairo size 1500,900 font 'DejaVu Sans,24' linewidth 2.5";
  if (extension == ".svg") return "svg size 750,450 font 'DejaVu Sans,12' linewidth 1.25 background 'white'";
  if (extension == ".pdf") return "pdfcairo size 12.7cm,7.62cm font 'DejaVu Sans,8' linewidth 1.25";
  return {};
}

/// In gnuplot's single quotes nothing is special but the quote itself.
std::string singleQuoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::string script(const std::string& output, std::string_view terminal, const PlotKind& kind,
                   std::span<const Curve> curves) {
  std::string text;
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    fmt::format_to(out, "$curve{} << END\n", i);
    const Curve& c = curves[i];
    for (std::size_t k = 0; k < std::min(c.x.size(), c.y.size()); ++k) {
      if (std::isfinite(c.y[k]))
        fmt::format_to(out, "{} {}\n", c.x[k], c.y[k]);
      else
        text += "\n";  // an empty line interrupts a curve
    }
    text += "END\n";
  }
  fmt::format_to(out, "set encoding utf8\nset terminal {} noenhanced\nset output {}\n", terminal,
                 singleQuoted(output));
  fmt::format_to(out, "set xlabel 't, s'\nset ylabel {}\nset xrange [0:*]\nset yrange [* < {} : {} < *]\n",
                 singleQuoted(kind.yLabel), kind.yMin, kind.yMax);
  text += "set grid linecolor rgb '#D0D0D0' linetype 1 linewidth 0.5\nset tics nomirror out\nset border 3\n";
  text += curves.size() > 1 ? "set key outside top center horizontal Left reverse\n" : "unset key\n";
  for (std::size_t i = 0; i < curves.size(); ++i)
    fmt::format_to(out,
                   "{} $curve{} using 1:2 with lines linewidth 1 dashtype {} linecolor rgb '{}' title {}",
                   i == 0 ? "plot" : ",", i, i / colors.size() + 1, colors[i % colors.size()],
                   singleQuoted(curves[i].label));
  text += "\nunset output\n";
  return text;
}

/// Blanks the day of creation, the one thing in a PDF of cairo's that would differ the next time. The file
/// keeps its length, and with it the places its table of contents gives.
bool removeDate(const std::filesystem::path& pdf) {
  std::fstream file(pdf, std::ios::in | std::ios::out | std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  constexpr std::string_view key = "/CreationDate (D:", never = "20000101000000";
  const std::size_t at = text.find(key);
  if (at == std::string::npos) return true;
  file.clear();
  file.seekp(static_cast<std::streamoff>(at + key.size()));
  file.write(never.data(), never.size());
  file.close();
  return !file.fail();
}

Diagnostic noGnuplot(const std::string& why) {
  return {{}, "no curves can be drawn: " + why + "; install gnuplot-nox", Trouble::unavailable};
}

}  // namespace

std::span<const PlotKind> plotKinds() { return kinds; }

Result<const PlotKind*> findPlotKind(std::string_view name) {
  std::string known;
  for (const PlotKind& kind : kinds) {
    if (kind.name == name) return &kind;
    known += known.empty() ? "" : ", ";
    known += kind.name;
  }
  return Diagnostic{{}, fmt::format("there is no kind of plot '{}'; the kinds are {}", name, known)};
}

Result<Done> writePlot(const std::filesystem::path& path, const PlotKind& kind,
                       std::span<const Curve> curves) {
  const std::string_view terminal = terminalFor(path);
  if (terminal.empty())
    return Diagnostic{{path.string()},
                      "a plot is written as .png, .svg or .pdf; give the file one of these endings"};
  const bool drawable = std::any_of(curves.begin(), curves.end(), [](const Curve& c) {
    return std::any_of(c.y.begin(), c.y.end(), [](double y) { return std::isfinite(y); });
  });
  if (!drawable)
    return Diagnostic{{path.string()}, "there is no value to plot; is the run shorter than a sample?"};

  PartFile part(path);
  const Result<ProcessEnd> end =
      runProcess({"gnuplot"}, script(part.path().string(), terminal, kind, curves));
  if (!end) return noGnuplot(end.problems.front().message);
  std::error_code error;
  if (end->status != 0 || std::filesystem::file_size(part.path(), error) == 0 || error)
    return part.failure("gnuplot says: " + end->output);
  if (path.extension() == ".pdf" && !removeDate(part.path()))
    return part.failure("its date cannot be removed");
  return part.keep();
}

Result<std::string> probePlotter() {
  Result<ProcessEnd> end = runProcess({"gnuplot", "--version"}, "");
  if (!end) return noGnuplot(end.problems.front().message);
  std::string version = end->output;
  while (!version.empty() && version.back() == '\n') version.pop_back();
  return version;
}

}  // namespace bedmix
