// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/image.h"

#include <filesystem>
#include <memory>
#include <string>

namespace bedmix {

/// An H.264 film in an MP4 file: yuv420p tagged and converted as BT.709 limited range, constant frame rate.
/// Odd sizes gain a row or column by repeating the last. Frames go to `path`.part in fragments, so that a
/// killed program leaves a film up to the last closed fragment (a second or so); finish() rewrites it with
/// the index in front and gives it its name. The same pictures give the same bytes.
class Movie {
 public:
  /// Fails as `unavailable` without an H.264 encoder, as `file` where `path` cannot be written.
  static Result<Movie> create(const std::filesystem::path& path, Size size, double fps);
  ~Movie();  // without finish(): removes `path`.part
  Movie(Movie&&) noexcept;
  Movie& operator=(Movie&&) noexcept;

  /// All frames have the film's size. After a failure only the destructor may follow.
  Result<Done> add(const Image& frame);
  Result<Done> finish();

 private:
  struct State;
  explicit Movie(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Which encoder films are made with ("libx264, libavcodec 59.37.100"), or why there is none.
Result<std::string> probeEncoder();

}  // namespace bedmix
