// SPDX-License-Identifier: MIT
#include "engine/effects/heat_contacts.h"

#include <algorithm>

namespace bedmix {

ContactHeat::ContactHeat(const Scene& scene)
    : law_(scene), wallTemperature_(scene.effects.find<HeatSettings>()->wallTemperature) {}

void ContactHeat::evaluate(const ParticleSolver& solver, const std::vector<double>& temperature,
                           std::vector<double>& flow, ThreadTeam& team) {
  const ContactList& contacts = solver.contacts();
  crossing_.resize(contacts.blocks());
  team.run([&](int member) {
    const Range mine = team.share(contacts.blocks(), member);
    for (std::size_t b = mine.begin; b < mine.end; ++b) {
      ownContacts(contacts.block(b), solver, temperature, crossing_[b], flow);
      if (wallTemperature_) wallContacts(contacts.block(b), solver, temperature, flow);
    }
    team.barrier();
    for (std::size_t b = mine.begin; b < mine.end; ++b)
      for (const ContactBlock::Incoming& in : contacts.block(b).incoming)
        flow[in.particle] -= crossing_[in.block][in.row];
  });
}

void ContactHeat::ownContacts(const ContactBlock& block, const ParticleSolver& solver,
                              const std::vector<double>& temperature, std::vector<double>& crossing,
                              std::vector<double>& flow) const {
  const Particles& particles = solver.particles();
  /// What the first gets.
  const auto between = [&](std::int32_t a, std::int32_t b) {
    const double r = particles.radiusOf(a), s = particles.radiusOf(b);
    const Vec2 apart = solver.contacts().period().nearest(particles.position[b] - particles.position[a]);
    const double overlap = r + s - norm(apart);
    return overlap > 0.0 ? law_.pair(overlap, r * s / (r + s)) * (temperature[b] - temperature[a]) : 0.0;
  };
  std::fill(flow.begin() + static_cast<std::ptrdiff_t>(block.particles.begin),
            flow.begin() + static_cast<std::ptrdiff_t>(block.particles.end), 0.0);
  for (std::size_t c = 0; c < block.near.count; ++c) {
    const std::int32_t a = block.near.first[c], b = block.near.second[c];
    const double heat = between(a, b);
    flow[a] += heat;
    flow[b] -= heat;
  }
  crossing.resize(block.crossing.count);
  for (std::size_t c = 0; c < block.crossing.count; ++c) {
    const std::int32_t a = block.crossing.first[c];
    crossing[c] = between(a, block.crossing.second[c]);
    flow[a] += crossing[c];
  }
}

void ContactHeat::wallContacts(const ContactBlock& block, const ParticleSolver& solver,
                               const std::vector<double>& temperature, std::vector<double>& flow) const {
  const Particles& particles = solver.particles();
  for (const ContactBlock::AtWall& at : block.walls) {
    const WallShape wall = solver.wallNow(at.wall);
    for (std::size_t c = 0; c < at.slots.count; ++c) {
      const std::int32_t a = at.slots.first[c];
      Vec2 point;
      if (!wall.touchPoint(particles.position[a], point)) continue;
      const double radius = particles.radiusOf(a), overlap = radius - norm(point - particles.position[a]);
      if (overlap > 0.0) flow[a] += law_.wall(overlap, radius) * (*wallTemperature_ - temperature[a]);
    }
  }
}

}  // namespace bedmix
