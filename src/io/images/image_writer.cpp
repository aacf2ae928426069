// SPDX-License-Identifier: BSD-3-Clause
// Image files written through OpenImageIO.
#include "io/images/image_writer.h"

#include <OpenImageIO/filesystem.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "io/files/atomic_file.h"
#include "io/images/open_image_io.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// The output of OpenImageIO's writers. Some of them do not notice that a disk is full, and libjpeg
/// and libpng would end the process: so every write reports success, and the first error is kept
/// until close().
class CheckedFile : public OIIO::Filesystem::IOProxy {
 public:
  /// Writes to a copy of `descriptor`.
  CheckedFile(const fs::path& path, int descriptor) : IOProxy(path.string(), Mode::Write) {
    const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
    if (copy >= 0) m_file = ::fdopen(copy, "wb+");
    check(m_file != nullptr);
    if (m_file == nullptr && copy >= 0) ::close(copy);
  }
  ~CheckedFile() override { CheckedFile::close(); }

  [[nodiscard]] const char* proxytype() const override { return "checked file"; }
  bool seek(int64_t offset) override {
    m_pos = offset;
    check(m_file != nullptr && ::fseeko(m_file, offset, SEEK_SET) == 0);
    return true;
  }
  std::size_t write(const void* data, std::size_t size) override {
    if (size == 0) return 0;  // the data of WebP's last write may be null
    check(m_file != nullptr && std::fwrite(data, 1, size, m_file) == size);
    m_pos += int64_t(size);
    m_end = std::max(m_end, std::size_t(m_pos));
    return size;
  }
  std::size_t read(void* data, std::size_t size) override {
    return m_file == nullptr ? 0 : std::fread(data, 1, size, m_file);
  }
  [[nodiscard]] std::size_t size() const override { return m_end; }
  void flush() const override { check(m_file != nullptr && std::fflush(m_file) == 0); }
  void close() override {
    if (m_file == nullptr) return;
    struct stat status {};
    check(std::fflush(m_file) == 0);
    if (check(::fstat(::fileno(m_file), &status) == 0) && std::size_t(status.st_size) != m_end)
      m_error = m_error == 0 ? EIO : m_error;
    check(std::fclose(std::exchange(m_file, nullptr)) == 0);
  }
  /// errno of the first failure, or 0; complete after close().
  [[nodiscard]] int error() const { return m_error; }

 private:
  bool check(bool isDone) const {
    if (!isDone && m_error == 0) m_error = errno != 0 ? errno : EIO;
    return isDone;
  }

  std::FILE* m_file = nullptr;
  std::size_t m_end = 0;
  mutable int m_error = 0;  ///< flush() is const in OpenImageIO
};

InputError cannotWrite(const fs::path& file, int error) {
  return {file.string(), "cannot be written", std::strerror(error)};
}

}  // namespace

/// An image file that is being written.
struct ImageRowWriter::Output {
  AtomicFile atomic;
  fs::path file;
  CheckedFile bytes;
  std::unique_ptr<OIIO::ImageOutput> image;
  int row = 0;

  Output(const fs::path& path, OIIO::ImageSpec spec)
      : atomic(path), file(path), bytes(path, atomic.descriptor()) {
    spec.attribute("DateTime", "");  // the same content is the same file: no clock in it
    image = OIIO::ImageOutput::create(path.string());
    if (!image)
      throw InputError(path.string(), "cannot be written",
                       "no picture format has the extension \"" + path.extension().string() + "\"");
    refuseTooLarge(spec);
    if (bytes.error() != 0) throw cannotWrite(file, bytes.error());
    if (!image->supports("ioproxy") || !image->set_ioproxy(&bytes) ||
        !image->open(file.string(), spec))
      fail();
  }

