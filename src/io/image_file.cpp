// SPDX-License-Identifier: BSD-3-Clause
// Picture files, through OpenImageIO.
#include "io/image_file.h"

#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "io/atomic_file.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

template <class T>
constexpr OIIO::TypeDesc::BASETYPE baseType() {
  if constexpr (std::is_same_v<T, std::uint8_t>) return OIIO::TypeDesc::UINT8;
  if constexpr (std::is_same_v<T, std::uint16_t>) return OIIO::TypeDesc::UINT16;
  return OIIO::TypeDesc::FLOAT;
}

/// OpenImageIO's message on one line, without the file's name, which our line has already.
std::string oneLine(std::string text, const fs::path& file) {
  for (const std::string& noise : {"\"" + file.string() + "\"", "'" + file.string() + "'"})
    if (const std::size_t at = text.find(noise); at != std::string::npos)
      text.replace(at, noise.size(), "it");
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text.empty() ? "unknown reason" : text;
}

void refuseNotANumber(std::span<const float> values, std::size_t width, const fs::path& file) {
  const auto bad =
      std::find_if(values.begin(), values.end(), [](float v) { return std::isnan(v); });
  if (bad == values.end()) return;
  const std::size_t pixel = std::size_t(bad - values.begin()) / 3;
  throw InputError(
      file.string(),
      "pixel (" + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) + ")",
      "is not a number");
}

std::string gigabytes(double bytes) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f GB", bytes / 1e9);
  return text.data();
}

}  // namespace

void checkFits(std::size_t bytes, const fs::path& file) {
  const double memory = double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGESIZE));
  if (double(bytes) > 0.9 * memory)
    throw InputError(
        file.string(), "size",
        "needs " + gigabytes(double(bytes)) + " of memory, this machine has " + gigabytes(memory));
}

struct ImageFile::Input {
  std::unique_ptr<OIIO::ImageInput> image;
  OIIO::ImageSpec spec;
};

ImageFile::ImageFile(const fs::path& file) : m_file(file), m_input(std::make_unique<Input>()) {
  std::error_code error;
  if (!fs::exists(file, error)) throw InputError(file.string(), "", "there is no such file");
  if (fs::is_directory(file, error))
    throw InputError(file.string(), "",
                     "is a folder, not a picture; a folder has layout \"views\"");
  m_input->image = OIIO::ImageInput::open(file.string());
  if (!m_input->image)
    throw InputError(file.string(), "cannot be read as a picture", oneLine(OIIO::geterror(), file));
  m_input->spec = m_input->image->spec();
  const OIIO::ImageSpec& spec = m_input->spec;
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1 || spec.deep)
    throw InputError(file.string(), "", "is not a flat picture with pixels");
}

ImageFile::~ImageFile() = default;
ImageFile::ImageFile(ImageFile&&) noexcept = default;

std::size_t ImageFile::width() const {
  return std::size_t(m_input->spec.width);
}
std::size_t ImageFile::height() const {
  return std::size_t(m_input->spec.height);
}
int ImageFile::channels() const {
  return m_input->spec.nchannels;
}
std::string ImageFile::format() const {
  return m_input->image->format_name();
}

