// SPDX-License-Identifier: MIT
#include "engine/dem/closing_speed.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

/// The largest square of the speeds at which bodies on one kind of spring meet.
class Hardest {
 public:
  Hardest(const SpringDashpot& law, double span)
      : reach_(law.reach), frequency2_(law.stiffness / law.mass), span_(span) {}

  /// `apart` leads to the other body, `velocity` is the other's relative to this one.
  void look(Vec2 apart, Vec2 velocity) {
    const double distance2 = dot(apart, apart), nearing = -dot(apart, velocity);
    // r + g out of reach and (r + g) closing = nearing: g > closing span where (r + g)^2 - r^2 > 2 span
    // nearing.
    if (distance2 >= reach_ * reach_ && distance2 >= reach_ * reach_ + 2.0 * span_ * nearing) return;
    const double distance = std::sqrt(distance2), closing = nearing / distance;
    const double overlap = reach_ - distance;
    if (overlap > 0.0)
      largest2_ = std::max(largest2_, closing * closing + frequency2_ * overlap * overlap);
    else if (overlap + closing * span_ >= 0.0)
      largest2_ = std::max(largest2_, closing * closing);
  }
  double speed() const { return std::sqrt(largest2_); }

 private:
  double reach_, frequency2_, span_;
  double largest2_ = 0.0;
};

double hardestOfBlock(const BedState& bed, const ContactBlock& block, Hardest pairs, Hardest walls) {
  const Particles& p = bed.particles;
  const auto look = [&](std::int32_t i, std::int32_t j) {
    pairs.look(p.position[j] - p.position[i], p.velocity[j] - p.velocity[i]);
  };
  for (std::size_t c = 0; c < block.candidateCount; ++c)
    look(block.candidates[c].first, block.candidates[c].second);
  for (std::size_t c = 0; c < block.crossing.count; ++c)
    look(block.crossing.first[c], block.crossing.second[c]);
  for (const ContactBlock::AtWall& w : block.walls)
    for (std::size_t c = 0; c < w.slots.count; ++c) {
      const std::int32_t i = w.slots.first[c];
      Vec2 point;
      if (bed.contacts.walls()[w.wall].touchPoint(p.position[i], point))
        walls.look(point - p.position[i], -1.0 * p.velocity[i]);
    }
  return std::max(pairs.speed(), walls.speed());
}

/// What is left of the outer skin, by the particles' places and not by their speeds, m.
double measuredBudget(const BedState& bed) {
  return bed.contacts.remainder(bed.contacts.displacements({0, bed.bodies.size()}, bed.bodies));
}

}  // namespace

double closingSpeed(BedState& bed, const SpringDashpot& pair, const SpringDashpot& wall, double span) {
  double fastest2 = 0.0;
  for (const Vec2 v : bed.particles.velocity) fastest2 = std::max(fastest2, dot(v, v));
  const double most = 2.0 * std::sqrt(fastest2);
  if (most * span > bed.budget.outer && most * span > measuredBudget(bed)) return most;

  std::vector<double> ofBlock(bed.contacts.blocks());
  bed.team.run([&](int member) {
    const Range blocks = bed.team.share(ofBlock.size(), member);
    for (std::size_t b = blocks.begin; b < blocks.end; ++b)
      ofBlock[b] = hardestOfBlock(bed, bed.contacts.block(b), {pair, span}, {wall, span});
  });
  return *std::max_element(ofBlock.begin(), ofBlock.end());
}

}  // namespace bedmix
