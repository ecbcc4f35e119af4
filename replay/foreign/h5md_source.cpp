// SPDX-License-Identifier: MIT
#include "replay/foreign/h5md_source.h"

#include "replay/child_process.h"
#include "replay/contained_hdf5.h"
#include "replay/file_trouble.h"
#include "replay/foreign/h5md_input.h"
#include "replay/read_ahead.h"
#include "replay/shared_memory.h"

#include <fmt/format.h>

#include <cmath>
#include <system_error>

namespace bedmix {

namespace {

// A first process says what the file holds: trouble or, where that text is empty, the contents. So the memory
// that a second one reads frames into is no larger than two of them.

void describe(Channel& parent, const std::filesystem::path& file, const std::string& group) {
  allowWorkOn(file);
  H5mdContents found;
  const std::string trouble = troubleOf([&] { found = H5mdInput(file, group).contents(); });
  parent.putAll(trouble);
  if (!trouble.empty()) return;
  parent.put(found.row);
  parent.putAll(found.steps);
  parent.putAll(found.times);
  parent.put(found.box.has_value());
  parent.put(found.box.value_or(ForeignBox{}));
}

Result<H5mdContents> described(Channel& child, const std::filesystem::path& file) {
  std::string trouble = child.getAll<std::string>();
  if (!trouble.empty()) return fileTrouble(file, std::move(trouble));
  H5mdContents contents;
  contents.row = child.get<H5mdRow>();
  contents.steps = child.getAll<std::vector<std::int64_t>>();
  contents.times = child.getAll<std::vector<double>>();
  const bool hasBox = child.get<bool>();
  const auto box = child.get<ForeignBox>();
  if (hasBox) contents.box = box;
  return contents;
}

void serve(Channel& parent, const std::filesystem::path& file, const std::string& group,
           const H5mdContents& expected, const SharedMemory& memory) {
  allowWorkOn(file);
  std::optional<H5mdInput> in;
  const std::size_t bytes = expected.row.bytes();
  const std::string trouble = troubleOf([&] {
    in.emplace(file, group);
    if (in->contents().row != expected.row || in->contents().steps.size() < expected.steps.size())
      throw Hdf5Error("has become another file while it was read; open it once more");
    for (const std::size_t half : {0, 1}) in->readFixed(memory.data() + half * bytes);
  });
  for (;;) {
    const auto request = parent.get<FrameRequest>();
    allowWorkOn(file);
    parent.putAll(trouble.empty()
                      ? troubleOf([&] { in->readFrame(request.index, memory.data() + request.half * bytes); })
                      : trouble);
  }
}

Vec3d vectorAt(const double* numbers, std::size_t row, int components) {
  Vec3d v{};
  for (int k = 0; k < components; ++k)
    v[static_cast<std::size_t>(k)] =
        numbers[row * static_cast<std::size_t>(components) + static_cast<std::size_t>(k)];
  return v;
}

bool isFinite(const Vec3d& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

/// The particles that are there, out of all rows. Throws where one has what is no number.
ForeignFrame particlesIn(const std::byte* memory, const H5mdRow& row, std::size_t index) {
  const auto* const position = reinterpret_cast<const double*>(memory);
  const std::size_t n = row.particles;
  const double* const velocity = position + n * static_cast<std::size_t>(row.dimensions);
  const double* const spin = velocity + (row.hasVelocity ? n * static_cast<std::size_t>(row.dimensions) : 0);
  const double* const radius = spin + n * static_cast<std::size_t>(row.spinComponents);
  const auto* const integers = reinterpret_cast<const std::int64_t*>(position + row.doubles());
  const std::int64_t* const ids = integers + (row.hasSpecies ? n : 0);

  ForeignFrame frame;
  frame.position.reserve(n);
  frame.id.reserve(n);
  const auto require = [&](bool holds, std::size_t i, const char* what) {
    if (!holds)
      throw Hdf5Error(
          fmt::format("frame {}: the {} of particle {} is no number; what comes before it can be used", index,
                      what, ids[i]));
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (ids[i] < 0) continue;
    frame.id.push_back(ids[i]);
    frame.position.push_back(vectorAt(position, i, row.dimensions));
    require(isFinite(frame.position.back()), i, "position");
    if (row.hasVelocity) {
      frame.velocity.push_back(vectorAt(velocity, i, row.dimensions));
      require(isFinite(frame.velocity.back()), i, "velocity");
    }
    if (row.spinComponents > 0) {
      Vec3d w = vectorAt(spin, i, row.spinComponents);
      if (row.spinComponents == 1) w = {0.0, 0.0, w[0]};
      frame.angularVelocity.push_back(w);
      require(isFinite(w), i, "angular velocity");
    }
    if (row.hasRadius) {
      frame.radius.push_back(radius[i]);
      require(std::isfinite(radius[i]), i, "radius");
    }
    if (row.hasSpecies) frame.species.push_back(integers[i]);
  }
  return frame;
}

}  // namespace

struct H5mdSource::State {
  State(std::filesystem::path path, std::string name, H5mdContents found)
      : file(std::move(path)),
        group(std::move(name)),
        contents(std::move(found)),
        memory(1 + room()),
        child(start()) {}

