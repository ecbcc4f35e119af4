// SPDX-License-Identifier: MIT
#include "render/gnuplot.h"

#include "render/part_file.h"
#include "render/process.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

namespace bedmix {

namespace {

/// gnuplot's terminal for a file name, or nothing.
std::string terminalFor(const std::filesystem::path& path, int columns, int rows) {
  const std::string extension = path.extension().string();
  if (extension == ".png")
    return fmt::format("pngcairo size {},{} font 'DejaVu Sans,24' linewidth 2.5", 1500 * columns, 900 * rows);
  if (extension == ".svg")
    return fmt::format("svg size {},{} font 'DejaVu Sans,12' linewidth 1.25 background 'white'",
                       750 * columns, 450 * rows);
  if (extension == ".pdf")
    return fmt::format("pdfcairo size {}cm,{}cm font 'DejaVu Sans,8' linewidth 1.25", 12.7 * columns,
                       7.62 * rows);
  return {};
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

// In gnuplot's single quotes nothing is special but the quote itself.
std::string plotText(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

Result<Done> drawWithGnuplot(const std::filesystem::path& path, const std::string& commands, int columns,
                             int rows) {
  const std::string terminal = terminalFor(path, columns, rows);
  if (terminal.empty())
    return Diagnostic{{path.string()},
                      "a plot is written as .png, .svg or .pdf; give the file one of these endings"};
  PartFile part(path);
  const std::string script =
      fmt::format("set encoding utf8\nset terminal {} noenhanced\nset output {}\n{}\nunset output\n",
                  terminal, plotText(part.path().string()), commands);
  const Result<ProcessEnd> end = runProcess({"gnuplot"}, script);
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
