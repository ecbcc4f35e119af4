// SPDX-License-Identifier: MIT
#include "render/jpeg.h"

#include <string>
#include <turbojpeg.h>

namespace bedmix {

struct JpegEncoder::State {
  tjhandle handle = nullptr;
  std::vector<std::byte> room;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { tjDestroy(handle); }
};

JpegEncoder::JpegEncoder(std::unique_ptr<State> state) : state_(std::move(state)) {}
JpegEncoder::~JpegEncoder() = default;
JpegEncoder::JpegEncoder(JpegEncoder&&) noexcept = default;
JpegEncoder& JpegEncoder::operator=(JpegEncoder&&) noexcept = default;

Result<JpegEncoder> JpegEncoder::create() {
  auto state = std::make_unique<State>();
  state->handle = tjInitCompress();
  if (!state->handle)
    return Diagnostic{
        {}, std::string("libjpeg-turbo does not start: ") + tjGetErrorStr2(nullptr), Trouble::unavailable};
  return JpegEncoder(std::move(state));
}

Result<std::vector<std::byte>> JpegEncoder::encode(const Image& picture, int quality, bool sharp) {
  State& s = *state_;
  const auto [width, height] = picture.size;
  const TJSAMP colours = sharp ? TJSAMP_444 : TJSAMP_420;
  s.room.resize(tjBufSize(width, height, colours));
  auto* target = reinterpret_cast<unsigned char*>(s.room.data());
  unsigned long size = s.room.size();
  if (tjCompress2(s.handle, picture.rgba.data(), width, 0, height, TJPF_RGBX, &target, &size, colours,
                  quality, TJFLAG_NOREALLOC | TJFLAG_FASTDCT) != 0)
    return Diagnostic{{},
                      std::string("no JPEG can be made of a picture: ") + tjGetErrorStr2(s.handle),
                      Trouble::unavailable};
  return std::vector<std::byte>(s.room.begin(), s.room.begin() + static_cast<std::ptrdiff_t>(size));
}

}  // namespace bedmix
