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

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr std::size_t lanes = hn::MaxLanes(D());

/// (x, y) of every other particle of `index`, one after the other.
template <class Tag>
HWY_INLINE hn::Vec<Tag> loadEveryOther(Tag d, const Vec2* from, const std::int32_t* index) {
  if constexpr (hn::MaxLanes(Tag()) == 2) {
    return hn::LoadU(d, &from[index[0]].x);
  } else {
    const hn::Half<Tag> half;
    constexpr std::size_t upper = hn::MaxLanes(Tag()) / 2;
    return hn::Combine(d, loadEveryOther(half, from, index + upper), loadEveryOther(half, from, index));
  }
}

/// from[index[0]], from[index[1]], ...
template <class Tag>
HWY_INLINE hn::Vec<Tag> loadEach(Tag d, const double* from, const std::int32_t* index) {
  if constexpr (hn::MaxLanes(Tag()) == 1) {
    return hn::LoadU(d, &from[index[0]]);
  } else {
    const hn::Half<Tag> half;
    constexpr std::size_t upper = hn::MaxLanes(Tag()) / 2;
    return hn::Combine(d, loadEach(half, from, index + upper), loadEach(half, from, index));
  }
}

struct Plane {
  V x, y;
};

HWY_INLINE Plane difference(const Vec2* of, const std::int32_t* first, const std::int32_t* second) {
  const D d;
  const V even = hn::Sub(loadEveryOther(d, of, second), loadEveryOther(d, of, first));
  const V odd = hn::Sub(loadEveryOther(d, of, second + 1), loadEveryOther(d, of, first + 1));
  return {hn::InterleaveLower(d, even, odd), hn::InterleaveUpper(d, even, odd)};
}

HWY_INLINE Plane load(const Vec2* of, const std::int32_t* index) {
  const D d;
  const V even = loadEveryOther(d, of, index), odd = loadEveryOther(d, of, index + 1);
  return {hn::InterleaveLower(d, even, odd), hn::InterleaveUpper(d, even, odd)};
}

HWY_INLINE V dot(const Plane& a, const Plane& b) { return hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)); }

/// What a vector of contacts adds to the first particles.
struct Push {
  V fx, fy, torque;
};

/// Visits contact after contact: visit(l, row) with the row of the first particle's load, in as many vectors
/// as it takes.
template <class Tag, class Visit>
HWY_INLINE void forRows(Tag d, hn::Vec<Tag> fx, hn::Vec<Tag> fy, hn::Vec<Tag> torque, std::size_t l,
                        Visit&& visit) {
  constexpr std::size_t n = hn::MaxLanes(Tag());
  if constexpr (n > 4) {
    const hn::Half<Tag> half;
    forRows(half, hn::LowerHalf(half, fx), hn::LowerHalf(half, fy), hn::LowerHalf(half, torque), l, visit);
    forRows(half, hn::UpperHalf(half, fx), hn::UpperHalf(half, fy), hn::UpperHalf(half, torque), l + n / 2,
            visit);
  } else {
    const auto zero = hn::Zero(d);
    const auto even = hn::InterleaveLower(d, fx, fy), odd = hn::InterleaveUpper(d, fx, fy);
    const auto evenTurn = hn::InterleaveLower(d, torque, zero),
               oddTurn = hn::InterleaveUpper(d, torque, zero);
    if constexpr (n == 4) {
      visit(l, hn::ConcatLowerLower(d, evenTurn, even));
      visit(l + 1, hn::ConcatLowerLower(d, oddTurn, odd));
      visit(l + 2, hn::ConcatUpperUpper(d, evenTurn, even));
      visit(l + 3, hn::ConcatUpperUpper(d, oddTurn, odd));
    } else {
      visit(l, even, evenTurn);
      visit(l + 1, odd, oddTurn);
    }
  }
}

/// Whole rows, or halves of them: force, then torque.
using Row = hn::CappedTag<double, 4>;
using RowPart = hn::Vec<Row>;

HWY_INLINE void addRow(Load* load, RowPart row) {
  double* const to = &load->force.x;
  hn::Store(hn::Add(hn::Load(Row(), to), row), Row(), to);
}
HWY_INLINE void addRow(Load* load, RowPart force, RowPart torque) {
  double* const to = &load->force.x;
  hn::Store(hn::Add(hn::Load(Row(), to), force), Row(), to);
  hn::Store(hn::Add(hn::Load(Row(), to + 2), torque), Row(), to + 2);
}

/// The same on the other: the force changes its sign, the torque does not.
HWY_ALIGN constexpr double signs[] = {-0.0, -0.0, 0.0, 0.0};
HWY_INLINE void addOther(Load* load, RowPart row) { addRow(load, hn::Xor(row, hn::Load(Row(), signs))); }
HWY_INLINE void addOther(Load* load, RowPart force, RowPart torque) { addRow(load, hn::Neg(force), torque); }

