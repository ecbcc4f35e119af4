// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/client_message.h"
#include "app/view/stream_message.h"
#include "app/view/view_host.h"
#include "engine/core/diagnostic.h"
#include "render/h264_stream.h"
#include "render/jpeg.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace bedmix {

/// A picture that is the same for all clients, and what has been made of it.
struct StreamPicture {
  Image image;
  std::uint64_t version = 0;         // 0: none yet
  std::uint32_t input = 0;           // the last whose effect it shows
  SharedBytes quickJpeg, sharpJpeg;  // null until somebody needs it
};

/// A client as the stream sees it.
class StreamClient {
 public:
  explicit StreamClient(Role role) : role_(role) {}

  Role role() const { return role_; }
  void setRole(Role role) { role_ = role; }
  /// It can show pictures from now on; from the next one on in this way.
  void greet(PictureCodec codec);
  void acknowledge(std::uint32_t picture);

  /// Whether a picture may be sent to it.
  bool isReady() const { return codec_ && onTheirWay_.size() < mostOnTheirWay; }
  bool wants(const StreamPicture& picture) const { return isReady() && picture.version > version_; }
  /// Whether it has all but the sharp one.
  bool wantsSharp(const StreamPicture& picture) const {
    return codec_ && onTheirWay_.empty() && picture.version == version_ && version_ > 0 && !isSharp_;
  }
  /// The picture as it is to be sent.
  Result<SharedBytes> encode(StreamPicture& picture, bool sharp, JpegEncoder& jpeg);

  static constexpr std::size_t mostOnTheirWay = 2;

 private:
  Result<SharedBytes> encodeJpeg(StreamPicture& picture, bool sharp, JpegEncoder& jpeg);
  Result<SharedBytes> encodeH264(const StreamPicture& picture);
  StreamHeader header(const StreamPicture& picture, StreamKind kind, bool sharp);

  Role role_;
  std::optional<PictureCodec> codec_;
  std::optional<H264Stream> video_;
  Size videoSize_;
  std::deque<std::uint32_t> onTheirWay_;  // numbers
  std::uint32_t pictures_ = 0;
  std::uint64_t version_ = 0;  // of the last one sent
  bool isSharp_ = false;
};

/// At most so many pictures a second are drawn by themselves; input is answered sooner.
inline constexpr double streamRate = 32.0;

}  // namespace bedmix
