// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

// What figures drawn with gnuplot share.

namespace bedmix {

/// Dark to light in grey, apart for the colour-blind (Okabe and Ito), and apart by dashes in print.
inline constexpr std::array plotColors{"#000000", "#009E73", "#0072B2", "#E69F00", "#56B4E9", "#CC79A7"};
/// Of lines and axes of all figures.
inline constexpr std::string_view plotFrame =
    "set grid linecolor rgb '#D0D0D0' linetype 1 linewidth 0.5\nset tics nomirror out\nset border 3\n";

/// As gnuplot takes a text literally.
std::string plotText(std::string_view text);

/// Runs gnuplot's `commands` into a .png, .svg or .pdf file of `columns` by `rows` figures, which gets its
/// name when it is complete. Fails as `unavailable` without gnuplot. The same commands give the same bytes.
Result<Done> drawWithGnuplot(const std::filesystem::path& path, const std::string& commands, int columns = 1,
                             int rows = 1);

/// Version of the gnuplot that is found, or why there is none.
Result<std::string> probePlotter();

}  // namespace bedmix
