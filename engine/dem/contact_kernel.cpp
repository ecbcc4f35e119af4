// SPDX-License-Identifier: MIT
#include "engine/dem/contact_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/dem/contact_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Four contacts at a time even where vectors are longer: rows of four are what is loaded and stored.
using D = hn::CappedTag<double, 4>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr std::size_t lanes = hn::MaxLanes(D());

/// value(0), value(1), ...
template <class Tag, class Value>
HWY_INLINE hn::Vec<Tag> collect(Tag d, std::size_t first, Value&& value) {
  if constexpr (hn::MaxLanes(Tag()) == 2) {
    return hn::OddEven(hn::Set(d, value(first + 1)), hn::Set(d, value(first)));
  } else {
    const hn::Half<Tag> half;
    constexpr std::size_t upper = hn::MaxLanes(Tag()) / 2;
    return hn::Combine(d, collect(half, first + upper, value), collect(half, first, value));
  }
}

struct Plane {
  V x, y;
};

/// Position and velocity of some particles, or of some relative to others.
struct Kinematics {
  Plane position, velocity;
};

/// row(l, part) are rows of bodies, or their halves where vectors are no longer.
template <class LoadRow>
HWY_INLINE Kinematics transpose(LoadRow&& row) {
  const D d;
  if constexpr (lanes == 4) {
    const V r0 = row(0, 0), r1 = row(1, 0), r2 = row(2, 0), r3 = row(3, 0);
    const V x01 = hn::InterleaveLower(d, r0, r1), y01 = hn::InterleaveUpper(d, r0, r1);
    const V x23 = hn::InterleaveLower(d, r2, r3), y23 = hn::InterleaveUpper(d, r2, r3);
    return {{hn::ConcatLowerLower(d, x23, x01), hn::ConcatLowerLower(d, y23, y01)},
            {hn::ConcatUpperUpper(d, x23, x01), hn::ConcatUpperUpper(d, y23, y01)}};
  } else {
    const V p0 = row(0, 0), p1 = row(1, 0), v0 = row(0, 1), v1 = row(1, 1);
    return {{hn::InterleaveLower(d, p0, p1), hn::InterleaveUpper(d, p0, p1)},
            {hn::InterleaveLower(d, v0, v1), hn::InterleaveUpper(d, v0, v1)}};
  }
}

HWY_INLINE V part(const Body& body, std::size_t p) { return hn::Load(D(), &body.position.x + p * lanes); }

HWY_INLINE Kinematics load(const Body* body, const std::int32_t* i) {
  return transpose([&](std::size_t l, std::size_t p) HWY_ATTR { return part(body[i[l]], p); });
}
HWY_INLINE Kinematics difference(const Body* body, const std::int32_t* i, const std::int32_t* j) {
  return transpose([&](std::size_t l, std::size_t p)
                       HWY_ATTR { return hn::Sub(part(body[j[l]], p), part(body[i[l]], p)); });
}

HWY_INLINE V dot(const Plane& a, const Plane& b) { return hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)); }

/// What a vector of contacts adds to the first particles.
struct Push {
  V fx, fy, torque;
};

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

/// The part of the step around an instant for which two bodies touch, if they go on as they do, and the
/// means over the step.
struct Window {
  V share;    // of the step
  V overlap;  // m, counted as 0 while they do not touch
  V rate;     // m/s
};

constexpr double shortest = 1e-300;  // m; stands for a way of zero
constexpr double least = 1e-9;       // share that a sliding spring is set from

/// Of the force at an instant, or, with `onset`, of its mean over the step around it.
template <bool friction, bool onset>
class Law {
 public:
  explicit Law(const ContactKernel& kernel)
      : reach_(hn::Set(d_, kernel.law.reach)),
        reach2_(hn::Set(d_, kernel.law.reach * kernel.law.reach)),
        stiffness_(hn::Set(d_, kernel.law.stiffness)),
        damping_(hn::Set(d_, kernel.law.damping)),
        tangentialStiffness_(hn::Set(d_, kernel.law.tangentialStiffness)),
        perStiffness_(hn::Set(d_, friction ? 1.0 / kernel.law.tangentialStiffness : 0.0)),
        tangentialDamping_(hn::Set(d_, kernel.law.tangentialDamping)),
        friction_(hn::Set(d_, kernel.law.friction)),
        halfStep_(hn::Set(d_, kernel.halfStep)),
        pull_(hn::Set(d_, onset ? kernel.halfStep * kernel.law.stiffness / kernel.law.mass : 0.0)),
        radius_(hn::Set(d_, kernel.radius)),
        closest2_(reach2_) {}

