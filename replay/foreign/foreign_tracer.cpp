// SPDX-License-Identifier: MIT
#include "replay/foreign/foreign_tracer.h"

#include "engine/core/bed_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace bedmix {

namespace {

std::string listOf(const std::set<std::int64_t>& species) {
  constexpr std::ptrdiff_t most = 8;
  const bool all = species.size() <= most;
  const auto end = all ? species.end() : std::next(species.begin(), most);
  return fmt::format("{}{}", fmt::join(species.begin(), end, ", "), all ? "" : ", ...");
}

}  // namespace

Result<ForeignTracer> ForeignTracer::of(const Frame& first, std::span<const std::int64_t> species,
                                        const Scene& scene, std::optional<std::int64_t> chosen) {
  const std::set<std::int64_t> there(species.begin(), species.end());
  ForeignTracer tracer;
  if (chosen) {
    if (!there.contains(*chosen))
      return Diagnostic{{},
                        there.empty()
                            ? "has no species to choose a tracer from"
                            : fmt::format("has no particle of species {} in its first frame; there are {}",
                                          *chosen, listOf(there)),
                        Trouble::file};
    tracer.tracer_ = chosen;
    return tracer;
  }
  if (there.size() > 2)
    return Diagnostic{
        {},
        fmt::format("has particles of the species {}; say which is the tracer with --tracer-species V",
                    listOf(there)),
        Trouble::file};
  if (there.size() == 2) {
    tracer.tracer_ = *there.rbegin();
    tracer.rest_ = *there.begin();
    return tracer;
  }
  const std::vector<std::uint8_t> tags =
      tagTracer(scene.tracer.rule, first.position, first.kind, scene.bed.width);
  for (std::size_t i = 0; i < tags.size(); ++i)
    if (tags[i] == 1) tracer.taggedIds_.push_back(first.id[i]);
  return tracer;
}

std::optional<std::string> ForeignTracer::apply(Frame& frame, std::span<const std::int64_t> species) const {
  frame.species.resize(frame.size());
  if (!tracer_) {
    auto tagged = taggedIds_.begin();
    for (std::size_t i = 0; i < frame.size(); ++i) {
      while (tagged != taggedIds_.end() && *tagged < frame.id[i]) ++tagged;
      frame.species[i] = tagged != taggedIds_.end() && *tagged == frame.id[i];
    }
    return std::nullopt;
  }
  if (species.size() != frame.size()) return "has no species, other than the first frame";
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (rest_ && species[i] != *rest_ && species[i] != *tracer_)
      return fmt::format(
          "particle {} is of species {}, which the first frame has none of; say which is the tracer "
          "with --tracer-species V",
          frame.id[i], species[i]);
    frame.species[i] = species[i] == *tracer_;
  }
  return std::nullopt;
}

}  // namespace bedmix
