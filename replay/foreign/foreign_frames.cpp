// SPDX-License-Identifier: MIT
#include "replay/foreign/foreign_frames.h"

#include "replay/file_trouble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bedmix {

namespace {

Result<std::vector<double>> timesOf(const ForeignSource& source, const std::string& file,
                                    std::optional<double> timeStep) {
  std::vector<double> times = source.times();
  if (timeStep) {
    times.clear();
    for (const std::int64_t step : source.steps()) times.push_back(*timeStep * static_cast<double>(step));
  }
  if (times.empty())
    return fileTrouble(file,
                       "numbers its steps but does not tell their times; give --time-step DT, the length of "
                       "a step in seconds");
  for (std::size_t i = 0; i < times.size(); ++i)
    if (!std::isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1])))
      return fileTrouble(file,
                         fmt::format("frame {} at {} s does not follow the one before it", i, times[i]));
  return times;
}

/// Rows by id; empty where they are in order.
std::vector<std::size_t> orderOf(const std::vector<std::int64_t>& ids) {
  if (std::is_sorted(ids.begin(), ids.end())) return {};
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  return order;
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::size_t>& order) {
  if (values.empty() || order.empty()) return;
  std::vector<T> ordered;
  ordered.reserve(values.size());
  for (const std::size_t row : order) ordered.push_back(values[row]);
  values = std::move(ordered);
}

/// Puts rows in order of id.
void sortRows(ForeignFrame& frame) {
  if (frame.id.empty()) {
    frame.id.resize(frame.position.size());
    std::iota(frame.id.begin(), frame.id.end(), 0);
    return;
  }
  const std::vector<std::size_t> order = orderOf(frame.id);
  permute(frame.position, order);
  permute(frame.velocity, order);
  permute(frame.angularVelocity, order);
  permute(frame.species, order);
  permute(frame.id, order);
}

/// Why the ids, which are in order, cannot be a frame's.
std::optional<std::string> badId(const std::vector<std::int64_t>& ids) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (!ids.empty() && (ids.front() < 0 || ids.back() > most))
    return fmt::format("there is a particle {}; ids are from 0 to {}",
                       ids.front() < 0 ? ids.front() : ids.back(), most);
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) return fmt::format("particle {} is there twice", *twice);
  return std::nullopt;
}

bool isFinite(Vec2f v) { return std::isfinite(v.x) && std::isfinite(v.y); }

/// All but the species. Throws nothing; `bad` says what cannot be told in a frame.
Frame inPlane(const ForeignFrame& from, const ForeignScene& scene, std::optional<std::string>& bad) {
  const std::size_t n = from.position.size();
  Frame frame;
  frame.id.assign(from.id.begin(), from.id.end());
  frame.position.reserve(n);
  frame.velocity.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    frame.position.push_back(toFloat(scene.view(from.position[i]) - scene.corner));
    if (!from.velocity.empty()) frame.velocity[i] = toFloat(scene.view(from.velocity[i]));
    if (!from.angularVelocity.empty())
      frame.angularVelocity.push_back(static_cast<float>(scene.view.spin(from.angularVelocity[i])));
    if (!isFinite(frame.position[i]) || !isFinite(frame.velocity[i]) ||
        (!frame.angularVelocity.empty() && !std::isfinite(frame.angularVelocity[i])))
      bad = fmt::format("particle {} is too far away or too fast for single precision", frame.id[i]);
  }
  return frame;
}

}  // namespace

ForeignFrames::ForeignFrames(std::unique_ptr<ForeignSource> source, std::string file,
                             std::vector<double> times, ForeignScene made, ForeignTracer tracer)
    : source_(std::move(source)),
      file_(std::move(file)),
      times_(std::move(times)),
      made_(std::move(made)),
      tracer_(std::move(tracer)) {}

Result<ForeignFrames> ForeignFrames::make(std::unique_ptr<ForeignSource> source,
                                          const std::filesystem::path& path, const ForeignOptions& options) {
  const std::string file = path.string();
  Result<std::vector<double>> times = timesOf(*source, file, options.timeStep);
  if (!times) return std::move(times.problems);
  Result<ForeignFrame> first = source->frame(0);
  if (!first) return std::move(first.problems);
  sortRows(*first);
  std::optional<std::string> bad = badId(first->id);
  if (bad) return fileTrouble(file, fmt::format("frame 0: {}", *bad));
  Result<ForeignScene> scene = foreignScene(*source, *first, *times, file, options);
  if (!scene) return std::move(scene.problems);
  const Frame frame = inPlane(*first, *scene, bad);
  if (bad) return fileTrouble(file, fmt::format("frame 0: {}", *bad));
  Result<ForeignTracer> tracer =
      ForeignTracer::of(frame, first->species, scene->scene, options.tracerSpecies);
  if (!tracer) {
    for (Diagnostic& problem : tracer.problems) problem.at.file = file;
    return std::move(tracer.problems);
  }
  return ForeignFrames(std::move(source), file, std::move(*times), std::move(*scene), std::move(*tracer));
}

Result<FramePtr> ForeignFrames::frame(std::size_t index) {
  Result<ForeignFrame> read = source_->frame(index);
  if (!read) return std::move(read.problems);
  sortRows(*read);
  std::optional<std::string> bad = badId(read->id);
  auto frame = std::make_shared<Frame>();
  if (!bad) *frame = inPlane(*read, made_, bad);
  if (!bad) bad = tracer_.apply(*frame, read->species);
  if (!bad && made_.scene.contacts.friction && frame->angularVelocity.size() != frame->size())
    bad = "has no angular velocities, other than the first frame";
  if (bad)
    return fileTrouble(file_, fmt::format("frame {}: {}; what comes before it can be used", index, *bad));
  if (!made_.scene.contacts.friction) frame->angularVelocity.clear();
  frame->step = source_->steps()[index];
  frame->time = times_[index];
  return FramePtr(std::move(frame));
}

}  // namespace bedmix
