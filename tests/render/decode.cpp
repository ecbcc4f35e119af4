// SPDX-License-Identifier: MIT
#include "tests/render/decode.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

namespace bedmix::test {

namespace {

Image toRgb(const AVFrame& frame) {
  Image image;
  image.resize({frame.width, frame.height});
  SwsContext* sws = sws_getContext(
      frame.width, frame.height, static_cast<AVPixelFormat>(frame.format), frame.width, frame.height,
      AV_PIX_FMT_RGBA, SWS_POINT | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr, nullptr, nullptr);
  const int* coefficients = sws_getCoefficients(frame.colorspace);
  sws_setColorspaceDetails(sws, coefficients, frame.color_range == AVCOL_RANGE_JPEG, coefficients, 1, 0,
                           1 << 16, 1 << 16);
  std::uint8_t* out[] = {image.rgba.data()};
  const int stride[] = {4 * frame.width};
  sws_scale(sws, frame.data, frame.linesize, 0, frame.height, out, stride);
  sws_freeContext(sws);
  return image;
}

void receive(AVCodecContext* decoder, const AVStream& stream, DecodedMovie& movie) {
  AVFrame* frame = av_frame_alloc();
  while (avcodec_receive_frame(decoder, frame) == 0) {
    movie.frames.push_back(toRgb(*frame));
    movie.times.push_back(static_cast<double>(frame->best_effort_timestamp) * av_q2d(stream.time_base));
    movie.bt709Limited = frame->color_primaries == AVCOL_PRI_BT709 && frame->color_trc == AVCOL_TRC_BT709 &&
                         frame->colorspace == AVCOL_SPC_BT709 && frame->color_range == AVCOL_RANGE_MPEG;
    movie.yuv420 = frame->format == AV_PIX_FMT_YUV420P;
  }
  av_frame_free(&frame);
}

}  // namespace

DecodedMovie decode(const std::filesystem::path& path) {
  DecodedMovie movie;
  AVFormatContext* file = nullptr;
  if (avformat_open_input(&file, path.c_str(), nullptr, nullptr) < 0) return movie;
  avformat_find_stream_info(file, nullptr);
  const AVStream& stream = *file->streams[0];
  AVCodecContext* decoder = avcodec_alloc_context3(nullptr);
  avcodec_parameters_to_context(decoder, stream.codecpar);
  avcodec_open2(decoder, avcodec_find_decoder(stream.codecpar->codec_id), nullptr);
  AVPacket* packet = av_packet_alloc();
  while (av_read_frame(file, packet) >= 0) {
    avcodec_send_packet(decoder, packet);
    receive(decoder, stream, movie);
    av_packet_unref(packet);
  }
  avcodec_send_packet(decoder, nullptr);
  receive(decoder, stream, movie);
  movie.duration = static_cast<double>(file->duration) / AV_TIME_BASE;
  movie.framesPerSecond = av_q2d(stream.avg_frame_rate);
  movie.codec = avcodec_get_name(stream.codecpar->codec_id);
  char tag[AV_FOURCC_MAX_STRING_SIZE];
  movie.tag = av_fourcc_make_string(tag, stream.codecpar->codec_tag);
  const char* profile = avcodec_profile_name(stream.codecpar->codec_id, stream.codecpar->profile);
  movie.profile = profile ? profile : "";
  av_packet_free(&packet);
  avcodec_free_context(&decoder);
  avformat_close_input(&file);
  return movie;
}

}  // namespace bedmix::test
