// SPDX-License-Identifier: MIT
#include "engine/dem/contacts.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

SpringDashpot contactLaw(const Scene& scene, double reach, double damping) {
  SpringDashpot law;
  law.reach = reach;
  law.stiffness = scene.contacts.stiffness;
  law.damping = damping;
  if (const auto& friction = scene.contacts.friction) {
    law.tangentialStiffness = friction->stiffnessRatio * law.stiffness;
    law.tangentialDamping = friction->dampingRatio * damping;
    law.friction = friction->coefficient;
  }
  return law;
}

void watch(OverlapRecord& deepest, double reach, double distance2, std::int64_t particle) {
  const double depth = reach - std::sqrt(distance2);
  if (depth > deepest.depth) deepest = {depth, particle};
}

}  // namespace

SpringDashpot pairLaw(const Scene& scene) {
  return contactLaw(scene, scene.particles.diameter, pairDamping(scene));
}
SpringDashpot wallLaw(const Scene& scene) {
  return contactLaw(scene, scene.particles.diameter / 2.0, wallDamping(scene));
}

template <bool friction>
ContactForces<friction>::ContactForces(const Scene& scene)
    : pair_(pairLaw(scene)), wall_(wallLaw(scene)), radius_(scene.particles.diameter / 2.0) {}

template <bool friction>
void ContactForces<friction>::evaluate(const Motion& at, const NeighbourList& list,
                                       const ContactHistory& from, double halfStep, ContactHistory& to,
                                       ContactLoads& loads) {
  std::fill(loads.fx.begin(), loads.fx.end(), 0.0);
  std::fill(loads.fy.begin(), loads.fy.end(), 0.0);
  std::fill(loads.torque.begin(), loads.torque.end(), 0.0);
  findTouchingPairs(at, list, to);
  addPairs(at, list, from, halfStep, to, loads);
  addWalls(at, list, from, halfStep, to, loads);
}

// The loop over all candidates: no branch, the few that touch are packed to the front.
template <bool friction>
void ContactForces<friction>::findTouchingPairs(const Motion& at, const NeighbourList& list,
                                                ContactHistory& to) const {
  const double reach2 = pair_.reach * pair_.reach;
  const Candidate* __restrict pairs = list.pairs().data();
  const auto candidates = static_cast<std::int32_t>(list.pairs().size());
  std::int32_t* __restrict touching = to.touching.data();
  std::size_t count = 0;
  for (std::int32_t k = 0; k < candidates; ++k) {
    const std::int32_t i = pairs[k].first, j = pairs[k].second;
    const double dx = at.x[j] - at.x[i], dy = at.y[j] - at.y[i];
    touching[count] = k;
    count += static_cast<std::size_t>(dx * dx + dy * dy < reach2);
  }
  to.pairCount = to.count = count;
}

template <bool friction>
void ContactForces<friction>::addPairs(const Motion& at, const NeighbourList& list,
                                       const ContactHistory& from, double halfStep, ContactHistory& to,
                                       ContactLoads& loads) {
  const Candidate* __restrict pairs = list.pairs().data();
  double* __restrict fx = loads.fx.data();
  double* __restrict fy = loads.fy.data();
  [[maybe_unused]] double* __restrict torque = loads.torque.data();
  ContactBatch& b = batch_;
  for (std::size_t done = 0; done < to.pairCount; done += ContactBatch::capacity) {
    const std::size_t count = std::min(ContactBatch::capacity, to.pairCount - done);
    const std::int32_t* __restrict contact = to.touching.data() + done;
    double closest = pair_.reach * pair_.reach;
    for (std::size_t c = 0; c < count; ++c) {
      const std::int32_t i = pairs[contact[c]].first, j = pairs[contact[c]].second;
      b.dx[c] = at.x[j] - at.x[i];
      b.dy[c] = at.y[j] - at.y[i];
      b.dvx[c] = at.vx[j] - at.vx[i];
      b.dvy[c] = at.vy[j] - at.vy[i];
      const double distance2 = b.dx[c] * b.dx[c] + b.dy[c] * b.dy[c];
      closest = distance2 < closest ? distance2 : closest;
      if constexpr (friction) {
        b.rolling[c] = radius_ * (at.spin[i] + at.spin[j]);
        b.spring[c] = from.spring[contact[c]];
        b.slip[c] = from.slip[contact[c]];
      }
    }
    const double record = pair_.reach - loads.deepest.depth;
    if (closest < record * record)
      for (std::size_t c = 0; c < count; ++c)
        watch(loads.deepest, pair_.reach, b.dx[c] * b.dx[c] + b.dy[c] * b.dy[c], pairs[contact[c]].first);

    applyLaw(pair_, halfStep, count);

    for (std::size_t c = 0; c < count; ++c) {
      const std::int32_t i = pairs[contact[c]].first, j = pairs[contact[c]].second;
      fx[i] += b.fx[c];
      fy[i] += b.fy[c];
      fx[j] -= b.fx[c];
      fy[j] -= b.fy[c];
      if constexpr (friction) {
        torque[i] += radius_ * b.tangential[c];
        torque[j] += radius_ * b.tangential[c];
        to.spring[contact[c]] = b.spring[c];
        to.slip[contact[c]] = b.slip[c];
      }
    }
  }
}

