// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/sample.h"
#include "engine/core/diagnostic.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace bedmix {

/// accuracy.csv: one row a finished sample, written at once, so that a study that was ended goes on from
/// there. Columns: version, scene (hash of its settings), panel, setting, reference, sample, failure, and all
/// measures. Texts with commas or quotes stand in quotes, as in RFC 4180.
class SampleLog {
 public:
  /// Opens the file; with `resume` it keeps its samples of this version and scene (a last line without its
  /// end, as a killed study leaves it, is not one), else it begins anew. All fail as Trouble::file.
  static Result<SampleLog> open(const std::filesystem::path& path, std::string version, std::string scene,
                                bool resume);

  /// Those there are, in the order in which they came.
  const std::vector<Sample>& samples() const { return samples_; }
  std::optional<Diagnostic> add(Sample sample);

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  SampleLog() = default;
  std::optional<Diagnostic> write(const std::string& text);

  std::filesystem::path path_;
  std::string version_, scene_;
  std::unique_ptr<std::FILE, Closer> file_;
  std::vector<Sample> samples_;
};

}  // namespace bedmix
