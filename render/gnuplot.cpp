// SPDX-License-Identifier: MIT
#include "render/gnuplot.h"

#include "render/colors.h"
#include "render/part_file.h"
#include "render/png.h"
#include "render/process.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

constexpr double points = 7.7;  // of texts in print

/// gnuplot's terminal for a file name, or nothing. What it takes for points are those of a 96 dpi screen in a
/// .png, pixels of such a screen in a .svg, and half of the former in a .pdf unless told otherwise.
std::string terminalFor(const fs::path& path, const PrintSize& size) {
  const std::string extension = path.extension().string();
  const auto pixels = [](double mm, double dpi) { return std::lround(mm / 25.4 * dpi); };
  if (extension == ".png")
    return fmt::format("pngcairo size {},{} font 'DejaVu Sans,{:.1f}' linewidth {:g}",
                       pixels(size.width, size.dpi), pixels(size.height, size.dpi), points * size.dpi / 96.0,
                       size.dpi / 120.0);
  if (extension == ".svg")
    return fmt::format("svg size {},{} font 'DejaVu Sans,{:.1f}' linewidth 0.8 background 'white'",
                       pixels(size.width, 96.0), pixels(size.height, 96.0), points * 96.0 / 72.0);
  if (extension == ".pdf")
    return fmt::format("pdfcairo size {}cm,{}cm font 'DejaVu Sans,{}' fontscale 0.75 linewidth 1.25",
                       0.1 * size.width, 0.1 * size.height, points);
  return {};
}

/// Blanks the day of creation, the one thing in a PDF of cairo's that would differ the next time. The file
/// keeps its length, and with it the places its table of contents gives.
bool removeDate(const fs::path& pdf) {
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

std::string scriptFor(const std::string& terminal, const fs::path& output, const std::string& commands) {
  return fmt::format("set encoding utf8\nset terminal {} noenhanced\nset output {}\n{}\nunset output\n",
                     terminal, plotText(output.string()), commands);
}

Result<Done> writeText(const PartFile& part, const std::string& text) {
  std::ofstream file(part.path(), std::ios::binary);
  file << text;
  file.close();
  if (file.fail()) return part.failure(std::strerror(errno));
  return Done{};
}

/// Draws what is to become `path`.
Result<Done> drawInto(const PartFile& part, const fs::path& path, const PrintSize& size,
                      const std::string& commands) {
  const std::string terminal = terminalFor(path, size);
  if (terminal.empty())
    return Diagnostic{{path.string()},
                      "a plot is written as .png, .svg or .pdf; give the file one of these endings"};
  const Result<ProcessEnd> end = runProcess({"gnuplot"}, scriptFor(terminal, part.path(), commands));
  if (!end) return noGnuplot(end.problems.front().message);
  std::error_code error;
  if (end->status != 0 || fs::file_size(part.path(), error) == 0 || error)
    return part.failure("gnuplot says: " + end->output);
  if (path.extension() == ".pdf" && !removeDate(part.path()))
    return part.failure("its date cannot be removed");
  if (path.extension() != ".png") return Done{};
  const Result<Image> image = readPng(part.path());  // gnuplot does not say how large it is in print
  return image ? writePng(part.path(), *image, {.small = true, .text = {}, .dpi = size.dpi})
               : part.failure(image.problems.front().message);
}

}  // namespace

std::string plotColor(std::size_t n) { return colorText(seriesColors[n % seriesColors.size()]); }

std::size_t plotDashes(std::size_t n) { return n / seriesColors.size() + 1; }

// In gnuplot's single quotes nothing is special but the quote itself.
std::string plotText(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

Result<Done> drawWithGnuplot(const fs::path& path, const std::string& commands, const PrintSize& size) {
  PartFile part(path);
  auto drawn = drawInto(part, path, size, commands);
  return drawn ? part.keep() : drawn;
}

Result<Done> drawTable(const fs::path& path, const std::string& commands, const std::string& csv,
                       const PrintSize& size) {
  const auto beside = [&](const char* ending) { return path.native() + ending; };
  const auto reading = [&](const fs::path& table) {
    return fmt::format("data = {}\n{}", plotText(table.string()), commands);
  };
  const fs::path name = path.filename();
  PartFile part(path), table(beside(".csv")), script(beside(".gp"));
  auto done = writeText(table, csv);
  if (done) done = drawInto(part, path, size, reading(table.path()));
  if (done)
    done = writeText(script,
                     fmt::format("# Draws {0} from {0}.csv: gnuplot {0}.gp\n{1}", name.string(),
                                 scriptFor(terminalFor(path, size), name, reading(name.string() + ".csv"))));
  if (done) done = table.keep();
  if (done) done = script.keep();
  return done ? part.keep() : done;
}

Result<std::string> probePlotter() {
  Result<ProcessEnd> end = runProcess({"gnuplot", "--version"}, "");
  if (!end) return noGnuplot(end.problems.front().message);
  std::string version = end->output;
  while (!version.empty() && version.back() == '\n') version.pop_back();
  return version;
}

}  // namespace bedmix