  V radius() const { return radius_; }

  /// n points to the other, t = (-n_y, n_x): in the plane the tangential spring is one number and turns with
  /// the contact by itself. `apart` leads from the particle to the other, `velocity` is the other's relative
  /// to the particle, `rolling` the slip due to spin. Slip is the velocity of the particle's surface relative
  /// to the other's, along t. False, and no push, where none touches.
  HWY_INLINE bool apply(const Plane& apart, const Plane& velocity, V rolling, M among, std::size_t at,
                        const Tangential& t, Push& push) {
    const V distance2 = dot(apart, apart);
    const M touching = hn::And(among, hn::Lt(distance2, reach2_));
    M acting = touching;
    // Who gets within reach in half a step: (r + g)^2 < r^2 + 2 g (r + g), g = dt/2 |dot(v, n)|.
    if constexpr (onset)
      acting = hn::And(among, hn::Lt(distance2, hn::Add(reach2_, twoWays(hn::Abs(dot(apart, velocity))))));
    if (hn::AllFalse(d_, acting)) {
      if constexpr (friction) {
        hn::StoreU(hn::Zero(d_), d_, t.newSpring + at);
        hn::StoreU(hn::Zero(d_), d_, t.newSlip + at);
      }
      return false;
    }
    count_ += hn::CountTrue(d_, touching);
    closest2_ = hn::Min(closest2_, hn::IfThenElse(touching, distance2, reach2_));

    const V distance = hn::Sqrt(distance2);
    const V perDistance = hn::Div(hn::Set(d_, 1.0), distance);
    const V nx = hn::Mul(apart.x, perDistance), ny = hn::Mul(apart.y, perDistance);
    const V parting = dot(velocity, {nx, ny});
    const V overlap = hn::Sub(reach_, distance);
    Window window{};
    V normal;
    if constexpr (onset) {
      window = around(overlap, hn::Neg(parting));
      acting = hn::And(acting, hn::Gt(window.share, hn::Zero(d_)));
      normal =
          hn::Add(hn::Mul(stiffness_, window.overlap), hn::Mul(hn::Mul(damping_, window.share), window.rate));
    } else {
      normal = hn::Sub(hn::Mul(stiffness_, overlap), hn::Mul(damping_, parting));
    }
    V fx = hn::Neg(hn::Mul(normal, nx)), fy = hn::Neg(hn::Mul(normal, ny));
    push.torque = hn::Zero(d_);
    if constexpr (friction) {
      const V slip = hn::Add(hn::Sub(hn::Mul(velocity.x, ny), hn::Mul(velocity.y, nx)), rolling);
      const V limit = hn::Mul(friction_, hn::Abs(normal));
      const V force =
          onset ? rubInWindow(window, slip, limit, acting, at, t) : rub(slip, limit, acting, at, t);
      fx = hn::Sub(fx, hn::Mul(force, ny));
      fy = hn::Add(fy, hn::Mul(force, nx));
      push.torque = hn::IfThenElseZero(acting, hn::Mul(radius_, force));
    }
    push.fx = hn::IfThenElseZero(acting, fx);
    push.fy = hn::IfThenElseZero(acting, fy);
    return true;
  }

  KernelReport report() const { return {hn::GetLane(hn::MinOfLanes(d_, closest2_)), count_}; }

 private:
  HWY_INLINE V twoWays(V speed) const { return hn::Mul(hn::Add(halfStep_, halfStep_), speed); }

  /// `rate` is foreseen with the forces of the last step. Those of the contact's own spring, which began
  /// where the overlap was a step ago, are taken out of it, and put in again as they are now: else the
  /// dashpot lags behind.
  HWY_INLINE Window around(V overlap, V rate) const {
    const V zero = hn::Zero(d_);
    const V before = hn::Max(hn::Sub(overlap, twoWays(rate)), zero);
    const V free = hn::Add(rate, hn::Mul(pull_, before));
    const V way = hn::Mul(halfStep_, hn::Abs(free));
    const V inside = hn::Max(hn::Add(overlap, way), zero);
    const V share =
        hn::Min(hn::Div(inside, hn::Max(hn::Add(way, way), hn::Set(d_, shortest))), hn::Set(d_, 1.0));
    const V mean = hn::Max(overlap, hn::Mul(hn::Set(d_, 0.5), hn::Mul(inside, share)));
    return {share, mean, hn::Sub(free, hn::Mul(pull_, mean))};
  }

