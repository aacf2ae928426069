// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/png_output.h"

#include <spng.h>

#include <new>
#include <utility>

#include "core/base/error.h"

namespace hogelscope {

namespace {

class PngOutput : public ImageOutput {
 public:
  PngOutput(std::string name, const ImageSpec& spec, PngEffort effort, PngSink sink)
      : m_name(std::move(name)),
        m_sink(std::move(sink)),
        m_context(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free) {
    constexpr std::size_t longest = 1000000;  // the limit of libpng, used by most programs
    if (spec.width > longest || spec.height > longest)
      throw InputError(m_name, "cannot be written", "PNG ends at 1000000 px; use TIFF");
    if (spec.type == StoredType::real)
      throw InputError(m_name, "cannot be written",
                       "its format does not hold floats; use .exr or .tif");
    if (!m_context) throw std::bad_alloc();
    const std::size_t bytes = spec.type == StoredType::uint16 ? 2 : 1;
    m_rowBytes = spec.channels.size() * spec.width * bytes;
    spng_ihdr header{};
    header.width = std::uint32_t(spec.width);
    header.height = std::uint32_t(spec.height);
    header.bit_depth = std::uint8_t(8 * bytes);
    header.color_type =
        spec.channels.size() == 1 ? SPNG_COLOR_TYPE_GRAYSCALE : SPNG_COLOR_TYPE_TRUECOLOR;
    check(spng_set_ihdr(m_context.get(), &header));
    if (effort == PngEffort::quick) {
      check(spng_set_option(m_context.get(), SPNG_IMG_COMPRESSION_LEVEL, 3));
      check(spng_set_option(m_context.get(), SPNG_FILTER_CHOICE, SPNG_DISABLE_FILTERING));
    }
    const auto hand = [](spng_ctx* /*context*/, void* user, void* data, std::size_t size) {
      static_cast<PngOutput*>(user)->m_sink(data, size);
      return 0;
    };
    check(spng_set_png_stream(m_context.get(), hand, this));
    check(spng_encode_image(m_context.get(), nullptr, 0, SPNG_FMT_PNG,
                            SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE));
  }

  void write(const StoredRows& values, std::size_t rows) override {
    std::visit(
        [&](const auto* first) {
          const auto* at = reinterpret_cast<const char*>(first);
          for (std::size_t row = 0; row < rows; ++row, at += m_rowBytes) {
            const int status = spng_encode_row(m_context.get(), at, m_rowBytes);
            if (status != SPNG_EOI) check(status);  // the last row returns SPNG_EOI
          }
        },
        values);
  }

  /// Does nothing; the last row has completed the file.
  void finish() override {}

 private:
  void check(int status) const {
    if (status != 0) throw InputError(m_name, "cannot be written", spng_strerror(status));
  }

  std::string m_name;
  PngSink m_sink;
  std::size_t m_rowBytes = 0;
  std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> m_context;
};

}  // namespace

std::unique_ptr<ImageOutput> pngOutput(std::string name, const ImageSpec& spec, PngEffort effort,
                                       PngSink sink) {
  return std::make_unique<PngOutput>(std::move(name), spec, effort, std::move(sink));
}

}  // namespace hogelscope
