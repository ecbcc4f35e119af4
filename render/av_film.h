// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "render/image.h"
#include "render/part_file.h"

#include <cstdint>
#include <filesystem>
#include <string>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

namespace bedmix {

/// How libav knows a kind of film, and how it is to be written.
struct AvFormat {
  const char* encoder;
  const char* muxer;
  const char* muxerOptions;  // "key=value:key=value"
};

/// A film as libav writes it: an encoder, and the file its packets go to under the name `target`.part. To be
/// used in the order findEncoder, open, any number of encode, close.
class AvFilm {
 public:
  AvFilm(const std::filesystem::path& target, const AvFormat& format) : part_(target), format_(format) {}
  ~AvFilm();
  AvFilm(const AvFilm&) = delete;
  AvFilm& operator=(const AvFilm&) = delete;

  /// An encoder for pictures of `size`, `rate` a second, with nothing else set.
  Result<Done> findEncoder(Size size, AVRational rate);
  AVCodecContext& encoder() { return *encoder_; }

  /// Opens the encoder as it is set, and the file.
  Result<Done> open();
  /// The picture that encode() takes, to be overwritten.
  AVFrame& frame() { return *frame_; }
  /// Makes the frame ours, where the encoder has kept it; before it is overwritten.
  Result<Done> takeFrame();
  Result<Done> encode();
  /// Ends the film, still under its name in making.
  Result<Done> close();

  PartFile& part() { return part_; }

 private:
  void release();
  Result<Done> openEncoder();
  Result<Done> openFile();
  /// Encodes `input` (null: the rest) and writes what comes out.
  Result<Done> pass(const AVFrame* input);
  Diagnostic failure(int error) const;
  Diagnostic noEncoder(const std::string& why) const;

  PartFile part_;
  AvFormat format_;
  std::int64_t pictures_ = 0;
  bool hasBegun_ = false;  // the file, and not ended yet
  AVFormatContext* file_ = nullptr;
  AVCodecContext* encoder_ = nullptr;
  AVFrame* frame_ = nullptr;
  AVPacket* packet_ = nullptr;
};

/// "libx264, libavcodec 59.37.100", or why there is no such encoder.
Result<std::string> probeAvEncoder(const char* encoder);

/// libav's words for one of its error codes.
std::string libavError(int error);

}  // namespace bedmix
