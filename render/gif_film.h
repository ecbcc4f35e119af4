// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture_writer.h"

#include <filesystem>
#include <memory>

namespace bedmix {

/// A GIF that begins anew when it ends, in colours that GifPalette finds. The same pictures give the same
/// bytes.
class GifFilm final : public PictureWriter {
 public:
  /// Shows each picture for `delay`, 1/100 s. Fails as `unavailable` where libav has no GIF, as `file` where
  /// `path` cannot be written.
  static Result<GifFilm> create(const std::filesystem::path& path, Size size, int delay);
  ~GifFilm() override;
  GifFilm(GifFilm&&) noexcept;
  GifFilm& operator=(GifFilm&&) noexcept;

  Result<Done> add(const Image& picture) override;
  Result<Done> finish() override;

 private:
  struct State;
  explicit GifFilm(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
