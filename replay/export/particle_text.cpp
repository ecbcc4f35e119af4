// SPDX-License-Identifier: MIT
#include "replay/export/particle_text.h"

#include "engine/core/particle_list.h"
#include "replay/export/growing_file.h"

#include <fmt/format.h>

#include <iterator>

namespace bedmix {

namespace {

using Format = std::string (*)(const Frame& frame, const Scene& scene);

/// All frames one after the other in a file.
class ParticleText final : public Export {
 public:
  ParticleText(const Scene& scene, GrowingFile file, Format format)
      : scene_(scene), file_(std::move(file)), format_(format) {}

  std::vector<std::filesystem::path> files() const override { return {file_.path()}; }

 private:
  std::optional<Diagnostic> write(const Frame& frame) override {
    return file_.append(format_(frame, scene_));
  }

  const Scene& scene_;
  GrowingFile file_;
  Format format_;
};

Result<std::unique_ptr<Export>> open(const ExportInput& input, const char* name, std::string_view head,
                                     Format format) {
  auto file = GrowingFile::create(input.folder / name, head);
  if (!file) return std::move(file.problems);
  return std::unique_ptr<Export>(std::make_unique<ParticleText>(input.scene, std::move(*file), format));
}

// The particles' mid-plane is z = 0.

std::string extxyz(const Frame& frame, const Scene& scene) {
  const bool spins = !frame.angularVelocity.empty();
  const double depth = scene.bed.thickness;
  std::string text = fmt::format(
      "{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"0 0 {}\" pbc=\"{} F F\" "
      "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1{}{}{} Time={}\n",
      frame.size(), scene.bed.width, scene.bed.height, depth, -depth / 2,
      scene.bed.sides == BedSides::periodic ? "T" : "F", spins ? ":omega:R:1" : "",
      frame.temperature.empty() ? "" : ":temperature:R:1", frame.content.empty() ? "" : ":content:R:1",
      frame.time);
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec2f at = frame.position[i], v = frame.velocity[i];
    fmt::format_to(out, "{} {} {} 0 {} {} 0 {} {}", frame.species[i] ? "C" : "Cl", at.x, at.y, v.x, v.y,
                   radiusOf(scene, frame, i), frame.id[i]);
    if (spins) fmt::format_to(out, " {}", frame.angularVelocity[i]);
    if (!frame.temperature.empty()) fmt::format_to(out, " {}", frame.temperature[i]);
    if (!frame.content.empty()) fmt::format_to(out, " {}", frame.content[i]);
    text += '\n';
  }
  return text;
}

std::string lammps(const Frame& frame, const Scene& scene) {
  const bool spins = !frame.angularVelocity.empty();
  const double depth = scene.bed.thickness;
  std::string text = fmt::format(
      "ITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n"
      "ITEM: BOX BOUNDS {} ff ff\n0 {}\n0 {}\n{} {}\nITEM: ATOMS id type x y z vx vy vz radius{}{}{}\n",
      frame.time, frame.step, frame.size(), scene.bed.sides == BedSides::periodic ? "pp" : "ff",
      scene.bed.width, scene.bed.height, -depth / 2, depth / 2, spins ? " omegaz" : "",
      frame.temperature.empty() ? "" : " temperature", frame.content.empty() ? "" : " content");
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec2f at = frame.position[i], v = frame.velocity[i];
    fmt::format_to(out, "{} {} {} {} 0 {} {} 0 {}", frame.id[i], frame.species[i] + 1, at.x, at.y, v.x, v.y,
                   radiusOf(scene, frame, i));
    if (spins) fmt::format_to(out, " {}", frame.angularVelocity[i]);
    if (!frame.temperature.empty()) fmt::format_to(out, " {}", frame.temperature[i]);
    if (!frame.content.empty()) fmt::format_to(out, " {}", frame.content[i]);
    text += '\n';
  }
  return text;
}

}  // namespace

Result<std::unique_ptr<Export>> openExtxyz(const ExportInput& input) {
  return open(input, "particles.extxyz", "", extxyz);
}

Result<std::unique_ptr<Export>> openLammps(const ExportInput& input) {
  return open(input, "particles.lammpstrj", "ITEM: UNITS\nsi\n", lammps);
}

}  // namespace bedmix
