// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <spng.h>

#include <memory>
#include <new>

#include "errors.h"

namespace hogelscope::mesh {

namespace {

constexpr double mostPixels = 1 << 26;

/// One picture on its way out of a file, with the names for its messages.
struct Source {
  std::string_view bytes;
  const std::string& file;
  const std::string& name;

  [[noreturn]] void damaged(const std::string& why) const {
    fail(file, name + " cannot be decoded", why);
  }
  [[nodiscard]] Picture allocate(double width, double height) const {
    if (!(width >= 1 && height >= 1 && width * height <= mostPixels))
      damaged("it must have 1 to 67108864 pixels");
    return {int(width), int(height), std::vector<std::uint8_t>(std::size_t(width * height) * 3)};
  }
};

/// libpng and with it OpenImageIO report damage on stderr, libspng does not.
Picture decodePng(const Source& source) {
  const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> png(spng_ctx_new(0), &spng_ctx_free);
  if (!png) throw std::bad_alloc();
  const auto check = [&](int error) {
    if (error != 0) source.damaged(spng_strerror(error));
  };
  constexpr std::size_t chunkBytes = std::size_t{16} << 20U;
  check(spng_set_chunk_limits(png.get(), chunkBytes, chunkBytes));
  check(spng_set_png_buffer(png.get(), source.bytes.data(), source.bytes.size()));
  spng_ihdr header{};
  check(spng_get_ihdr(png.get(), &header));
  Picture picture = source.allocate(header.width, header.height);
  std::size_t size = 0;
  check(spng_decoded_image_size(png.get(), SPNG_FMT_RGB8, &size));
  if (size != picture.rgb.size()) source.damaged("its size is not what its header says");
  check(spng_decode_image(png.get(), picture.rgb.data(), size, SPNG_FMT_RGB8, 0));
  return picture;
}

Picture decodeJpeg(const Source& source) {
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(source.bytes.data()),  // only read
                                       source.bytes.size());
  OIIO::ImageSpec asked;
  void* proxy = &memory;
  asked.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, static_cast<void*>(&proxy));
  const auto input = OIIO::ImageInput::create("jpg");
  OIIO::ImageSpec spec;
  if (!input || !input->open("picture.jpg", spec, asked))
    source.damaged(input ? input->geterror() : OIIO::geterror());
  if (spec.nchannels < 1) source.damaged("it has no channels");
  Picture picture = source.allocate(spec.width, spec.height);
  std::vector<std::uint8_t> pixels(picture.rgb.size() / 3 * std::size_t(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data()))
    source.damaged(input->geterror());
  const auto channels = std::size_t(spec.nchannels);
  for (std::size_t k = 0; k < picture.rgb.size(); ++k)
    picture.rgb[k] = pixels[k / 3 * channels + (channels < 3 ? 0 : k % 3)];
  return picture;
}

}  // namespace

Picture decodePicture(std::string_view bytes, const std::string& file, const std::string& name) {
  const Source source{bytes, file, name};
  if (bytes.starts_with("\x89PNG")) return decodePng(source);
  if (bytes.starts_with("\xFF\xD8")) return decodeJpeg(source);
  source.damaged("it is neither PNG nor JPEG");
}

}  // namespace hogelscope::mesh
