// SPDX-License-Identifier: BSD-3-Clause
// Image files read through OpenImageIO; PNGs by libspng, PGX and raw YUV by ourselves.
#include "io/images/image_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "core/base/error.h"
#include "core/optics/image.h"
#include "io/images/big_tiff.h"
#include "io/images/exr_header.h"
#include "io/images/library_versions.h"
#include "io/images/open_image_io.h"
#include "io/images/pgx_rows.h"
#include "io/images/png_rows.h"
#include "io/images/yuv_rows.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

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

/// Throws InputError if not even an image of one colour could be so small.
void checkSize(const OIIO::ImageSpec& spec, const fs::path& file) {
  constexpr double mostBytesPerByte = 1 << 17;
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (!error && double(spec.image_bytes(true)) > mostBytesPerByte * double(bytes))
    throw InputError(file.string(), "is damaged",
                     "its " + std::to_string(bytes) + " bytes cannot be " +
                         std::to_string(spec.width) + "×" + std::to_string(spec.height) + " px");
}

void checkIsFile(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found)
    throw InputError(file.string(), "", "there is no such file");
  if (error) throw InputError(file.string(), "cannot be read", error.message());
  if (fs::is_directory(status))
    throw InputError(file.string(), "",
                     "is a folder, not a picture; a folder has layout \"views\"");
  if (!fs::is_regular_file(status))
    throw InputError(file.string(), "", "is a device or a pipe, not a picture file");
}

StoredType typeOf(const OIIO::ImageSpec& spec) {
  switch (spec.format.basetype) {
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

/// The largest value of a PNM file, by its header: its third number. 0 where there is none.
int largestPnmValue(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  in.ignore(2);  // "P6"
  int value = 0;
  for (int number = 0; number < 3; ++number) {
    while (in >> std::ws && in.peek() == '#')
      in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    if (!(in >> value)) return 0;
  }
  return value;
}

/// The bits of 16-bit values: readers spread fewer bits over all 16, and OpenImageIO 2.4's of PNM
/// does not say so.
int bitsOf(const OIIO::ImageSpec& spec, const std::string& format, const fs::path& file) {
  if (format != "pnm") return std::clamp(spec.get_int_attribute("oiio:BitsPerSample", 16), 8, 16);
  const int largest = largestPnmValue(file);
  for (int bits = 9; bits < 16; ++bits)
    if (largest == largestValue(bits)) return bits;
  return 16;
}

/// A bare codestream, or one in boxes.
bool isJpegXl(const fs::path& file) {
  constexpr std::string_view codestream("\xff\x0a");
  constexpr std::string_view box("\0\0\0\x0cJXL \r\n\x87\n", 12);
  std::string begin(box.size(), '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(begin.data(), std::streamsize(begin.size()));
  begin.resize(std::size_t(in.gcount()));
  return begin.starts_with(codestream) || begin == box;
}

/// Throws InputError for a file that OpenImageIO cannot open.
[[noreturn]] void refuse(const fs::path& file) {
  const std::string why = asOneLine(OIIO::geterror(), file);  // unless asked for, it is printed
  if (isJpegXl(file))
    throw InputError(file.string(), "",
                     "is JPEG XL, which OpenImageIO " + openImageIoVersion() +
                         " does not read; convert it, such as by djxl NAME.jxl NAME.png");
  throw InputError(file.string(), "cannot be read as a picture", why);
}

}  // namespace

struct ImageFile::Input {
  std::unique_ptr<OIIO::ImageInput> image;
  OIIO::ImageSpec spec;
};

ImageFile::ImageFile(const fs::path& file, const YuvParams& yuv) : m_file(file), m_yuv(yuv) {
  checkIsFile(file);
  m_reader = YuvRows::isYuv(file)   ? Reader::yuv
             : PngRows::isPng(file) ? Reader::png
             : PgxRows::isPgx(file) ? Reader::pgx
                                    : Reader::openImageIo;
  switch (m_reader) {
    case Reader::yuv:
      take(YuvRows(file, yuv), "yuv");
      break;
    case Reader::png:
      take(PngRows(file), "png");
      break;
    case Reader::pgx:
      take(PgxRows(file), "pgx");
      break;
    default:
      openOther();
  }
}

ImageFile::~ImageFile() = default;
ImageFile::ImageFile(ImageFile&&) noexcept = default;

template <class Rows>
void ImageFile::take(const Rows& rows, const char* format) {
  m_facts = {rows.width(),
             rows.height(),
             rows.channels(),
             rows.type(),
             std::max(rows.bits(), 8),
             format,
             1};
}

void ImageFile::openOther() {
  checkExrHeader(m_file);
  m_input = std::make_unique<Input>();
  m_input->image = OIIO::ImageInput::open(m_file.string());
  if (!m_input->image) refuse(m_file);
  m_input->spec = m_input->image->spec();
  const OIIO::ImageSpec& spec = m_input->spec;
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1 || spec.deep)
    throw InputError(m_file.string(), "", "is not a flat picture with pixels");
  checkSize(spec, m_file);
  const StoredType type = typeOf(spec);
  const std::string format = m_input->image->format_name();
  const int bits = type == StoredType::uint8    ? 8
                   : type == StoredType::uint16 ? bitsOf(spec, format, m_file)
                                                : 16;
  const bool isVideo = spec.get_int_attribute("oiio:Movie") != 0;
  const int frames = isVideo ? spec.get_int_attribute("oiio:subimages", 1) : 1;
  m_facts = {
      std::size_t(spec.width),         std::size_t(spec.height), spec.nchannels, type, bits, format,
      std::size_t(std::max(frames, 1))};
}

template <class T>
std::vector<T> ImageFile::readRows(std::size_t first, std::size_t rows) {
  OIIO::ImageInput& image = *m_input->image;
  const OIIO::ImageSpec& spec = m_input->spec;
  // Readers multiply the colours by alpha. OpenImageIO 2.4's TIFF reader must be asked for
  // alpha to do so with scanlines, and does it twice if it is asked with tiles.
  const bool isAsked = spec.tile_width == 0;
  const bool hasAlpha = isAsked && (spec.alpha_channel == 1 || spec.alpha_channel == 3);
  const int used = hasAlpha ? spec.alpha_channel + 1 : channels() < 3 ? 1 : 3;
  const auto stored = std::size_t(used);
  std::vector<T> read(stored * width() * rows);
  const int begin = spec.y + int(first);
  const int end = begin + int(rows);
  const auto stride = OIIO::stride_t(stored * sizeof(T));
  const bool isRead =
      spec.tile_width > 0
          ? image.read_tiles(m_frame, 0, spec.x, spec.x + spec.width, begin, end, spec.z,
                             spec.z + 1, 0, used, baseType<T>(), read.data(), stride)
          : image.read_scanlines(m_frame, 0, begin, end, spec.z, 0, used, baseType<T>(),
                                 read.data(), stride);
  // Some readers fill the rest of a truncated file and only set a message.
  if (!isRead || image.has_error())
    throw InputError(m_file.string(), "is damaged", asOneLine(image.geterror(), m_file));
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
    reportProgress(progress, double(first) / double(height()));
    const std::size_t count = std::min(rows, height() - first);
    band(first, count, StoredRows(readRows<T>(first, count).data()));
  }
}

