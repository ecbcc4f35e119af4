// SPDX-License-Identifier: MIT
#include "engine/dem/contact_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/dem/contact_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/dem/contact_law-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

/// Visits contact after contact: visit(l, row) with the row of the first particle's load, or visit(l, force,
/// torque) with its halves.
template <class Visit>
HWY_INLINE void forRows(const Push& push, Visit&& visit) {
  const D d;
  const V zero = hn::Zero(d);
  const V even = hn::InterleaveLower(d, push.fx, push.fy), odd = hn::InterleaveUpper(d, push.fx, push.fy);
  const V evenTurn = hn::InterleaveLower(d, push.torque, zero),
          oddTurn = hn::InterleaveUpper(d, push.torque, zero);
  if constexpr (lanes == 4) {
    visit(0, hn::ConcatLowerLower(d, evenTurn, even));
    visit(1, hn::ConcatLowerLower(d, oddTurn, odd));
    visit(2, hn::ConcatUpperUpper(d, evenTurn, even));
    visit(3, hn::ConcatUpperUpper(d, oddTurn, odd));
  } else {
    visit(0, even, evenTurn);
    visit(1, odd, oddTurn);
  }
}

HWY_INLINE void addRow(Load* load, V row) {
  double* const to = &load->force.x;
  hn::Store(hn::Add(hn::Load(D(), to), row), D(), to);
}
HWY_INLINE void addRow(Load* load, V force, V torque) {
  double* const to = &load->force.x;
  hn::Store(hn::Add(hn::Load(D(), to), force), D(), to);
  hn::Store(hn::Add(hn::Load(D(), to + 2), torque), D(), to + 2);
}

/// The same on the other: the force changes its sign, the torque does not.
HWY_ALIGN constexpr double signs[] = {-0.0, -0.0, 0.0, 0.0};
HWY_INLINE void addOther(Load* load, V row) { addRow(load, hn::Xor(row, hn::Load(D(), signs))); }
HWY_INLINE void addOther(Load* load, V force, V torque) { addRow(load, hn::Neg(force), torque); }

/// What becomes of the second particles' part.
enum class Second { added, inRows };

