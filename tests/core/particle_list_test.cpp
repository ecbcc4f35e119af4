// SPDX-License-Identifier: MIT
#include "engine/core/particle_list.h"

#include "engine/core/scene_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

Scene sceneOf(std::int64_t count) {
  Scene scene;
  scene.contacts.restitution = 0.9;
  scene.particles.count = count;
  return scene;
}

/// Of the diameters over that of the scene: mean and deviation.
struct Moments {
  double mean = 0.0, deviation = 0.0;
};
Moments momentsOf(const std::vector<double>& values) {
  Moments m;
  for (const double v : values) m.mean += v / static_cast<double>(values.size());
  for (const double v : values)
    m.deviation += (v - m.mean) * (v - m.mean) / static_cast<double>(values.size());
  m.deviation = std::sqrt(m.deviation);
  return m;
}

/// Standard deviation of a normal distribution of deviation 1 that is cut at +-c: 1 - 2 c phi(c)/(2 Phi(c) -
/// 1).
double cutDeviation(double c) {
  const double density = std::exp(-0.5 * c * c) / std::sqrt(2.0 * std::numbers::pi);
  return std::sqrt(1.0 - 2.0 * c * density / std::erf(c / std::numbers::sqrt2));
}

TEST(ParticleList, SizesAreThoseOfTheDistribution) {
  for (const auto distribution :
       {SizeDistribution::normal, SizeDistribution::lognormal, SizeDistribution::uniform}) {
    Scene scene = sceneOf(4000);
    scene.particles.size = SizeSettings{distribution, 0.2, 2.0};
    std::vector<double> sizes;
    for (const double radius : particleList(scene).radii) {
      const double d = 2.0 * radius / scene.particles.diameter;
      sizes.push_back(distribution == SizeDistribution::lognormal ? std::log(d) : d - 1.0);
    }
    const bool isUniform = distribution == SizeDistribution::uniform;
    const Moments m = momentsOf(sizes);
    EXPECT_NEAR(m.mean, 0.0, 1e-12);
    EXPECT_NEAR(m.deviation / 0.2, isUniform ? 1.0 : cutDeviation(2.0), 1e-3);
    const double furthest = 0.2 * (isUniform ? std::sqrt(3.0) : 2.0);
    EXPECT_LT(*std::max_element(sizes.begin(), sizes.end()), furthest);
    EXPECT_GT(*std::max_element(sizes.begin(), sizes.end()), 0.97 * furthest);
    EXPECT_NEAR(*std::min_element(sizes.begin(), sizes.end()), -*std::max_element(sizes.begin(), sizes.end()),
                1e-12);
  }
}

Scene binary() {
  Scene scene = sceneOf(1000);
  scene.particles.species.push_back({"jetsam", 300, 0.002, 7000.0, std::nullopt});
  scene.particles.species.push_back({"dust", 50, std::nullopt, 300.0, SizeSettings{}});
  return scene;
}

TEST(ParticleList, KindsAreAsManyAsAskedForAndWellMixed) {
  const ParticleList list = particleList(binary());
  EXPECT_EQ(std::count(list.kinds.begin(), list.kinds.end(), 0), 650);
  EXPECT_EQ(std::count(list.kinds.begin(), list.kinds.end(), 1), 300);
  EXPECT_EQ(std::count(list.kinds.begin(), list.kinds.end(), 2), 50);
  for (std::size_t i = 0; i < list.kinds.size(); ++i) {
    if (list.kinds[i] < 2) {
      EXPECT_EQ(list.radii[i], list.kinds[i] == 0 ? 0.002 : 0.001);
    }
  }
  // Of the first half 150 on average, with a deviation of 7.2.
  EXPECT_NEAR(static_cast<double>(std::count(list.kinds.begin(), list.kinds.begin() + 500, 1)), 150.0, 30.0);
}

TEST(ParticleList, FollowsFromTheSeed) {
  Scene scene = binary();
  const ParticleList one = particleList(scene), again = particleList(scene);
  EXPECT_EQ(one.kinds, again.kinds);
  EXPECT_EQ(one.radii, again.radii);
  scene.seed = 2;
  EXPECT_NE(particleList(scene).kinds, one.kinds);
}

