// SPDX-License-Identifier: MIT
#include "render/movie.h"

#include "render/movie_remux.h"
#include "render/part_file.h"

#include <algorithm>
#include <cmath>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <fmt/format.h>

namespace bedmix {

namespace {

constexpr const char* encoderName = "libx264";
/// The stream depends on it, so it does not follow the machine.
constexpr int encoderThreads = 2;

Diagnostic noEncoder(const std::string& why) {
  return {
      {}, "no H.264 film can be made: " + why + "; Debian's libavcodec59 has libx264", Trouble::unavailable};
}

/// Repeats the last pixel of each row and the last row, where the film is larger than the picture.
void pad(const Image& picture, Image& padded) {
  const std::size_t from = 4 * static_cast<std::size_t>(picture.size.width);
  const std::size_t to = 4 * static_cast<std::size_t>(padded.size.width);
  for (int y = 0; y < padded.size.height; ++y) {
    const std::uint8_t* row = picture.rgba.data() + std::min(y, picture.size.height - 1) * from;
    std::uint8_t* out = padded.rgba.data() + y * to;
    std::copy_n(row, from, out);
    if (to > from) std::copy_n(row + from - 4, 4, out + from);
  }
}

}  // namespace

struct Movie::State {
  std::filesystem::path target;
  PartFile part;
  Size picture;
  Image padded;  // of the film's size; unused where that is the picture's
  std::int64_t frames = 0;
  AVFormatContext* file = nullptr;
  AVCodecContext* encoder = nullptr;
  AVFrame* frame = nullptr;
  AVPacket* packet = nullptr;
  SwsContext* toYuv = nullptr;

