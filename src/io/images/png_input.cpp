// SPDX-License-Identifier: BSD-3-Clause
// Reads PNGs through libspng.
#include <spng.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <limits>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/random_access_file.h"
#include "io/files/system_limits.h"
#include "io/images/image_inputs.h"
#include "io/images/tiff_directories.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// The first bytes of a PNG. Those after them reveal a damaged transfer, which libpng would report
/// on stderr.
constexpr std::array<unsigned char, 4> signature{0x89, 'P', 'N', 'G'};

/// Deflate's limit: two bits, a length and a distance, stand for at most 258 bytes.
constexpr double mostBytesPerByte = 1032;

bool hasColourAndAlpha(const spng_ihdr& header) {
  return header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ||
         header.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
}

bool isGrey(const spng_ihdr& header) {
  return header.color_type == SPNG_COLOR_TYPE_GRAYSCALE ||
         header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA;
}

bool isPng(const fs::path& path) {
  const RandomAccessFile file(path);
  std::array<unsigned char, signature.size()> found{};
  return file.readSome(0, std::as_writable_bytes(std::span(found))) == found.size() &&
         found == signature;
}

std::uint32_t bigEndian(const std::uint8_t* bytes) {
  return std::uint32_t(bytes[0]) << 24U | std::uint32_t(bytes[1]) << 16U |
         std::uint32_t(bytes[2]) << 8U | bytes[3];
}

/// Returns the orientation of a chunk eXIf behind the pixels, where some programs add it; only the
/// last bytes are searched. It counts if chunks follow on from it up to the end.
int orientationAtEnd(const RandomAccessFile& file) {
  constexpr std::size_t most = 4096;
  const std::size_t bytes = std::min<std::uint64_t>(most, file.size());
  std::vector<std::uint8_t> end(bytes);
  end.resize(file.readSome(file.size() - bytes, std::as_writable_bytes(std::span(end))));
  constexpr std::string_view name("eXIf");
  constexpr std::size_t around = 12;  // length, name and checksum
  const auto at = std::search(end.begin(), end.end(), name.begin(), name.end());
  if (at == end.end() || at - end.begin() < 4) return 1;
  const auto chunk = std::size_t(at - end.begin()) - 4;
  std::size_t next = chunk;
  while (next + around <= end.size()) next += around + bigEndian(&end[next]);
  if (next != end.size()) return 1;
  const std::span content = std::span(end).subspan(chunk + 8, bigEndian(&end[chunk]));
  return exifOrientation(std::as_bytes(content));
}

class PngInput : public RowInput {
 public:
  explicit PngInput(fs::path file) : m_file(std::move(file)) {
    open();
    addWhatFileSays();
  }

 private:
  void readRow(std::size_t y, std::uint8_t* rgb) override {
    if (m_hasAlpha || m_isInterlaced) return copyRow(y, rgb);
    decodeRow(y, rgb);
  }
  void readRow(std::size_t y, std::uint16_t* rgb) override { copyRow(y, rgb); }

  /// Opens the file, also again, because rows can only be read from the top.
  void open() {
    m_context.reset(spng_ctx_new(0));
    m_input.reset(std::fopen(m_file.c_str(), "rbe"));
    m_row = 0;
    if (!m_input) throw InputError(m_file.string(), "cannot be read", std::strerror(errno));
    if (!m_context) throw std::bad_alloc();
    constexpr std::size_t chunkBytes = std::size_t{16} << 20U;  // of texts and the like
    check(spng_set_option(m_context.get(), SPNG_KEEP_UNKNOWN_CHUNKS, 1));
    check(spng_set_image_limits(m_context.get(), INT32_MAX, INT32_MAX));
    check(spng_set_chunk_limits(m_context.get(), chunkBytes, chunkBytes));
    check(spng_set_png_file(m_context.get(), m_input.get()), "cannot be read as a picture");
    readHeader();
  }