  ~Output() {
    // Closing a PNG without rows complains on stderr; a cancelled writer is leaked.
    if (!isFinished) (void)image.release();
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Checks limits for which libjpeg would end the process and libpng write to stderr.
  void refuseTooLarge(const OIIO::ImageSpec& spec) const {
    constexpr int jpegLimit = 65500;
    constexpr int pngLimit = 1000000;
    const std::string format = image->format_name();
    const int side = std::max(spec.width, spec.height);
    if (format == "jpeg" && side > jpegLimit)
      throw InputError(file.string(), "cannot be written",
                       "JPEG ends at 65500 px; use PNG or TIFF");
    if (format == "png" && side > pngLimit)
      throw InputError(file.string(), "cannot be written", "PNG ends at 1000000 px; use TIFF");
  }

  [[noreturn]] void fail() {
    throw InputError(file.string(), "cannot be written", asOneLine(image->geterror(), file));
  }

  void close() {
    isFinished = true;
    if (!image->close()) fail();
    bytes.close();
    if (bytes.error() != 0) throw cannotWrite(file, bytes.error());
  }

  void finish() {
    close();
    atomic.commit();
  }

  bool isFinished = false;
};

namespace {

/// Writes as write_image() does, but can be cancelled between bands of rows.
template <class T>
bool writeRows(OIIO::ImageOutput& image, const T* values, const Progress& progress) {
  constexpr int band = 64;
  const int height = image.spec().height;
  const std::size_t row = std::size_t(image.spec().width) * std::size_t(image.spec().nchannels);
  for (int y = 0; y < height; y += band) {
    hearStop(progress);
    if (!image.write_scanlines(y, std::min(y + band, height), 0, baseType<T>(),
                               values + std::size_t(y) * row))
      return false;
  }
  return true;
}

template <class T>
void writeWhole(const fs::path& file, const OIIO::ImageSpec& spec, std::span<const T> values,
                const Progress& progress = {}) {
  ImageRowWriter::Output output(file, spec);
  if (!writeRows(*output.image, values.data(), progress)) output.fail();
  output.finish();
}

}  // namespace

void writeImage(const fs::path& file, int width, int height, std::span<const std::uint8_t> rgb,
                const Progress& progress) {
  writeWhole(file, OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8), rgb, progress);
}

void writeImage(const fs::path& file, int width, int height, std::span<const float> rgb) {
  const bool isExr = file.extension() == ".exr";
  const auto type = isExr ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT16;
  std::vector<float> unit(rgb.begin(), rgb.end());
  for (float& value : unit) value /= 255;
  writeWhole(file, OIIO::ImageSpec(width, height, 3, type), std::span<const float>(unit));
}

std::string encodedPng(int width, int height, std::span<const std::uint8_t> rgb,
                       const Progress& progress) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  auto image = OIIO::ImageOutput::create("png");
  try {
    if (!image || !image->set_ioproxy(&memory) ||
        !image->open("memory.png", OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8)) ||
        !writeRows(*image, rgb.data(), progress) || !image->close())
      throw InputError("PNG", "cannot be made", image ? image->geterror() : "is not known here");
  } catch (const Cancelled&) {
    (void)image.release();  // as in ~Output
    throw;
  }
  return {bytes.begin(), bytes.end()};
}

void writePlanes(const fs::path& file, int width, int height,
                 const std::vector<std::pair<std::string, std::vector<float>>>& planes) {
  OIIO::ImageSpec spec(width, height, int(planes.size()), OIIO::TypeDesc::FLOAT);
  std::vector<float> values(planes.size() * std::size_t(width) * std::size_t(height));
  for (std::size_t k = 0; k < planes.size(); ++k) {
    spec.channelnames[k] = planes[k].first;
    for (std::size_t at = 0; at < planes[k].second.size(); ++at)
      values[at * planes.size() + k] = planes[k].second[at];
  }
  writeWhole(file, spec, std::span<const float>(values));
}

void writeMask(const fs::path& file, int width, int height, std::span<const std::uint8_t> grey) {
  writeWhole(file, OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::UINT8), grey);
}

ImageRowWriter::ImageRowWriter(const fs::path& file, std::size_t width, std::size_t height,
                               StoredType type) {
  constexpr std::size_t largest = 1U << 30U;
  if (width > largest || height > largest)
    throw InputError(file.string(), "size", "is beyond 2^30 px on a side");
  static constexpr std::array types{OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16,
                                    OIIO::TypeDesc::FLOAT};
  OIIO::ImageSpec spec(int(width), int(height), 3, types[std::size_t(type)]);
  // PNG: on runs of one colour six times as fast as libpng's own choice of filters, at three times
  // the size; and the row of a large light field is a megabyte.
  constexpr int noFilter = 8;
  spec.attribute("png:compressionLevel", 3);
  spec.attribute("png:filter", noFilter);
  m_output = std::make_unique<Output>(file, spec);
  if (type != StoredType::uint8 && m_output->image->spec().format != spec.format)
    throw InputError(file.string(), "cannot be written",
                     "its format does not hold " + std::string(type == StoredType::real
                                                                   ? "floats; use .exr or .tif"
                                                                   : "16 bits; use .png or .tif"));
}

ImageRowWriter::~ImageRowWriter() = default;

void ImageRowWriter::write(const StoredRows& row) {
  const bool isWritten = std::visit(
      [this]<class T>(const T* values) {
        return m_output->image->write_scanline(m_output->row++, 0, baseType<T>(), values);
      },
      row);
  if (!isWritten) m_output->fail();
}

void ImageRowWriter::finish() {
  m_output->finish();
}

std::uintmax_t ImageRowWriter::discard() {
  m_output->close();
  return m_output->bytes.size();
}

}  // namespace hogelscope
