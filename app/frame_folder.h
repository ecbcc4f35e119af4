// SPDX-License-Identifier: MIT
#pragma once

#include "app/folder_claim.h"
#include "engine/core/diagnostic.h"
#include "render/image.h"
#include "render/png.h"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace bedmix {

/// A folder of PNGs frame_000000.png, frame_000001.png, ..., which a rendering that was ended goes on with.
/// A PNG has its name only when it is complete, so all that are there are kept, if they are of the same
/// rendering: each must be of its size and say that it comes from the same scene, program and frame, and
/// those beside a gap must be, pixel by pixel, what would be drawn in their place. Anything else is an error;
/// nothing that is there is overwritten.
class FrameFolder {
 public:
  /// Makes the folder where there is none; for `pictures` of them. Removes all frames in it with `force`.
  /// Fails where another program writes into it.
  static Result<FrameFolder> open(const std::filesystem::path& path, std::size_t pictures, bool force);

  std::filesystem::path file(std::size_t number) const;
  /// Whether the picture is there, complete.
  Result<bool> holds(std::size_t number, Size size, const PngText& text) const;
  /// Whether the picture is the first or the last, or lacks a neighbour.
  bool besideGap(std::size_t number) const;
  /// That the picture there shows `image`.
  Result<Done> expect(std::size_t number, const Image& image) const;

 private:
  FrameFolder(std::filesystem::path path, FolderClaim claim, std::size_t pictures)
      : path_(std::move(path)), claim_(std::move(claim)), named_(pictures) {}
  Result<Done> look(bool force);
  Diagnostic foreign(std::size_t number, const std::string& why) const;

  std::filesystem::path path_;
  FolderClaim claim_;
  std::vector<bool> named_;  // pictures by whose name there is something
};

}  // namespace bedmix
