// SPDX-License-Identifier: BSD-3-Clause
// Rows of a PNG through libspng.
#include "io/images/png_rows.h"

#include <spng.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <limits>

#include "core/base/error.h"
#include "io/files/random_access_file.h"
#include "io/files/system_limits.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Further bytes reveal a damaged transfer, which libpng would print on stderr.
constexpr std::array<unsigned char, 4> signature{0x89, 'P', 'N', 'G'};

/// Deflate's limit: two bits, a length and a distance, encode at most 258 bytes.
constexpr double mostBytesPerByte = 1032;

bool hasColourAndAlpha(const spng_ihdr& header) {
  return header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ||
         header.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
}

bool isGrey(const spng_ihdr& header) {
  return header.color_type == SPNG_COLOR_TYPE_GRAYSCALE ||
         header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA;
}

/// Multiplies colours by alpha, for a black background.
template <class T>
void blend(const T* rgba, std::vector<T>& rgb) {
  constexpr std::uint32_t opaque = std::numeric_limits<T>::max();
  for (std::size_t k = 0; k < rgb.size(); ++k) {
    const std::size_t at = k / 3 * 4;
    rgb[k] = T(std::uint32_t(rgba[at + k % 3]) * rgba[at + 3] / opaque);
  }
}

}  // namespace

bool PngRows::isPng(const fs::path& path) {
  const RandomAccessFile file(path);
  std::array<unsigned char, signature.size()> found{};
  return file.readSome(0, std::as_writable_bytes(std::span(found))) == found.size() &&
         found == signature;
}

PngRows::PngRows(const fs::path& file)
    : m_file(file),
      m_input(std::fopen(file.c_str(), "rbe"), &std::fclose),
      m_context(spng_ctx_new(0), &spng_ctx_free) {
  if (!m_input) throw InputError(file.string(), "cannot be read", std::strerror(errno));
  if (!m_context) throw std::bad_alloc();
  constexpr std::size_t chunkBytes = std::size_t{16} << 20U;  // for texts and similar chunks
  check(spng_set_image_limits(m_context.get(), INT32_MAX, INT32_MAX));
  check(spng_set_chunk_limits(m_context.get(), chunkBytes, chunkBytes));
  check(spng_set_png_file(m_context.get(), m_input.get()), "cannot be read as a picture");
  readHeader();
}

void PngRows::readHeader() {
  spng_ihdr header{};
  spng_trns transparency{};
  check(spng_get_ihdr(m_context.get(), &header), "cannot be read as a picture");
  m_hasAlpha = hasColourAndAlpha(header) || spng_get_trns(m_context.get(), &transparency) == 0;
  m_isInterlaced = header.interlace_method != SPNG_INTERLACE_NONE;
  m_width = header.width;
  m_height = header.height;
  m_channels = (isGrey(header) ? 1 : 3) + (m_hasAlpha ? 1 : 0);
  m_type = header.bit_depth == 16 ? StoredType::uint16 : StoredType::uint8;
  const bool is16 = m_type == StoredType::uint16;
  m_format = is16 ? SPNG_FMT_RGBA16 : m_hasAlpha ? SPNG_FMT_RGBA8 : SPNG_FMT_RGB8;
  m_rowBytes = m_width * (is16 ? 8 : m_hasAlpha ? 4 : 3);
  // Checked before anything of this size is allocated.
  const double stored = double(m_width) * double(m_height) * header.bit_depth / 8;
  if (stored > mostBytesPerByte * double(RandomAccessFile(m_file).size()))
    throw InputError(
        m_file.string(), "is damaged",
        "it is too short for " + std::to_string(m_width) + "×" + std::to_string(m_height) + " px");
}

void PngRows::begin() {
  const int flags = m_hasAlpha ? SPNG_DECODE_TRNS : 0;
  if (!m_isInterlaced) {
    m_decoded.resize(m_rowBytes);
    return check(
        spng_decode_image(m_context.get(), nullptr, 0, m_format, flags | SPNG_DECODE_PROGRESSIVE));
  }
  checkFits(m_rowBytes * m_height, m_file, ", all of it, since it is interlaced");
  m_decoded.resize(m_rowBytes * m_height);
  check(spng_decode_image(m_context.get(), m_decoded.data(), m_decoded.size(), m_format, flags));
}

const std::byte* PngRows::nextRow() {
  if (m_row == 0) begin();
  const std::size_t row = m_row++;
  if (m_isInterlaced) return &m_decoded[row * m_rowBytes];
  const int status = spng_decode_row(m_context.get(), m_decoded.data(), m_rowBytes);
  if (status != SPNG_EOI) check(status);
  return m_decoded.data();
}

std::span<const std::uint8_t> PngRows::next8() {
  const auto* row = reinterpret_cast<const std::uint8_t*>(nextRow());
  if (!m_hasAlpha) return {row, m_rowBytes};
  m_rgb8.resize(3 * m_width);
  blend(row, m_rgb8);
  return m_rgb8;
}

std::span<const std::uint16_t> PngRows::next16() {
  m_rgb16.resize(3 * m_width);
  blend(reinterpret_cast<const std::uint16_t*>(nextRow()), m_rgb16);
  return m_rgb16;
}

void PngRows::check(int status, const std::string& what) const {
  if (status == 0) return;
  if (m_row == 0) throw InputError(m_file.string(), what, spng_strerror(status));
  throw InputError(m_file.string(), "row " + std::to_string(m_row - 1),
                   "is damaged: " + std::string(spng_strerror(status)));
}

}  // namespace hogelscope
