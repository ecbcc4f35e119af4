// SPDX-License-Identifier: MIT
#include "engine/core/particle_list.h"

#include "engine/core/rng.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

namespace bedmix {

namespace {

constexpr std::uint64_t ownSequence = 0xd1b54a32d192ed03;  // another one than that of the places

double sphereVolume(double diameter) { return std::numbers::pi / 6.0 * diameter * diameter * diameter; }

template <class T>
void shuffle(std::vector<T>& values, std::size_t begin, Rng& rng) {
  for (std::size_t i = begin; i < values.size(); ++i) {
    const auto left = static_cast<double>(values.size() - i);
    std::swap(values[i], values[i + static_cast<std::size_t>(rng.uniform() * left)]);
  }
}

}  // namespace

bool isMixed(const Scene& scene) { return scene.particles.size || !scene.particles.species.empty(); }

std::vector<ParticleKind> particleKinds(const Scene& scene) {
  const ParticleSettings& first = scene.particles;
  std::vector<ParticleKind> kinds{
      {first.name, first.count, first.diameter, first.density, first.size ? &*first.size : nullptr}};
  for (const SpeciesSettings& s : first.species) {
    kinds.front().count -= s.count;
    kinds.push_back({s.name, s.count, s.diameter.value_or(first.diameter), s.density.value_or(first.density),
                     s.size ? &*s.size : nullptr});
  }
  return kinds;
}

double diameterAt(const ParticleKind& kind, double share) {
  if (!kind.size) return kind.diameter;
  const SizeSettings& size = *kind.size;
  if (size.distribution == SizeDistribution::uniform)
    return kind.diameter * (1.0 + std::sqrt(3.0) * size.deviation * (2.0 * share - 1.0));
  const double inside = std::erf(size.cut / std::numbers::sqrt2);  // of the whole distribution
  const double z = share <= 0.0   ? -size.cut
                   : share >= 1.0 ? size.cut
                                  : std::numbers::sqrt2 * boost::math::erf_inv((2.0 * share - 1.0) * inside);
  return size.distribution == SizeDistribution::normal ? kind.diameter * (1.0 + size.deviation * z)
                                                       : kind.diameter * std::exp(size.deviation * z);
}

double smallestDiameter(const ParticleKind& kind) { return diameterAt(kind, 0.0); }
double massOf(const ParticleKind& kind, double radius) {
  return kind.density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

std::optional<std::uint8_t> kindNamed(const Scene& scene, std::string_view name) {
  if (name.empty()) return 0;
  const std::vector<ParticleKind> kinds = particleKinds(scene);
  for (std::size_t k = 0; k < kinds.size(); ++k)
    if (kinds[k].name == name) return static_cast<std::uint8_t>(k);
  return std::nullopt;
}

std::int64_t mostParticles(const Scene& scene) {
  const FeedSettings* feed = scene.effects.find<FeedSettings>();
  return feed ? feed->most : scene.particles.count;
}

ParticleList particleList(const Scene& scene) {
  Rng rng(scene.seed ^ ownSequence);
  struct Particle {
    double radius;
    std::uint8_t kind;
  };
  std::vector<Particle> particles;
  const std::vector<ParticleKind> kinds = particleKinds(scene);
  for (std::size_t k = 0; k < kinds.size(); ++k)
    for (std::int64_t i = 0; i < kinds[k].count; ++i) {
      const double middle = (static_cast<double>(i) + 0.5) / static_cast<double>(kinds[k].count);
      particles.push_back({0.5 * diameterAt(kinds[k], middle), static_cast<std::uint8_t>(k)});
    }
  shuffle(particles, 0, rng);
  ParticleList list;
  for (const Particle& p : particles) {
    list.radii.push_back(p.radius);
    list.kinds.push_back(p.kind);
  }
  return list;
}

double radiusOf(const Scene& scene, const Frame& frame, std::size_t i) {
  return frame.radius.empty() ? 0.5 * scene.particles.diameter : static_cast<double>(frame.radius[i]);
}

double massOf(const Scene& scene, const Frame& frame, std::size_t i) {
  if (frame.radius.empty()) return particleMass(scene);
  const std::size_t kind = frame.kind.empty() ? 0 : frame.kind[i];
  const ParticleSettings& first = scene.particles;
  const double density = kind == 0 ? first.density : first.species[kind - 1].density.value_or(first.density);
  return density * sphereVolume(2.0 * radiusOf(scene, frame, i));
}

Scene ofLightest(const Scene& scene) {
  Scene alike = scene;
  if (!isMixed(scene)) return alike;
  const double lightest = particleRange(scene).lightest;
  for (const ParticleKind& kind : particleKinds(scene)) {
    const double d = smallestDiameter(kind);
    if (kind.density * sphereVolume(d) > lightest) continue;
    alike.particles.diameter = d;
    alike.particles.density = kind.density;
  }
  alike.particles.size.reset();
  alike.particles.species.clear();
  alike.contacts.pairs.clear();
  return alike;
}

ParticleMeans particleMeans(const Scene& scene) {
  constexpr int parts = 64;  // of a distribution
  double mass = 0.0, volume = 0.0, surface = 0.0;
  for (const ParticleKind& kind : particleKinds(scene)) {
    const int n = kind.size ? parts : 1;
    const double each = static_cast<double>(kind.count) / n;
    for (int i = 0; i < n; ++i) {
      const double d = diameterAt(kind, (i + 0.5) / n);
      mass += each * kind.density * sphereVolume(d);
      volume += each * sphereVolume(d);
      surface += each * std::numbers::pi * d * d;
    }
  }
  if (volume == 0.0) return {0.0, scene.particles.diameter, scene.particles.density};
  return {mass, 6.0 * volume / surface, mass / volume};
}

ParticleRange particleRange(const Scene& scene) {
  ParticleRange range{infinity, 0.0, infinity, 0.0};
  for (const ParticleKind& kind : particleKinds(scene))
    for (const double diameter : {diameterAt(kind, 0.0), diameterAt(kind, 1.0)}) {
      const double mass = kind.density * sphereVolume(diameter);
      range.smallest = std::min(range.smallest, diameter);
      range.largest = std::max(range.largest, diameter);
      range.lightest = std::min(range.lightest, mass);
      range.heaviest = std::max(range.heaviest, mass);
    }
  return range;
}

}  // namespace bedmix
