// SPDX-License-Identifier: MIT
#include "app/run_folder.h"

#include <fmt/core.h>

#include <system_error>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

Diagnostic trouble(const fs::path& path, const std::string& message) {
  return {{path.string()}, message, Trouble::file};
}

Result<RunFolder> makeAndClaim(const fs::path& path) {
  if (Result<Done> made = makeFolder(path); !made) return made.problems;
  Result<FolderClaim> claim = claimFolder(path);
  if (!claim) return claim.problems;
  return RunFolder{path, *claim};
}

}  // namespace

Result<RunFolder> claimRunFolder(const fs::path& path) {
  std::error_code none;
  if (!fs::exists(RunFolder{path}.trajectory(), none))
    return trouble(path, "holds no run to go on with; leave out --resume to begin one");
  return makeAndClaim(path);
}

Result<RunFolder> makeRunFolder(const fs::path& path, bool force) {
  Result<RunFolder> folder = makeAndClaim(path);
  if (!folder) return folder;
  std::error_code error;
  if (fs::is_empty(path, error)) return folder;
  if (!force)
    return Diagnostic{
        {path.string()},
        "this folder is not empty; give another with -o, --resume to go on with the run in it, or "
        "--force to replace that (other files in it are kept)"};
  const RunFolder old{path};
  for (const fs::path& file :
       {old.trajectory(), old.mixing(), old.flux(), old.pressure(), old.summary(), old.video()}) {
    fs::remove(file, error);
    if (error) return trouble(file, fmt::format("cannot be removed: {}", error.message()));
  }
  return folder;
}

Result<RunFolder> makeReplayFolder(const fs::path& path) {
  std::error_code none;
  if (fs::exists(RunFolder{path}.trajectory(), none))
    return Diagnostic{{path.string()},
                      "this folder holds a run, whose own series would be overwritten; give another "
                      "with -o"};
  if (Result<Done> made = makeFolder(path); !made) return made.problems;
  return RunFolder{path};
}

fs::path runFolderOf(const fs::path& run) {
  std::error_code none;
  if (fs::is_directory(run, none)) return run;
  return run.has_parent_path() ? run.parent_path() : fs::path(".");
}

}  // namespace bedmix
