// SPDX-License-Identifier: MIT
#include "replay/trajectory_reader.h"

#include "engine/core/scene_reader.h"
#include "replay/contained_hdf5.h"
#include "replay/file_trouble.h"
#include "replay/reader_process.h"
#include "replay/trajectory_layout.h"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>

namespace bedmix {

struct TrajectoryReader::State {
  std::filesystem::path path;
  Reading reading;
  ReaderProcess process;
  RunPreamble run;

  /// What the process answers. When it has ended, that may be due to what it read ahead: then a new one is
  /// asked. Throws ChannelClosed where that ends too.
  template <class Ask>
  auto answer(Ask&& ask) -> decltype(ask(process)) {
    try {
      return ask(process);
    } catch (const ChannelClosed&) {
      restart();
      return ask(process);
    }
  }

  void restart() {
    process = ReaderProcess(path, reading);
    const Result<RunPreamble> again = process.open();
    if (!again) throw std::runtime_error(again.problems.front().message);
    if (writeScene(again->scene) != writeScene(run.scene) ||
        again->constants.steps.size() < run.constants.steps.size())
      throw std::runtime_error("has become another file while it was read; open it once more");
  }
};

Result<TrajectoryReader> TrajectoryReader::open(const std::filesystem::path& path) {
  return open(path, Reading::whole);
}

Result<TrajectoryReader> TrajectoryReader::openRemains(const std::filesystem::path& path) {
  return open(path, Reading::remains);
}

Result<TrajectoryReader> TrajectoryReader::open(const std::filesystem::path& path, Reading reading) {
  std::error_code error;
  const bool isFolder = std::filesystem::is_directory(path, error);
  const std::filesystem::path file = isFolder ? path / layout::fileName : path;
  if (!std::filesystem::exists(file, error))
    return fileTrouble(file, "does not exist; name a trajectory.h5 or the folder of a run");
  try {
    ReaderProcess process(file, reading);
    try {
      Result<RunPreamble> run = process.open();
      if (!run) return std::move(run.problems);
      return TrajectoryReader(std::make_unique<State>(file, reading, std::move(process), std::move(*run)));
    } catch (const ChannelClosed&) {
      return fileTrouble(file, damageShownBy(process.end()));
    }
  } catch (const std::system_error& e) {
    return fileTrouble(file, e.what());
  }
}

TrajectoryReader::TrajectoryReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
TrajectoryReader::~TrajectoryReader() = default;
TrajectoryReader::TrajectoryReader(TrajectoryReader&&) noexcept = default;
TrajectoryReader& TrajectoryReader::operator=(TrajectoryReader&&) noexcept = default;

const Scene& TrajectoryReader::scene() const { return state_->run.scene; }
const Provenance& TrajectoryReader::provenance() const { return state_->run.constants.provenance; }
const std::vector<RunEvent>& TrajectoryReader::events() const { return state_->run.constants.events; }
const std::vector<double>& TrajectoryReader::times() const { return state_->run.constants.times; }
std::size_t TrajectoryReader::recorded() const { return state_->run.constants.recorded; }

Result<FramePtr> TrajectoryReader::frame(std::size_t index) {
  State& s = *state_;
  try {
    return s.answer([&](ReaderProcess& process) { return process.frame(s.run, index); });
  } catch (const ChannelClosed&) {
    return fileTrouble(s.path,
                       fmt::format("frame {} is damaged: the HDF5 library fails on it ({}); what comes "
                                   "before it can be used",
                                   index, s.process.end()));
  } catch (const std::runtime_error& e) {
    return fileTrouble(s.path, e.what());
  }
}

std::vector<std::vector<std::byte>> TrajectoryReader::checkpoints() {
  std::vector<std::vector<std::byte>> found(layout::checkpointSlots.size());
  for (std::size_t slot = 0; slot < found.size(); ++slot) {
    try {
      found[slot] = state_->answer([&](ReaderProcess& process) { return process.checkpoint(slot); });
    } catch (const std::runtime_error&) {  // none
    }
  }
  return found;
}

}  // namespace bedmix
