// SPDX-License-Identifier: BSD-3-Clause
// Reads image files: PNG by libspng, PGX and raw YUV by this program, others by codecs().
#include "io/images/image_file.h"

#include <OpenImageIO/oiioversion.h>
#include <algorithm>
#include <cmath>
#include <opencv2/core/utility.hpp>

#include "core/base/error.h"
#include "io/images/image_inputs.h"
#include "io/images/matlab_file.h"
#include "io/images/other_formats.h"
#include "io/images/picture_facts.h"

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

/// Opens a picture, and says which format a file has that is none.
std::unique_ptr<ImageInput> openNamed(const fs::path& file) {
  try {
    return openPicture(file);
  } catch (const InputError&) {
    refuseMatlab(file);
    const std::string advice = adviceOnFormat(file);
    if (advice.empty()) throw;
    throw InputError(file.string(), "", advice);
  }
}

/// Whether more than half of the values in the middle of a picture are above white.
bool isMostlyAboveWhite(ImageInput& input) {
  const ImageFacts& facts = input.facts();
  const std::size_t band = facts.height / 2 / facts.bandRows * facts.bandRows;
  const std::size_t rows = std::min(facts.bandRows, facts.height - band);
  std::vector<float> values(3 * facts.width * rows);
  try {
    input.read(facts.frames / 2, band, rows, values.data());
  } catch (const InputError&) {
    return false;  // said by whoever reads all of it
  }
  const auto above = std::ranges::count_if(values, [](float value) { return value > 1; });
  return std::size_t(above) > values.size() / 2;
}

}  // namespace

ImageFile::ImageFile(const fs::path& file, const YuvParams& yuv) : m_file(file) {
  checkIsFile(file);
  m_input = openYuv(file, yuv);
  if (!m_input) m_input = openPng(file);
  if (!m_input) m_input = openPgx(file);
  if (!m_input) m_input = openNamed(file);
  m_input = asFileSays(file, std::move(m_input));
}

ImageFile::ImageFile(fs::path file, std::unique_ptr<ImageInput> input)
    : m_file(std::move(file)), m_input(std::move(input)) {}

std::vector<std::string> ImageFile::notes() {
  std::vector<std::string> notes = m_input->facts().notes;
  if (type() == StoredType::real && isMostlyAboveWhite(*m_input))
    notes.emplace_back("has mostly values above 1, which is white: divide them, such as by 255");
  return notes;
}

std::vector<std::string> ImageFile::notesOfOne() {
  std::vector<std::string> lines = notes();
  if (frames() > 1 && !isVideo())
    lines.push_back(
        "has " + std::to_string(frames()) +
        " pictures, of which one is read; the file by itself, as layout \"views\", has all");
  return lines;
}

template <class T>
void ImageFile::readAs(const Band& band, const Progress& progress) {
  const std::size_t rows = m_input->facts().bandRows;
  std::vector<T> values;
  for (std::size_t first = 0; first < height(); first += rows) {
    reportProgress(progress, double(first) / double(height()));
    const std::size_t count = std::min(rows, height() - first);
    values.resize(3 * width() * count);
    m_input->read(m_frame, first, count, values.data());
    if constexpr (std::is_same_v<T, float>)
      if (this->type() == StoredType::real) refuseNotANumber(values, width(), first, m_file);
    band(first, count, StoredRows(values.data()));
  }
}

void ImageFile::read(StoredType type, const Band& band, const Progress& progress) {
  withStoredType(type, [&]<class T>(T) { readAs<T>(band, progress); });
}

void ImageFile::readRows(const Row& row, const Progress& progress) {
  const auto hand = [&](std::size_t first, std::size_t rows, const StoredRows& values) {
    const float* const rgb = std::get<const float*>(values);
    for (std::size_t k = 0; k < rows; ++k) row(first + k, rgb + 3 * k * width());
  };
  read(StoredType::real, hand, progress);
}

std::string openCvVersion() {
  return cv::getVersionString();
}

std::string openImageIoVersion() {
  return OIIO_VERSION_STRING;
}

}  // namespace hogelscope
