// SPDX-License-Identifier: MIT
#include "replay/recover.h"

#include "replay/file_trouble.h"
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"

#include <fmt/format.h>

#include <system_error>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

using Checkpoints = std::vector<std::vector<std::byte>>;

Checkpoints usableCheckpoints(TrajectoryReader& reader, const CheckpointTest& isUsable, std::size_t frames) {
  Checkpoints found = reader.checkpoints();
  std::erase_if(found, [&](const auto& bytes) { return !isUsable(bytes, reader.scene(), frames); });
  return found;
}

/// What a whole file holds, or what is wrong with one that is not.
Recovery examine(const fs::path& file, const CheckpointTest& isUsable) {
  auto reader = TrajectoryReader::open(file);
  if (!reader) return {0, 0, 0.0, 0, reader.problems.front()};
  while (reader->next()) continue;
  const std::size_t frames = reader->times().size();
  return {frames, frames, reader->times().back(), usableCheckpoints(*reader, isUsable, frames).size(),
          reader->failure()};
}

/// Writes into `path`, whole or not.
Result<Recovery> save(TrajectoryReader& remains, const fs::path& path, const CheckpointTest& isUsable,
                      const Provenance& by) {
  Recovery recovery;
  recovery.recorded = remains.recorded();
  FramePtr frame = remains.next();
  if (!frame) return *remains.failure();
  auto writer = TrajectoryWriter::create(path, remains.scene(), remains.provenance());
  if (!writer) return std::move(writer.problems);
  for (; frame && !writer->failure(); frame = remains.next()) {
    writer->accept(*frame);
    recovery.until = frame->time;
    ++recovery.frames;
  }
  for (const auto& checkpoint : usableCheckpoints(remains, isUsable, recovery.frames)) {
    writer->keep(checkpoint);
    ++recovery.checkpoints;
  }
  for (const RunEvent& event : remains.events()) writer->note(event);
  writer->note({recovery.until, "recover",
                fmt::format("the first {} of {} recorded frames, by bedmix {} ({})", recovery.frames,
                            recovery.recorded, by.version, by.commit)});
  if (writer->failure()) return *writer->failure();
  return recovery;
}

}  // namespace

Result<Recovery> recover(const fs::path& file, const fs::path& into, const CheckpointTest& isUsable,
                         const Provenance& by) {
  std::error_code error;
  if (fs::symlink_status(into, error).type() != fs::file_type::not_found)
    return fileTrouble(into, "is there already; remove it, or give another name with -o");
  Recovery found = examine(file, isUsable);
  if (!found.damage) return found;

  auto remains = TrajectoryReader::openRemains(file);
  if (!remains) return std::move(remains.problems);
  const fs::path partial = into.string() + ".part";
  Result<Recovery> saved = save(*remains, partial, isUsable, by);
  if (saved) {
    saved->damage = found.damage;
    fs::rename(partial, into, error);
    if (error) saved = fileTrouble(into, "cannot be made: " + error.message());
  }
  if (!saved) fs::remove(partial, error);
  return saved;
}

}  // namespace bedmix
