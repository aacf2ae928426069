// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/exr_output.h"

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>

#include <utility>

#include "core/base/error.h"

namespace hogelscope {

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
