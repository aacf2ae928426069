// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/tiff_directories.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <set>
#include <string_view>
#include <tuple>

#include "io/files/random_access_file.h"

namespace hogelscope {

namespace {

namespace tiff_tag {
constexpr unsigned newSubfileType = 254;
constexpr unsigned subfileType = 255;
constexpr unsigned width = 256;
constexpr unsigned height = 257;
constexpr unsigned bits = 258;
constexpr unsigned photometric = 262;
constexpr unsigned description = 270;
constexpr unsigned orientation = 274;
constexpr unsigned samples = 277;
constexpr unsigned tileWidth = 322;
constexpr unsigned sampleFormat = 339;
}  // namespace tiff_tag

/// Reads directories of both sizes and both orders of bytes.
class DirectoryParser {
 public:
  explicit DirectoryParser(const ReadBytes& read) : m_read(read) {
    std::array<std::byte, 16> begin{};
    if (m_read(0, begin) < 8) return;
    const auto is = [&begin](char letter) {
      return begin[0] == std::byte(letter) && begin[1] == std::byte(letter);
    };
    if (!is('I') && !is('M')) return;
    m_isBigEndian = is('M');
    const std::uint64_t version = numberAt(begin, 2, 2);
    m_isBig = version == 43;
    if (version == 42) m_first = numberAt(begin, 4, 4);
    if (m_isBig) m_first = numberAt(begin, 8, 8);
  }

  [[nodiscard]] std::uint64_t first() const { return m_first; }

  /// Returns the directory at a position; none if it is damaged.
  [[nodiscard]] std::optional<TiffDirectory> at(std::uint64_t position) const {
    constexpr std::size_t mostEntries = 512;
    const std::size_t countBytes = m_isBig ? 8 : 2;
    const std::size_t entryBytes = m_isBig ? 20 : 12;
    const std::size_t linkBytes = m_isBig ? 8 : 4;
    std::array<std::byte, 8> count{};
    if (m_read(position, std::span(count).first(countBytes)) < countBytes) return std::nullopt;
    const std::uint64_t entries = numberAt(count, 0, countBytes);
    if (entries < 1 || entries > mostEntries) return std::nullopt;
    std::vector<std::byte> bytes(entries * entryBytes + linkBytes);
    if (m_read(position + countBytes, bytes) < bytes.size() - linkBytes) return std::nullopt;
    TiffDirectory directory;
    for (std::size_t k = 0; k < entries; ++k) addEntry(bytes, k * entryBytes, directory);
    directory.next = numberAt(bytes, entries * entryBytes, linkBytes);
    return directory;
  }

 private:
  [[nodiscard]] std::uint64_t numberAt(std::span<const std::byte> bytes, std::size_t at,
                                       std::size_t size) const {
    std::uint64_t number = 0;
    for (std::size_t k = 0; k < size; ++k)
      number = 256 * number + std::uint64_t(bytes[at + (m_isBigEndian ? k : size - 1 - k)]);
    return number;
  }

  void addEntry(std::span<const std::byte> bytes, std::size_t at, TiffDirectory& directory) const {
    constexpr std::array<std::size_t, 17> typeBytes{0, 1, 1, 2, 4, 8, 1, 1, 2,
                                                    4, 8, 4, 8, 4, 0, 0, 8};
    const auto tag = unsigned(numberAt(bytes, at, 2));
    const std::uint64_t type = numberAt(bytes, at + 2, 2);
    const std::size_t wordBytes = m_isBig ? 8 : 4;
    const std::uint64_t count = numberAt(bytes, at + 4, wordBytes);
    const std::size_t valueAt = at + 4 + wordBytes;
    if (type >= typeBytes.size() || typeBytes[type] == 0 || count < 1) return;
    const std::size_t size = typeBytes[type];
    const bool isHere = count <= wordBytes / size;
    const std::uint64_t position = numberAt(bytes, valueAt, wordBytes);
    if (type == 2) {
      if (tag == tiff_tag::description && !isHere) directory.description = textAt(position, count);
      return;
    }
    if (type != 1 && type != 3 && type != 4 && type != 13 && type != 16) return;
    std::array<std::byte, 8> value{};
    if (isHere)
      std::ranges::copy(bytes.subspan(valueAt, size), value.begin());
    else if (m_read(position, std::span(value).first(size)) < size)
      return;
    directory.numbers[tag] = numberAt(value, 0, size);
  }

  [[nodiscard]] std::string textAt(std::uint64_t position, std::uint64_t count) const {
    constexpr std::uint64_t most = 65536;
    std::string text(std::min(count, most), '\0');
    text.resize(m_read(position, std::as_writable_bytes(std::span(text))));
    return text;
  }