  State(const std::filesystem::path& path, Size size) : target(path), part(path), picture(size) {
    padded.resize({size.width + size.width % 2, size.height + size.height % 2});
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State();

  Result<Done> openEncoder(double fps);
  Result<Done> openFile();
  /// Encodes `input` (null: the rest) and writes what comes out.
  Result<Done> encode(const AVFrame* input);
  Diagnostic failure(int error) const { return part.failure(libavError(error)); }
};

Movie::State::~State() {
  sws_freeContext(toYuv);
  av_packet_free(&packet);
  av_frame_free(&frame);
  avcodec_free_context(&encoder);
  if (file) avio_closep(&file->pb);
  avformat_free_context(file);
}

Result<Done> Movie::State::openEncoder(double fps) {
  const AVCodec* codec = avcodec_find_encoder_by_name(encoderName);
  if (!codec) return noEncoder(fmt::format("libavcodec has no {}", encoderName));
  encoder = avcodec_alloc_context3(codec);
  encoder->width = padded.size.width;
  encoder->height = padded.size.height;
  encoder->framerate = av_d2q(fps, 1001000);
  encoder->time_base = av_inv_q(encoder->framerate);
  encoder->pix_fmt = AV_PIX_FMT_YUV420P;
  encoder->color_primaries = AVCOL_PRI_BT709;
  encoder->color_trc = AVCOL_TRC_BT709;
  encoder->colorspace = AVCOL_SPC_BT709;
  encoder->color_range = AVCOL_RANGE_MPEG;
  encoder->gop_size = std::max(1, static_cast<int>(std::lround(fps)));  // a fragment a second
  encoder->max_b_frames = 0;                                            // starts at 0 in every player
  encoder->thread_count = encoderThreads;
  encoder->flags |= AV_CODEC_FLAG_BITEXACT | AV_CODEC_FLAG_GLOBAL_HEADER;
  av_opt_set(encoder->priv_data, "preset", "veryfast", 0);
  av_opt_set(encoder->priv_data, "crf", "18", 0);
  if (const int error = avcodec_open2(encoder, codec, nullptr); error < 0)
    return noEncoder(fmt::format("{} refuses {}x{} at {:g} frames/s ({})", encoderName, padded.size.width,
                                 padded.size.height, fps, libavError(error)));

  frame = av_frame_alloc();
  packet = av_packet_alloc();
  frame->format = encoder->pix_fmt;
  frame->width = encoder->width;
  frame->height = encoder->height;
  frame->colorspace = encoder->colorspace;
  frame->color_range = encoder->color_range;
  if (av_frame_get_buffer(frame, 0) < 0) return noEncoder("no memory for a frame");
  toYuv = sws_getContext(
      encoder->width, encoder->height, AV_PIX_FMT_RGBA, encoder->width, encoder->height, encoder->pix_fmt,
      SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_BITEXACT, nullptr, nullptr, nullptr);
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(toYuv, bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
  return Done{};
}

Result<Done> Movie::State::openFile() {
  const std::string name = part.path().string();
  if (avformat_alloc_output_context2(&file, nullptr, "mp4", name.c_str()) < 0)
    return noEncoder("libavformat writes no MP4");
  file->flags |= AVFMT_FLAG_BITEXACT | AVFMT_FLAG_FLUSH_PACKETS;  // a closed fragment survives a kill
  AVStream* stream = avformat_new_stream(file, nullptr);
  avcodec_parameters_from_context(stream->codecpar, encoder);
  stream->time_base = encoder->time_base;
  stream->avg_frame_rate = encoder->framerate;
  if (const int error = avio_open(&file->pb, name.c_str(), AVIO_FLAG_WRITE); error < 0) return failure(error);
  AVDictionary* options = nullptr;
  av_dict_set(&options, "movflags", "frag_keyframe+empty_moov+default_base_moof", 0);
  const int error = avformat_write_header(file, &options);
  av_dict_free(&options);
  if (error < 0) return failure(error);
  return Done{};
}

Result<Done> Movie::State::encode(const AVFrame* input) {
  if (const int error = avcodec_send_frame(encoder, input); error < 0) return failure(error);
  for (;;) {
    const int got = avcodec_receive_packet(encoder, packet);
    if (got == AVERROR(EAGAIN) || got == AVERROR_EOF) return Done{};
    if (got < 0) return failure(got);
    packet->duration = 1;
    av_packet_rescale_ts(packet, encoder->time_base, file->streams[0]->time_base);
    if (const int error = av_write_frame(file, packet); error < 0) return failure(error);
    if (file->pb->error < 0) return failure(file->pb->error);
    av_packet_unref(packet);
  }
}

Movie::Movie(std::unique_ptr<State> state) : state_(std::move(state)) {}
Movie::~Movie() = default;
Movie::Movie(Movie&&) noexcept = default;
Movie& Movie::operator=(Movie&&) noexcept = default;

Result<Movie> Movie::create(const std::filesystem::path& path, Size size, double fps) {
  av_log_set_level(AV_LOG_QUIET);  // its failures come back as results
  auto state = std::make_unique<State>(path, size);
  if (Result<Done> done = state->openEncoder(fps); !done) return done.problems;
  if (Result<Done> done = state->openFile(); !done) return done.problems;
  return Movie(std::move(state));
}

Result<Done> Movie::add(const Image& picture) {
  State& s = *state_;
  const bool even = s.picture == s.padded.size;
  if (!even) pad(picture, s.padded);
  if (const int error = av_frame_make_writable(s.frame); error < 0) return s.failure(error);
  const std::uint8_t* pixels[] = {(even ? picture : s.padded).rgba.data()};
  const int stride[] = {4 * s.padded.size.width};
  sws_scale(s.toYuv, pixels, stride, 0, s.padded.size.height, s.frame->data, s.frame->linesize);
  s.frame->pts = s.frames++;
  return s.encode(s.frame);
}

Result<Done> Movie::finish() {
  State& s = *state_;
  if (Result<Done> done = s.encode(nullptr); !done) return done;
  if (const int error = av_write_trailer(s.file); error < 0) return s.failure(error);
  if (const int error = avio_closep(&s.file->pb); error < 0) return s.failure(error);
  return remuxMovie(s.part.path(), s.target);
}

Result<std::string> probeEncoder() {
  if (!avcodec_find_encoder_by_name(encoderName))
    return noEncoder(fmt::format("libavcodec has no {}", encoderName));
  const unsigned version = avcodec_version();
  return fmt::format("{}, libavcodec {}.{}.{}", encoderName, AV_VERSION_MAJOR(version),
                     AV_VERSION_MINOR(version), AV_VERSION_MICRO(version));
}

}  // namespace bedmix
