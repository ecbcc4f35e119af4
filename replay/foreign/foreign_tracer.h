// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bedmix {

/// Which particles of a file are tracer: those of a species or, where the file has but one or none, those
/// that the scene's rule tags in the first frame.
class ForeignTracer {
 public:
  /// From the first frame: its species, empty where it has none. Of two species the larger one is tracer,
  /// unless `chosen` says which of any number is. Fails on more than two without a choice, and on a choice
  /// that no particle is of.
  static Result<ForeignTracer> of(const Frame& first, std::span<const std::int64_t> species,
                                  const Scene& scene, std::optional<std::int64_t> chosen);

  /// Sets frame.species, rows in order of id. Fails on a species that the first frame lacked, where it did
  /// not take a choice.
  std::optional<std::string> apply(Frame& frame, std::span<const std::int64_t> species) const;

 private:
  std::optional<std::int64_t> tracer_, rest_;  // species; no `rest_`: all others
  std::vector<std::int32_t> taggedIds_;        // in order; where there is no tracer species
};

}  // namespace bedmix
