// SPDX-License-Identifier: BSD-3-Clause
// Picture files, through OpenImageIO.
#include "io/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/error.h"
#include "core/report.h"
#include "io/atomic_file.h"
#include "io/png_rows.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

template <class T>
constexpr OIIO::TypeDesc::BASETYPE baseType() {
  if constexpr (std::is_same_v<T, std::uint8_t>) return OIIO::TypeDesc::UINT8;
  if constexpr (std::is_same_v<T, std::uint16_t>) return OIIO::TypeDesc::UINT16;
  return OIIO::TypeDesc::FLOAT;
}

/// OpenImageIO's message on one line, without the file's name, which our line has already.
std::string oneLine(std::string text, const fs::path& file) {
  for (const std::string& noise : {"\"" + file.string() + "\"", "'" + file.string() + "'"})
    if (const std::size_t at = text.find(noise); at != std::string::npos)
      text.replace(at, noise.size(), "it");
  text = text.substr(0, text.find('\n'));  // the rest says it again
  if (text.ends_with(" (it)")) text.resize(text.size() - 5);
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text.empty() ? "unknown reason" : text;
}

/// libpng and libjpeg write to stderr what OpenImageIO tells us anyway; our line is to stand alone.
/// For the whole process: one thread at a time reads pictures here.
class QuietLibraries {
 public:
  QuietLibraries() : m_stderr(::dup(STDERR_FILENO)) {
    const int nowhere = m_stderr < 0 ? -1 : ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) ::close(nowhere);
  }
  QuietLibraries(const QuietLibraries&) = delete;
  QuietLibraries& operator=(const QuietLibraries&) = delete;
  ~QuietLibraries() {
    if (m_stderr < 0) return;
    ::dup2(m_stderr, STDERR_FILENO);
    ::close(m_stderr);
  }

 private:
  int m_stderr;
};

void refuseNotANumber(std::span<const float> values, std::size_t width, std::size_t firstRow,
                      const fs::path& file) {
  const auto bad =
      std::find_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); });
  if (bad == values.end()) return;
  const std::size_t pixel = std::size_t(bad - values.begin()) / 3;
  throw InputError(file.string(),
                   "pixel (" + std::to_string(pixel % width) + ", " +
                       std::to_string(firstRow + pixel / width) + ")",
                   std::isnan(*bad) ? "is not a number" : "is infinite");
}

}  // namespace

std::size_t machineMemory() {
  return std::size_t(::sysconf(_SC_PHYS_PAGES)) * std::size_t(::sysconf(_SC_PAGESIZE));
}

void checkFits(std::size_t bytes, const fs::path& file) {
  if (double(bytes) > 0.9 * double(machineMemory()))
    throw InputError(
        file.string(), "size",
        "needs " + bytesText(bytes) + " of memory, this machine has " + bytesText(machineMemory()));
}

struct ImageFile::Input {
  std::unique_ptr<OIIO::ImageInput> image;
  OIIO::ImageSpec spec;
};

ImageFile::ImageFile(const fs::path& file) : m_file(file), m_input(std::make_unique<Input>()) {
  std::error_code error;
  if (!fs::exists(file, error)) throw InputError(file.string(), "", "there is no such file");
  if (fs::is_directory(file, error))
    throw InputError(file.string(), "",
                     "is a folder, not a picture; a folder has layout \"views\"");
  if (!fs::is_regular_file(file, error))
    throw InputError(file.string(), "", "is a device or a pipe, not a picture file");
  {
    const QuietLibraries quiet;
    m_input->image = OIIO::ImageInput::open(file.string());
  }
  if (!m_input->image)
    throw InputError(file.string(), "cannot be read as a picture", oneLine(OIIO::geterror(), file));
  m_input->spec = m_input->image->spec();
  const OIIO::ImageSpec& spec = m_input->spec;
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1 || spec.deep)
    throw InputError(file.string(), "", "is not a flat picture with pixels");
}

ImageFile::~ImageFile() = default;
ImageFile::ImageFile(ImageFile&&) noexcept = default;

std::size_t ImageFile::width() const {
  return std::size_t(m_input->spec.width);
}
std::size_t ImageFile::height() const {
  return std::size_t(m_input->spec.height);
}
int ImageFile::channels() const {
  return m_input->spec.nchannels;
}
std::string ImageFile::format() const {
  return m_input->image->format_name();
}

StoredType ImageFile::type() const {
  switch (m_input->spec.format.basetype) {
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::INT8:
      return StoredType::uint8;
    case OIIO::TypeDesc::UINT16:
    case OIIO::TypeDesc::INT16:
      return StoredType::uint16;
    default:
      return StoredType::real;
  }
}

