// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/scene_library.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <iterator>
#include <memory>

// Completion scripts are made from the commands themselves, so they cannot drift from them.

namespace bedmix {

namespace {

std::vector<const CLI::App*> commandsOf(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> optionsOf(const CLI::App& command) {
  return command.get_options([](const CLI::Option* o) { return o->nonpositional(); });
}

bool takesValue(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// What may stand as a command's own words, beside files: its sub-commands and, for a scene, the bundled
/// names.
std::string wordsOf(const CLI::App& command) {
  std::string words;
  for (const CLI::App* sub : commandsOf(command)) words += ' ' + sub->get_name();
  if (command.get_option_no_throw("scene"))
    for (const auto& scene : bundledScenes()) words += ' ' + scene.stem().string();
  return words;
}

std::string optionWords(const CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : optionsOf(command))
    for (const std::string& name : option->get_lnames()) words += " --" + name;
  return words;
}

/// Text between single quotes of any of the three shells, and inside zsh's brackets.
std::string quotable(std::string text) {
  std::erase_if(text, [](char c) { return c == '\'' || c == '[' || c == ']' || c == ':' || c == '\n'; });
  return text;
}

std::string bash(const CLI::App& program) {
  std::string commands, cases;
  for (const CLI::App* command : commandsOf(program)) {
    commands += ' ' + command->get_name();
    cases += fmt::format("    {}) words='{}{}{}' ;;\n", command->get_name(), wordsOf(*command),
                         optionWords(*command), optionWords(program));
  }
  return fmt::format(R"(# bash completion of bedmix; source <(bedmix completion bash)
_bedmix() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} words=
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    words='{}{}'
  else
    case ${{COMP_WORDS[1]}} in
{}    esac
    [[ $current == -* ]] || mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
  mapfile -t -O ${{#COMPREPLY[@]}} COMPREPLY < <(compgen -W "$words" -- "$current")
}}
complete -o filenames -F _bedmix bedmix
)",
                     commands, optionWords(program), cases);
}

std::string zsh(const CLI::App& program) {
  std::string commands, cases;
  for (const CLI::App* command : commandsOf(program)) {
    commands += fmt::format("    '{}:{}'\n", command->get_name(), quotable(command->get_description()));
    cases += fmt::format("    {})\n      _arguments", command->get_name());
    for (const CLI::Option* option : optionsOf(*command))
      for (const std::string& name : option->get_lnames())
        cases += fmt::format(
            " \\\n        '*--{}[{}]{}'", name, quotable(option->get_description()),
            takesValue(*option) ? fmt::format(":{}:_files", quotable(option->get_type_name())) : "");
    const std::string words = wordsOf(*command);
    const std::string files = words.empty() ? "_files" : fmt::format("{{ compadd --{}; _files }}", words);
    cases += fmt::format(" \\\n        '*:file:{}' ;;\n", files);
  }
  return fmt::format(R"(#compdef bedmix
# zsh completion of bedmix; bedmix completion zsh > a folder of $fpath/_bedmix
_bedmix() {{
  local -a commands=(
{}  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  shift words
  ((CURRENT--))
  case $words[1] in
{}  esac
}}
if [[ $funcstack[1] == _bedmix ]]; then _bedmix "$@"; else compdef _bedmix bedmix; fi
)",
                     commands, cases);
}

std::string fish(const CLI::App& program) {
  std::string text =
      "# fish completion of bedmix; bedmix completion fish > ~/.config/fish/completions/bedmix.fish\n";
  const auto out = std::back_inserter(text);
  for (const CLI::App* command : commandsOf(program)) {
    fmt::format_to(out, "complete -c bedmix -n __fish_use_subcommand -f -a {} -d '{}'\n", command->get_name(),
                   quotable(command->get_description()));
    const std::string when = fmt::format("-n '__fish_seen_subcommand_from {}'", command->get_name());
    if (const std::string words = wordsOf(*command); !words.empty())
      fmt::format_to(out, "complete -c bedmix {} -a '{}'\n", when, words.substr(1));
    for (const CLI::Option* option : optionsOf(*command))
      for (const std::string& name : option->get_lnames())
        fmt::format_to(out, "complete -c bedmix {} -l {} -d '{}'{}\n", when, name,
                       quotable(option->get_description()), takesValue(*option) ? " -r" : "");
  }
  return text;
}

}  // namespace

void addCompletionCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("completion", "Print a completion script for a shell");
  auto shell = std::make_shared<std::string>();
  command->add_option("shell", *shell, "bash, zsh or fish")
      ->required()
      ->type_name("SHELL")
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->footer("Example:\n  source <(bedmix completion bash)");
  command->callback([&program, shell, context] {
    context.console.print(*shell == "bash" ? bash(program) : *shell == "zsh" ? zsh(program) : fish(program));
  });
}

}  // namespace bedmix
