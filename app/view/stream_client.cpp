// SPDX-License-Identifier: MIT
#include "app/view/stream_client.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace bedmix {

namespace {

constexpr int quickQuality = 75, sharpQuality = 92;

SharedBytes shared(std::vector<std::byte> bytes) {
  return std::make_shared<const std::vector<std::byte>>(std::move(bytes));
}

}  // namespace

void StreamClient::greet(PictureCodec codec) {
  codec_ = codec;
  video_.reset();
  onTheirWay_.clear();
  version_ = 0;
}

void StreamClient::acknowledge(std::uint32_t picture) {
  // What came before it is not missed any more either.
  const auto found = std::find(onTheirWay_.begin(), onTheirWay_.end(), picture);
  if (found != onTheirWay_.end()) onTheirWay_.erase(onTheirWay_.begin(), found + 1);
}

StreamHeader StreamClient::header(const StreamPicture& picture, StreamKind kind, bool sharp) {
  onTheirWay_.push_back(++pictures_);
  version_ = picture.version;
  isSharp_ = sharp;
  const auto [width, height] = picture.image.size;
  return {kind,
          sharp,
          pictures_,
          picture.input,
          static_cast<std::uint16_t>(width),
          static_cast<std::uint16_t>(height)};
}

Result<SharedBytes> StreamClient::encode(StreamPicture& picture, bool sharp, JpegEncoder& jpeg) {
  if (codec_ == PictureCodec::jpeg || sharp) return encodeJpeg(picture, sharp, jpeg);
  auto video = encodeH264(picture);
  if (video) return video;
  codec_ = PictureCodec::jpeg;  // this machine has no encoder
  return encodeJpeg(picture, sharp, jpeg);
}

Result<SharedBytes> StreamClient::encodeJpeg(StreamPicture& picture, bool sharp, JpegEncoder& jpeg) {
  SharedBytes& made = sharp ? picture.sharpJpeg : picture.quickJpeg;
  if (!made) {
    auto bytes = jpeg.encode(picture.image, sharp ? sharpQuality : quickQuality, sharp);
    if (!bytes) return bytes.problems;
    made = shared(std::move(*bytes));
  }
  return shared(streamMessage(header(picture, StreamKind::jpeg, sharp), *made));
}

Result<SharedBytes> StreamClient::encodeH264(const StreamPicture& picture) {
  if (!video_ || !(videoSize_ == picture.image.size)) {
    auto video = H264Stream::create(picture.image.size, streamRate);
    if (!video) return video.problems;
    video_.emplace(std::move(*video));
    videoSize_ = picture.image.size;
  }
  const auto packet = video_->encode(picture.image);
  if (!packet) return packet.problems;
  const StreamKind kind = packet->isKey ? StreamKind::h264Key : StreamKind::h264Next;
  return shared(streamMessage(header(picture, kind, false), packet->bytes));
}

}  // namespace bedmix