template <class T>
std::vector<T> ImageFile::readRows(std::size_t first, std::size_t rows) {
  OIIO::ImageInput& image = *m_input->image;
  const OIIO::ImageSpec& spec = m_input->spec;
  // Readers multiply the colours by alpha. OpenImageIO 2.4's TIFF reader wants to be asked for
  // alpha to do so with scanlines, and does it twice if it is asked with tiles.
  const bool isAsked = spec.tile_width == 0;
  const bool hasAlpha = isAsked && (spec.alpha_channel == 1 || spec.alpha_channel == 3);
  const int used = hasAlpha ? spec.alpha_channel + 1 : channels() < 3 ? 1 : 3;
  const auto stored = std::size_t(used);
  std::vector<T> read(stored * width() * rows);
  const QuietLibraries quiet;
  const int begin = spec.y + int(first);
  const int end = begin + int(rows);
  const auto stride = OIIO::stride_t(stored * sizeof(T));
  const bool isRead =
      spec.tile_width > 0
          ? image.read_tiles(0, 0, spec.x, spec.x + spec.width, begin, end, spec.z, spec.z + 1, 0,
                             used, baseType<T>(), read.data(), stride)
          : image.read_scanlines(0, 0, begin, end, spec.z, 0, used, baseType<T>(), read.data(),
                                 stride);
  // Some readers fill the rest of a truncated file and only leave a message.
  if (!isRead || image.has_error())
    throw InputError(m_file.string(), "is damaged", oneLine(image.geterror(), m_file));
  std::vector<T> values(3 * width() * rows);
  for (std::size_t p = 0; p < width() * rows; ++p)
    for (std::size_t c = 0; c < 3; ++c) values[3 * p + c] = read[stored * p + (stored < 3 ? 0 : c)];
  if constexpr (std::is_same_v<T, float>) refuseNotANumber(values, width(), first, m_file);
  return values;
}

template <class T>
void ImageFile::readAs(const Band& band, const Progress& progress) {
  constexpr std::size_t bandPixels = std::size_t{1} << 20;
  const auto tileRows = std::size_t(std::max(m_input->spec.tile_height, 1));
  const std::size_t rows = (bandPixels / width() / tileRows + 1) * tileRows;
  for (std::size_t first = 0; first < height(); first += rows) {
    advance(progress, double(first) / double(height()));
    const std::size_t count = std::min(rows, height() - first);
    band(first, count, StoredRows(readRows<T>(first, count).data()));
  }
}

namespace {

void readPlainPng(PngRows& png, std::size_t width, std::size_t height, const ImageFile::Band& band,
                  const Progress& progress) {
  std::vector<std::uint8_t> row(3 * width);
  for (std::size_t y = 0; y < height; ++y) {
    advance(progress, double(y) / double(height));
    png.next(row);
    band(y, 1, row.data());
  }
}

}  // namespace

void ImageFile::read(StoredType type, const Band& band, const Progress& progress) {
  if (type == StoredType::uint8)
    if (const auto png = PngRows::open(m_file))
      return readPlainPng(*png, width(), height(), band, progress);
  switch (type) {
    case StoredType::uint8:
      return readAs<std::uint8_t>(band, progress);
    case StoredType::uint16:
      return readAs<std::uint16_t>(band, progress);
    default:
      return readAs<float>(band, progress);
  }
}

namespace {

/// Where OpenImageIO's writers put their bytes: some of them do not notice that a disk is full.
class CheckedFile : public OIIO::Filesystem::IOProxy {
 public:
  explicit CheckedFile(const fs::path& path)
      : IOProxy(path.string(), Mode::Write), m_file(std::fopen(path.c_str(), "wb+")) {
    if (m_file == nullptr) m_error = errno;
  }
  ~CheckedFile() override { CheckedFile::close(); }

  [[nodiscard]] const char* proxytype() const override { return "checked file"; }
  bool seek(int64_t offset) override {
    m_pos = offset;
    return m_file != nullptr && ::fseeko(m_file, offset, SEEK_SET) == 0;
  }
  std::size_t write(const void* data, std::size_t size) override {
    const std::size_t written = m_file == nullptr ? 0 : std::fwrite(data, 1, size, m_file);
    if (written < size && m_error == 0) m_error = errno;
    m_pos += int64_t(written);
    // What is lost is told at the end: libjpeg and libpng would end the process here.
    return size;
  }
  std::size_t read(void* data, std::size_t size) override {
    return m_file == nullptr ? 0 : std::fread(data, 1, size, m_file);
  }
  [[nodiscard]] std::size_t size() const override {
    const auto here = ::ftello(m_file);
    ::fseeko(m_file, 0, SEEK_END);
    const auto end = ::ftello(m_file);
    ::fseeko(m_file, here, SEEK_SET);
    return std::size_t(end);
  }
  void flush() const override {}
  void close() override {
    if (m_file != nullptr && std::fclose(m_file) != 0 && m_error == 0) m_error = errno;
    m_file = nullptr;
  }
  /// errno of the first failure, or 0; after close.
  [[nodiscard]] int error() const { return m_error; }