  void readHeader() {
    spng_ihdr header{};
    spng_trns transparency{};
    check(spng_get_ihdr(m_context.get(), &header), "cannot be read as a picture");
    m_hasAlpha = hasColourAndAlpha(header) || spng_get_trns(m_context.get(), &transparency) == 0;
    m_isInterlaced = header.interlace_method != SPNG_INTERLACE_NONE;
    const bool is16 = header.bit_depth == 16;
    m_facts.format = "png";
    m_facts.width = header.width;
    m_facts.height = header.height;
    m_facts.channels = (isGrey(header) ? 1 : 3) + (m_hasAlpha ? 1 : 0);
    m_facts.type = is16 ? StoredType::uint16 : StoredType::uint8;
    m_facts.bits = is16 ? 16 : 8;
    m_format = is16 ? SPNG_FMT_RGBA16 : m_hasAlpha ? SPNG_FMT_RGBA8 : SPNG_FMT_RGB8;
    m_rowBytes = m_facts.width * (is16 ? 8 : m_hasAlpha ? 4 : 3);
    // Before anything of this size is allocated.
    const double stored = double(header.width) * header.height * header.bit_depth / 8;
    if (stored > mostBytesPerByte * double(RandomAccessFile(m_file).size()))
      throw InputError(m_file.string(), "is damaged",
                       "it is too short for " + pairText(header.width, header.height) + " px");
  }

  /// Adds EXIF's orientation, and the number of pictures of an animation (APNG).
  void addWhatFileSays() {
    spng_exif exif{};
    if (spng_get_exif(m_context.get(), &exif) == 0)
      m_facts.orientation = exifOrientation(std::as_bytes(std::span(exif.data, exif.length)));
    else
      m_facts.orientation = orientationAtEnd(RandomAccessFile(m_file));
    std::uint32_t count = 0;
    if (spng_get_unknown_chunks(m_context.get(), nullptr, &count) != 0 || count == 0) return;
    std::vector<spng_unknown_chunk> chunks(count);
    if (spng_get_unknown_chunks(m_context.get(), chunks.data(), &count) != 0) return;
    for (const spng_unknown_chunk& chunk : chunks)
      if (std::memcmp(chunk.type, "acTL", 4) == 0 && chunk.length >= 4)
        m_facts.pictures =
            std::max<std::size_t>(1, bigEndian(static_cast<std::uint8_t*>(chunk.data)));
  }

  void begin() {
    const int flags = m_hasAlpha ? SPNG_DECODE_TRNS : 0;
    if (!m_isInterlaced)
      return check(spng_decode_image(m_context.get(), nullptr, 0, m_format,
                                     flags | SPNG_DECODE_PROGRESSIVE));
    checkFits(double(m_rowBytes * m_facts.height), m_file,
              "it is interlaced, so all of it is read at once: save it without, or allow more");
    m_decoded.resize(m_rowBytes * m_facts.height);
    check(spng_decode_image(m_context.get(), m_decoded.data(), m_decoded.size(), m_format, flags));
  }

  /// Decodes a row; an interlaced file is decoded as a whole before its first row.
  void decodeRow(std::size_t y, void* to) {
    if (y < m_row) open();
    if (y == 0) begin();
    m_row = y + 1;
    if (m_isInterlaced) return;
    const int status = spng_decode_row(m_context.get(), to, m_rowBytes);
    if (status != SPNG_EOI) check(status);
  }

  /// Copies a row, composited over black: multiplies colours by alpha if the format has it.
  template <class T>
  void copyRow(std::size_t y, T* rgb) {
    if (!m_isInterlaced) m_decoded.resize(m_rowBytes);
    decodeRow(y, m_decoded.data());
    const auto* from = reinterpret_cast<const T*>(&m_decoded[m_isInterlaced ? y * m_rowBytes : 0]);
    const std::size_t count = 3 * m_facts.width;
    if (m_rowBytes == count) return (void)std::copy_n(from, count, rgb);
    constexpr std::uint32_t opaque = std::numeric_limits<T>::max();
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t at = k / 3 * 4;
      rgb[k] = T(std::uint32_t(from[at + k % 3]) * from[at + 3] / opaque);
    }
  }

  void check(int status, const std::string& what = "is damaged") const {
    if (status == 0) return;
    if (m_row == 0) throw InputError(m_file.string(), what, spng_strerror(status));
    throw InputError(m_file.string(), "row " + std::to_string(m_row - 1),
                     "is damaged: " + std::string(spng_strerror(status)));
  }

  fs::path m_file;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> m_input{nullptr, &std::fclose};
  std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> m_context{nullptr, &spng_ctx_free};
  bool m_hasAlpha = false;
  bool m_isInterlaced = false;
  int m_format = 0;                  ///< a format of libspng
  std::size_t m_rowBytes = 0;        ///< in that format
  std::size_t m_row = 0;             ///< the next row
  std::vector<std::byte> m_decoded;  ///< a row; of an interlaced file all of them
};

}  // namespace

std::unique_ptr<ImageInput> openPng(const fs::path& file) {
  return isPng(file) ? std::make_unique<PngInput>(file) : nullptr;
}

}  // namespace hogelscope
