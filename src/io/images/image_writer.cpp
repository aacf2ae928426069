// SPDX-License-Identifier: BSD-3-Clause
// Writes image files: PNG by libspng, floats by OpenEXR, others by codecs().
#include "io/images/image_writer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <shared_mutex>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/atomic_file.h"
#include "io/files/isolated.h"
#include "io/images/checked_file.h"
#include "io/images/codecs.h"
#include "io/images/image_outputs.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

InputError cannotWriteImage(const fs::path& file, int error) {
  return {file.string(), "cannot be written", std::strerror(error)};
}

/// Holds Isolated::librariesInUse() while the library works.
class LibraryOutput : public ImageOutput {
 public:
  LibraryOutput(const fs::path& file, const ImageSpec& spec, ByteOutput& bytes) {
    const std::shared_lock lock(Isolated::librariesInUse());
    m_output = codecs().create(file, spec, bytes);
  }
  ~LibraryOutput() override {
    const std::shared_lock lock(Isolated::librariesInUse());
    m_output.reset();
  }
  LibraryOutput(const LibraryOutput&) = delete;
  LibraryOutput& operator=(const LibraryOutput&) = delete;

  void write(const StoredRows& values, std::size_t rows) override {
    const std::shared_lock lock(Isolated::librariesInUse());
    m_output->write(values, rows);
  }
  void finish() override {
    const std::shared_lock lock(Isolated::librariesInUse());
    m_output->finish();
  }

 private:
  std::unique_ptr<ImageOutput> m_output;
};

}  // namespace

/// An image file under construction.
struct ImageRowWriter::Output {
  fs::path file;
  AtomicFile atomic;
  CheckedFile bytes;
  std::unique_ptr<ImageOutput> image;

  Output(const fs::path& path, const ImageSpec& spec, PngEffort effort)
      : file(path), atomic(path), bytes(atomic.descriptor()) {
    if (bytes.error() != 0) throw cannotWriteImage(file, bytes.error());
    const std::string extension = lowerCase(file.extension().string());
    if (extension == ".png")
      image = pngOutput(file.string(), spec, effort,
                        [this](const void* data, std::size_t size) { bytes.write(data, size); });
    else if (extension == ".exr" && spec.type == StoredType::real)
      image = exrOutput(file.string(), spec, bytes);
    else
      image = std::make_unique<LibraryOutput>(file, spec, bytes);
  }

  void close() {
    image->finish();
    bytes.close();
    if (bytes.error() != 0) throw cannotWriteImage(file, bytes.error());
  }

  void finish() {
    close();
    atomic.commit();
  }
};

namespace {

/// Writes rows; can be cancelled between bands of rows.
template <class T>
void writeRows(ImageOutput& image, const ImageSpec& spec, const T* values,
               const Progress& progress) {
  constexpr std::size_t band = 64;
  const std::size_t row = spec.width * spec.channels.size();
  for (std::size_t y = 0; y < spec.height; y += band) {
    throwIfCancelled(progress);
    image.write(values + y * row, std::min(band, spec.height - y));
  }
}

template <class T>
void writeWhole(const fs::path& file, const ImageSpec& spec, const T* values,
                const Progress& progress = {}) {
  ImageRowWriter::Output output(file, spec, PngEffort::small);
  writeRows(*output.image, spec, values, progress);
  output.finish();
}

ImageSpec specOf(int width, int height, StoredType type = StoredType::uint8) {
  return {.width = std::size_t(width), .height = std::size_t(height), .type = type};
}

}  // namespace

void writeImage(const fs::path& file, int width, int height, std::span<const std::uint8_t> values,
                const Progress& progress) {
  ImageSpec spec = specOf(width, height);
  if (values.size() == 4 * spec.width * spec.height) spec.channels = {"R", "G", "B", "A"};
  writeWhole(file, spec, values.data(), progress);
}

void writeImage(const fs::path& file, int width, int height, std::span<const float> rgb) {
  std::vector<float> unit(rgb.begin(), rgb.end());
  for (float& value : unit) value /= 255;
  if (file.extension() == ".exr")
    return writeWhole(file, specOf(width, height, StoredType::real), unit.data());
  std::vector<std::uint16_t> rounded(unit.size());
  std::ranges::transform(unit, rounded.begin(), [](float value) {
    return std::uint16_t(std::lround(65535 * std::clamp(double(value), 0.0, 1.0)));
  });
  writeWhole(file, specOf(width, height, StoredType::uint16), rounded.data());
}

std::string encodedPng(int width, int height, std::span<const std::uint8_t> rgb,
                       const Progress& progress) {
  std::string bytes;
  const ImageSpec spec = specOf(width, height);
  const auto add = [&bytes](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  };
  writeRows(*pngOutput("PNG", spec, PngEffort::small, add), spec, rgb.data(), progress);
  return bytes;
}

void writePlanes(const fs::path& file, int width, int height,
                 const std::vector<std::pair<std::string, std::vector<float>>>& planes) {
  ImageSpec spec = specOf(width, height, StoredType::real);
  spec.channels.clear();
  std::vector<float> values(planes.size() * std::size_t(width) * std::size_t(height));
  for (std::size_t k = 0; k < planes.size(); ++k) {
    spec.channels.push_back(planes[k].first);
    for (std::size_t at = 0; at < planes[k].second.size(); ++at)
      values[at * planes.size() + k] = planes[k].second[at];
  }
  writeWhole(file, spec, values.data());
}

void writeMask(const fs::path& file, int width, int height, std::span<const std::uint8_t> grey) {
  ImageSpec spec = specOf(width, height);
  spec.channels = {"Y"};
  writeWhole(file, spec, grey.data());
}

ImageRowWriter::ImageRowWriter(const fs::path& file, std::size_t width, std::size_t height,
                               StoredType type) {
  constexpr std::size_t largest = 1U << 30U;
  if (width > largest || height > largest)
    throw InputError(file.string(), "size", "is beyond 2^30 px on a side");
  // A row of a large light field is a megabyte.
  const ImageSpec spec{.width = width, .height = height, .type = type};
  m_output = std::make_unique<Output>(file, spec, PngEffort::quick);
}

ImageRowWriter::~ImageRowWriter() = default;

void ImageRowWriter::write(const StoredRows& row) {
  m_output->image->write(row, 1);
}

void ImageRowWriter::finish() {
  m_output->finish();
}

std::uintmax_t ImageRowWriter::discard() {
  m_output->close();
  return m_output->bytes.size();
}

}  // namespace hogelscope