 private:
  std::FILE* m_file;
  int m_error = 0;
};

InputError cannotWrite(const fs::path& file, int error) {
  return {file.string(), "cannot be written", std::strerror(error)};
}

}  // namespace

/// A picture on its way to the disk.
struct ImageRowWriter::Output {
  AtomicFile atomic;
  fs::path file;
  CheckedFile bytes;
  std::unique_ptr<OIIO::ImageOutput> image;
  int row = 0;

  Output(const fs::path& path, OIIO::ImageSpec spec)
      : atomic(path), file(path), bytes(atomic.temporary()) {
    spec.attribute("DateTime", "");  // the same content is the same file: no clock in it
    image = OIIO::ImageOutput::create(path.string());
    if (!image)
      throw InputError(path.string(), "cannot be written",
                       "no picture format has the extension \"" + path.extension().string() + "\"");
    // libjpeg's own handler ends the process beyond this.
    constexpr int jpegLimit = 65500;
    if (std::string(image->format_name()) == "jpeg" &&
        std::max(spec.width, spec.height) > jpegLimit)
      throw InputError(path.string(), "cannot be written",
                       "JPEG ends at 65500 px; use PNG or TIFF");
    if (bytes.error() != 0) throw cannotWrite(file, bytes.error());
    if (!image->supports("ioproxy") || !image->set_ioproxy(&bytes) ||
        !image->open(atomic.temporary().string(), spec))
      fail();
  }

  ~Output() {
    // Closing a PNG without rows complains on stderr; a writer that was stopped is left alone.
    if (!isFinished) (void)image.release();
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  [[noreturn]] void fail() {
    throw InputError(file.string(), "cannot be written",
                     oneLine(image->geterror(), atomic.temporary()));
  }

  void finish() {
    isFinished = true;
    if (!image->close()) fail();
    bytes.close();
    if (bytes.error() != 0) throw cannotWrite(file, bytes.error());
    atomic.commit();
  }

  bool isFinished = false;
};

namespace {

template <class T>
void writeWhole(const fs::path& file, const OIIO::ImageSpec& spec, std::span<const T> values) {
  ImageRowWriter::Output output(file, spec);
  if (!output.image->write_image(baseType<T>(), values.data())) output.fail();
  output.finish();
}

}  // namespace

void writeImage(const fs::path& file, int width, int height, std::span<const std::uint8_t> rgb) {
  writeWhole(file, OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8), rgb);
}

void writeImage(const fs::path& file, int width, int height, std::span<const float> rgb) {
  const bool isExr = file.extension() == ".exr";
  const auto type = isExr ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT16;
  std::vector<float> unit(rgb.begin(), rgb.end());
  for (float& value : unit) value /= 255;
  writeWhole(file, OIIO::ImageSpec(width, height, 3, type), std::span<const float>(unit));
}

std::string encodedPng(int width, int height, std::span<const std::uint8_t> rgb) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto image = OIIO::ImageOutput::create("png");
  if (!image || !image->set_ioproxy(&memory) ||
      !image->open("memory.png", OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8)) ||
      !image->write_image(OIIO::TypeDesc::UINT8, rgb.data()) || !image->close())
    throw InputError("PNG", "cannot be made", image ? image->geterror() : "is not known here");
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

ImageRowWriter::ImageRowWriter(const fs::path& file, std::size_t width, std::size_t height) {
  constexpr std::size_t largest = 1U << 30U;
  if (width > largest || height > largest)
    throw InputError(file.string(), "size", "is beyond 2^30 px on a side");
  OIIO::ImageSpec spec(int(width), int(height), 3, OIIO::TypeDesc::UINT8);
  // PNG: on runs of one colour six times as fast as libpng's own choice of filters, at three times
  // the size; and the row of a large light field is a megabyte.
  constexpr int noFilter = 8;
  spec.attribute("png:compressionLevel", 3);
  spec.attribute("png:filter", noFilter);
  m_output = std::make_unique<Output>(file, spec);
}

ImageRowWriter::~ImageRowWriter() = default;

void ImageRowWriter::write(std::span<const std::uint8_t> row) {
  if (!m_output->image->write_scanline(m_output->row++, 0, OIIO::TypeDesc::UINT8, row.data()))
    m_output->fail();
}

void ImageRowWriter::finish() {
  m_output->finish();
}

}  // namespace hogelscope
