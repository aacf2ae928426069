// SPDX-License-Identifier: BSD-3-Clause
// Input and output of images by OpenImageIO.
#include "io/codecs/open_image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/optics/image.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Returns OpenImageIO's message on one line, without the file's name.
std::string asOneLine(std::string text, const fs::path& file) {
  for (const std::string& noise : {"\"" + file.string() + "\"", "'" + file.string() + "'"})
    if (const std::size_t at = text.find(noise); at != std::string::npos)
      text.replace(at, noise.size(), "it");
  text = text.substr(0, text.find('\n'));  // the other lines repeat it
  if (text.ends_with(" (it)")) text.resize(text.size() - 5);
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text.empty() ? "unknown reason" : text;
}

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
  const auto type = spec.format.basetype;
  if (type == OIIO::TypeDesc::UINT8 || type == OIIO::TypeDesc::INT8) return StoredType::uint8;
  const bool is16 = type == OIIO::TypeDesc::UINT16 || type == OIIO::TypeDesc::INT16;
  return is16 ? StoredType::uint16 : StoredType::real;
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

/// Returns the first 12 bytes of a file; those that it does not have are 0.
std::string beginOf(const fs::path& file) {
  std::string begin(12, '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), std::streamsize(begin.size()));
  return begin;
}

/// Whether the file is JPEG XL: a bare codestream, or one in boxes.
bool isJpegXl(const fs::path& file) {
  using namespace std::string_view_literals;
  const std::string begin = beginOf(file);
  return begin.starts_with("\xff\x0a") || begin == "\0\0\0\x0cJXL \r\n\x87\n"sv;
}

/// Throws InputError for a file that OpenImageIO cannot open.
[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  if (isJpegXl(file))
    throw InputError(file.string(), "",
                     "is JPEG XL, which OpenImageIO " OIIO_VERSION_STRING
                     " does not read; convert it, such as by djxl NAME.jxl NAME.png");
  throw InputError(file.string(), "cannot be read as a picture", why);
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

/// Opens a file as the first format that accepts it, the one of its extension first. Nothing is
/// passed to its reader of videos, which loses frames; openVideo() reads them.
std::unique_ptr<OIIO::ImageInput> openAny(const fs::path& file, std::string& why) {
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
    takeNumbers();
    addWhatFileSays();
  }

  void choose(std::size_t picture, const std::optional<std::array<int, 3>>& colours) override {
    goTo(int(picture));
    m_colours = colours;
    takeNumbers();
  }

  void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) override {
    goTo(int(frame));
    std::visit([&](auto* values) { readRows(int(frame), first, rows, values); }, to);
  }

  void readChannel(std::size_t channel, std::size_t first, std::size_t rows, float* to) override {
    const int c = int(channel);
    if (!m_spec.channelformat(c).is_floating_point())
      throw InputError(m_file.string(), "channel \"" + m_facts.channelNames[channel] + "\"",
                       "has whole numbers, not floats");
    if (const int parts = m_spec.get_int_attribute("oiio:subimages", 1); parts > 1)
      throw InputError(m_file.string(), "",
                       "has " + std::to_string(parts) + " pictures; its channels must be in one");
    readStored(0, first, rows, {c, c + 1}, OIIO::TypeDesc::FLOAT, to);
  }

 private:
  struct Channels {
    int begin = 0;
    int end = 0;
  };

  /// Sets the facts of the current picture.
  void takeNumbers() {
    const StoredType type = typeOf(m_spec);
    m_facts.format = m_image->format_name();
    m_facts.width = std::size_t(m_spec.width);
    m_facts.height = std::size_t(m_spec.height);
    m_facts.channels = m_spec.nchannels;
    m_facts.type = type;
    m_facts.bits = type == StoredType::uint8    ? 8
                   : type == StoredType::uint16 ? bitsOf(m_spec, m_facts.format, m_file)
                                                : 16;
    m_facts.channelNames.clear();
    for (int c = 0; c < m_spec.nchannels; ++c)
      m_facts.channelNames.emplace_back(m_spec.channel_name(c));
    m_facts.bandRows = bandRowsOf(m_facts.width, std::size_t(std::max(m_spec.tile_height, 1)));
  }

  /// Makes one of the file's pictures the current one.
  void goTo(int picture) {
    if (picture == m_picture) return;
    m_spec = m_image->spec(picture);
    if (m_spec.width < 1 || m_spec.height < 1 || m_spec.nchannels < 1 || m_spec.deep)
      throw InputError(m_file.string(), "is damaged",
                       "its picture " + std::to_string(picture + 1) + " cannot be read");
    checkSize(m_spec, m_file);
    m_picture = picture;
  }

  /// Adds orientation, number of pictures, and parts. OpenImageIO's HEIF reader turns pictures
  /// itself.
  void addWhatFileSays() {
    const std::string& format = m_facts.format;
    if (format == "jpeg" || format == "tiff")
      m_facts.orientation = std::clamp(m_spec.get_int_attribute("Orientation", 1), 1, 8);
    const int pictures = m_spec.get_int_attribute("oiio:subimages", 1);
    if (format == "openexr") {
      addParts(pictures);
    } else if (pictures > 1) {
      m_facts.pictures = std::size_t(pictures);
      m_facts.frames = 1;
    } else {
      static constexpr std::array<std::string_view, 4> silent{"gif", "ico", "psd", "heif"};
      if (std::ranges::find(silent, format) != silent.end()) lookForSecond();
    }
  }

  /// Of formats whose readers do not tell the number of pictures. Opens the file again if there is
  /// a second one, since not all of them come back to the first.
  void lookForSecond() {
    const bool isThere = m_image->seek_subimage(1, 0);
    (void)m_image->geterror();
    if (!isThere) return;
    m_facts.pictures = 0;
    std::string why;
    m_image = openAs(m_facts.format, m_file, why);
    if (!m_image) refuse(m_file, why);
  }

  void addParts(int count) {
    constexpr int most = 1000;
    for (int k = 0; k < std::min(count, most); ++k) {
      const OIIO::ImageSpec spec = k == 0 ? m_spec : m_image->spec(k);
      PicturePart part{std::string(spec.get_string_attribute("oiio:subimagename")),
                       {spec.x, spec.y, spec.width, spec.height},
                       {spec.full_x, spec.full_y, spec.full_width, spec.full_height}};
      for (int c = 0; c < spec.nchannels && !spec.deep; ++c)
        part.channels.emplace_back(spec.channel_name(c));
      m_facts.parts.push_back(std::move(part));
    }
    if (count > 1) m_image->seek_subimage(0, 0);
  }

  /// Reads channels as `type`, pixel by pixel.
  void readStored(int frame, std::size_t first, std::size_t rows, const Channels& channels,
                  const OIIO::TypeDesc& type, void* to) {
    const auto [from, past] = channels;
    const int begin = m_spec.y + int(first);
    const int end = begin + int(rows);
    const auto stride = OIIO::stride_t(std::size_t(past - from) * type.size());
    const bool isRead =
        m_spec.tile_width > 0
            ? m_image->read_tiles(frame, 0, m_spec.x, m_spec.x + m_spec.width, begin, end, m_spec.z,
                                  m_spec.z + 1, from, past, type, to, stride)
            : m_image->read_scanlines(frame, 0, begin, end, m_spec.z, from, past, type, to, stride);
    // Some readers fill the rest of a truncated file and only set a message.
    if (!isRead || m_image->has_error())
      throw InputError(m_file.string(), "is damaged", asOneLine(m_image->geterror(), m_file));
  }

  template <class T>
  void readRows(int frame, std::size_t first, std::size_t rows, T* to) {
    // Readers multiply the colours by alpha. OpenImageIO 2.4's TIFF reader does so for scanlines
    // only if alpha is requested, and twice for tiles if alpha is requested.
    const bool isAsked = m_spec.tile_width == 0;
    const bool hasAlpha = isAsked && (m_spec.alpha_channel == 1 || m_spec.alpha_channel == 3);
    const int used = hasAlpha ? m_spec.alpha_channel + 1 : m_spec.nchannels < 3 ? 1 : 3;
    Channels channels{0, used};
    std::array<int, 3> colours = used < 3 ? std::array{0, 0, 0} : std::array{0, 1, 2};
    if (m_colours) {
      const auto [least, most] = std::ranges::minmax(*m_colours);
      channels = {least, most + 1};
      std::ranges::transform(*m_colours, colours.begin(),
                             [&](int c) { return c - channels.begin; });
    }
    const auto stored = std::size_t(channels.end - channels.begin);
    if (stored == 3 && colours == std::array{0, 1, 2})
      return readStored(frame, first, rows, channels, OIIO::BaseTypeFromC<T>::value, to);
    const std::size_t pixels = std::size_t(m_spec.width) * rows;
    std::vector<T> read(stored * pixels);
    readStored(frame, first, rows, channels, OIIO::BaseTypeFromC<T>::value, read.data());
    for (std::size_t p = 0; p < pixels; ++p)
      for (std::size_t c = 0; c < 3; ++c)
        to[3 * p + c] = read[stored * p + std::size_t(colours[c])];
  }

  fs::path m_file;
  std::unique_ptr<OIIO::ImageInput> m_image;
  OIIO::ImageSpec m_spec;                       ///< of the current picture
  int m_picture = 0;                            ///< the current picture
  std::optional<std::array<int, 3>> m_colours;  ///< channels, if not the first ones
};

