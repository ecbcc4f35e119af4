// SPDX-License-Identifier: MIT
#include "render/mp4_remux.h"

#include "render/av_film.h"
#include "render/part_file.h"

extern "C" {
#include <libavformat/avformat.h>
}

#include <memory>

namespace bedmix {

namespace {

struct CloseInput {
  void operator()(AVFormatContext* input) const { avformat_close_input(&input); }
};
struct CloseOutput {
  void operator()(AVFormatContext* output) const {
    avio_closep(&output->pb);
    avformat_free_context(output);
  }
};
struct FreePacket {
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
using Output = std::unique_ptr<AVFormatContext, CloseOutput>;

int openOutput(Output& output, const std::string& name, const AVStream& like) {
  AVFormatContext* context = nullptr;
  if (const int error = avformat_alloc_output_context2(&context, nullptr, "mp4", name.c_str()); error < 0)
    return error;
  output.reset(context);
  context->flags |= AVFMT_FLAG_BITEXACT;
  AVStream* stream = avformat_new_stream(context, nullptr);
  avcodec_parameters_copy(stream->codecpar, like.codecpar);
  stream->codecpar->codec_tag = 0;
  stream->time_base = like.time_base;
  stream->avg_frame_rate = like.avg_frame_rate;
  if (const int error = avio_open(&context->pb, name.c_str(), AVIO_FLAG_WRITE); error < 0) return error;
  AVDictionary* options = nullptr;
  av_dict_set(&options, "movflags", "faststart", 0);
  const int error = avformat_write_header(context, &options);
  av_dict_free(&options);
  return error;
}

int copyPackets(AVFormatContext& input, AVFormatContext& output) {
  const std::unique_ptr<AVPacket, FreePacket> packet(av_packet_alloc());
  for (;;) {
    const int got = av_read_frame(&input, packet.get());
    if (got == AVERROR_EOF) return av_write_trailer(&output);
    if (got < 0) return got;
    av_packet_rescale_ts(packet.get(), input.streams[0]->time_base, output.streams[0]->time_base);
    packet->pos = -1;
    if (const int error = av_write_frame(&output, packet.get()); error < 0) return error;
    if (output.pb->error < 0) return output.pb->error;
    av_packet_unref(packet.get());
  }
}

}  // namespace

Result<Done> remuxMp4(const std::filesystem::path& fragmented, const std::filesystem::path& target) {
  PartFile part(target, ".whole.part");
  AVFormatContext* opened = nullptr;
  if (const int error = avformat_open_input(&opened, fragmented.c_str(), nullptr, nullptr); error < 0)
    return part.failure(libavError(error));
  const std::unique_ptr<AVFormatContext, CloseInput> input(opened);
  if (const int error = avformat_find_stream_info(opened, nullptr); error < 0)
    return part.failure(libavError(error));

  Output output;
  int error = openOutput(output, part.path().string(), *input->streams[0]);
  if (error >= 0) error = copyPackets(*input, *output);
  if (error >= 0) error = avio_closep(&output->pb);
  if (error < 0) return part.failure(libavError(error));
  return part.keep();
}

}  // namespace bedmix
