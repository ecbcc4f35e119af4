// SPDX-License-Identifier: MIT
#include "engine/coupling/exchange.h"

#include <algorithm>

namespace bedmix {

Exchange::Exchange(const Scene& scene, const GasSolver& gas, const VoidageField& voidage, ThreadTeam& team)
    : gas_(gas),
      voidage_(voidage),
      team_(team),
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
  const GridAxis::Interpolation across = columns_.interpolate(x), up = rows_.interpolate(y);
  FaceWeights w;
  w.u = {layout.uFace(across.faces.first, up.centres.first),
         layout.uFace(across.faces.second, up.centres.first),
         layout.uFace(across.faces.first, up.centres.second),
         layout.uFace(across.faces.second, up.centres.second)};
  w.uWeight = corners(across.faces, up.centres);
  w.v = {layout.vFace(across.centres.first, up.faces.first),
         layout.vFace(across.centres.second, up.faces.first),
         layout.vFace(across.centres.first, up.faces.second),
         layout.vFace(across.centres.second, up.faces.second)};
  w.vWeight = corners(across.centres, up.faces);
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

/// B times the coupling of particle i, whose weights are known.
double Exchange::dragCoefficient(std::size_t i, Vec2 velocity) const {
  const VolumeShares& s = voidage_.shares()[i];
  double voidage = 0.0;
  for (int k = 0; k < 4; ++k) voidage += s.share[k] * voidage_.voidage()[s.cell[k]];
  voidage /= s.coupling;
  const double slip = norm(gasVelocity(weights_[i]) - velocity);
  return s.coupling * particleVolume_ * drag_(voidage, slip, properties_) / (1.0 - voidage);
}

void Exchange::evaluateDrag(const Particles& particles, MomentumExchange& exchange) {
  weights_.resize(particles.size());
  coefficient_.resize(particles.size());
  team_.forBlocks(particles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool coupled = voidage_.shares()[i].coupling > 0.0;
      weights_[i] = weightsAt(particles.x[i], particles.y[i]);
      coefficient_[i] = coupled ? dragCoefficient(i, {particles.vx[i], particles.vy[i]}) : 0.0;
    }
  });
  // Sums over particles stay in the order of the particles.
  std::fill(exchange.coefficient.begin(), exchange.coefficient.end(), 0.0);
  std::fill(exchange.source.begin(), exchange.source.end(), 0.0);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const FaceWeights& w = weights_[i];
    const double b = coefficient_[i];
    for (int k = 0; k < 4; ++k) {
      const double bu = b * w.uWeight[k], bv = b * w.vWeight[k];
      exchange.coefficient[w.u[k]] += bu;
      exchange.source[w.u[k]] += bu * particles.vx[i];
      exchange.coefficient[w.v[k]] += bv;
      exchange.source[w.v[k]] += bv * particles.vy[i];
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
  team_.forBlocks(particles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const VolumeShares& s = voidage_.shares()[i];
      Vec2 force = coefficient_[i] * (gasVelocity(weights_[i]) - Vec2{particles.vx[i], particles.vy[i]});
      for (int k = 0; k < 4; ++k) force -= s.share[k] * particleVolume_ * gradient_[s.cell[k]];
      particles.fx[i] = force.x;
      particles.fy[i] = force.y;
    }
  });
}

}  // namespace bedmix
