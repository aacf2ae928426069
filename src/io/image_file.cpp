// SPDX-License-Identifier: BSD-3-Clause
// Picture files read through OpenImageIO; plain PNGs by libspng.
#include "io/image_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "io/open_image_io.h"
#include "io/png_rows.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

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

}  // namespace hogelscope
