// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/picture_facts.h"

#include <algorithm>
#include <cstring>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/random_access_file.h"
#include "io/files/system_limits.h"
#include "io/images/exr_layers.h"
#include "io/images/tiff_directories.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// What a file says beyond one upright picture at its place.
struct PictureFacts {
  int orientation = 1;             ///< EXIF's: 1 upright, 3 turned by 180°, 6 and 8 by 90°, …
  std::vector<PicturePart> parts;  ///< with data and display windows, layers of channels
  TiffPages pages{};
  std::size_t pictures = 1;  ///< as ImageNumbers::pictures; of which the first is read
  std::string kind{};        ///< of the file with these pictures, such as "animation"; may be ""
};

/// How a stored picture becomes the one that its file means.
struct Placement {
  std::vector<std::size_t> frames;  ///< of the reader; `planes` successive ones for a frame
  std::size_t planes = 1;
  PixelWindow stored{};   ///< what the reader has
  PixelWindow picture{};  ///< what is shown of it, in the same coordinates
  int orientation = 1;
};

/// Orientations of 5 and above exchange width and height.
bool isTransposed(int orientation) {
  return orientation >= 5;
}

class PlacedInput : public ImageInput {
 public:
  PlacedInput(fs::path file, std::unique_ptr<ImageInput> input, Placement placement,
              std::vector<std::string> notes)
      : m_file(std::move(file)), m_input(std::move(input)), m_placement(std::move(placement)) {
    m_facts = m_input->facts();
    m_facts.width = std::size_t(m_placement.picture.width);
    m_facts.height = std::size_t(m_placement.picture.height);
    if (isTransposed(m_placement.orientation)) std::swap(m_facts.width, m_facts.height);
    if (m_facts.frames == 1) m_facts.frames = m_placement.frames.size() / m_placement.planes;
    if (m_placement.planes == 3) m_facts.channels = 3;
    // Rows that are moved or turned may begin anywhere.
    if (m_placement.orientation != 1 || m_placement.stored != m_placement.picture)
      m_facts.bandRows = bandRowsOf(m_facts.width);
    m_facts.notes = std::move(notes);
  }

  void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) override {
    std::visit([&](auto* rgb) { readUpright(frame, first, rows, rgb); }, to);
  }

 private:
  /// A whole picture, decoded, since the rows of an upright one may be its columns, or come from
  /// its end.
  template <class T>
  const std::vector<T>& whole(std::size_t frame) {
    if (m_wholeFrame == frame && std::holds_alternative<std::vector<T>>(m_whole))
      return std::get<std::vector<T>>(m_whole);
    const auto height = std::size_t(m_placement.picture.height);
    const std::size_t rowValues = 3 * std::size_t(m_placement.picture.width);
    checkFits(
        double(rowValues * height * sizeof(T)), m_file,
        "it is turned upright, so all of it is read at once: store it upright, or allow more");
    m_wholeFrame = ~std::size_t{0};
    auto& values = m_whole.emplace<std::vector<T>>(rowValues * height);
    const std::size_t band = m_input->facts().bandRows;
    for (std::size_t first = 0; first < height; first += band)
      readPlaced(frame, first, std::min(band, height - first), &values[first * rowValues]);
    m_wholeFrame = frame;
    return values;
  }

  template <class T>
  void readUpright(std::size_t frame, std::size_t first, std::size_t rows, T* rgb) {
    const int orientation = m_placement.orientation;
    if (orientation == 1) return readPlaced(frame, first, rows, rgb);
    const std::vector<T>& values = whole<T>(frame);
    const auto width = std::size_t(m_placement.picture.width);
    const auto height = std::size_t(m_placement.picture.height);
    // EXIF 2.32, 4.6.4: which sides of the picture row 0 and column 0 are.
    const bool isFromRight =
        orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool isFromBottom =
        orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    for (std::size_t y = first; y < first + rows; ++y)
      for (std::size_t x = 0; x < m_facts.width; ++x, rgb += 3) {
        const std::size_t column = isTransposed(orientation) ? y : x;
        const std::size_t row = isTransposed(orientation) ? x : y;
        const std::size_t at = (isFromBottom ? height - 1 - row : row) * width +
                               (isFromRight ? width - 1 - column : column);
        std::copy_n(&values[3 * at], 3, rgb);
      }
  }

  /// Reads rows of the picture as it is stored, black where nothing is.
  template <class T>
  void readPlaced(std::size_t frame, std::size_t first, std::size_t rows, T* rgb) {
    const auto& [frames, planes, stored, picture, unused] = m_placement;
    if (stored == picture) return readPlanes(frame, first, rows, rgb);
    std::fill_n(rgb, 3 * std::size_t(picture.width) * rows, T{});
    // Rows and columns of the picture that are stored.
    const long long down = (long long)(picture.y) - stored.y;
    const long long right = (long long)(picture.x) - stored.x;
    const long long top = std::max<long long>((long long)(first), -down);
    const long long bottom = std::min<long long>((long long)(first + rows), stored.height - down);
    const long long from = std::max<long long>(0, -right);
    const long long past = std::min<long long>(picture.width, stored.width - right);
    if (top >= bottom || from >= past) return;
    const std::size_t band = m_input->facts().bandRows;
    const std::size_t begin = std::size_t(top + down) / band * band;
    const std::size_t end =
        std::min(std::size_t(stored.height), (std::size_t(bottom + down) + band - 1) / band * band);
    const std::size_t rowValues = 3 * std::size_t(stored.width);
    std::vector<T> values(rowValues * (end - begin));
    for (std::size_t row = begin; row < end; row += band)
      readPlanes(frame, row, std::min(band, end - row), &values[(row - begin) * rowValues]);
    for (long long y = top; y < bottom; ++y)
      std::copy_n(
          &values[(std::size_t(y + down) - begin) * rowValues + 3 * std::size_t(from + right)],
          3 * std::size_t(past - from),
          rgb + 3 * (std::size_t(y) - first) * std::size_t(picture.width) + 3 * from);
  }

  /// Reads rows of one of the reader's frames, or red, green and blue of three grey ones.
  template <class T>
  void readPlanes(std::size_t frame, std::size_t first, std::size_t rows, T* rgb) {
    const auto& [frames, planes, stored, picture, unused] = m_placement;
    if (planes == 1)
      return m_input->read(frame < frames.size() ? frames[frame] : frame, first, rows, rgb);
    std::vector<T> grey(3 * std::size_t(stored.width) * rows);
    for (std::size_t c = 0; c < planes; ++c) {
      m_input->read(frames[planes * frame + c], first, rows, grey.data());
      for (std::size_t k = c; k < grey.size(); k += planes) rgb[k] = grey[k];
    }
  }

  fs::path m_file;
  std::unique_ptr<ImageInput> m_input;
  Placement m_placement;
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> m_whole;
  std::size_t m_wholeFrame = ~std::size_t{0};
};

