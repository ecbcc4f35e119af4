// SPDX-License-Identifier: MIT
#include "engine/core/particle_list.h"
#include "engine/core/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace bedmix {

namespace {

constexpr std::size_t mostSpecies = std::numeric_limits<std::uint8_t>::max();
constexpr double smallestSize = 0.1;  // of the mean
constexpr double largestRatio =
    20.0;  // of the largest to the smallest diameter: contacts are looked for by it

class ParticleRules {
 public:
  explicit ParticleRules(const Scene& scene) : scene_(scene), kinds_(particleKinds(scene)) {}

  std::vector<Contradiction> broken() {
    counts();
    names();
    for (std::size_t k = 0; k < kinds_.size(); ++k)
      if (kinds_[k].size) sizes(pathOf(k) + "size", kinds_[k]);
    if (broken_.empty()) ratio();
    for (std::size_t i = 0; i < scene_.contacts.pairs.size(); ++i) pair(i);
    if (scene_.tracer.rule == TracerRule::species && kinds_.size() == 1)
      add("tracer.rule", {"particles.species"},
          "there is one kind of particles only, so that none is of another; choose another rule or give "
          "[[particles.species]]");
    const FeedSettings* feed = scene_.effects.find<FeedSettings>();
    if (scene_.tracer.rule == TracerRule::fed && (!feed || feed->streams.empty()))
      add("tracer.rule", {"feed"},
          "nobody is fed, so that nobody would be black; choose another rule or give [[feed.streams]]");
    return std::move(broken_);
  }

 private:
  static std::string pathOf(std::size_t kind) {
    return kind == 0 ? "particles." : fmt::format("particles.species.{}.", kind - 1);
  }
  void add(std::string path, std::vector<std::string> concerns, std::string message) {
    broken_.push_back({std::move(path), std::move(message), std::move(concerns)});
  }

  void counts() {
    if (kinds_.size() > mostSpecies)
      return add(
          "particles.species", {},
          fmt::format("there are {} species; at most {} are told apart", kinds_.size() - 1, mostSpecies - 1));
    if (kinds_.front().count < 0)
      add("particles.count", {"particles.species"},
          fmt::format("the species together are {} particles, but there are {} of all kinds; the first kind "
                      "gets what they leave",
                      scene_.particles.count - kinds_.front().count, scene_.particles.count));
  }

  void names() {
    for (std::size_t k = 0; k < kinds_.size(); ++k)
      for (std::size_t other = 0; other <= k; ++other) {
        const bool isTaken = other < k && kinds_[other].name == kinds_[k].name;
        if (isTaken || kinds_[k].name.empty() || kinds_[k].name == "wall") {
          add(pathOf(k) + "name", {},
              fmt::format(
                  "a kind of particles cannot be called \"{}\": {}", kinds_[k].name,
                  isTaken ? "another is" : "pairs are told apart by names, and this stands for none"));
          break;
        }
      }
  }

  void sizes(const std::string& path, const ParticleKind& kind) {
    const SizeSettings& size = *kind.size;
    if (size.distribution != SizeDistribution::normal || size.deviation * size.cut <= 1.0 - smallestSize)
      return;
    add(path + ".cut", {path + ".deviation"},
        fmt::format("{} deviations of {} below the mean there is no diameter left; cut at {:.3g} or less",
                    size.cut, size.deviation, (1.0 - smallestSize) / size.deviation));
  }

  void ratio() {
    const ParticleRange range = particleRange(scene_);
    if (range.largest > largestRatio * range.smallest)
      add("particles.diameter", {"particles.species", "particles.size"},
          fmt::format("the largest particles, of {:.3g} m, are {:.3g} times as large as the smallest, of "
                      "{:.3g} m; at most {} times is feasible",
                      range.largest, range.largest / range.smallest, range.smallest, largestRatio));
  }

  bool isKind(const std::string& name) const {
    return std::any_of(kinds_.begin(), kinds_.end(), [&](const ParticleKind& k) { return k.name == name; });
  }

  void pair(std::size_t index) {
    const std::vector<PairSettings>& pairs = scene_.contacts.pairs;
    const PairSettings& p = pairs[index];
    const std::string path = fmt::format("contacts.pairs.{}", index);
    std::string known;
    for (const ParticleKind& k : kinds_) known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", k.name);
    if (!isKind(p.first))
      add(path + ".first", {"particles.name", "particles.species"},
          fmt::format("no kind of particles is called \"{}\"; there are {}", p.first, known));
    if (!isKind(p.second) && p.second != "wall")
      add(path + ".second", {"particles.name", "particles.species"},
          fmt::format("no kind of particles is called \"{}\"; there are {} and \"wall\"", p.second, known));
    for (std::size_t other = 0; other < index; ++other) {
      const bool isSame = (pairs[other].first == p.first && pairs[other].second == p.second) ||
                          (pairs[other].first == p.second && pairs[other].second == p.first);
      if (isSame)
        return add(path, {fmt::format("contacts.pairs.{}", other)},
                   fmt::format("\"{}\" and \"{}\" have a table already", p.first, p.second));
    }
    if (p.restitution && scene_.contacts.damping)
      add(path + ".restitution", {"contacts.damping"},
          "contacts.damping sets the dashpot of all contacts; give contacts.restitution instead");
    if (p.friction && !scene_.contacts.friction)
      add(path + ".friction", {"contacts.friction"},
          "there is no friction without [contacts.friction], which the pairs then change");
  }

  const Scene& scene_;
  std::vector<ParticleKind> kinds_;
  std::vector<Contradiction> broken_;
};

}  // namespace

std::vector<Contradiction> contradictions(const Scene& scene, const ParticleSettings&) {
  return ParticleRules(scene).broken();
}

}  // namespace bedmix
