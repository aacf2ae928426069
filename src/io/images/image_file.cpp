// SPDX-License-Identifier: BSD-3-Clause
// Input of image files: PNG by libspng, PGX and raw YUV by this program, others by codecs().
#include "io/images/image_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "io/images/big_tiff.h"
#include "io/images/pgx_rows.h"
#include "io/images/picture_input.h"
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

}  // namespace

ImageFile::ImageFile(const fs::path& file, const YuvParams& yuv) : m_file(file), m_yuv(yuv) {
  checkIsFile(file);
  m_reader = YuvRows::isYuv(file)   ? Reader::yuv
             : PngRows::isPng(file) ? Reader::png
             : PgxRows::isPgx(file) ? Reader::pgx
                                    : Reader::codecs;
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
      m_input = openPicture(m_file);
      m_facts = m_input->facts();
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

template <class T>
void ImageFile::readAs(const Band& band, const Progress& progress) {
  constexpr std::size_t bandPixels = std::size_t{1} << 20;
  const std::size_t tileRows = m_input->tileRows();
  const std::size_t rows = (bandPixels / width() / tileRows + 1) * tileRows;
  std::vector<T> values;
  for (std::size_t first = 0; first < height(); first += rows) {
    reportProgress(progress, double(first) / double(height()));
    const std::size_t count = std::min(rows, height() - first);
    values.resize(3 * width() * count);
    m_input->read(std::size_t(m_frame), first, count, values.data());
    if constexpr (std::is_same_v<T, float>) refuseNotANumber(values, width(), first, m_file);
    band(first, count, StoredRows(values.data()));
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

/// Reads row by row with PngRows, PgxRows or YuvRows.
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
