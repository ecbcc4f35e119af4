// SPDX-License-Identifier: MIT
#include "app/frame_selection.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace bedmix {

void addFrameSelection(CLI::App& command, FrameSelection& selection, const char* last) {
  command.add_option("--from", selection.from, "First simulated second")->type_name("T");
  command.add_option(last, selection.to, "Last simulated second")->type_name("T");
  command.add_option("--every", selection.every, "Take every N-th frame only")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000000));
}

Result<std::vector<std::size_t>> selectFrames(const std::vector<double>& times,
                                              const FrameSelection& selection) {
  constexpr double rounding = 1e-9;  // s; times in decimals may lie a bit beside those asked for
  std::vector<std::size_t> within, selected;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (times[i] >= selection.from - rounding && times[i] <= selection.to + rounding) within.push_back(i);
  for (std::size_t i = 0; i < within.size(); i += static_cast<std::size_t>(selection.every))
    selected.push_back(within[i]);
  if (selected.empty())
    return Diagnostic{{"--from/--to"},
                      fmt::format("no frame lies between {:g} and {:g} s; the run goes from {:g} to {:g} s",
                                  selection.from, selection.to, times.front(), times.back())};
  return selected;
}

}  // namespace bedmix