template <bool friction>
void ContactForces<friction>::addWalls(const Motion& at, const NeighbourList& list,
                                       const ContactHistory& from, double halfStep, ContactHistory& to,
                                       ContactLoads& loads) {
  const std::vector<Candidate>& wallPairs = list.wallPairs();
  const std::size_t offset = list.pairs().size();
  const double reach2 = wall_.reach * wall_.reach;
  ContactBatch& b = batch_;
  std::size_t k = 0;
  while (k < wallPairs.size()) {
    std::size_t count = 0;
    for (; k < wallPairs.size() && count < ContactBatch::capacity; ++k) {
      const std::int32_t i = wallPairs[k].first;
      const Vec2 centre{at.x[i], at.y[i]};
      Vec2 point;
      if (!list.walls()[wallPairs[k].second].touchPoint(centre, point)) continue;
      const Vec2 d = point - centre;
      if (!(dot(d, d) < reach2)) continue;
      b.dx[count] = d.x;
      b.dy[count] = d.y;
      b.dvx[count] = -at.vx[i];
      b.dvy[count] = -at.vy[i];
      watch(loads.deepest, wall_.reach, dot(d, d), i);
      if constexpr (friction) {
        b.rolling[count] = radius_ * at.spin[i];
        b.spring[count] = from.spring[offset + k];
        b.slip[count] = from.slip[offset + k];
      }
      to.touching[to.count + count++] = static_cast<std::int32_t>(offset + k);
    }

    applyLaw(wall_, halfStep, count);

    for (std::size_t c = 0; c < count; ++c) {
      const std::int32_t contact = to.touching[to.count + c];
      const std::int32_t i = wallPairs[contact - offset].first;
      loads.fx[i] += b.fx[c];
      loads.fy[i] += b.fy[c];
      if constexpr (friction) {
        loads.torque[i] += radius_ * b.tangential[c];
        to.spring[contact] = b.spring[c];
        to.slip[contact] = b.slip[c];
      }
    }
    to.count += count;
  }
}

// n points to the other, t = (-n_y, n_x): in the plane the tangential spring is one number and turns with the
// contact by itself. `slip` is the velocity of the particle's surface relative to the other's, along t.
template <bool friction>
void ContactForces<friction>::applyLaw(const SpringDashpot& law, double halfStep, std::size_t count) {
  ContactBatch& b = batch_;
  [[maybe_unused]] const double perStiffness = friction ? 1.0 / law.tangentialStiffness : 0.0;
  for (std::size_t c = 0; c < count; ++c) {
    const double distance = std::sqrt(b.dx[c] * b.dx[c] + b.dy[c] * b.dy[c]);
    const double perDistance = 1.0 / distance;
    const double nx = b.dx[c] * perDistance, ny = b.dy[c] * perDistance;
    const double parting = b.dvx[c] * nx + b.dvy[c] * ny;
    const double push = law.stiffness * (law.reach - distance) - law.damping * parting;
    b.fx[c] = -push * nx;
    b.fy[c] = -push * ny;
    if constexpr (friction) {
      const double slip = b.dvx[c] * ny - b.dvy[c] * nx + b.rolling[c];
      const double spring = b.spring[c] + halfStep * (b.slip[c] + slip);
      const double limit = law.friction * std::abs(push);
      const double stick = -law.tangentialStiffness * spring - law.tangentialDamping * slip;
      const double below = stick < limit ? stick : limit;
      const double force = below > -limit ? below : -limit;
      b.fx[c] -= force * ny;
      b.fy[c] += force * nx;
      b.tangential[c] = force;
      b.spring[c] = spring + (stick - force) * perStiffness;  // unchanged where it sticks
      b.slip[c] = slip;
    }
  }
}

template class ContactForces<false>;
template class ContactForces<true>;

}  // namespace bedmix
