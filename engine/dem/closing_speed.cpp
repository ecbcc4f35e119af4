// SPDX-License-Identifier: MIT
#include "engine/dem/closing_speed.h"

#include "engine/dem/closing_kernel.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

double hardestOfBlock(const BedState& bed, const ContactBlock& block, const SpringDashpot& pair,
                      const SpringDashpot& wall, double span) {
  const Body* const bodies = bed.bodies.data();
  double hardest2 = 0.0;
  if (block.candidateCount > 0) {
    const ContactBlock::Pair* const pairs = block.candidates.data();
    hardest2 = hardestImpact2(pair, span, bodies, {&pairs->first, &pairs->second, 2, block.candidateCount});
  }
  const ContactSlots& crossing = block.crossing;
  hardest2 = std::max(
      hardest2,
      hardestImpact2(pair, span, bodies, {crossing.first.data(), crossing.second.data(), 1, crossing.count}));
  for (const ContactBlock::AtWall& w : block.walls)
    for (std::size_t c = 0; c < w.slots.count; ++c) {
      const Body& body = bodies[w.slots.first[c]];
      Vec2 point;
      if (!bed.contacts.walls()[w.wall].touchPoint(body.position, point)) continue;
      const double distance = norm(point - body.position), overlap = wall.reach - distance;
      const double closing = dot(body.velocity, point - body.position) / distance;
      const double pressed = std::max(overlap, 0.0);
      if (overlap > 0.0 || overlap + closing * span > 0.0)
        hardest2 = std::max(hardest2, closing * closing + wall.stiffness / wall.mass * pressed * pressed);
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
  const double most = 2.0 * fastest;
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
