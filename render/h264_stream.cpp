// SPDX-License-Identifier: MIT
#include "render/h264_stream.h"

#include "render/av_film.h"
#include "render/yuv_picture.h"

extern "C" {
#include <libavutil/opt.h>
}

namespace bedmix {

namespace {

struct FreeEncoder {
  void operator()(AVCodecContext* encoder) const { avcodec_free_context(&encoder); }
};
struct FreeFrame {
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};
struct FreePacket {
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};

Diagnostic noStream(const std::string& why) {
  return {{}, "no H.264 can be streamed: " + why, Trouble::unavailable};
}

}  // namespace

struct H264Stream::State {
  std::unique_ptr<AVCodecContext, FreeEncoder> encoder;
  std::unique_ptr<AVFrame, FreeFrame> frame;
  std::unique_ptr<AVPacket, FreePacket> packet;
  YuvPicture toYuv;
  std::int64_t pictures = 0;

  explicit State(Size size) : toYuv(size, YuvPicture::Quality::quick) {}
};

H264Stream::H264Stream(std::unique_ptr<State> state) : state_(std::move(state)) {}
H264Stream::~H264Stream() = default;
H264Stream::H264Stream(H264Stream&&) noexcept = default;
H264Stream& H264Stream::operator=(H264Stream&&) noexcept = default;

Result<H264Stream> H264Stream::create(Size size, double fps) {
  av_log_set_level(AV_LOG_QUIET);  // its failures come back as results
  const AVCodec* codec = avcodec_find_encoder_by_name("libx264");
  if (!codec) return noStream("libavcodec has no libx264");
  auto state = std::make_unique<State>(size);
  state->encoder.reset(avcodec_alloc_context3(codec));
  AVCodecContext& encoder = *state->encoder;
  encoder.width = state->toYuv.size().width;
  encoder.height = state->toYuv.size().height;
  encoder.time_base = av_inv_q(av_d2q(fps, 1000));
  encoder.framerate = av_d2q(fps, 1000);
  setBt709(encoder);
  encoder.gop_size = 100000;  // key pictures where one is asked for: the socket loses nothing
  encoder.max_b_frames = 0;
  encoder.thread_count = 1;
  encoder.profile = FF_PROFILE_H264_CONSTRAINED_BASELINE;
  av_opt_set(encoder.priv_data, "preset", "ultrafast", 0);
  av_opt_set(encoder.priv_data, "tune", "zerolatency", 0);
  av_opt_set(encoder.priv_data, "crf", "24", 0);
  av_opt_set(encoder.priv_data, "forced-idr", "1", 0);
  if (const int error = avcodec_open2(&encoder, nullptr, nullptr); error < 0)
    return noStream(libavError(error));
  state->frame.reset(av_frame_alloc());
  state->packet.reset(av_packet_alloc());
  state->frame->format = encoder.pix_fmt;
  state->frame->width = encoder.width;
  state->frame->height = encoder.height;
  if (const int error = av_frame_get_buffer(state->frame.get(), 0); error < 0)
    return noStream(libavError(error));
  return H264Stream(std::move(state));
}

Result<H264Stream::Packet> H264Stream::encode(const Image& picture, bool key) {
  State& s = *state_;
  AVFrame& frame = *s.frame;
  if (const int error = av_frame_make_writable(&frame); error < 0) return noStream(libavError(error));
  s.toYuv.convert(picture, frame);
  frame.pts = s.pictures++;
  frame.pict_type = key ? AV_PICTURE_TYPE_I : AV_PICTURE_TYPE_NONE;
  if (const int error = avcodec_send_frame(s.encoder.get(), &frame); error < 0)
    return noStream(libavError(error));
  if (const int error = avcodec_receive_packet(s.encoder.get(), s.packet.get()); error < 0)
    return noStream(libavError(error));
  const auto* bytes = reinterpret_cast<const std::byte*>(s.packet->data);
  Packet packet{{bytes, bytes + s.packet->size}, (s.packet->flags & AV_PKT_FLAG_KEY) != 0};
  av_packet_unref(s.packet.get());
  return packet;
}

}  // namespace bedmix
