// SPDX-License-Identifier: MIT
#include "engine/dem/closing_speed.h"

#include "engine/dem/closing_kernel.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

/// The square of the impact, (m/s)2, of a body at `apart` that comes with `velocity`, in contact from `reach`
/// on.
double impact2(const SpringDashpot& law, double reach, Vec2 apart, Vec2 velocity, double span) {
  const double distance = norm(apart), overlap = reach - distance;
  const double closing = -dot(velocity, apart) / distance;
  if (overlap <= 0.0 && overlap + closing * span <= 0.0) return 0.0;
  const double pressed = std::max(overlap, 0.0);
  return closing * closing + law.stiffness / law.mass * pressed * pressed;
}

/// Of pairs that touch at distances of their own, or at the bed's two sides.
double hardestOneByOne(const BedState& bed, const ContactBlock& block, const SpringDashpot& law,
                       double span) {
  const Period& period = bed.contacts.period();
  double hardest2 = 0.0;
  const auto look = [&](std::int32_t i, std::int32_t j) {
    const Body &first = bed.bodies[i], &second = bed.bodies[j];
    const Vec2 apart = period.nearest(second.position - first.position);
    hardest2 = std::max(hardest2, impact2(law, bed.particles.radiusOf(i) + bed.particles.radiusOf(j), apart,
                                          second.velocity - first.velocity, span));
  };
  for (std::size_t c = 0; c < block.candidateCount; ++c)
    look(block.candidates[c].first, block.candidates[c].second);
  for (std::size_t c = 0; c < block.crossing.count; ++c)
    look(block.crossing.first[c], block.crossing.second[c]);
  return hardest2;
}

double hardestOfAlike(const BedState& bed, const ContactBlock& block, const SpringDashpot& law, double span) {
  const Body* const bodies = bed.bodies.data();
  double hardest2 = 0.0;
  if (block.candidateCount > 0) {
    const ContactBlock::Pair* const pairs = block.candidates.data();
    hardest2 = hardestImpact2(law, span, bodies, {&pairs->first, &pairs->second, 2, block.candidateCount});
  }
  const ContactSlots& crossing = block.crossing;
  return std::max(
      hardest2,
      hardestImpact2(law, span, bodies, {crossing.first.data(), crossing.second.data(), 1, crossing.count}));
}

double hardestOfBlock(const BedState& bed, const ContactBlock& block, const SpringDashpot& pair,
                      const SpringDashpot& wall, double span) {
  const bool alike = !bed.particles.areMixed() && !bed.contacts.period().isOn();
  double hardest2 = alike ? hardestOfAlike(bed, block, pair, span) : hardestOneByOne(bed, block, pair, span);
  for (const ContactBlock::AtWall& w : block.walls) {
    const WallShape shape = bed.contacts.walls()[w.wall].at(bed.timeAfter(0.0));
    for (std::size_t c = 0; c < w.slots.count; ++c) {
      const std::int32_t i = w.slots.first[c];
      const Body& body = bed.bodies[i];
      Vec2 point;
      if (!shape.touchPoint(body.position, point)) continue;
      hardest2 = std::max(hardest2, impact2(wall, bed.particles.radiusOf(i), point - body.position,
                                            shape.velocity - body.velocity, span));
    }
  }
  return hardest2;
}

/// What is left of the outer skin, by the particles' places and not by their speeds, m.
double measuredBudget(const BedState& bed) {
  return bed.contacts.remainder(bed.contacts.displacements({0, bed.bodies.size()}, bed.bodies));
}

}  // namespace

double closingSpeed(BedState& bed, const SpringDashpot& pair, const SpringDashpot& wall, double fastest,
                    double span) {
  // What they were foreseen to do is not kept by a checkpoint.
  bed.placeBodies();
  const double most = std::max(2.0 * fastest, fastest + bed.fastestWall());
  if (most * span > bed.budget.outer && most * span > measuredBudget(bed)) return most;

  std::vector<double> ofBlock(bed.contacts.blocks());
  bed.team.run([&](int member) {
    const Range blocks = bed.team.share(ofBlock.size(), member);
    for (std::size_t b = blocks.begin; b < blocks.end; ++b)
      ofBlock[b] = hardestOfBlock(bed, bed.contacts.block(b), pair, wall, span);
  });
  return std::sqrt(*std::max_element(ofBlock.begin(), ofBlock.end()));
}

}  // namespace bedmix