/// Those from `c` on; of the vector's lanes only those `among`.
template <Parts parts, Second where>
HWY_INLINE void addPairs(Law<parts>& law, const Meetings& meetings, const Motion& at, const std::int32_t* i,
                         const std::int32_t* j, std::size_t c, M among, const Tangential& t, Load* loads,
                         Load* second) {
  const D d;
  Meeting<parts.rich> meeting;
  if constexpr (parts.rich) {
    meeting = meetings.ofPairs(i + c, j + c);
  } else {
    meeting.rolling = hn::Zero(d);
    if constexpr (parts.friction)
      meeting.rolling =
          hn::Mul(law.radius(), collect(d, c, [&](std::size_t l) { return at.spin[i[l]] + at.spin[j[l]]; }));
  }
  Kinematics other = difference(at.body, i + c, j + c);
  if constexpr (parts.rich) meetings.takeNearest(other.position);
  Push push{hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  const bool any = law.apply(other.position, other.velocity, meeting, among, c, t, push);
  // Rows of all, for who reads them does not know who touches.
  if (!any && where == Second::added) return;
  forRows(push, [&](std::size_t l, auto... halves) HWY_ATTR {
    addRow(loads + i[c + l], halves...);
    if constexpr (where == Second::inRows) second[c + l] = Load{};
    if constexpr (!parts.rich)
      addOther(where == Second::added ? loads + j[c + l] : second + c + l, halves...);
  });
  if constexpr (parts.rich)
    forRows({hn::Neg(push.fx), hn::Neg(push.fy), push.torqueOfSecond, push.torque},
            [&](std::size_t l, auto... halves)
                HWY_ATTR { addRow(where == Second::added ? loads + j[c + l] : second + c + l, halves...); });
}

template <Parts parts, Second where>
KernelReport pairLoop(const ContactKernel& kernel, const Motion& motion, const PairIndices& pairs,
                      const Tangential& tangential, Load* loads, Load* second) {
  const D d;
  const Motion at = motion;  // copies, which no store can change
  const Tangential t = tangential;
  const std::int32_t *i = pairs.first, *j = pairs.second;
  const std::size_t end = pairs.slots.end;
  const M all = hn::FirstN(d, lanes);
  Law<parts> law(kernel, false);
  const Meetings meetings(kernel, at);
  std::size_t c = pairs.slots.begin;
  for (; c + lanes <= end; c += lanes)
    addPairs<parts, where>(law, meetings, at, i, j, c, all, t, loads, second);
  if (c < end) addPairs<parts, where>(law, meetings, at, i, j, c, hn::FirstN(d, end - c), t, loads, second);
  return law.report();
}

/// What walls have that are not plain, see WallShape::isPlain().
struct Surface {
  V radius, spin;
  Planar a, velocity;

  explicit Surface(const WallShape& wall)
      : radius(hn::Set(D(), wall.radius)),
        spin(hn::Set(D(), wall.spin)),
        a{hn::Set(D(), wall.a.x), hn::Set(D(), wall.a.y)},
        velocity{hn::Set(D(), wall.velocity.x), hn::Set(D(), wall.velocity.y)} {}

  /// From the nearest point of the segment to that of the surface, as WallShape::onSurface() does.
  HWY_INLINE Planar nearest(const Planar& centre, const Planar& core) const {
    const Planar out{hn::Sub(centre.x, core.x), hn::Sub(centre.y, core.y)};
    const V share = hn::Div(radius, hn::Max(hn::Sqrt(dot(out, out)), hn::Set(D(), WallShape::tiny)));
    return {hn::Add(core.x, hn::Mul(share, out.x)), hn::Add(core.y, hn::Mul(share, out.y))};
  }
  /// Of the surface at a point, relative to a particle with this velocity.
  HWY_INLINE Planar slip(const Planar& point, const Planar& particle) const {
    const V x = hn::Sub(point.x, a.x), y = hn::Sub(point.y, a.y);
    return {hn::Sub(hn::Sub(velocity.x, hn::Mul(spin, y)), particle.x),
            hn::Sub(hn::Add(velocity.y, hn::Mul(spin, x)), particle.y)};
  }
};

template <Parts parts, bool plain>
KernelReport wallLoop(const ContactKernel& kernel, const Motion& motion, const WallShape& wall,
                      const std::int32_t* particle, std::size_t count, const Tangential& tangential,
                      Load* loads) {
  const D d;
  const auto plane = [d](Vec2 v) { return Planar{hn::Set(d, v.x), hn::Set(d, v.y)}; };
  const auto minus = [](const Planar& a, const Planar& b) {
    return Planar{hn::Sub(a.x, b.x), hn::Sub(a.y, b.y)};
  };
  const Planar a = plane(wall.a), b = plane(wall.b), along = plane(wall.along);
  const Planar awayA = plane(wall.awayA), awayB = plane(wall.awayB);
  const V zero = hn::Zero(d), length = hn::Set(d, wall.length);
  const M none = hn::FirstN(d, 0), all = hn::FirstN(d, lanes);
  const Motion at = motion;
  const Tangential t = tangential;
  Law<parts> law(kernel, true);
  const Meetings meetings(kernel, at);
  const Surface surface(wall);
  for (std::size_t c = 0; c < count; c += lanes) {
    const std::int32_t* i = particle + c;
    const auto [centre, velocity] = load(at.body, i);
    const Planar fromA = minus(centre, a), fromB = minus(centre, b);
    const V place = dot(fromA, along);
    const M beforeA = hn::Lt(place, zero), beyondB = hn::Gt(place, length);
    // A corner pushes only what lies beyond the ends of both walls that meet there, see WallShape.
    const M cornerA = wall.ownsA ? hn::Lt(dot(fromA, awayA), zero) : none;
    const M cornerB = wall.ownsB ? hn::Lt(dot(fromB, awayB), zero) : none;
    const M pushes = hn::And(hn::Or(hn::Not(beforeA), cornerA), hn::Or(hn::Not(beyondB), cornerB));
    const V clamped = hn::Min(hn::Max(place, zero), length);
    const Planar point{hn::Add(a.x, hn::Mul(clamped, along.x)), hn::Add(a.y, hn::Mul(clamped, along.y))};
    Planar nearest{hn::IfThenElse(beyondB, b.x, point.x), hn::IfThenElse(beyondB, b.y, point.y)};
    Planar slip{hn::Neg(velocity.x), hn::Neg(velocity.y)};
    if constexpr (!plain) {
      nearest = surface.nearest(centre, nearest);
      slip = surface.slip(nearest, velocity);
    }
    Meeting<parts.rich> meeting;
    if constexpr (parts.rich) {
      meeting = meetings.atWall(i);
    } else {
      meeting.rolling = zero;
      if constexpr (parts.friction)
        meeting.rolling = hn::Mul(law.radius(), collect(d, 0, [&](std::size_t l) { return at.spin[i[l]]; }));
    }
    const M among = hn::And(pushes, count - c < lanes ? hn::FirstN(d, count - c) : all);
    Push push{zero, zero, zero, zero};
    if (!law.apply(minus(nearest, centre), slip, meeting, among, c, t, push)) continue;
    forRows(push, [&](std::size_t l, auto... halves) HWY_ATTR { addRow(loads + i[l], halves...); });
  }
  return law.report();
}

template <Parts parts>
struct Composed {
  static constexpr Parts value = parts;
};

/// Calls run() with the parts that the kernel has.
template <class Run>
KernelReport compose(const ContactKernel& kernel, const Run& run) {
  const auto withFriction = [&]<bool onset, bool rich>() {
    return kernel.friction ? run(Composed<Parts{true, onset, rich}>{})
                           : run(Composed<Parts{false, onset, rich}>{});
  };
  if (kernel.effects)
    return kernel.onset ? withFriction.template operator()<true, true>()
                        : withFriction.template operator()<false, true>();
  return kernel.onset ? withFriction.template operator()<true, false>()
                      : withFriction.template operator()<false, false>();
}

template <Second where>
KernelReport anyPairs(const ContactKernel& kernel, const Motion& at, const PairIndices& pairs,
                      const Tangential& t, Load* loads, Load* second) {
  return compose(kernel, [&](auto parts) {
    return pairLoop<decltype(parts)::value, where>(kernel, at, pairs, t, loads, second);
  });
}

}  // namespace

