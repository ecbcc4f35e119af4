// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture_writer.h"

#include <filesystem>
#include <memory>

namespace bedmix {

/// A lossless film: FFV1 in a Matroska file, RGB tagged as sRGB, of any size. Decoded, each picture is to the
/// bit what was added. A killed program leaves `path`.part with all but the last second or so. The same
/// pictures give the same bytes.
class MkvFilm final : public PictureWriter {
 public:
  /// Fails as `unavailable` without an FFV1 encoder, as `file` where `path` cannot be written.
  static Result<MkvFilm> create(const std::filesystem::path& path, Size size, double fps);
  ~MkvFilm() override;
  MkvFilm(MkvFilm&&) noexcept;
  MkvFilm& operator=(MkvFilm&&) noexcept;

  Result<Done> add(const Image& picture) override;
  Result<Done> finish() override;

 private:
  struct State;
  explicit MkvFilm(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