OIIO::TypeDesc typeDesc(StoredType type) {
  if (type == StoredType::uint8) return OIIO::TypeDesc::UINT8;
  return type == StoredType::uint16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT;
}

/// Reports success of every write and keeps the error in ByteOutput, because some writers do not
/// notice a full disk, and libjpeg would end the process.
class Proxy : public OIIO::Filesystem::IOProxy {
 public:
  Proxy(const fs::path& file, ByteOutput& bytes)
      : IOProxy(file.string(), Mode::Write), m_bytes(bytes) {}

  [[nodiscard]] const char* proxytype() const override { return "checked file"; }
  bool seek(int64_t offset) override {
    m_pos = offset;
    m_bytes.seek(offset);
    return true;
  }
  std::size_t write(const void* data, std::size_t size) override {
    if (size == 0) return 0;  // the data of WebP's last write may be null
    m_bytes.write(data, size);
    m_pos += int64_t(size);
    return size;
  }
  std::size_t read(void* data, std::size_t size) override { return m_bytes.read(data, size); }
  [[nodiscard]] std::size_t size() const override { return m_bytes.size(); }
  // One of the two overrides: it is const up to OpenImageIO 3.0.
  void flush() const { m_bytes.flush(); }  // NOLINT(modernize-use-override)
  void flush() { m_bytes.flush(); }        // NOLINT(modernize-use-override)