  HWY_INLINE V clamp(V force, V limit) const { return hn::Max(hn::Min(force, limit), hn::Neg(limit)); }

  HWY_INLINE V rub(V slip, V limit, M acting, std::size_t at, const Tangential& t) const {
    const V grown = hn::Mul(halfStep_, hn::Add(hn::LoadU(d_, t.slip + at), slip));
    const V spring = hn::Add(hn::LoadU(d_, t.spring + at), grown);
    const V stick =
        hn::Neg(hn::Add(hn::Mul(tangentialStiffness_, spring), hn::Mul(tangentialDamping_, slip)));
    const V force = clamp(stick, limit);
    // Unchanged where it sticks.
    const V left = hn::Add(spring, hn::Mul(hn::Sub(stick, force), perStiffness_));
    hn::StoreU(hn::IfThenElseZero(acting, left), d_, t.newSpring + at);
    hn::StoreU(hn::IfThenElseZero(acting, slip), d_, t.newSlip + at);
    return force;
  }

  /// The spring grows only in the part of the window in which they touch, and ends with a contact that does.
  /// Stored is what it would be in the middle of the window if it had grown through all of it.
  HWY_INLINE V rubInWindow(const Window& window, V slip, V limit, M acting, std::size_t at,
                           const Tangential& t) const {
    const V way = hn::Mul(halfStep_, slip);
    const V first = hn::Add(hn::LoadU(d_, t.spring + at), hn::Mul(halfStep_, hn::LoadU(d_, t.slip + at)));
    const V grown = hn::Mul(window.share, way);
    const V stick =
        hn::Neg(hn::Mul(window.share, hn::Add(hn::Mul(tangentialStiffness_, hn::Add(first, grown)),
                                              hn::Mul(tangentialDamping_, slip))));
    const V force = clamp(stick, limit);
    const V last = hn::Add(first, hn::Sub(hn::Add(grown, grown), way));
    const V slid =
        hn::Div(hn::Mul(hn::Sub(stick, force), perStiffness_), hn::Max(window.share, hn::Set(d_, least)));
    const M goesOn = hn::Or(hn::Ge(window.share, hn::Set(d_, 1.0)), hn::Gt(window.rate, hn::Zero(d_)));
    const M kept = hn::And(acting, goesOn);
    hn::StoreU(hn::IfThenElseZero(kept, hn::Add(last, slid)), d_, t.newSpring + at);
    hn::StoreU(hn::IfThenElseZero(kept, slip), d_, t.newSlip + at);
    return force;
  }

  D d_;
  V reach_, reach2_, stiffness_, damping_, tangentialStiffness_, perStiffness_, tangentialDamping_, friction_;
  V halfStep_, pull_, radius_, closest2_;
  std::size_t count_ = 0;
};

/// What becomes of the second particles' part.
enum class Second { added, inRows };

