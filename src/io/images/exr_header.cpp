// SPDX-License-Identifier: BSD-3-Clause
// The layout of an EXR's header: https://openexr.com/en/latest/OpenEXRFileLayout.html
#include "io/images/exr_header.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "io/files/random_access_file.h"

namespace hogelscope {

namespace {

constexpr std::array<unsigned char, 4> exrMagic{0x76, 0x2f, 0x31, 0x01};

struct Attribute {
  std::string name;
  std::string type;
  std::uint64_t valueAt = 0;
  std::uint32_t size = 0;
};

class ExrHeader {
 public:
  ExrHeader(const RandomAccessFile& file, bool isMultiPart)
      : m_file(file), m_isMultiPart(isMultiPart) {}

  void check() {
    constexpr int mostAttributes = 10000;
    for (int k = 0; k < mostAttributes; ++k) {
      const std::optional<Attribute> attribute = next();
      if (!attribute) {
        checkChunks();
        ++m_at;  // the end of a part's header; another part may follow
        if (!m_isMultiPart || !next()) return;
        continue;
      }
      if (attribute->size > m_file.size() - attribute->valueAt) refuse(attribute->name);
      checkType(*attribute);
      if (attribute->name == "dataWindow") m_window = numbers<std::int32_t, 4>(*attribute);
      if (attribute->name == "compression") m_compression = numbers<std::uint8_t, 1>(*attribute)[0];
      if (attribute->name == "tiles") m_tile = numbers<std::uint32_t, 2>(*attribute);
      m_at = attribute->valueAt + attribute->size;
    }
    refuse("header");
  }

 private:
  /// Returns the next attribute; none at the header's end and at the end of the file.
  std::optional<Attribute> next() const {
    std::array<char, 600> bytes{};  // two names of at most 255 letters
    const std::size_t count = m_file.readSome(m_at, std::as_writable_bytes(std::span(bytes)));
    const std::string_view text(bytes.data(), count);
    const std::size_t nameEnd = text.find('\0');
    const std::size_t typeEnd =
        nameEnd == std::string_view::npos ? nameEnd : text.find('\0', nameEnd + 1);
    constexpr std::size_t longestName = 255;
    if (std::min(nameEnd, count) > longestName ||
        (nameEnd != 0 && count == bytes.size() && typeEnd == std::string_view::npos))
      refuse("header");
    if (nameEnd == 0 || typeEnd == std::string_view::npos || typeEnd + 5 > count)
      return std::nullopt;
    Attribute attribute{std::string(text.substr(0, nameEnd)),
                        std::string(text.substr(nameEnd + 1, typeEnd - nameEnd - 1)),
                        m_at + typeEnd + 5};
    std::memcpy(&attribute.size, &text[typeEnd + 1], sizeof(attribute.size));
    return attribute;
  }

  /// Checks that a value has the size of its type.
  void checkType(const Attribute& attribute) const {
    // The types of fixed size by their size in bytes. OpenEXR reads these sizes regardless of the
    // header's, so this reader must do the same.
    static const std::map<std::uint32_t, std::vector<std::string_view>> typesOfSize{
        {1, {"compression", "deepImageState", "envmap", "lineOrder"}},
        {4, {"float", "int"}},
        {8, {"double", "rational", "timecode", "v2f", "v2i"}},
        {9, {"tiledesc"}},
        {12, {"v3f", "v3i"}},
        {16, {"box2f", "box2i", "v2d"}},
        {24, {"v3d"}},
        {28, {"keycode"}},
        {32, {"chromaticities"}},
        {36, {"m33f"}},
        {64, {"m44f"}},
        {72, {"m33d"}},
        {128, {"m44d"}}};
    for (const auto& [size, types] : typesOfSize)
      if (attribute.size != size && std::ranges::count(types, attribute.type) > 0)
        refuseSize(attribute);
    if (attribute.type == "preview") {
      const auto [width, height] = numbers<std::uint32_t, 2>(attribute);
      if (8 + 4.0 * width * height != attribute.size) refuseSize(attribute);
    }
    if (attribute.type == "chlist" || attribute.type == "stringvector") {
      std::string value(attribute.size, '\0');
      m_file.read(attribute.valueAt, std::as_writable_bytes(std::span(value)));
      if (!(attribute.type == "chlist" ? isChannelList(value) : isStringVector(value)))
        refuseSize(attribute);
    }
  }

