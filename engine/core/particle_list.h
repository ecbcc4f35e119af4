// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/scene.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

// Beds whose particles are not all alike: several kinds, or sizes that differ.

namespace bedmix {

/// Whether particles differ in size or density. Where not, nothing of theirs is kept one by one.
bool isMixed(const Scene& scene);

/// One kind of particles, everything resolved; the first is that of [particles] itself.
struct ParticleKind {
  std::string_view name;
  std::int64_t count;
  double diameter;           // m; mean, or median
  double density;            // kg/m3
  const SizeSettings* size;  // null where all are of one size
};
std::vector<ParticleKind> particleKinds(const Scene& scene);
double smallestDiameter(const ParticleKind& kind);  // m
/// The diameter below which a `share` of the kind's particles are, m.
double diameterAt(const ParticleKind& kind, double share);
double massOf(const ParticleKind& kind, double radius);  // kg
/// Number of the kind of that name; of the first where the name is empty, and of none where there is no such.
std::optional<std::uint8_t> kindNamed(const Scene& scene, std::string_view name);
/// The most particles that there may be at a time.
std::int64_t mostParticles(const Scene& scene);

/// What particle each id is.
struct ParticleList {
  std::vector<double> radii;        // m
  std::vector<std::uint8_t> kinds;  // numbers of particleKinds()
};
/// Who is what is drawn at random by the scene's seed. Sizes of a kind are the quantiles of its distribution,
/// so that they are as it says however few there are.
ParticleList particleList(const Scene& scene);

/// Of a frame's particle `i`: from its size and kind, or as all are.
double radiusOf(const Scene& scene, const Frame& frame, std::size_t i);  // m
double massOf(const Scene& scene, const Frame& frame, std::size_t i);    // kg

/// Bounds of the diameters, m, and of the masses, kg.
struct ParticleRange {
  double smallest, largest, lightest, heaviest;
};
ParticleRange particleRange(const Scene& scene);

/// The same scene with all particles alike, of the lightest that it has: whose contacts are the shortest.
Scene ofLightest(const Scene& scene);

/// Of all particles together: mass, kg; volume over surface as of spheres of one diameter (Sauter's), m; mass
/// over volume, kg/m3.
struct ParticleMeans {
  double mass, diameter, density;
};
ParticleMeans particleMeans(const Scene& scene);

}  // namespace bedmix
