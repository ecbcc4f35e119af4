// SPDX-License-Identifier: MIT
#include "render/png.h"

#include "render/c_file.h"
#include "render/part_file.h"

#include <png.h>

#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>

namespace bedmix {

namespace {

/// libpng's two halves of a picture being written.
struct PngWriter {
  std::string error;
  png_structp png = nullptr;
  png_infop info = nullptr;

  PngWriter() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, onError, [](png_structp, png_const_charp) {});
    if (png) info = png_create_info_struct(png);
  }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }

  static void onError(png_structp png, png_const_charp message) {
    auto* self = static_cast<PngWriter*>(png_get_error_ptr(png));
    self->error = errno ? std::strerror(errno) : message;
    png_longjmp(png, 1);
  }
};

/// libpng leaves by longjmp, so everything with a destructor lives in the caller.
bool encode(PngWriter& writer, std::FILE* file, const Image& image, const PngOptions& options,
            std::vector<png_text>& text) {
  if (setjmp(png_jmpbuf(writer.png))) return false;
  const png_structp png = writer.png;
  png_init_io(png, file);
  // Areas of one colour: differences of neighbours compress worse than the pixels, and level 9 takes ten
  // times as long as 6 for a few per cent.
  png_set_compression_level(png, options.small ? 6 : 3);
  png_set_filter(png, 0, PNG_FILTER_NONE);
  png_set_IHDR(png, writer.info, static_cast<png_uint_32>(image.size.width),
               static_cast<png_uint_32>(image.size.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!text.empty()) png_set_text(png, writer.info, text.data(), static_cast<int>(text.size()));
  if (options.dpi) {
    const auto perMetre = static_cast<png_uint_32>(std::lround(*options.dpi / 0.0254));
    png_set_pHYs(png, writer.info, perMetre, perMetre, PNG_RESOLUTION_METER);
  }
  png_write_info(png, writer.info);
  png_set_filler(png, 0, PNG_FILLER_AFTER);  // takes alpha for filler and drops it
  const std::size_t stride = 4 * static_cast<std::size_t>(image.size.width);
  for (int y = 0; y < image.size.height; ++y) png_write_row(png, image.rgba.data() + y * stride);
  png_write_end(png, writer.info);
  return true;
}

}  // namespace

Result<Done> writePng(const std::filesystem::path& path, const Image& image, const PngOptions& options) {
  PartFile part(path);
  CFile file(std::fopen(part.path().c_str(), "wb"));
  if (!file) return part.failure(std::strerror(errno));

  std::vector<png_text> text;
  for (const auto& [key, value] : options.text) {
    png_text entry{};
    entry.compression = PNG_TEXT_COMPRESSION_NONE;
    entry.key = const_cast<char*>(key.c_str());  // libpng only reads them
    entry.text = const_cast<char*>(value.c_str());
    text.push_back(entry);
  }
  PngWriter writer;
  if (!writer.info) return part.failure("libpng does not start");
  errno = 0;
  if (!encode(writer, file.get(), image, options, text)) return part.failure(writer.error);
  if (std::fclose(file.release()) != 0) return part.failure(std::strerror(errno));
  return part.keep();
}

Result<Image> readPng(const std::filesystem::path& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto failure = [&] {
    return Diagnostic{{path.string()}, std::string("cannot read it as PNG: ") + png.message, Trouble::file};
  };
  if (!png_image_begin_read_from_file(&png, path.c_str())) return failure();
  png.format = PNG_FORMAT_RGBA;
  Image image;
  image.resize({static_cast<int>(png.width), static_cast<int>(png.height)});
  if (!png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr)) return failure();
  return image;
}

}  // namespace bedmix
