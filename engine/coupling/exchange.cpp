// SPDX-License-Identifier: MIT
#include "engine/coupling/exchange.h"

#include <algorithm>

namespace bedmix {

Exchange::Exchange(const Scene& scene, const GasSolver& gas, const VoidageField& voidage)
    : gas_(gas),
      voidage_(voidage),
      columns_(gas.grid().x),
      rows_(gas.grid().y),
      drag_(dragFunction(scene.gas->drag)),
      properties_{scene.particles.diameter, scene.gas->density, scene.gas->viscosity},
      particleVolume_(bedmix::particleVolume(scene)),
      solved_(gas.layout().faceArea.size()),
      faceGradient_(gas.layout().faceArea.size()),
      gradient_(gas.grid().cells()) {
  for (const MomentumVolume& v : gas.layout().volumes) solved_[v.face] = 1;
}

Exchange::FaceWeights Exchange::weightsAt(double x, double y) const {
  const FaceLayout& layout = gas_.layout();
  const auto corners = [](const GridAxis::Pair& a, const GridAxis::Pair& b) {
    return std::array{a.share * b.share, (1.0 - a.share) * b.share, a.share * (1.0 - b.share),
                      (1.0 - a.share) * (1.0 - b.share)};
  };
  FaceWeights w;
  const GridAxis::Pair ux = columns_.betweenFaces(x), uy = rows_.betweenCentres(y);
  w.u = {layout.uFace(ux.first, uy.first), layout.uFace(ux.second, uy.first),
         layout.uFace(ux.first, uy.second), layout.uFace(ux.second, uy.second)};
  w.uWeight = corners(ux, uy);
  const GridAxis::Pair vx = columns_.betweenCentres(x), vy = rows_.betweenFaces(y);
  w.v = {layout.vFace(vx.first, vy.first), layout.vFace(vx.second, vy.first),
         layout.vFace(vx.first, vy.second), layout.vFace(vx.second, vy.second)};
  w.vWeight = corners(vx, vy);
  for (std::int32_t& f : w.u) f = layout.openFace[f];
  for (std::int32_t& f : w.v) f = layout.openFace[f];
  return w;
}

Vec2 Exchange::gasVelocity(const FaceWeights& w) const {
  const std::vector<double>& velocity = gas_.fields().velocity;
  Vec2 u;
  for (int k = 0; k < 4; ++k) {
    u.x += w.uWeight[k] * velocity[w.u[k]];
    u.y += w.vWeight[k] * velocity[w.v[k]];
  }
  return u;
}

void Exchange::evaluateDrag(const Particles& particles, MomentumExchange& exchange) {
  weights_.resize(particles.size());
  coefficient_.resize(particles.size());
  std::fill(exchange.coefficient.begin(), exchange.coefficient.end(), 0.0);
  std::fill(exchange.source.begin(), exchange.source.end(), 0.0);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const VolumeShares& s = voidage_.shares()[i];
    coefficient_[i] = 0.0;
    if (s.coupling == 0.0) continue;
    double voidage = 0.0;
    for (int k = 0; k < 4; ++k) voidage += s.share[k] * voidage_.voidage()[s.cell[k]];
    voidage /= s.coupling;

    FaceWeights& w = weights_[i];
    w = weightsAt(particles.x[i], particles.y[i]);
    const double slip = norm(gasVelocity(w) - Vec2{particles.vx[i], particles.vy[i]});
    const double b = s.coupling * particleVolume_ * drag_(voidage, slip, properties_) / (1.0 - voidage);
    coefficient_[i] = b;
    for (int k = 0; k < 4; ++k) {
      exchange.coefficient[w.u[k]] += b * w.uWeight[k];
      exchange.source[w.u[k]] += b * w.uWeight[k] * particles.vx[i];
      exchange.coefficient[w.v[k]] += b * w.vWeight[k];
      exchange.source[w.v[k]] += b * w.vWeight[k] * particles.vy[i];
    }
  }
}

void Exchange::updatePressureGradient() {
  const FaceLayout& layout = gas_.layout();
  const std::vector<double>& pressure = gas_.fields().pressure;
  for (const MomentumVolume& v : layout.volumes) {
    const double beyond = v.cellPlus < 0 ? 0.0 : pressure[v.cellPlus];
    faceGradient_[v.face] = (beyond - pressure[v.cellMinus]) * v.area / v.volume;
  }
  const auto mean = [&](int a, int b) {
    const int solved = solved_[a] + solved_[b];
    return solved == 0 ? 0.0 : (faceGradient_[a] + faceGradient_[b]) / solved;
  };
  for (int c : layout.openCells) {
    const auto& [left, right, bottom, top] = layout.cellFaces[c];
    gradient_[c] = {mean(left, right), mean(bottom, top)};
  }
}

void Exchange::applyForces(Particles& particles) {
  updatePressureGradient();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const VolumeShares& s = voidage_.shares()[i];
    Vec2 force;
    if (s.coupling > 0.0) {
      force = coefficient_[i] * (gasVelocity(weights_[i]) - Vec2{particles.vx[i], particles.vy[i]});
      for (int k = 0; k < 4; ++k) force -= s.share[k] * particleVolume_ * gradient_[s.cell[k]];
    }
    particles.fx[i] = force.x;
    particles.fy[i] = force.y;
  }
}

}  // namespace bedmix