StoredType ImageFile::type() const {
  switch (m_input->spec.format.basetype) {
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

template <class T>
std::vector<T> ImageFile::readAs(const Progress& progress) {
  const std::size_t pixels = width() * height();
  checkFits(3 * pixels * sizeof(T), m_file);
  std::vector<T> values(3 * pixels);
  const int used = channels() < 3 ? 1 : 3;
  bool stopped = false;
  const auto stop = [](void* data, float done) {
    const auto& [tell, flag] = *static_cast<std::pair<const Progress*, bool*>*>(data);
    *flag = *tell && !(*tell)(double(done));
    return *flag;
  };
  std::pair<const Progress*, bool*> context{&progress, &stopped};
  const bool whole =
      m_input->image->read_image(0, 0, 0, used, baseType<T>(), values.data(), 3 * sizeof(T),
                                 OIIO::AutoStride, OIIO::AutoStride, stop, &context);
  if (stopped) throw Cancelled();
  // Some readers fill the rest of a truncated file and only leave a message.
  if (!whole || m_input->image->has_error())
    throw InputError(m_file.string(), "is damaged", oneLine(m_input->image->geterror(), m_file));
  if (used == 1)
    for (std::size_t p = 0; p < pixels; ++p) values[3 * p + 1] = values[3 * p + 2] = values[3 * p];
  if constexpr (std::is_same_v<T, float>) refuseNotANumber(values, width(), m_file);
  return values;
}

LightField::Values ImageFile::read(StoredType type, const Progress& progress) {
  switch (type) {
    case StoredType::uint8:
      return readAs<std::uint8_t>(progress);
    case StoredType::uint16:
      return readAs<std::uint16_t>(progress);
    default:
      return readAs<float>(progress);
  }
}

struct ImageRowWriter::Output {
  AtomicFile atomic;
  fs::path file;
  std::unique_ptr<OIIO::ImageOutput> image;
  int row = 0;

  Output(const fs::path& path, const OIIO::ImageSpec& spec) : atomic(path), file(path) {
    image = OIIO::ImageOutput::create(path.string());
    if (!image)
      throw InputError(path.string(), "cannot be written",
                       "no picture format has the extension \"" + path.extension().string() + "\"");
    // libjpeg's own handler ends the process beyond this.
    constexpr int jpegLimit = 65500;
    if (std::string(image->format_name()) == "jpeg" &&
        std::max(spec.width, spec.height) > jpegLimit)
      throw InputError(path.string(), "cannot be written",
                       "JPEG ends at 65500 px; use PNG or TIFF");
    if (!image->open(atomic.temporary().string(), spec)) fail();
  }

  [[noreturn]] void fail() {
    throw InputError(file.string(), "cannot be written",
                     oneLine(image->geterror(), atomic.temporary()));
  }

  void finish() {
    if (!image->close()) fail();
    atomic.commit();
  }
};

namespace {

template <class T>
void writeWhole(const fs::path& file, const OIIO::ImageSpec& spec, std::span<const T> values) {
  AtomicFile atomic(file);
  const auto image = OIIO::ImageOutput::create(file.string());
  const bool done = image && image->open(atomic.temporary().string(), spec) &&
                    image->write_image(baseType<T>(), values.data()) && image->close();
  if (!done)
    throw InputError(file.string(), "cannot be written",
                     oneLine(image ? image->geterror() : OIIO::geterror(), atomic.temporary()));
  atomic.commit();
}

}  // namespace

void writeImage(const fs::path& file, int width, int height, std::span<const std::uint8_t> rgb) {
  writeWhole(file, OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8), rgb);
}

void writeImage(const fs::path& file, int width, int height, std::span<const float> rgb) {
  const bool isExr = file.extension() == ".exr";
  const auto type = isExr ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT16;
  std::vector<float> unit(rgb.begin(), rgb.end());
  for (float& value : unit) value /= 255;
  writeWhole(file, OIIO::ImageSpec(width, height, 3, type), std::span<const float>(unit));
}

void writeMask(const fs::path& file, int width, int height, std::span<const std::uint8_t> grey) {
  writeWhole(file, OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::UINT8), grey);
}

ImageRowWriter::ImageRowWriter(const fs::path& file, std::size_t width, std::size_t height) {
  constexpr std::size_t largest = 1U << 30U;
  if (width > largest || height > largest)
    throw InputError(file.string(), "size", "is beyond 2^30 px on a side");
  m_output = std::make_unique<Output>(
      file, OIIO::ImageSpec(int(width), int(height), 3, OIIO::TypeDesc::UINT8));
}

ImageRowWriter::~ImageRowWriter() = default;

void ImageRowWriter::write(std::span<const std::uint8_t> row) {
  if (!m_output->image->write_scanline(m_output->row++, 0, OIIO::TypeDesc::UINT8, row.data()))
    m_output->fail();
}

void ImageRowWriter::finish() {
  m_output->finish();
}

}  // namespace hogelscope
