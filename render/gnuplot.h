// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

// What figures drawn with gnuplot share.

namespace bedmix {

/// Colour and dashes of the n-th series of a figure, which tell it from all before: seriesColors, then the
/// same with other dashes.
std::string plotColor(std::size_t n);
std::size_t plotDashes(std::size_t n);
/// Of lines and axes of all figures.
inline constexpr std::string_view plotFrame =
    "set grid linecolor rgb '#D0D0D0' linetype 1 linewidth 0.5\nset tics nomirror out\nset border 3\n";

/// A figure in print.
struct PrintSize {
  double width = 0.0, height = 0.0;  // mm
  double dpi = 300.0;                // of a .png
};

/// As gnuplot takes a text literally.
std::string plotText(std::string_view text);

/// Runs gnuplot's `commands` into a .png, .svg or .pdf file, its texts in 7.7 pt, which gets its name when it
/// is complete. Fails as `unavailable` without gnuplot. The same commands give the same bytes.
Result<Done> drawWithGnuplot(const std::filesystem::path& path, const std::string& commands,
                             const PrintSize& size);

/// The same of commands that read the table `csv` from the file that gnuplot's variable `data` names. Both
/// are left beside the figure: the table as `path`.csv, and the script, which in that folder draws the figure
/// anew, as `path`.gp. The longer names keep them apart from the series of a run.
Result<Done> drawTable(const std::filesystem::path& path, const std::string& commands, const std::string& csv,
                       const PrintSize& size);

/// Version of the gnuplot that is found, or why there is none.
Result<std::string> probePlotter();

}  // namespace bedmix