  std::size_t room() const { return 2 * contents.row.bytes(); }
  ChildProcess start() {
    memory.open(room());
    ahead = {};
    return ChildProcess([this](Channel& parent) { serve(parent, file, group, contents, memory); });
  }
  ReadAhead::Read read(std::size_t index) {
    Channel& channel = child.channel();
    return ahead.frame(channel, index, contents.steps.size(), [&](FrameRequest r) { channel.put(r); });
  }

  std::filesystem::path file;
  std::string group;
  H5mdContents contents;
  SharedMemory memory;
  ReadAhead ahead;
  ChildProcess child;
};

Result<std::unique_ptr<ForeignSource>> H5mdSource::open(const std::filesystem::path& path,
                                                        const std::string& group) {
  try {
    ChildProcess child([&](Channel& parent) { describe(parent, path, group); });
    try {
      Result<H5mdContents> contents = described(child.channel(), path);
      if (!contents) return std::move(contents.problems);
      return std::unique_ptr<ForeignSource>(
          new H5mdSource(std::make_unique<State>(path, group, std::move(*contents))));
    } catch (const ChannelClosed&) {
      return fileTrouble(path, damageShownBy(child.end()));
    }
  } catch (const std::system_error& e) {
    return fileTrouble(path, e.what());
  }
}

H5mdSource::H5mdSource(std::unique_ptr<State> state) : state_(std::move(state)) {}
H5mdSource::~H5mdSource() = default;

int H5mdSource::dimensions() const { return state_->contents.row.dimensions; }
const std::vector<std::int64_t>& H5mdSource::steps() const { return state_->contents.steps; }
const std::vector<double>& H5mdSource::times() const { return state_->contents.times; }
std::optional<ForeignBox> H5mdSource::box() const { return state_->contents.box; }

Result<ForeignFrame> H5mdSource::frame(std::size_t index) {
  State& s = *state_;
  try {
    ReadAhead::Read read;
    try {
      read = s.read(index);
    } catch (const ChannelClosed&) {  // perhaps for what it read ahead
      s.child = s.start();
      read = s.read(index);
    }
    if (!read.trouble.empty()) return fileTrouble(s.file, std::move(read.trouble));
    return particlesIn(s.memory.data() + read.half * s.contents.row.bytes(), s.contents.row, index);
  } catch (const ChannelClosed&) {
    return fileTrouble(s.file,
                       fmt::format("frame {} is damaged: the HDF5 library fails on it ({}); what comes "
                                   "before it can be used",
                                   index, s.child.end()));
  } catch (const std::runtime_error& e) {
    return fileTrouble(s.file, e.what());
  }
}

}  // namespace bedmix