/// An input whose picture is not clear: size and type are.
class UnclearInput : public ImageInput {
 public:
  UnclearInput(fs::path file, const ImageFacts& facts, std::string why)
      : m_file(std::move(file)), m_why(std::move(why)) {
    m_facts = facts;
  }
  void read(std::size_t, std::size_t, std::size_t, const Rows&) override {
    throw InputError(m_file.string(), "", m_why);
  }

 private:
  fs::path m_file;
  std::string m_why;
};

std::uint64_t bigEndian(std::span<const std::byte> bytes) {
  std::uint64_t number = 0;
  for (const std::byte byte : bytes) number = 256 * number + std::uint64_t(byte);
  return number;
}

bool isText(std::span<const std::byte> bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

/// Returns the number of pictures in a JPEG, by the list in the segment MPF of its head (CIPA
/// DC-007): stereo cameras' MPO, and phones' maps of depth and gain.
std::size_t picturesOfJpeg(const RandomAccessFile& file) {
  constexpr int mostSegments = 200;
  std::uint64_t at = 2;
  for (int k = 0; k < mostSegments; ++k) {
    std::array<std::byte, 8> segment{};
    if (file.readSome(at, segment) < segment.size() || segment[0] != std::byte{0xff}) return 1;
    const auto marker = unsigned(segment[1]);
    constexpr unsigned startOfScan = 0xda;
    constexpr unsigned app2 = 0xe2;
    if (marker == startOfScan) return 1;
    if (marker == app2 && isText(std::span(segment).subspan(4), std::string_view("MPF\0", 4))) {
      const std::uint64_t base = at + segment.size();
      const auto list = tiffDirectories(
          [&](std::uint64_t from, std::span<std::byte> bytes) {
            return file.readSome(base + from, bytes);
          },
          1);
      constexpr unsigned numberOfImages = 0xb001;
      return list.empty() ? 1 : std::size_t(list[0].number(numberOfImages, 1));
    }
    at += 2 + bigEndian(std::span(segment).subspan(2, 2));
  }
  return 1;
}

/// Adds the orientation in the chunk EXIF of a WebP and its number of pictures, which OpenImageIO
/// 2.4 does not tell.
void addFactsOfWebp(const RandomAccessFile& file, PictureFacts& found) {
  constexpr int mostChunks = 10000;
  constexpr std::size_t mostBytes = 65536;
  std::uint64_t at = 12;
  std::size_t pictures = 0;
  for (int k = 0; k < mostChunks; ++k) {
    std::array<std::byte, 8> head{};
    if (file.readSome(at, head) < head.size()) break;
    const std::uint64_t bytes = bigEndian(std::array{head[7], head[6], head[5], head[4]});
    if (isText(head, "ANMF")) ++pictures;
    if (isText(head, "EXIF")) {
      std::vector<std::byte> exif(std::min<std::uint64_t>(bytes, mostBytes));
      exif.resize(file.readSome(at + head.size(), exif));
      found.orientation = exifOrientation(exif);
    }
    at += head.size() + bytes + bytes % 2;
  }
  found.pictures = std::max<std::size_t>(pictures, 1);
}

/// Whether a file is read as TIFF by its name; cameras' raw formats are TIFFs as well.
bool isTiffName(const fs::path& file) {
  return lowerCase(file.extension().string()).starts_with(".tif");
}

/// Collects what a file says from its reader and from its bytes.
PictureFacts pictureFactsOf(const fs::path& file, const ImageFacts& facts) {
  PictureFacts found{
      .orientation = facts.orientation, .parts = facts.parts, .pictures = facts.pictures};
  if (facts.format == "jpeg") {
    found.pictures = picturesOfJpeg(RandomAccessFile(file));
    found.kind = "a JPEG with further pictures (MPO)";
  } else if (facts.format == "webp") {
    addFactsOfWebp(RandomAccessFile(file), found);
    found.kind = "an animation";
  } else if (facts.format == "gif" || facts.format == "png") {
    found.kind = "an animation";
  } else if (facts.format == "tiff" && isTiffName(file)) {
    found.pages = tiffPagesOf(file);
    found.pictures = 1;
    if (!found.pages.views.empty()) found.orientation = found.pages.orientation;
  }
  return found;
}

std::string pictureNote(const PictureFacts& facts) {
  if (facts.pictures == 1) return {};
  const std::string kind = facts.kind.empty() ? "" : "is " + facts.kind + " and ";
  return kind + "has " +
         (facts.pictures == 0
              ? "more pictures than the one that is read"
              : std::to_string(facts.pictures) + " pictures, of which the first is read") +
         ": keep the views as files of their own";
}

/// Says which pages are not read where those that are alike are.
std::string pageNote(const TiffPages& pages) {
  if (!pages.note.empty() || pages.views.empty() || pages.views.size() == pages.all)
    return pages.note;
  return "has " + std::to_string(pages.all) + " pages, of which " +
         (pages.views.size() == 1 ? "one is read"
                                  : std::to_string(pages.views.size()) + " are views") +
         ": the others have another size or kind, or are thumbnails or masks";
}

/// Throws InputError if a picture is larger than any that its bytes can mean.
void checkWindow(const PixelWindow& window, const fs::path& file) {
  constexpr double mostPixelsPerByte = 1 << 17;
  if (window.width < 1 || window.height < 1 ||
      double(window.width) * window.height >
          mostPixelsPerByte * double(RandomAccessFile(file).size()))
    throw InputError(file.string(), "is damaged",
                     "its display window is " + pairText(window.width, window.height) + " px");
}

/// Puts the layer that is the picture, and its windows, into the placement. Returns its note.
std::string placeLayer(const fs::path& file, ImageInput& input, const ChosenLayer& layer,
                       Placement& placement) {
  const PicturePart& part = input.facts().parts[layer.part];
  if (!layer.isDefault) input.choose(layer.part, layer.channels);
  placement.frames = {layer.part};
  placement.stored = part.data;
  placement.picture = part.display;
  if (part.data != part.display) checkWindow(part.display, file);
  const bool isApart = part.data.x >= part.display.x + (long long)(part.display.width) ||
                       part.data.y >= part.display.y + (long long)(part.display.height) ||
                       part.data.x + (long long)(part.data.width) <= part.display.x ||
                       part.data.y + (long long)(part.data.height) <= part.display.y;
  return isApart ? "is black, because its data window lies outside of its display window"
                 : layer.note;
}

}  // namespace

