// SPDX-License-Identifier: BSD-3-Clause
#include "picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <spng.h>

#include <algorithm>
#include <memory>
#include <new>

#include "errors.h"

namespace hogelscope::mesh {

namespace {

constexpr double mostPixels = 1 << 26;
/// The number of rows between calls of the listener.
constexpr int someRows = 64;

[[noreturn]] void damaged(const EncodedPicture& source, const std::string& why) {
  fail(source.file, source.name + " cannot be decoded", why);
}

void checkSize(const EncodedPicture& source, double width, double height) {
  if (!(width >= 1 && height >= 1 && width * height <= mostPixels))
    damaged(source, "it must have 1 to 67108864 pixels");
}

Picture blank(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 3)};
}

/// Decodes PNG by libspng, because libpng, and OpenImageIO with it, prints errors on stderr.
class Png {
 public:
  explicit Png(const EncodedPicture& source) : m_source(source) {
    if (!m_png) throw std::bad_alloc();
    constexpr std::size_t chunkBytes = std::size_t{16} << 20U;
    check(spng_set_chunk_limits(m_png.get(), chunkBytes, chunkBytes));
    check(spng_set_png_buffer(m_png.get(), source.bytes.data(), source.bytes.size()));
    check(spng_get_ihdr(m_png.get(), &m_header));
    checkSize(source, m_header.width, m_header.height);
  }

  [[nodiscard]] double pixels() const { return double(m_header.width) * m_header.height; }

  Picture decode(const Reading& reading) {
    Picture picture = blank(int(m_header.width), int(m_header.height));
    const std::size_t rowBytes = std::size_t{3} * m_header.width;
    std::size_t size = 0;
    check(spng_decoded_image_size(m_png.get(), SPNG_FMT_RGB8, &size));
    if (size != picture.rgb.size()) damaged(m_source, "its size is not what its header says");
    check(spng_decode_image(m_png.get(), nullptr, 0, SPNG_FMT_RGB8, SPNG_DECODE_PROGRESSIVE));
    int result = 0;
    for (int rows = 0; result == 0; ++rows) {
      if (rows % someRows == 0) reading.poll();
      spng_row_info row{};
      check(spng_get_row_info(m_png.get(), &row));
      result = spng_decode_row(m_png.get(), &picture.rgb[row.row_num * rowBytes], rowBytes);
    }
    if (result != SPNG_EOI) check(result);
    return picture;
  }

 private:
  void check(int error) const {
    if (error != 0) damaged(m_source, spng_strerror(error));
  }

  const EncodedPicture& m_source;
  std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> m_png{spng_ctx_new(0), &spng_ctx_free};
  spng_ihdr m_header{};
};

class Jpeg {
 public:
  explicit Jpeg(const EncodedPicture& source)
      : m_source(source),
        m_memory(const_cast<char*>(source.bytes.data()), source.bytes.size()),  // read only
        m_input(OIIO::ImageInput::create("jpg")) {
    OIIO::ImageSpec asked;
    void* proxy = &m_memory;
    asked.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, static_cast<void*>(&proxy));
    if (!m_input || !m_input->open("picture.jpg", m_spec, asked))
      damaged(source, m_input ? m_input->geterror() : OIIO::geterror());
    if (m_spec.nchannels < 1) damaged(source, "it has no channels");
    checkSize(source, m_spec.width, m_spec.height);
  }

  [[nodiscard]] double pixels() const { return double(m_spec.width) * m_spec.height; }

  Picture decode(const Reading& reading) {
    Picture picture = blank(m_spec.width, m_spec.height);
    const auto width = std::size_t(m_spec.width);
    const auto channels = std::size_t(m_spec.nchannels);
    std::vector<std::uint8_t> rows(width * channels * someRows);
    for (int y = 0; y < m_spec.height; y += someRows) {
      reading.poll();
      const int end = std::min(y + someRows, m_spec.height);
      if (!m_input->read_scanlines(0, 0, y, end, 0, 0, m_spec.nchannels, OIIO::TypeDesc::UINT8,
                                   rows.data()))
        damaged(m_source, m_input->geterror());
      std::uint8_t* to = &picture.rgb[3 * width * std::size_t(y)];
      for (std::size_t k = 0; k < 3 * width * std::size_t(end - y); ++k)
        to[k] = rows[k / 3 * channels + (channels < 3 ? 0 : k % 3)];
    }
    return picture;
  }

 private:
  const EncodedPicture& m_source;
  OIIO::Filesystem::IOMemReader m_memory;
  std::unique_ptr<OIIO::ImageInput> m_input;
  OIIO::ImageSpec m_spec;
};

/// Calls `use` with the decoder for the file's first bytes.
template <class Use>
auto withDecoder(const EncodedPicture& picture, const Use& use) {
  if (picture.bytes.starts_with("\x89PNG")) return use(Png(picture));
  if (picture.bytes.starts_with("\xFF\xD8")) return use(Jpeg(picture));
  damaged(picture, "it is neither PNG nor JPEG");
}

}  // namespace

double pixelsOf(const EncodedPicture& picture) {
  return withDecoder(picture, [](const auto& decoder) { return decoder.pixels(); });
}

Picture decoded(const EncodedPicture& picture, const Reading& reading) {
  return withDecoder(picture, [&](auto&& decoder) { return decoder.decode(reading); });
}

}  // namespace hogelscope::mesh
