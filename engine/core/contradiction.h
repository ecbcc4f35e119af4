// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace bedmix {

struct ParticleSettings;
struct PictureSettings;
struct Scene;

/// What is wrong with settings that are each in range but do not fit together; readScene() includes these.
struct Contradiction {
  std::string path;  // dotted key it is reported at
  std::string message;
  std::vector<std::string> concerns;  // the other keys it follows from
};
std::vector<Contradiction> contradictions(const Scene& scene);
/// Of these, those of kinds and sizes.
std::vector<Contradiction> contradictions(const Scene& scene, const ParticleSettings& particles);
/// The same of settings of pictures, which need not be the scene's own.
std::vector<Contradiction> contradictions(const Scene& scene, const PictureSettings& pictures);

}  // namespace bedmix