std::unique_ptr<ImageInput> asFileSays(const fs::path& file, std::unique_ptr<ImageInput> input) {
  const PictureFacts said = pictureFactsOf(file, input->facts());
  const std::vector<std::size_t>& views = said.pages.views;
  if (!views.empty() && views[0] != 0) input->choose(views[0], std::nullopt);
  const ImageFacts& facts = input->facts();
  Placement placement{.frames = {0}, .orientation = said.orientation};
  placement.stored = {0, 0, int(facts.width), int(facts.height)};
  placement.picture = placement.stored;
  std::vector<std::string> notes = facts.notes;
  notes.push_back(pictureNote(said));
  notes.push_back(pageNote(said.pages));
  if (!said.parts.empty()) {
    const ChosenLayer layer = chosenLayer(said.parts);
    if (!layer.refusal.empty()) return std::make_unique<UnclearInput>(file, facts, layer.refusal);
    notes.push_back(placeLayer(file, *input, layer, placement));
  } else if (!views.empty()) {
    placement.frames = views;
    placement.planes = said.pages.planes;
  }
  std::erase(notes, "");
  if (placement.frames == std::vector<std::size_t>{0} && placement.stored == placement.picture &&
      placement.orientation == 1 && notes == facts.notes)
    return input;
  return std::make_unique<PlacedInput>(file, std::move(input), std::move(placement),
                                       std::move(notes));
}

bool hasViewPages(const fs::path& file) {
  if (!isTiffName(file)) return false;
  try {
    const TiffPages pages = tiffPagesOf(file);
    return pages.views.size() > pages.planes;
  } catch (const InputError&) {
    return false;  // said by whoever opens it
  }
}

}  // namespace hogelscope
