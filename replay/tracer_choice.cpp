// SPDX-License-Identifier: MIT
#include "replay/tracer_choice.h"

#include "engine/core/bed_statistics.h"
#include "engine/core/near_miss.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <muParser.h>
#include <numeric>
#include <optional>

namespace bedmix {

namespace {

constexpr int mostParts = 1000;

/// The number N of "name=N".
std::optional<int> countOf(std::string_view text, std::string_view name) {
  if (!text.starts_with(name) || text.substr(name.size(), 1) != "=") return std::nullopt;
  text.remove_prefix(name.size() + 1);
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return count;
}

/// An expression with the variables it may name.
struct Formula {
  struct Variable {
    const char* name;
    double value;
  };
  std::array<Variable, 8> variables{
      {{"x", 0}, {"y", 0}, {"vx", 0}, {"vy", 0}, {"id", 0}, {"species", 0}, {"width", 0}, {"height", 0}}};
  mu::Parser parser;

  explicit Formula(const std::string& text) {
    for (Variable& v : variables) parser.DefineVar(v.name, &v.value);
    parser.SetExpr(text);
  }
  Formula(const Formula&) = delete;  // the parser holds the places of the variables

  double at(const Frame& frame, std::size_t i, const Scene& scene) {
    const double values[] = {frame.position[i].x,
                             frame.position[i].y,
                             frame.velocity[i].x,
                             frame.velocity[i].y,
                             static_cast<double>(frame.id[i]),
                             static_cast<double>(frame.species[i]),
                             scene.bed.width,
                             scene.bed.height};
    for (std::size_t v = 0; v < variables.size(); ++v) variables[v].value = values[v];
    return parser.Eval();
  }
};

std::string known() {
  std::string names;
  for (const ModelInfo& rule : modelTable<TracerRule>) names += fmt::format("{}, ", rule.name);
  return names +
         "strips=N, layers=N, or an expression of x, y, vx, vy, id, species, width, height such as "
         "\"x < width/3 && y > 0.02\"";
}

Diagnostic refused(const std::string& text, const std::string& why) {
  std::vector<std::string> rules;
  for (const ModelInfo& rule : modelTable<TracerRule>) rules.emplace_back(rule.name);
  return {{"--tracer"}, fmt::format("\"{}\": {}{}; give {}", text, why, didYouMean(text, rules), known())};
}

std::vector<std::uint8_t> inLayers(const Frame& frame, std::size_t count) {
  const std::size_t n = frame.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return frame.position[a].y < frame.position[b].y; });
  std::vector<std::uint8_t> tags(n);
  for (std::size_t k = 0; k < n; ++k) tags[order[k]] = k * count / n % 2 == 0;
  return tags;
}

std::vector<std::uint8_t> tagFed(const Frame& frame, const Scene& scene) {
  std::vector<std::uint8_t> tags(frame.size());
  for (std::size_t i = 0; i < tags.size(); ++i) tags[i] = frame.id[i] >= scene.particles.count;
  return tags;
}

}  // namespace

Result<TracerChoice> TracerChoice::parse(const std::string& text) {
  for (std::size_t rule = 0; rule < modelTable<TracerRule>.size(); ++rule)
    if (modelTable<TracerRule>[rule].name == text) return TracerChoice(static_cast<TracerRule>(rule));
  const auto strips = countOf(text, "strips"), layers = countOf(text, "layers");
  if (const auto count = strips ? strips : layers) {
    if (*count < 2 || *count > mostParts)
      return refused(text, fmt::format("from 2 to {} parts can be told apart", mostParts));
    return strips ? TracerChoice(Strips{*count}) : TracerChoice(Layers{*count});
  }
  try {
    Formula(text).parser.Eval();
  } catch (const mu::ParserError& e) {
    return refused(text, e.GetMsg());
  }
  return TracerChoice(text);
}

Result<std::vector<std::uint8_t>> TracerChoice::tag(const Frame& frame, const Scene& scene) const {
  if (const auto* rule = std::get_if<TracerRule>(&kind_); rule && *rule == TracerRule::fed)
    return tagFed(frame, scene);
  else if (rule)
    return tagTracer(*rule, frame.position, frame.kind, scene.bed.width);
  if (const auto* layers = std::get_if<Layers>(&kind_))
    return inLayers(frame, static_cast<std::size_t>(layers->count));
  std::vector<std::uint8_t> tags(frame.size());
  if (const auto* strips = std::get_if<Strips>(&kind_)) {
    for (std::size_t i = 0; i < tags.size(); ++i)
      tags[i] =
          static_cast<std::int64_t>(std::floor(frame.position[i].x / scene.bed.width * strips->count)) % 2 ==
          0;
    return tags;
  }
  const auto& text = std::get<Expression>(kind_);
  Formula formula(text);
  try {
    for (std::size_t i = 0; i < tags.size(); ++i) {
      const double value = formula.at(frame, i, scene);
      if (std::isnan(value))
        return refused(text, fmt::format("has no value for particle {} at {:g} s", frame.id[i], frame.time));
      tags[i] = value != 0.0;
    }
  } catch (const mu::ParserError& e) {
    return refused(text, e.GetMsg());
  }
  return tags;
}

Retagging::Retagging(const Frame& chosenAt, std::vector<std::uint8_t> tags)
    : id_(chosenAt.id), tag_(std::move(tags)) {}

Frame Retagging::applied(Frame frame) const {
  if (frame.id == id_) {  // nobody came or went
    frame.species = tag_;
    return frame;
  }
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const auto at = std::lower_bound(id_.begin(), id_.end(), frame.id[i]);
    frame.species[i] =
        at != id_.end() && *at == frame.id[i] ? tag_[static_cast<std::size_t>(at - id_.begin())] : 0;
  }
  return frame;
}

}  // namespace bedmix
