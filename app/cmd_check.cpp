// SPDX-License-Identifier: MIT
#include "app/check_report.h"
#include "app/commands.h"
#include "app/scene_library.h"
#include "engine/core/presets.h"
#include "engine/core/scene_keys.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>
#include <memory>
#include <optional>
#include <vector>

namespace bedmix {

namespace {

struct CheckOptions {
  std::string scene;
  std::optional<std::string> accuracy;  // a preset
  bool resolved = false, json = false;
};

ExitCode refuse(const std::vector<Diagnostic>& problems, bool json, const Console& console) {
  if (!json) return console.fail(problems);
  nlohmann::ordered_json report{{"valid", false}, {"problems", nlohmann::ordered_json::array()}};
  for (const Diagnostic& d : problems)
    report["problems"].push_back(
        {{"file", d.at.file}, {"line", d.at.line}, {"column", d.at.column}, {"message", d.message}});
  console.print(report.dump(2));
  return exitCodeOf(problems.front().trouble);
}

std::string asText(const std::vector<CheckRow>& rows) {
  std::string text, section;
  for (const CheckRow& row : rows) {
    if (row.section != section)
      text += fmt::format("{}{}\n", text.empty() ? "" : "\n", section = row.section);
    const auto* number = std::get_if<double>(&row.value);
    const std::string value = (number ? fmt::format("{:.6g}", *number) : std::get<std::string>(row.value)) +
                              (row.unit.empty() ? "" : ' ' + row.unit);
    text += fmt::format("  {:<22} {:<16} {}\n", row.name, value, row.note);
  }
  return text;
}

nlohmann::ordered_json asJson(const std::vector<CheckRow>& rows) {
  nlohmann::ordered_json report{{"valid", true}};
  for (const CheckRow& row : rows) {
    auto& entry = report[row.section][row.name];
    std::visit([&](const auto& value) { entry["value"] = value; }, row.value);
    entry["unit"] = row.unit;
    entry["note"] = row.note;
  }
  return report;
}

ExitCode check(const CheckOptions& options, const Console& console) {
  const auto scene = loadScene(
      options.scene, options.accuracy ? accuracyOverrides(*options.accuracy) : std::vector<Override>{});
  if (!scene) return refuse(scene.problems, options.json, console);
  if (options.resolved) {
    console.print(writeScene(*scene));
    return ExitCode::done;
  }
  const auto rows = checkReport(*scene);
  console.print(options.json ? asJson(rows).dump(2) : asText(rows));
  return ExitCode::done;
}

/// The reference of all keys, for --help.
std::string keyTable() {
  std::string text = "Keys of a scene:\n";
  for (const SceneKey& key : sceneKeys()) {
    std::string facts = rangeText(key.key);
    if (facts.empty())
      facts = key.key.unit.empty() || key.type != "number" ? key.type : std::string(key.key.unit);
    if (!key.defaultValue.empty()) facts += "; default " + key.defaultValue;
    if (key.key.required) facts += "; required";
    fmt::format_to(std::back_inserter(text), "  {:<36} {} ({})\n", key.path, key.key.meaning, facts);
  }
  return text;
}

}  // namespace

void addCheckCommand(CLI::App& program, CommandContext context) {
  CLI::App* command =
      program.add_subcommand("check", "Validate a scene; say what it calls for and what it will take");
  auto options = std::make_shared<CheckOptions>();
  command->add_option("scene", options->scene, "Scene file, or the name of a bundled scene")
      ->required()
      ->type_name("SCENE");
  command
      ->add_option("--accuracy", options->accuracy,
                   "Preset of the numerics, in place of the scene's: draft, standard, paper, reference")
      ->type_name("NAME");
  command->add_flag("--resolved", options->resolved,
                    "Print the scene with every default written out instead");
  command->add_flag("--json", options->json, "Print as JSON");
  command->footer("Example:\n  bedmix check tian-2007-even\n\n" + keyTable());
  command->callback([options, context] { context.outcome = check(*options, context.console); });
}

}  // namespace bedmix