TEST(ParticleList, MeansAndRangeAreThoseOfTheParticles) {
  const Scene scene = binary();
  const ParticleList list = particleList(scene);
  const double density[] = {1500.0, 7000.0, 300.0};
  double mass = 0.0, volume = 0.0, surface = 0.0, smallest = 1.0, largest = 0.0, lightest = 1.0;
  for (std::size_t i = 0; i < list.radii.size(); ++i) {
    const double r = list.radii[i], v = 4.0 / 3.0 * std::numbers::pi * r * r * r;
    mass += density[list.kinds[i]] * v;
    lightest = std::min(lightest, density[list.kinds[i]] * v);
    volume += v;
    surface += 4.0 * std::numbers::pi * r * r;
    smallest = std::min(smallest, 2.0 * r);
    largest = std::max(largest, 2.0 * r);
  }
  const ParticleMeans means = particleMeans(scene);
  EXPECT_NEAR(means.mass / mass, 1.0, 1e-4);
  EXPECT_NEAR(means.diameter / (6.0 * volume / surface), 1.0, 1e-4);
  EXPECT_NEAR(means.density / (mass / volume), 1.0, 1e-4);
  const ParticleRange range = particleRange(scene);
  EXPECT_LE(range.smallest, smallest);
  EXPECT_GE(range.largest, largest);
  EXPECT_LE(range.lightest, lightest);
  EXPECT_GT(range.lightest, 0.8 * lightest);
}

TEST(ParticleList, AlikeOnesHaveTheSceneOwnNumbers) {
  const Scene scene = sceneOf(10);
  EXPECT_FALSE(isMixed(scene));
  const ParticleRange range = particleRange(scene);
  EXPECT_EQ(range.smallest, scene.particles.diameter);
  EXPECT_EQ(range.largest, scene.particles.diameter);
  EXPECT_EQ(range.lightest, particleMass(scene));
  EXPECT_EQ(lightestMass(scene), particleMass(scene));
}

constexpr const char* base = R"(
[bed]
width = 0.1
height = 0.4
thickness = 0.012
[particles]
count = 100
diameter = 0.004
density = 1500.0
[contacts]
stiffness = 2000.0
restitution = 0.9
[time]
duration = 1.0
step = 1e-5
)";

/// All that is wrong, one after the other: a step may be too long for what is too small.
std::string problemOf(const std::string& more) {
  const Result<Scene> scene = readScene(base + more, "scene.toml");
  std::string all;
  for (const Diagnostic& problem : scene.problems) all += problem.message + '\n';
  return all;
}

TEST(ParticleRules, TellWhatDoesNotFit) {
  EXPECT_EQ(problemOf("[[particles.species]]\nname = \"big\"\ncount = 100\ndiameter = 0.003\n"), "");
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has(problemOf("[[particles.species]]\nname = \"big\"\ncount = 101\n"), "what they leave"));
  EXPECT_TRUE(has(problemOf("[[particles.species]]\nname = \"first\"\ncount = 1\n"), "another is"));
  EXPECT_TRUE(has(problemOf("[[particles.species]]\nname = \"big\"\ncount = 1\ndiameter = 0.02\n"), "thick"));
  EXPECT_TRUE(has(problemOf("[[particles.species]]\nname = \"s\"\ncount = 1\ndiameter = 0.0001\n"),
                  "times as large"));
  EXPECT_TRUE(has(problemOf("[particles.size]\ndeviation = 0.5\ncut = 3.0\n"), "no diameter left"));
  EXPECT_TRUE(has(problemOf("[[contacts.pairs]]\nfirst = \"first\"\nsecond = \"big\"\n"), "no kind"));
  EXPECT_TRUE(has(problemOf("[[contacts.pairs]]\nfirst = \"first\"\nsecond = \"wall\"\nfriction = 0.1\n"),
                  "no friction"));
  EXPECT_TRUE(has(problemOf("[tracer]\nrule = \"species\"\n"), "one kind"));
}

TEST(ParticleRules, SceneWithKindsIsWrittenAndReadBack) {
  const Result<Scene> scene = readScene(std::string(base) + R"([particles.size]
distribution = "lognormal"
[[particles.species]]
name = "jetsam"
count = 40
density = 7000.0
[[contacts.pairs]]
first = "jetsam"
second = "wall"
restitution = 0.5
)",
                                        "scene.toml");
  ASSERT_TRUE(scene) << scene.problems.front().message;
  const Result<Scene> again = readScene(writeScene(*scene), "again.toml");
  ASSERT_TRUE(again) << again.problems.front().message;
  EXPECT_EQ(writeScene(*again), writeScene(*scene));
}

}  // namespace
}  // namespace bedmix
