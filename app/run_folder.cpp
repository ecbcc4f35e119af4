// SPDX-License-Identifier: MIT
#include "app/run_folder.h"

#include <fmt/core.h>

#include <system_error>
#include <unistd.h>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

Diagnostic trouble(const fs::path& path, const std::string& message) {
  return {{path.string()}, message, Trouble::file};
}

Result<RunFolder> claimed(Result<RunFolder> folder) {
  if (!folder) return folder;
  Result<FolderClaim> claim = claimFolder(folder->path);
  if (!claim) return claim.problems;
  folder->claim = std::move(*claim);
  return folder;
}

}  // namespace

Result<RunFolder> makeFolder(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    return trouble(path, "is a file; give a folder with -o");
  fs::create_directories(path, error);
  if (error) return trouble(path, fmt::format("cannot make this folder: {}", error.message()));
  if (access(path.c_str(), W_OK | X_OK) != 0)
    return trouble(path, "cannot write into this folder; change its permissions or give another with -o");
  return RunFolder{path};
}

Result<RunFolder> claimRunFolder(const fs::path& path) {
  std::error_code none;
  if (!fs::exists(RunFolder{path}.trajectory(), none))
    return trouble(path, "holds no run to go on with; leave out --resume to begin one");
  return claimed(makeFolder(path));
}

Result<RunFolder> makeRunFolder(const fs::path& path, bool force) {
  Result<RunFolder> folder = claimed(makeFolder(path));
  if (!folder) return folder;
  std::error_code error;
  if (fs::is_empty(path, error)) return folder;
  if (!force)
    return Diagnostic{
        {path.string()},
        "this folder is not empty; give another with -o, --resume to go on with the run in it, or "
        "--force to replace that (other files in it are kept)"};
  const RunFolder old{path};
  for (const fs::path& file : {old.trajectory(), old.mixing(), old.flux(), old.pressure(), old.heat(),
                               old.reaction(), old.feed(), old.summary(), old.video()}) {
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
  return makeFolder(path);
}

fs::path runFolderOf(const fs::path& run) {
  std::error_code none;
  if (fs::is_directory(run, none)) return run;
  return run.has_parent_path() ? run.parent_path() : fs::path(".");
}

fs::path foreignFolderOf(const fs::path& file) {
  std::string name = (file.has_filename() ? file : file.parent_path()).string();
  for (auto at = name.find('*'); at != std::string::npos; at = name.find('*')) name.replace(at, 1, "all");
  return name + "-replay";
}

}  // namespace bedmix