  const ReadBytes& m_read;
  bool m_isBigEndian = false;
  bool m_isBig = false;
  std::uint64_t m_first = 0;
};

/// What pages that are views have in common.
auto kindOf(const TiffDirectory& page) {
  return std::tuple(page.number(tiff_tag::width, 0), page.number(tiff_tag::height, 0),
                    page.number(tiff_tag::samples, 1), page.number(tiff_tag::bits, 1),
                    page.number(tiff_tag::sampleFormat, 1), page.number(tiff_tag::photometric, 0),
                    page.number(tiff_tag::orientation, 1), page.number(tiff_tag::tileWidth, 0));
}

/// Whether a page is a picture of its own: no level of a pyramid and no mask.
bool isPicture(const TiffDirectory& page) {
  constexpr std::uint64_t reducedOrMask = 5;
  constexpr std::uint64_t reduced = 2;
  return (page.number(tiff_tag::newSubfileType, 0) & reducedOrMask) == 0 &&
         page.number(tiff_tag::subfileType, 0) != reduced && page.number(tiff_tag::width, 0) > 0;
}

/// Returns the number behind a key in a text, such as 25 for "images=" or "SizeZ=\""; 0 if it is
/// not there.
std::uint64_t numberBehind(std::string_view text, std::string_view key) {
  const std::size_t at = text.find(key);
  std::uint64_t number = 0;
  if (at != std::string_view::npos)
    std::from_chars(text.data() + at + key.size(), text.data() + text.size(), number);
  return number;
}

/// How far apart the pages of a picture's channels are, by the file's own description.
struct Channels {
  std::uint64_t count = 1;
  std::uint64_t stride = 1;
};

/// ImageJ has channels first; OME says the order, such as XYZCT.
Channels channelsOf(std::string_view text) {
  if (text.starts_with("ImageJ="))
    return {std::max<std::uint64_t>(1, numberBehind(text, "\nchannels=")), 1};
  const std::size_t pixels = text.find("<Pixels ");
  if (pixels == std::string_view::npos) return {};
  const std::string_view element = text.substr(pixels, text.find('>', pixels) - pixels);
  constexpr std::string_view key = "DimensionOrder=\"XY";
  const std::size_t order = element.find(key);
  Channels channels{std::max<std::uint64_t>(1, numberBehind(element, "SizeC=\"")), 1};
  for (std::size_t at = order + key.size();
       order != std::string_view::npos && at < element.size() && element[at] != 'C' &&
       element[at] != '"';
       ++at)
    channels.stride *= std::max<std::uint64_t>(
        1, numberBehind(element, element[at] == 'Z' ? "SizeZ=\"" : "SizeT=\""));
  return channels;
}

/// Puts the pages of three channels next to each other.
void joinPlanes(TiffPages& pages, const TiffDirectory& page, std::string_view description) {
  const auto [count, stride] = channelsOf(description);
  const std::size_t all = pages.views.size();
  if (count != 3 || page.number(tiff_tag::samples, 1) != 1 || stride > all ||
      all % (3 * stride) != 0)
    return;
  std::vector<std::size_t> views;
  for (std::size_t begin = 0; begin < all; begin += 3 * stride)
    for (std::size_t k = 0; k < stride; ++k)
      for (std::size_t c = 0; c < 3; ++c) views.push_back(pages.views[begin + k + c * stride]);
  pages.views = std::move(views);
  pages.planes = 3;
  pages.note = "has three channels, which are taken for red, green and blue";
}

}  // namespace

std::uint64_t TiffDirectory::number(unsigned tag, std::uint64_t otherwise) const {
  const auto found = numbers.find(tag);
  return found == numbers.end() ? otherwise : found->second;
}

std::vector<TiffDirectory> tiffDirectories(const ReadBytes& read, std::size_t most) {
  const DirectoryParser reader(read);
  std::vector<TiffDirectory> directories;
  std::set<std::uint64_t> known;
  for (std::uint64_t at = reader.first();
       at != 0 && directories.size() < most && known.insert(at).second;) {
    std::optional<TiffDirectory> directory = reader.at(at);
    if (!directory) break;
    at = directory->next;
    if (!directories.empty()) directory->description.clear();
    directories.push_back(std::move(*directory));
  }
  return directories;
}

int exifOrientation(std::span<const std::byte> exif) {
  constexpr std::string_view mark("Exif\0\0", 6);
  if (exif.size() > mark.size() && std::memcmp(exif.data(), mark.data(), mark.size()) == 0)
    exif = exif.subspan(mark.size());
  const auto directories = tiffDirectories(
      [&](std::uint64_t at, std::span<std::byte> bytes) {
        if (at >= exif.size()) return std::size_t{0};
        const auto there = exif.subspan(at, std::min(bytes.size(), exif.size() - at));
        std::ranges::copy(there, bytes.begin());
        return there.size();
      },
      1);
  if (directories.empty()) return 1;
  return int(std::clamp<std::uint64_t>(directories[0].number(tiff_tag::orientation, 1), 1, 8));
}

TiffPages tiffPagesOf(const std::filesystem::path& path) {
  constexpr std::size_t most = 65536;
  const RandomAccessFile file(path);
  TiffPages pages;
  const auto directories = tiffDirectories(
      [&](std::uint64_t at, std::span<std::byte> bytes) { return file.readSome(at, bytes); }, most);
  pages.all = directories.size();
  if (directories.empty()) return pages;
  const std::uint64_t images = numberBehind(directories[0].description, "\nimages=");
  if (directories[0].description.starts_with("ImageJ=") && images > directories.size())
    pages.note = "says that it has " + std::to_string(images) + " images, of which " +
                 std::to_string(directories.size()) + " can be found: save it as an image sequence";
  if (directories.size() < 2) return pages;
  std::map<decltype(kindOf(directories[0])), std::vector<std::size_t>> kinds;
  for (std::size_t k = 0; k < directories.size(); ++k)
    if (isPicture(directories[k])) kinds[kindOf(directories[k])].push_back(k);
  for (const auto& [kind, members] : kinds) {
    const bool isEarlier = members.size() == pages.views.size() && members[0] < pages.views[0];
    if (members.size() > pages.views.size() || isEarlier) pages.views = members;
  }
  if (pages.views.empty()) return pages;
  const TiffDirectory& first = directories[pages.views[0]];
  pages.orientation = int(std::clamp<std::uint64_t>(first.number(tiff_tag::orientation, 1), 1, 8));
  joinPlanes(pages, first, directories[0].description);
  return pages;
}

}  // namespace hogelscope
