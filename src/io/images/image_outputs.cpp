// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/image_outputs.h"

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
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
    const std::size_t channels = spec.channels.size();
    header.color_type = channels == 1   ? SPNG_COLOR_TYPE_GRAYSCALE
                        : channels == 4 ? SPNG_COLOR_TYPE_TRUECOLOR_ALPHA
                                        : SPNG_COLOR_TYPE_TRUECOLOR;
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

namespace {

Imf::Header headerOf(const ImageSpec& spec) {
  Imf::Header header(int(spec.width), int(spec.height));
  for (const std::string& channel : spec.channels)
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  return header;
}

class ExrOutput : public ImageOutput {
 public:
  ExrOutput(std::string name, const ImageSpec& spec, ByteOutput& bytes)
      : m_name(std::move(name)), m_spec(spec) {
    try {
      m_file = std::make_unique<File>(m_name, spec, bytes);
    } catch (const Iex::BaseExc& error) {
      throw InputError(m_name, "cannot be written", error.what());
    }
  }

  void write(const StoredRows& values, std::size_t rows) override {
    const std::size_t pixel = m_spec.channels.size() * sizeof(float);
    const std::size_t row = m_spec.width * pixel;
    // OpenEXR counts rows from the image's first.
    auto* first = reinterpret_cast<char*>(const_cast<float*>(std::get<const float*>(values)));
    Imf::FrameBuffer buffer;
    for (std::size_t k = 0; k < m_spec.channels.size(); ++k)
      buffer.insert(m_spec.channels[k],
                    Imf::Slice(Imf::FLOAT, first + k * sizeof(float) - m_row * row, pixel, row));
    try {
      m_file->rows.setFrameBuffer(buffer);
      m_file->rows.writePixels(int(rows));
    } catch (const Iex::BaseExc& error) {
      throw InputError(m_name, "cannot be written", error.what());
    }
    m_row += rows;
  }

  void finish() override { m_file.reset(); }

 private:
  struct File : Imf::OStream {
    File(const std::string& name, const ImageSpec& spec, ByteOutput& output)
        : OStream(name.c_str()), bytes(output), rows(*this, headerOf(spec)) {}
    void write(const char* data, int size) override {
      bytes.write(data, std::size_t(size));
      pos += std::uint64_t(size);
    }
    std::uint64_t tellp() override { return pos; }
    void seekp(std::uint64_t to) override {
      bytes.seek(std::int64_t(to));
      pos = to;
    }

    ByteOutput& bytes;
    std::uint64_t pos = 0;
    Imf::OutputFile rows;  // destroyed first, because it then writes the rest of the rows
  };

  std::string m_name;
  ImageSpec m_spec;
  std::unique_ptr<File> m_file;
  std::size_t m_row = 0;
};

}  // namespace

std::unique_ptr<ImageOutput> exrOutput(std::string name, const ImageSpec& spec, ByteOutput& bytes) {
  return std::make_unique<ExrOutput>(std::move(name), spec, bytes);
}

}  // namespace hogelscope