  /// Whether the value is a list of names, each with 16 bytes of its channel, ended by an empty
  /// name.
  static bool isChannelList(std::string_view value) {
    constexpr std::size_t channel = 16;
    for (;;) {
      const std::size_t end = value.find('\0');
      if (end == 0) return value.size() == 1;
      if (end == std::string_view::npos || value.size() - end - 1 < channel) return false;
      value.remove_prefix(end + 1 + channel);
    }
  }

  /// Whether the value is a list of strings, each after its length.
  static bool isStringVector(std::string_view value) {
    while (!value.empty()) {
      std::uint32_t length = 0;
      if (value.size() < sizeof(length)) return false;
      std::memcpy(&length, value.data(), sizeof(length));
      value.remove_prefix(sizeof(length));
      if (length > value.size()) return false;
      value.remove_prefix(length);
    }
    return true;
  }

  template <class T, std::size_t count>
  std::array<T, count> numbers(const Attribute& attribute) const {
    std::array<T, count> values{};
    if (attribute.size >= sizeof(values))
      m_file.read(attribute.valueAt, std::as_writable_bytes(std::span(values)));
    return values;
  }

  /// Checks that the file has eight bytes for each chunk: a tile, or at most 256 lines. No
  /// compression packs more pixels into a byte: deflate's limit is 1032 bytes, DWA reached 2767
  /// pixels.
  void checkChunks() const {
    constexpr double mostLines = 256;
    const double width = double(m_window[2]) - m_window[0] + 1;
    const double height = double(m_window[3]) - m_window[1] + 1;
    const bool isTiled = m_tile[0] > 0 && m_tile[1] > 0;
    const double chunks = isTiled ? width / m_tile[0] * (height / m_tile[1]) : height / mostLines;
    const bool isDwa = m_compression >= 8;
    const auto bytes = double(m_file.size());
    const double pixelsPerByte = isDwa ? 1 << 14 : 1 << 10;
    if (8 * chunks > bytes || width * height > pixelsPerByte * bytes) refuse("dataWindow");
    constexpr double tilePixelsPerByte = 1 << 17;  // a tile may be larger than the image
    if (double(m_tile[0]) * m_tile[1] > tilePixelsPerByte * bytes) refuse("tiles");
  }

  [[noreturn]] void refuse(const std::string& attribute) const {
    throw InputError(m_file.path().string(), "is damaged",
                     "its " + attribute + " needs more than the file has");
  }

  [[noreturn]] void refuseSize(const Attribute& attribute) const {
    throw InputError(m_file.path().string(), "is damaged",
                     "its " + attribute.name + " is longer or shorter than a " + attribute.type);
  }

  const RandomAccessFile& m_file;
  bool m_isMultiPart;
  std::uint64_t m_at = 8;                  ///< after magic and version
  std::array<std::int32_t, 4> m_window{};  ///< x and y of the first and the last pixel
  std::uint8_t m_compression = 0;          ///< the file's code; 8 and 9 are DWAA and DWAB
  std::array<std::uint32_t, 2> m_tile{};   ///< width and height; 0: lines
};

}  // namespace

void checkExrHeader(const std::filesystem::path& path) {
  const RandomAccessFile file(path);
  std::array<unsigned char, 8> found{};  // magic, version and flags
  if (file.readSome(0, std::as_writable_bytes(std::span(found))) < found.size() ||
      !std::equal(exrMagic.begin(), exrMagic.end(), found.begin()))
    return;
  constexpr unsigned multiPart = 0x10;  // in the second byte of version and flags
  ExrHeader(file, (found[5] & multiPart) != 0).check();
}

}  // namespace hogelscope
