// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/contradiction.h"
#include "engine/core/key.h"

#include <optional>
#include <tuple>

namespace bedmix {

/// The settings of effects, each of which is on where its table is in the scene. An effect's settings are a
/// struct with a `static constexpr Key table`, the table's name and meaning; with describe(settings, visit),
/// as in core/scene_description.h; and with contradictions(scene, settings), as in core/contradiction.h.
template <class... Settings>
class EffectSet {
 public:
  /// Null where the effect is off.
  template <class S>
  const S* find() const {
    const auto& settings = std::get<std::optional<S>>(all_);
    return settings ? &*settings : nullptr;
  }
  template <class S>
  std::optional<S>& at() {
    return std::get<std::optional<S>>(all_);
  }

  /// Calls visit(table, std::optional<S>&) for each.
  template <class Visit>
  void forEach(Visit&& visit) {
    (visit(Settings::table, std::get<std::optional<Settings>>(all_)), ...);
  }
  template <class Visit>
  void forEach(Visit&& visit) const {
    (visit(Settings::table, std::get<std::optional<Settings>>(all_)), ...);
  }

 private:
  std::tuple<std::optional<Settings>...> all_;
};

}  // namespace bedmix
