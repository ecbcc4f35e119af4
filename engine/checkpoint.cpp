// SPDX-License-Identifier: MIT
#include "engine/checkpoint.h"

#include "engine/core/hash.h"
#include "engine/core/refinement.h"
#include "engine/core/scene_reader.h"
#include "engine/core/state_bytes.h"

#include <fmt/format.h>

#include <cstring>
#include <utility>

namespace bedmix {

namespace {

/// Comes first, as it lies in memory, which also tells machines of another byte order apart. After it the
/// state, then the checksum of both.
struct Header {
  std::uint64_t magic = 0x706b636d64656221;  // "!bedmckp"
  std::uint64_t version = currentVersion;
  std::uint64_t size = 0;   // of all, in bytes
  std::uint64_t scene = 0;  // see sceneMark()
  std::int64_t step = 0;
  double wallSeconds = 0.0;
  Refinement refinement;

  /// To be raised whenever a save() of the engine changes, or a result.
  static constexpr std::uint64_t currentVersion = 4;
};

std::uint64_t checksum(std::span<const std::byte> bytes) {
  StateHash hash;
  hash.add(bytes);
  return hash.value();
}

/// The same for scenes that differ in their duration, refinement and pictures alone.
std::uint64_t sceneMark(const Scene& scene) {
  Scene asked = unrefined(scene);
  asked.time.duration = 0.0;
  asked.pictures.reset();
  const std::string text = writeScene(asked);
  return checksum(std::as_bytes(std::span(text)));
}

/// The header of a whole checkpoint, or what is wrong with it.
Result<Header> readHeader(std::span<const std::byte> bytes) {
  const auto refuse = [](std::string why) {
    return Diagnostic{{}, "the checkpoint " + std::move(why), Trouble::file};
  };
  Header header;
  if (bytes.size() < sizeof header) return refuse("is cut off");
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.magic != Header{}.magic) return refuse("is none: it does not begin like one");
  if (header.version != Header::currentVersion)
    return refuse(fmt::format("is of version {}, this bedmix reads {}; go on with the program that wrote it",
                              header.version, Header::currentVersion));
  std::uint64_t sum = 0;
  if (header.size < sizeof header + sizeof sum || header.size > bytes.size()) return refuse("is cut off");
  const std::span whole = bytes.first(header.size);
  std::memcpy(&sum, whole.last(sizeof sum).data(), sizeof sum);
  if (sum != checksum(whole.first(whole.size() - sizeof sum)))
    return refuse("is damaged: its checksum is another");
  const auto& [particles, gas] = header.refinement;
  if (gas < 0 || gas > particles || particles > mostHalvings)
    return refuse("is of steps that no run takes; it was not written by bedmix");
  return header;
}

}  // namespace

std::vector<std::byte> writeCheckpoint(const Simulation& simulation, const Scene& scene, double wallSeconds) {
  constexpr std::size_t perParticle = 512;
  StateWriter out(perParticle * static_cast<std::size_t>(scene.particles.count));
  out.put(Header{.scene = sceneMark(scene),
                 .step = simulation.step(),
                 .wallSeconds = wallSeconds,
                 .refinement = scene.refinement});
  simulation.save(out);
  std::vector<std::byte> bytes = out.take();
  const std::uint64_t size = bytes.size() + sizeof(std::uint64_t);
  std::memcpy(bytes.data() + offsetof(Header, size), &size, sizeof size);
  const std::uint64_t sum = checksum(bytes);
  const auto* const end = reinterpret_cast<const std::byte*>(&sum);
  bytes.insert(bytes.end(), end, end + sizeof sum);
  return bytes;
}

std::optional<CheckpointMark> checkpointMark(std::span<const std::byte> bytes) {
  const Result<Header> header = readHeader(bytes);
  if (!header) return std::nullopt;
  return CheckpointMark{header->step, header->refinement};
}

Result<Resumed> readCheckpoint(std::span<const std::byte> bytes, const Scene& scene, int threads) {
  const Result<Header> header = readHeader(bytes);
  if (!header) return header.problems;
  if (header->scene != sceneMark(scene))
    return Diagnostic{{}, "the checkpoint is of another scene", Trouble::file};
  const Refinement was = header->refinement, is = scene.refinement;
  if (was.particles > is.particles || was.gas > is.gas)
    return Diagnostic{{}, "the checkpoint was taken with shorter steps", Trouble::file};
  const std::int64_t perStep = stepsPerStep(scene, refined(unrefined(scene), was));
  const std::size_t state = header->size - sizeof(Header) - sizeof(std::uint64_t);
  StateReader in(bytes.subspan(sizeof(Header), state));
  std::optional<Simulation> simulation = Simulation::make(scene, in, threads, perStep);
  if (!simulation || !in.done() || simulation->step() / perStep != header->step)
    return Diagnostic{
        {}, "the checkpoint does not fit its scene; it was not written by bedmix", Trouble::file};
  return Resumed{std::move(*simulation), header->wallSeconds};
}

}  // namespace bedmix