 private:
  ByteOutput& m_bytes;
};

class Output : public ImageOutput {
 public:
  Output(const fs::path& file, const ImageSpec& wanted, ByteOutput& bytes)
      : m_file(file), m_bytes(file, bytes), m_type(typeDesc(wanted.type)) {
    OIIO::ImageSpec spec(int(wanted.width), int(wanted.height), int(wanted.channels.size()),
                         m_type);
    spec.channelnames = wanted.channels;
    if (wanted.channels.size() == 4) spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("DateTime", "");  // equal content gives equal files, without a date
    m_image = OIIO::ImageOutput::create(file.string());
    if (!m_image) {
      (void)OIIO::geterror();  // otherwise the error is printed
      throw InputError(file.string(), "cannot be written",
                       "no picture format has the extension \"" + file.extension().string() + "\"");
    }
    constexpr std::size_t jpegLimit = 65500;  // beyond it libjpeg ends the process
    if (m_image->format_name() == std::string("jpeg") &&
        std::max(wanted.width, wanted.height) > jpegLimit)
      throw InputError(file.string(), "cannot be written",
                       "JPEG ends at 65500 px; use PNG or TIFF");
    if (!m_image->supports("ioproxy") || !m_image->set_ioproxy(&m_bytes) ||
        !m_image->open(file.string(), spec))
      fail();
    if (wanted.type == StoredType::uint8 || m_image->spec().format == m_type) return;
    (void)m_image.release();  // as in ~Output
    throw InputError(file.string(), "cannot be written",
                     "its format does not hold " + std::string(wanted.type == StoredType::real
                                                                   ? "floats; use .exr or .tif"
                                                                   : "16 bits; use .png or .tif"));
  }
  ~Output() override {
    // Leaks a cancelled writer, because closing a file without all of its rows prints on stderr.
    if (!m_isFinished) (void)m_image.release();
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  void write(const StoredRows& values, std::size_t rows) override {
    const int begin = m_row;
    m_row += int(rows);
    const void* first = std::visit([](const auto* at) -> const void* { return at; }, values);
    if (!m_image->write_scanlines(begin, m_row, 0, m_type, first)) fail();
  }

  void finish() override {
    m_isFinished = true;
    if (!m_image->close()) fail();
  }

 private:
  [[noreturn]] void fail() {
    throw InputError(m_file.string(), "cannot be written", asOneLine(m_image->geterror(), m_file));
  }

  fs::path m_file;
  Proxy m_bytes;
  OIIO::TypeDesc m_type;
  std::unique_ptr<OIIO::ImageOutput> m_image;
  int m_row = 0;
  bool m_isFinished = false;
};

}  // namespace

std::unique_ptr<ImageInput> openByOpenImageIo(const fs::path& file, const std::string& format) {
  return std::make_unique<Input>(file, format);
}

std::unique_ptr<ImageOutput> createByOpenImageIo(const fs::path& file, const ImageSpec& spec,
                                                 ByteOutput& bytes) {
  return std::make_unique<Output>(file, spec, bytes);
}

}  // namespace hogelscope
