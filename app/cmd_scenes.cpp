// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/scene_library.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace bedmix {

namespace {

ExitCode list(bool json, const Console& console) {
  auto table = nlohmann::ordered_json::array();
  std::size_t longest = 0;
  for (const auto& path : bundledScenes()) {
    const auto scene = loadScene(path.string());
    if (!scene) return console.fail(scene.problems);
    table.push_back({{"name", scene->name}, {"title", scene->title}});
    longest = std::max(longest, scene->name.size());
  }
  if (json) {
    console.print(table.dump(2));
    return ExitCode::done;
  }
  for (const auto& row : table)
    console.print(
        fmt::format("{:<{}}  {}", row["name"].get<std::string>(), longest, row["title"].get<std::string>()));
  return ExitCode::done;
}

ExitCode show(const std::string& name, const Console& console) {
  const auto path = findScene(name);
  if (!path) return console.fail(path.problems);
  const auto text = readTextFile(*path);
  if (!text) return console.fail(text.problems);
  console.print(*text);
  return ExitCode::done;
}

}  // namespace

void addScenesCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("scenes", "List the bundled scenes, or print one");
  auto json = std::make_shared<bool>(false);
  auto name = std::make_shared<std::string>();
  command->add_flag("--json", *json, "List as JSON");
  command->footer("Example:\n  bedmix scenes show tian-2007-even > mine.toml");
  CLI::App* showCommand = command->add_subcommand("show", "Print a scene's text, to start one's own from");
  showCommand->add_option("scene", *name, "Name of a bundled scene")->required()->type_name("NAME");
  showCommand->footer("Example:\n  bedmix scenes show tiny");
  command->require_subcommand(0, 1);
  command->callback([command, showCommand, json, name, context] {
    context.outcome =
        command->got_subcommand(showCommand) ? show(*name, context.console) : list(*json, context.console);
  });
}

}  // namespace bedmix
