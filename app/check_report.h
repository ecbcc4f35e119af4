// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <string>
#include <variant>
#include <vector>

namespace bedmix {

/// One line of what `check` says about a scene.
struct CheckRow {
  std::string section;
  std::string name;
  std::variant<double, std::string> value;
  std::string unit;
  std::string note;  // how it comes about, what it means
};

/// Which effects the scene calls for.
std::vector<CheckRow> effectRows(const Scene& scene);

/// The same, its time scales, the margins of its steps, velocities and sizes; and
/// the time a run will take, measured by running the scene for a moment.
std::vector<CheckRow> checkReport(const Scene& scene);

}  // namespace bedmix
