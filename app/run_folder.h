// SPDX-License-Identifier: MIT
#pragma once

#include "app/folder_claim.h"
#include "engine/core/diagnostic.h"

#include <filesystem>

namespace bedmix {

/// The files of a run, by their fixed names.
struct RunFolder {
  std::filesystem::path path;
  FolderClaim claim = nullptr;  // of whoever writes a run into it; null for others

  std::filesystem::path trajectory() const { return path / "trajectory.h5"; }
  std::filesystem::path mixing() const { return path / "mixing.csv"; }
  std::filesystem::path flux() const { return path / "flux.csv"; }
  std::filesystem::path pressure() const { return path / "pressure.csv"; }
  std::filesystem::path heat() const { return path / "heat.csv"; }
  std::filesystem::path reaction() const { return path / "reaction.csv"; }
  std::filesystem::path feed() const { return path / "feed.csv"; }
  std::filesystem::path summary() const { return path / "summary.json"; }
  std::filesystem::path video() const { return path / "video.mp4"; }
};

/// Makes a folder to write into; one that is there is taken with what it holds.
Result<RunFolder> makeFolder(const std::filesystem::path& path);

/// Makes the folder of a new run. One that holds anything is refused, unless `force`: then the files of an
/// earlier run are removed from it and all others are left alone. Fails, too, where another program writes a
/// run into it.
Result<RunFolder> makeRunFolder(const std::filesystem::path& path, bool force);

/// The folder of a run that is to be gone on with. Fails where there is none, and likewise.
Result<RunFolder> claimRunFolder(const std::filesystem::path& path);

/// Makes a folder for what is derived from a run. One that holds a trajectory is refused: its series belong
/// to that run.
Result<RunFolder> makeReplayFolder(const std::filesystem::path& path);

/// The folder a run is in, given that folder or its trajectory.
std::filesystem::path runFolderOf(const std::filesystem::path& run);

/// The folder that what is derived from another program's file goes to: FILE-replay, beside it; "all"
/// stands for a * in the name of several.
std::filesystem::path foreignFolderOf(const std::filesystem::path& file);

}  // namespace bedmix
