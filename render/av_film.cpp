// SPDX-License-Identifier: MIT
#include "render/av_film.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace bedmix {

namespace {

Diagnostic missing(const char* encoder) {
  return {{},
          fmt::format("no film can be encoded: libavcodec has no {}; Debian's libavcodec59 has it", encoder),
          Trouble::unavailable};
}

}  // namespace

AvFilm::~AvFilm() { release(); }

void AvFilm::release() {
  if (hasBegun_)
    av_write_trailer(file_);  // else what the muxer holds back is lost to memory: the last of a GIF
  hasBegun_ = false;
  av_packet_free(&packet_);
  av_frame_free(&frame_);
  avcodec_free_context(&encoder_);
  if (file_) avio_closep(&file_->pb);
  avformat_free_context(file_);
  file_ = nullptr;
}

Result<Done> AvFilm::findEncoder(Size size, AVRational rate) {
  av_log_set_level(AV_LOG_QUIET);  // its failures come back as results
  const AVCodec* codec = avcodec_find_encoder_by_name(format_.encoder);
  if (!codec) return missing(format_.encoder);
  encoder_ = avcodec_alloc_context3(codec);
  encoder_->width = size.width;
  encoder_->height = size.height;
  encoder_->framerate = rate;
  encoder_->time_base = av_inv_q(rate);
  encoder_->flags |= AV_CODEC_FLAG_BITEXACT;
  return Done{};
}

Result<Done> AvFilm::open() {
  if (Result<Done> done = openEncoder(); !done) return done;
  return openFile();
}

Result<Done> AvFilm::openEncoder() {
  const AVOutputFormat* muxer = av_guess_format(format_.muxer, nullptr, nullptr);
  if (!muxer) return noEncoder(fmt::format("libavformat does not write {}", format_.muxer));
  if (muxer->flags & AVFMT_GLOBALHEADER) encoder_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  if (const int error = avcodec_open2(encoder_, nullptr, nullptr); error < 0)
    return noEncoder(fmt::format("{} refuses {}x{} at {:g} pictures/s ({})", format_.encoder, encoder_->width,
                                 encoder_->height, av_q2d(encoder_->framerate), libavError(error)));
  frame_ = av_frame_alloc();
  packet_ = av_packet_alloc();
  frame_->format = encoder_->pix_fmt;
  frame_->width = encoder_->width;
  frame_->height = encoder_->height;
  frame_->color_primaries = encoder_->color_primaries;
  frame_->color_trc = encoder_->color_trc;
  frame_->colorspace = encoder_->colorspace;
  frame_->color_range = encoder_->color_range;
  if (av_frame_get_buffer(frame_, 0) < 0) return noEncoder("no memory for a picture");
  return Done{};
}

Result<Done> AvFilm::openFile() {
  const std::string name = part_.path().string();
  if (const int error = avformat_alloc_output_context2(&file_, nullptr, format_.muxer, name.c_str());
      error < 0)
    return failure(error);
  file_->flags |= AVFMT_FLAG_BITEXACT | AVFMT_FLAG_FLUSH_PACKETS;  // what is complete survives a kill
  AVStream* stream = avformat_new_stream(file_, nullptr);
  avcodec_parameters_from_context(stream->codecpar, encoder_);
  stream->time_base = encoder_->time_base;
  stream->avg_frame_rate = encoder_->framerate;
  if (const int error = avio_open(&file_->pb, name.c_str(), AVIO_FLAG_WRITE); error < 0)
    return failure(error);
  AVDictionary* options = nullptr;
  av_dict_parse_string(&options, format_.muxerOptions, "=", ":", 0);
  const int error = avformat_write_header(file_, &options);
  av_dict_free(&options);
  if (error < 0) return failure(error);
  hasBegun_ = true;
  return Done{};
}

Result<Done> AvFilm::takeFrame() {
  if (const int error = av_frame_make_writable(frame_); error < 0) return failure(error);
  return Done{};
}

Result<Done> AvFilm::encode() {
  frame_->pts = pictures_++;
  return pass(frame_);
}

Result<Done> AvFilm::pass(const AVFrame* input) {
  if (const int error = avcodec_send_frame(encoder_, input); error < 0) return failure(error);
  for (;;) {
    const int got = avcodec_receive_packet(encoder_, packet_);
    if (got == AVERROR(EAGAIN) || got == AVERROR_EOF) return Done{};
    if (got < 0) return failure(got);
    packet_->duration = 1;
    av_packet_rescale_ts(packet_, encoder_->time_base, file_->streams[0]->time_base);
    if (const int error = av_write_frame(file_, packet_); error < 0) return failure(error);
    if (file_->pb->error < 0) return failure(file_->pb->error);
    av_packet_unref(packet_);
  }
}

Result<Done> AvFilm::close() {
  if (Result<Done> done = pass(nullptr); !done) return done;
  hasBegun_ = false;
  if (const int error = av_write_trailer(file_); error < 0) return failure(error);
  if (const int error = avio_closep(&file_->pb); error < 0) return failure(error);
  release();  // what is done with the film next may need the memory
  return Done{};
}

Diagnostic AvFilm::failure(int error) const { return part_.failure(libavError(error)); }

Diagnostic AvFilm::noEncoder(const std::string& why) const {
  return {{}, "no film can be encoded: " + why, Trouble::unavailable};
}

Result<std::string> probeAvEncoder(const char* encoder) {
  if (!avcodec_find_encoder_by_name(encoder)) return missing(encoder);
  const unsigned version = avcodec_version();
  return fmt::format("{}, libavcodec {}.{}.{}", encoder, AV_VERSION_MAJOR(version), AV_VERSION_MINOR(version),
                     AV_VERSION_MICRO(version));
}

std::string libavError(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  return text.data();
}

}  // namespace bedmix