namespace {

template <class To, class From>
To converted(From value) {
  if constexpr (std::is_same_v<To, float>)
    return float(value) / std::numeric_limits<From>::max();
  else if constexpr (sizeof(To) > sizeof(From))
    return To(value * 257);  // 255 becomes 65535
  else
    return To((value + 128U) / 257U);
}

/// Reads one row after the other: PngRows, PgxRows, YuvRows.
template <class T, class Rows>
void readRowByRow(Rows image, const ImageFile::Band& band, const Progress& progress) {
  std::vector<T> row(3 * image.width());
  const auto hand = [&](std::size_t y, const auto& values) {
    if constexpr (std::is_same_v<decltype(values.data()), const T*>) {
      band(y, 1, StoredRows(values.data()));
    } else {
      std::transform(values.begin(), values.end(), row.begin(),
                     [](auto value) { return converted<T>(value); });
      band(y, 1, StoredRows(row.data()));
    }
  };
  for (std::size_t y = 0; y < image.height(); ++y) {
    reportProgress(progress, double(y) / double(image.height()));
    if (image.type() == StoredType::uint8)
      hand(y, image.next8());
    else
      hand(y, image.next16());
  }
}

}  // namespace

void ImageFile::read(StoredType type, const Band& band, const Progress& progress) {
  withStoredType(type, [&](auto value) {
    using T = decltype(value);
    switch (m_reader) {
      case Reader::yuv:
        return readRowByRow<T>(YuvRows(m_file, m_yuv), band, progress);
      case Reader::png:
        return readRowByRow<T>(PngRows(m_file), band, progress);
      case Reader::pgx:
        return readRowByRow<T>(PgxRows(m_file), band, progress);
      default:
        return readAs<T>(band, progress);
    }
  });
}

}  // namespace hogelscope
