// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/scene_library.h"
#include "app/version.h"
#include "engine/core/simd.h"
#include "render/gnuplot.h"
#include "render/mp4_film.h"
#include "render/surface.h"
#include "replay/trajectory_writer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace bedmix {

namespace {

struct Check {
  const char* part;
  Result<std::string> finding;
  const char* cure;
  bool needed = true;  // false: another part does the same work
};

Result<std::string> probeScenes() {
  const auto scenes = bundledScenes();
  if (scenes.empty()) return Diagnostic{{}, "none found"};
  return fmt::format("{} in {}", scenes.size(), scenes.front().parent_path().string());
}

Result<std::string> probeVectors() {
  return fmt::format("{}, of {}", simdLevelsHere().back(), fmt::join(simdLevelsHere(), ", "));
}

ExitCode doctor(bool json, const Console& console) {
  const Check checks[]{
      {"pictures", probeSurface(), "make osmesa or egl work, either will do; the next two lines say how"},
      {"osmesa", probeSurface(GlSource::osmesa),
       "apt install libosmesa6; where Mesa is 25.1 or newer there is none, and egl draws", false},
      {"egl", probeSurface(GlSource::egl), "apt install libegl1 libegl-mesa0 libgl1-mesa-dri", false},
      {"films", probeEncoder(), "apt install libavcodec59 libx264-164"},
      {"curves", probePlotter(), "apt install gnuplot-nox"},
      {"recording", hdf5Version(), "apt install libhdf5-103-1"},
      {"vectors", probeVectors(), ""},
      {"scenes", probeScenes(), "cmake --install the program, or run it from its build folder"},
  };
  auto table = nlohmann::ordered_json::array();
  ExitCode outcome = ExitCode::done;
  for (const Check& check : checks) {
    const bool works = static_cast<bool>(check.finding);
    const std::string text = works ? *check.finding : check.finding.problems.front().message;
    if (!works && check.needed) outcome = ExitCode::unavailable;
    if (json)
      table.push_back(
          {{"part", check.part}, {"works", works}, {"finding", text}, {"cure", works ? "" : check.cure}});
    else
      console.print(fmt::format("{:<4} {:<10} {}{}",
                                works          ? "ok"
                                : check.needed ? "FAIL"
                                               : "no",
                                check.part, text, works ? "" : fmt::format("\n     cure: {}", check.cure)));
  }
  if (json) console.print(table.dump(2));
  return outcome;
}

}  // namespace

void addDoctorCommand(CLI::App& program, CommandContext context) {
  CLI::App* command =
      program.add_subcommand("doctor", "Say what of drawing, filming, recording and computing works here");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print as JSON");
  command->footer("Example:\n  bedmix doctor");
  command->callback([json, context] { context.outcome = doctor(*json, context.console); });
}

}  // namespace bedmix
