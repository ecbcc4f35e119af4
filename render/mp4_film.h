// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture_writer.h"

#include <filesystem>
#include <memory>
#include <string>

namespace bedmix {

/// An H.264 film in an MP4 file: yuv420p tagged and converted as BT.709 limited range, constant frame rate,
/// what every player has. Odd sizes gain a row or column by repeating the last. Pictures go to `path`.part in
/// fragments, so that a killed program leaves a film up to the last closed fragment (a second or so);
/// finish() rewrites it with the index in front and gives it its name. The same pictures give the same bytes.
class Mp4Film final : public PictureWriter {
 public:
  /// Fails as `unavailable` without an H.264 encoder, as `file` where `path` cannot be written.
  static Result<Mp4Film> create(const std::filesystem::path& path, Size size, double fps);
  ~Mp4Film() override;
  Mp4Film(Mp4Film&&) noexcept;
  Mp4Film& operator=(Mp4Film&&) noexcept;

  Result<Done> add(const Image& picture) override;
  Result<Done> finish() override;

 private:
  struct State;
  explicit Mp4Film(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Of a film of such pictures: both numbers even.
Size evenSize(Size picture);

/// Which encoder films are made with ("libx264, libavcodec 59.37.100"), or why there is none.
Result<std::string> probeEncoder();

}  // namespace bedmix