KernelReport pairs(const ContactKernel& kernel, const Motion& at, const PairIndices& pairs,
                   const Tangential& t, Load* loads) {
  return anyPairs<Second::added>(kernel, at, pairs, t, loads, nullptr);
}

KernelReport crossing(const ContactKernel& kernel, const Motion& at, const PairIndices& pairs,
                      const Tangential& t, Load* loads, Load* second) {
  return anyPairs<Second::inRows>(kernel, at, pairs, t, loads, second);
}

KernelReport wall(const ContactKernel& kernel, const Motion& at, const WallShape& wall,
                  const std::int32_t* particle, std::size_t count, const Tangential& t, Load* loads) {
  return compose(kernel, [&](auto parts) {
    const auto loop =
        wall.isPlain() ? wallLoop<decltype(parts)::value, true> : wallLoop<decltype(parts)::value, false>;
    return loop(kernel, at, wall, particle, count, t, loads);
  });
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(pairs);
HWY_EXPORT(crossing);
HWY_EXPORT(wall);

KernelReport ContactKernel::pairs(const Motion& at, const PairIndices& pairs, const Tangential& t,
                                  Load* loads) const {
  return HWY_DYNAMIC_DISPATCH(pairs)(*this, at, pairs, t, loads);
}

KernelReport ContactKernel::crossing(const Motion& at, const PairIndices& pairs, const Tangential& t,
                                     Load* loads, Load* second) const {
  return HWY_DYNAMIC_DISPATCH(crossing)(*this, at, pairs, t, loads, second);
}

KernelReport ContactKernel::wall(const Motion& at, const WallShape& wall, const std::int32_t* particle,
                                 std::size_t count, const Tangential& t, Load* loads) const {
  return HWY_DYNAMIC_DISPATCH(wall)(*this, at, wall, particle, count, t, loads);
}

}  // namespace bedmix
#endif