template <bool friction>
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
    if (hn::AllFalse(d_, touching)) {
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
    const V normal = hn::Sub(hn::Mul(stiffness_, hn::Sub(reach_, distance)), hn::Mul(damping_, parting));
    V fx = hn::Neg(hn::Mul(normal, nx)), fy = hn::Neg(hn::Mul(normal, ny));
    push.torque = hn::Zero(d_);
    if constexpr (friction) {
      const V slip = hn::Add(hn::Sub(hn::Mul(velocity.x, ny), hn::Mul(velocity.y, nx)), rolling);
      const V grown = hn::Mul(halfStep_, hn::Add(hn::LoadU(d_, t.slip + at), slip));
      const V spring = hn::Add(hn::LoadU(d_, t.spring + at), grown);
      const V limit = hn::Mul(friction_, hn::Abs(normal));
      const V stick =
          hn::Neg(hn::Add(hn::Mul(tangentialStiffness_, spring), hn::Mul(tangentialDamping_, slip)));
      const V force = hn::Max(hn::Min(stick, limit), hn::Neg(limit));
      fx = hn::Sub(fx, hn::Mul(force, ny));
      fy = hn::Add(fy, hn::Mul(force, nx));
      // Unchanged where it sticks.
      const V left = hn::Add(spring, hn::Mul(hn::Sub(stick, force), perStiffness_));
      hn::StoreU(hn::IfThenElseZero(touching, left), d_, t.newSpring + at);
      hn::StoreU(hn::IfThenElseZero(touching, slip), d_, t.newSlip + at);
      push.torque = hn::IfThenElseZero(touching, hn::Mul(radius_, force));
    }
    push.fx = hn::IfThenElseZero(touching, fx);
    push.fy = hn::IfThenElseZero(touching, fy);
    return true;
  }

  KernelReport report() const { return {hn::GetLane(hn::MinOfLanes(d_, closest2_)), count_}; }

 private:
  D d_;
  V reach_, reach2_, stiffness_, damping_, tangentialStiffness_, perStiffness_, tangentialDamping_, friction_;
  V halfStep_, radius_, closest2_;
  std::size_t count_ = 0;
};

/// What becomes of the second particles' part.
enum class Second { added, inRows };

template <bool friction, Second where>
KernelReport pairLoop(const ContactKernel& kernel, const Motion& motion, const PairIndices& pairs,
                      const Tangential& tangential, Load* loads, Load* second) {
  const D d;
  const Motion at = motion;  // copies, which no store can change
  const Tangential t = tangential;
  const std::int32_t *firsts = pairs.first, *seconds = pairs.second;
  const std::size_t count = pairs.count;
  Law<friction> law(kernel);
  for (std::size_t c = 0; c < count; c += lanes) {
    const std::int32_t *i = firsts + c, *j = seconds + c;
    V rolling = hn::Zero(d);
    if constexpr (friction)
      rolling = hn::Mul(law.radius(), hn::Add(loadEach(d, at.spin, i), loadEach(d, at.spin, j)));
    Push push{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    const bool any = law.apply(difference(at.position, i, j), difference(at.velocity, i, j), rolling,
                               hn::FirstN(d, count - c), c, t, push);
    // Rows of all, for who reads them does not know who touches.
    if (!any && where == Second::added) continue;
    forRows(d, push.fx, push.fy, push.torque, 0, [&](std::size_t l, auto... parts) HWY_ATTR {
      addRow(loads + i[l], parts...);
      if constexpr (where == Second::inRows) second[c + l] = Load{};
      addOther(where == Second::added ? loads + j[l] : second + c + l, parts...);
    });
  }
  return law.report();
}

template <bool friction>
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
  Law<friction> law(kernel);
  for (std::size_t c = 0; c < count; c += lanes) {
    const std::int32_t* i = particle + c;
    const Plane centre = load(at.position, i), velocity = load(at.velocity, i);
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
    if constexpr (friction) rolling = hn::Mul(law.radius(), loadEach(d, at.spin, i));
    const M among = hn::And(pushes, count - c < lanes ? hn::FirstN(d, count - c) : all);
    Push push{zero, zero, zero};
    if (!law.apply(minus(nearest, centre), {hn::Neg(velocity.x), hn::Neg(velocity.y)}, rolling, among, c, t,
                   push))
      continue;
    forRows(d, push.fx, push.fy, push.torque, 0,
            [&](std::size_t l, auto... parts) HWY_ATTR { addRow(loads + i[l], parts...); });
  }
  return law.report();
}

}  // namespace

KernelReport pairs(const ContactKernel& kernel, const Motion& at, const PairIndices& pairs,
                   const Tangential& t, Load* loads) {
  const auto loop = kernel.friction ? pairLoop<true, Second::added> : pairLoop<false, Second::added>;
  return loop(kernel, at, pairs, t, loads, nullptr);
}

KernelReport crossing(const ContactKernel& kernel, const Motion& at, const PairIndices& pairs,
                      const Tangential& t, Load* loads, Load* second) {
  const auto loop = kernel.friction ? pairLoop<true, Second::inRows> : pairLoop<false, Second::inRows>;
  return loop(kernel, at, pairs, t, loads, second);
}

KernelReport wall(const ContactKernel& kernel, const Motion& at, const WallShape& wall,
                  const std::int32_t* particle, std::size_t count, const Tangential& t, Load* loads) {
  const auto loop = kernel.friction ? wallLoop<true> : wallLoop<false>;
  return loop(kernel, at, wall, particle, count, t, loads);
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
