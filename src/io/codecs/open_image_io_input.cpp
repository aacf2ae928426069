// SPDX-License-Identifier: BSD-3-Clause
// Input of images and videos by OpenImageIO.
#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <sstream>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/optics/image.h"
#include "io/codecs/open_image_io.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Throws InputError if even a single-colour image could not be so small.
void checkSize(const OIIO::ImageSpec& spec, const fs::path& file) {
  constexpr double mostBytesPerByte = 1 << 17;
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (!error && double(spec.image_bytes(true)) > mostBytesPerByte * double(bytes))
    throw InputError(file.string(), "is damaged",
                     "its " + std::to_string(bytes) + " bytes cannot be " +
                         std::to_string(spec.width) + "×" + std::to_string(spec.height) + " px");
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

/// Returns the largest value of a PNM file: the third number of its header. 0 if there is none.
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

/// Returns the bits of 16-bit values. Readers scale fewer bits to all 16, and OpenImageIO 2.4's PNM
/// reader does not report them.
int bitsOf(const OIIO::ImageSpec& spec, const std::string& format, const fs::path& file) {
  if (format != "pnm") return std::clamp(spec.get_int_attribute("oiio:BitsPerSample", 16), 8, 16);
  const int largest = largestPnmValue(file);
  for (int bits = 9; bits < 16; ++bits)
    if (largest == largestValue(bits)) return bits;
  return 16;
}

/// Whether the file is JPEG XL: a bare codestream, or one in boxes.
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
[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  if (isJpegXl(file))
    throw InputError(file.string(), "",
                     "is JPEG XL, which OpenImageIO " OIIO_VERSION_STRING
                     " does not read; convert it, such as by djxl NAME.jxl NAME.png");
  throw InputError(file.string(), "cannot be read as a picture", why);
}

/// Whether a file begins like a video. Excludes texts that name other files or addresses, which
/// FFmpeg would read: lists of files (ffconcat), HLS, DASH, SDP.
bool isVideo(const fs::path& file) {
  using namespace std::string_view_literals;
  constexpr std::size_t longest = 12;
  std::string begin(longest, '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), longest);
  const std::string_view all(begin);
  static constexpr std::array boxes{"ftyp"sv, "moov"sv, "mdat"sv, "free"sv, "skip"sv, "wide"sv};
  static constexpr std::array signatures{"\x1a\x45\xdf\xa3"sv, "FLV\1"sv, "\x30\x26\xb2\x75"sv,
                                         "OggS"sv, "YUV4MPEG2"sv};
  const auto begins = [&](std::string_view signature) { return all.starts_with(signature); };
  return std::ranges::find(boxes, all.substr(4, 4)) != boxes.end() ||
         std::ranges::any_of(signatures, begins) ||
         (begins("RIFF") && all.substr(8, 4) == "AVI "sv);
}

/// Whether a file begins like an MPEG stream, which does not contain its number of frames.
bool isMpegStream(const fs::path& file) {
  using namespace std::string_view_literals;
  std::string begin(4, '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), 4);
  return begin == "\0\0\1\xba"sv || begin == "\0\0\1\xb3"sv || begin.starts_with("\x47\x40"sv);
}

/// Opens a file as a format of OpenImageIO. Returns null, with the reason, if it has another
/// format.
std::unique_ptr<OIIO::ImageInput> openAs(const std::string& format, const fs::path& file,
                                         std::string& why) {
  std::unique_ptr<OIIO::ImageInput> image = OIIO::ImageInput::create(format);
  OIIO::ImageSpec spec;
  if (image && image->open(file.string(), spec)) return image;
  why = asOneLine(image ? image->geterror() : OIIO::geterror(), file);
  return nullptr;
}

/// Opens a file as the first format that accepts it, the one of its extension first. Only videos
/// are passed to FFmpeg.
std::unique_ptr<OIIO::ImageInput> openAny(const fs::path& file, std::string& why) {
  if (isVideo(file)) {
    std::unique_ptr<OIIO::ImageInput> image = OIIO::ImageInput::open(file.string());
    if (!image) why = asOneLine(OIIO::geterror(), file);  // otherwise the error is printed
    return image;
  }
  if (isMpegStream(file)) {
    why =
        "an MPEG stream does not say how many frames it has; copy it into another file, such as by "
        "ffmpeg -i NAME.mpg -c copy NAME.mp4";
    return nullptr;
  }
  // The extension is also the format's name.
  std::string ending = lowerCase(file.extension().string());
  if (!ending.empty()) ending.erase(0, 1);
  const std::string list = OIIO::get_string_attribute("input_format_list");
  std::istringstream formats(ending + "," + list);
  std::string own;
  for (std::string format; std::getline(formats, format, ',');) {
    const auto reader = OIIO::ImageInput::create(format);
    if (!reader || reader->format_name() == std::string("FFmpeg movie")) continue;
    if (auto image = openAs(format, file, why)) return image;
    if (format == ending) own = why;
  }
  why = own.empty() ? "its content is of no known format" : own;
  return nullptr;
}

class Input : public ImageInput {
 public:
  Input(const fs::path& file, const std::string& format) : m_file(file) {
    std::string why;
    m_image = format.empty() ? openAny(file, why) : openAs(format, file, why);
    if (!m_image) refuse(m_file, why);
    m_spec = m_image->spec();
    if (m_spec.width < 1 || m_spec.height < 1 || m_spec.nchannels < 1 || m_spec.depth > 1 ||
        m_spec.deep)
      throw InputError(m_file.string(), "", "is not a flat picture with pixels");
    checkSize(m_spec, m_file);
    const StoredType type = typeOf(m_spec);
    const std::string found = m_image->format_name();
    const int bits = type == StoredType::uint8    ? 8
                     : type == StoredType::uint16 ? bitsOf(m_spec, found, m_file)
                                                  : 16;
    const bool isMovie = m_spec.get_int_attribute("oiio:Movie") != 0;
    const int frames = isMovie ? m_spec.get_int_attribute("oiio:subimages", 1) : 1;
    if (isMovie && std::uintmax_t(frames) > fs::file_size(m_file))
      throw InputError(m_file.string(), "",
                       "does not say how many frames it has; copy it into another file");
    m_facts = {{std::size_t(m_spec.width), std::size_t(m_spec.height), m_spec.nchannels, type, bits,
                std::size_t(std::max(frames, 1))},
               found};
    m_facts.bandRows = bandRowsOf(m_facts.width, std::size_t(std::max(m_spec.tile_height, 1)));
  }

  void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) override {
    std::visit([&](auto* values) { readRows(int(frame), first, rows, values); }, to);
  }

 private:
  template <class T>
  void readRows(int frame, std::size_t first, std::size_t rows, T* to);

  fs::path m_file;
  std::unique_ptr<OIIO::ImageInput> m_image;
  OIIO::ImageSpec m_spec;
};

template <class T>
void Input::readRows(int frame, std::size_t first, std::size_t rows, T* to) {
  // Readers multiply the colours by alpha. OpenImageIO 2.4's TIFF reader does so for scanlines only
  // if alpha is requested, and twice for tiles if alpha is requested.
  const bool isAsked = m_spec.tile_width == 0;
  const bool hasAlpha = isAsked && (m_spec.alpha_channel == 1 || m_spec.alpha_channel == 3);
  const int used = hasAlpha ? m_spec.alpha_channel + 1 : m_spec.nchannels < 3 ? 1 : 3;
  const auto stored = std::size_t(used);
  const std::size_t pixels = m_facts.width * rows;
  std::vector<T> read(stored * pixels);
  const OIIO::TypeDesc type = OIIO::BaseTypeFromC<T>::value;
  const int begin = m_spec.y + int(first);
  const int end = begin + int(rows);
  const auto stride = OIIO::stride_t(stored * sizeof(T));
  const bool isRead =
      m_spec.tile_width > 0
          ? m_image->read_tiles(frame, 0, m_spec.x, m_spec.x + m_spec.width, begin, end, m_spec.z,
                                m_spec.z + 1, 0, used, type, read.data(), stride)
          : m_image->read_scanlines(frame, 0, begin, end, m_spec.z, 0, used, type, read.data(),
                                    stride);
  // Some readers fill the rest of a truncated file and only set a message.
  if (!isRead || m_image->has_error())
    throw InputError(m_file.string(), "is damaged", asOneLine(m_image->geterror(), m_file));
  for (std::size_t p = 0; p < pixels; ++p)
    for (std::size_t c = 0; c < 3; ++c) to[3 * p + c] = read[stored * p + (stored < 3 ? 0 : c)];
}

}  // namespace

std::unique_ptr<ImageInput> openByOpenImageIo(const fs::path& file, const std::string& format) {
  return std::make_unique<Input>(file, format);
}

}  // namespace hogelscope