/// Those from `c` on; of the vector's lanes only those `among`.
template <bool friction, bool onset, Second where>
HWY_INLINE void addPairs(Law<friction, onset>& law, const Motion& at, const std::int32_t* i,
                         const std::int32_t* j, std::size_t c, M among, const Tangential& t, Load* loads,
                         Load* second) {
  const D d;
  V rolling = hn::Zero(d);
  if constexpr (friction)
    rolling =
        hn::Mul(law.radius(), collect(d, c, [&](std::size_t l) { return at.spin[i[l]] + at.spin[j[l]]; }));
  const Kinematics other = difference(at.body, i + c, j + c);
  Push push{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  const bool any = law.apply(other.position, other.velocity, rolling, among, c, t, push);
  // Rows of all, for who reads them does not know who touches.
  if (!any && where == Second::added) return;
  forRows(push, [&](std::size_t l, auto... parts) HWY_ATTR {
    addRow(loads + i[c + l], parts...);
    if constexpr (where == Second::inRows) second[c + l] = Load{};
    addOther(where == Second::added ? loads + j[c + l] : second + c + l, parts...);
  });
}

template <bool friction, bool onset, Second where>
KernelReport pairLoop(const ContactKernel& kernel, const Motion& motion, const PairIndices& pairs,
                      const Tangential& tangential, Load* loads, Load* second) {
  const D d;
  const Motion at = motion;  // copies, which no store can change
  const Tangential t = tangential;
  const std::int32_t *i = pairs.first, *j = pairs.second;
  const std::size_t end = pairs.slots.end;
  const M all = hn::FirstN(d, lanes);
  Law<friction, onset> law(kernel);
  std::size_t c = pairs.slots.begin;
  for (; c + lanes <= end; c += lanes)
    addPairs<friction, onset, where>(law, at, i, j, c, all, t, loads, second);
  if (c < end) addPairs<friction, onset, where>(law, at, i, j, c, hn::FirstN(d, end - c), t, loads, second);
  return law.report();
}

template <bool friction, bool onset>
KernelReport wallLoop(const ContactKernel& kernel, const Motion& motion, const WallShape& wall,
                      const std::int32_t* particle, std::size_t count, const Tangential& tangential,
                      Load* loads) {
  const D d;
  const auto plane = [d](Vec2 v) { return Plane{hn::Set(d, v.x), hn::Set(d, v.y)}; };
  const auto minus = [](const Plane& a, const Plane& b) {
    return Plane{hn::Sub(a.x, b.x), hn::Sub(a.y, b.y)};
  };
  const Plane a = plane(wall.a), b = plane(wall.b), along = plane(wall.along);
  const Plane awayA = plane(wall.awayA), awayB = plane(wall.awayB);
  const V zero = hn::Zero(d), length = hn::Set(d, wall.length);
  const M none = hn::FirstN(d, 0), all = hn::FirstN(d, lanes);
  const Motion at = motion;
  const Tangential t = tangential;
  Law<friction, onset> law(kernel);
  for (std::size_t c = 0; c < count; c += lanes) {
    const std::int32_t* i = particle + c;
    const auto [centre, velocity] = load(at.body, i);
    const Plane fromA = minus(centre, a), fromB = minus(centre, b);
    const V place = dot(fromA, along);
    const M beforeA = hn::Lt(place, zero), beyondB = hn::Gt(place, length);
    // A corner pushes only what lies beyond the ends of both walls that meet there, see WallShape.
    const M cornerA = wall.ownsA ? hn::Lt(dot(fromA, awayA), zero) : none;
    const M cornerB = wall.ownsB ? hn::Lt(dot(fromB, awayB), zero) : none;
    const M pushes = hn::And(hn::Or(hn::Not(beforeA), cornerA), hn::Or(hn::Not(beyondB), cornerB));
    const V clamped = hn::Min(hn::Max(place, zero), length);
    const Plane point{hn::Add(a.x, hn::Mul(clamped, along.x)), hn::Add(a.y, hn::Mul(clamped, along.y))};
    const Plane nearest{hn::IfThenElse(beyondB, b.x, point.x), hn::IfThenElse(beyondB, b.y, point.y)};
    V rolling = zero;
    if constexpr (friction)
      rolling = hn::Mul(law.radius(), collect(d, 0, [&](std::size_t l) { return at.spin[i[l]]; }));
    const M among = hn::And(pushes, count - c < lanes ? hn::FirstN(d, count - c) : all);
    Push push{zero, zero, zero};
    if (!law.apply(minus(nearest, centre), {hn::Neg(velocity.x), hn::Neg(velocity.y)}, rolling, among, c, t,
                   push))
      continue;
    forRows(push, [&](std::size_t l, auto... parts) HWY_ATTR { addRow(loads + i[l], parts...); });
  }
  return law.report();
}

template <Second where>
KernelReport anyPairs(const ContactKernel& kernel, const Motion& at, const PairIndices& pairs,
                      const Tangential& t, Load* loads, Load* second) {
  const auto smooth = kernel.onset ? pairLoop<false, true, where> : pairLoop<false, false, where>;
  const auto rough = kernel.onset ? pairLoop<true, true, where> : pairLoop<true, false, where>;
  return (kernel.friction ? rough : smooth)(kernel, at, pairs, t, loads, second);
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
  const auto smooth = kernel.onset ? wallLoop<false, true> : wallLoop<false, false>;
  const auto rough = kernel.onset ? wallLoop<true, true> : wallLoop<true, false>;
  return (kernel.friction ? rough : smooth)(kernel, at, wall, particle, count, t, loads);
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
