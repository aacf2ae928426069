// SPDX-License-Identifier: BSD-3-Clause
// Output of images by OpenImageIO.
#include <OpenImageIO/filesystem.h>

#include <algorithm>

#include "core/base/error.h"
#include "io/codecs/open_image_io.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Reports success of every write and keeps the error in ByteOutput, because some writers do not
/// notice a full disk, and libjpeg would end the process.
class Proxy : public OIIO::Filesystem::IOProxy {
 public:
  Proxy(const fs::path& file, ByteOutput& bytes)
      : IOProxy(file.string(), Mode::Write), m_bytes(bytes) {}

  [[nodiscard]] const char* proxytype() const override { return "checked file"; }
  bool seek(int64_t offset) override {
    m_pos = offset;
    m_bytes.seek(offset);
    return true;
  }
  std::size_t write(const void* data, std::size_t size) override {
    if (size == 0) return 0;  // the data of WebP's last write may be null
    m_bytes.write(data, size);
    m_pos += int64_t(size);
    return size;
  }
  std::size_t read(void* data, std::size_t size) override { return m_bytes.read(data, size); }
  [[nodiscard]] std::size_t size() const override { return m_bytes.size(); }
  // One of the two overrides: it is const up to OpenImageIO 3.0.
  void flush() const { m_bytes.flush(); }  // NOLINT(modernize-use-override)
  void flush() { m_bytes.flush(); }        // NOLINT(modernize-use-override)

 private:
  ByteOutput& m_bytes;
};

class Output : public ImageOutput {
 public:
  Output(const fs::path& file, const ImageSpec& wanted, ByteOutput& bytes)
      : m_file(file), m_bytes(file, bytes), m_type(typeDesc(wanted.type)) {
    OIIO::ImageSpec spec(int(wanted.width), int(wanted.height), int(wanted.channels.size()),
                         m_type);
    spec.channelnames = wanted.channels;
    spec.attribute("DateTime", "");  // equal content gives equal files, without a date
    m_image = OIIO::ImageOutput::create(file.string());
    if (!m_image) {
      (void)OIIO::geterror();  // otherwise the error is printed
      throw InputError(file.string(), "cannot be written",
                       "no picture format has the extension \"" + file.extension().string() + "\"");
    }
    constexpr std::size_t jpegLimit = 65500;  // beyond it libjpeg ends the process
    if (m_image->format_name() == std::string("jpeg") &&
        std::max(wanted.width, wanted.height) > jpegLimit)
      throw InputError(file.string(), "cannot be written",
                       "JPEG ends at 65500 px; use PNG or TIFF");
    if (!m_image->supports("ioproxy") || !m_image->set_ioproxy(&m_bytes) ||
        !m_image->open(file.string(), spec))
      fail();
    if (wanted.type == StoredType::uint8 || m_image->spec().format == m_type) return;
    (void)m_image.release();  // as in ~Output
    throw InputError(file.string(), "cannot be written",
                     "its format does not hold " + std::string(wanted.type == StoredType::real
                                                                   ? "floats; use .exr or .tif"
                                                                   : "16 bits; use .png or .tif"));
  }
  ~Output() override {
    // Leaks a cancelled writer, because closing a file without all of its rows prints on stderr.
    if (!m_isFinished) (void)m_image.release();
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  void write(const StoredRows& values, std::size_t rows) override {
    const int begin = m_row;
    m_row += int(rows);
    const void* first = std::visit([](const auto* at) -> const void* { return at; }, values);
    if (!m_image->write_scanlines(begin, m_row, 0, m_type, first)) fail();
  }

  void finish() override {
    m_isFinished = true;
    if (!m_image->close()) fail();
  }

 private:
  [[noreturn]] void fail() {
    throw InputError(m_file.string(), "cannot be written", asOneLine(m_image->geterror(), m_file));
  }

  fs::path m_file;
  Proxy m_bytes;
  OIIO::TypeDesc m_type;
  std::unique_ptr<OIIO::ImageOutput> m_image;
  int m_row = 0;
  bool m_isFinished = false;
};

}  // namespace

std::unique_ptr<ImageOutput> createByOpenImageIo(const fs::path& file, const ImageSpec& spec,
                                                 ByteOutput& bytes) {
  return std::make_unique<Output>(file, spec, bytes);
}

}  // namespace hogelscope
