// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/sample.h"
#include "engine/core/scene.h"
#include "engine/dem/particles.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace bedmix {

/// Runs the scene for `duration` s and takes what a run is judged by: first time of A >= 0.9, mean A and M,
/// mean, deviation and spectrum of the pressure drop, bed height, flux, speed; means over the second half
/// where there is gas, over all where there is none. And what it kept to: mass of the gas, convergence,
/// overlap. A run that becomes invalid leaves why. False where `stop` said so, looked at once a frame.
bool measureStatistics(const Scene& scene, const Particles& start, double duration,
                       const std::function<bool()>& stop, Sample& into);

/// Centre of the power spectrum of equally spaced values, their mean taken out, Hz; none where they do not
/// change.
std::optional<double> spectralCentre(std::span<const double> values, double interval);

}  // namespace bedmix
