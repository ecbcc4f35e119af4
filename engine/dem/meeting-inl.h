// SPDX-License-Identifier: MIT

// What differs from contact to contact where contacts have effects, in vectors: once a target, in the manner
// of Highway.
#if defined(BEDMIX_DEM_MEETING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef BEDMIX_DEM_MEETING_INL_H_
#undef BEDMIX_DEM_MEETING_INL_H_
#else
#define BEDMIX_DEM_MEETING_INL_H_
#endif

#include "engine/dem/contact_kernel.h"
#include "engine/dem/kinematics-inl.h"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

/// Of a vector of contacts: the slip due to spin, m/s, and, where the law is rich, what each has of its own.
template <bool rich>
struct Meeting {
  V rolling;
};
template <>
struct Meeting<true> {
  V rolling;
  V reach, first, second;  // m: distance at touch, radii; at a wall the second is zero
  V radius, mass;          // effective: r1 r2/(r1 + r2), m1 m2/(m1 + m2); at a wall the particle's
  V damping, friction;     // see ContactMaterial
  V turning;               // rad/s, spin of the first less that of the second
  V rollingInertia;        // kg m2, of both about the point of contact
};

/// Looks up what each contact has.
class Meetings {
 public:
  explicit Meetings(const ContactKernel& kernel, const Motion& at)
      : kernel_(kernel), at_(at), repeats_(kernel.effects && kernel.effects->period.isOn()) {}

  HWY_INLINE Meeting<true> ofPairs(const std::int32_t* i, const std::int32_t* j) const {
    Meeting<true> m = begin(i);
    m.second = radius(j);
    const V firstMass = m.mass, secondMass = mass(j);
    m.reach = hn::Add(m.first, m.second);
    m.radius = hn::Div(hn::Mul(m.first, m.second), m.reach);
    m.mass = hn::Div(hn::Mul(firstMass, secondMass), hn::Add(firstMass, secondMass));
    const std::size_t columns = kernel_.effects->kinds + 1;
    lookUp(m, [&](std::size_t l) { return kind(i[l]) * columns + kind(j[l]); });
    if (!at_.spin) return m;
    const V firstSpin = spin(i), secondSpin = spin(j);
    m.rolling = hn::Add(hn::Mul(m.first, firstSpin), hn::Mul(m.second, secondSpin));
    m.turning = hn::Sub(firstSpin, secondSpin);
    const V a = aboutContact(firstMass, m.first), b = aboutContact(secondMass, m.second);
    m.rollingInertia = hn::Div(hn::Mul(a, b), hn::Add(a, b));
    return m;
  }

  HWY_INLINE Meeting<true> atWall(const std::int32_t* i) const {
    Meeting<true> m = begin(i);
    m.second = hn::Zero(d_);
    m.reach = m.radius = m.first;
    const std::size_t kinds = kernel_.effects->kinds;
    lookUp(m, [&](std::size_t l) { return kind(i[l]) * (kinds + 1) + kinds; });
    if (!at_.spin) return m;
    m.turning = spin(i);
    m.rolling = hn::Mul(m.first, m.turning);
    m.rollingInertia = aboutContact(m.mass, m.first);
    return m;
  }

  /// Of the images of the seconds, where the bed has them.
  HWY_INLINE void takeNearest(Planar& apart) const {
    if (!repeats_) return;
    const Period& period = kernel_.effects->period;
    const V periods = hn::Round(hn::Mul(apart.x, hn::Set(d_, period.perLength)));
    apart.x = hn::Sub(apart.x, hn::Mul(hn::Set(d_, period.length), periods));
  }

 private:
  HWY_INLINE Meeting<true> begin(const std::int32_t* i) const {
    Meeting<true> m;
    m.rolling = m.turning = m.rollingInertia = hn::Zero(d_);
    m.first = radius(i);
    m.mass = mass(i);
    return m;
  }
  std::size_t kind(std::int32_t i) const { return at_.kinds ? at_.kinds[i] : 0; }
  HWY_INLINE V radius(const std::int32_t* i) const {
    return at_.radii ? collect(d_, 0, [&](std::size_t l) { return at_.radii[i[l]]; })
                     : hn::Set(d_, kernel_.radius);
  }
  HWY_INLINE V mass(const std::int32_t* i) const {
    return at_.masses ? collect(d_, 0, [&](std::size_t l) { return at_.masses[i[l]]; })
                      : hn::Set(d_, kernel_.particleMass);
  }
  HWY_INLINE V spin(const std::int32_t* i) const {
    return collect(d_, 0, [&](std::size_t l) { return at_.spin[i[l]]; });
  }
  template <class Index>
  HWY_INLINE void lookUp(Meeting<true>& m, const Index& index) const {
    const ContactMaterial* const materials = kernel_.effects->materials.data();
    m.damping = collect(d_, 0, [&](std::size_t l) { return materials[index(l)].damping; });
    m.friction = collect(d_, 0, [&](std::size_t l) { return materials[index(l)].friction; });
  }
  /// Of a sphere that rolls, 7/5 m r^2.
  HWY_INLINE V aboutContact(V mass, V radius) const {
    return hn::Mul(hn::Set(d_, 1.4), hn::Mul(mass, hn::Mul(radius, radius)));
  }

  D d_;
  const ContactKernel& kernel_;
  Motion at_;
  bool repeats_;  // places, sideways
};

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
