// SPDX-License-Identifier: MIT
#include "app/gl_option.h"

#include "render/gl_context.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace bedmix {

void addGlOption(CLI::App& command) {
  const auto use = [](const std::string& name) {
    const auto* const found = std::find(glSourceNames.begin(), glSourceNames.end(), name);
    useGlSource(static_cast<GlSource>(found - glSourceNames.begin()));
  };
  command.add_option_function<std::string>("--gl", use, "OpenGL to draw with; see bedmix doctor")
      ->type_name("auto|osmesa|egl")
      ->check(CLI::IsMember(std::vector<std::string>(glSourceNames.begin(), glSourceNames.end())))
      ->default_str(std::string(glSourceNames.front()));
}

}  // namespace bedmix
