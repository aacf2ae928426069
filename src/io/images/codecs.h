// SPDX-License-Identifier: BSD-3-Clause
// The interface to OpenImageIO, FFmpeg's libraries and OpenCV's codecs, for videos and all image
// formats except PNG, PGX, raw YUV and this program's TIFFs. They bring 230 libraries, which take
// longer to load than rendering an image of the sample; io/codecs, which implements this, is
// therefore a library that the program loads with the first file that needs it. All functions throw
// InputError that names the file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "core/light_field/light_field.h"

namespace hogelscope {

/// A pointer to the first value of pixels owned by the caller.
using StoredRows = std::variant<const std::uint8_t*, const std::uint16_t*, const float*>;

/// The numbers of ImageFacts.
struct ImageNumbers {
  std::size_t width = 0;
  std::size_t height = 0;
  int channels = 0;
  StoredType type = StoredType::uint8;
  /// The bits of a value in the file, 8 … 16: 10 for a PPM whose largest value is 1023. 16 for
  /// floats, 8 for fewer.
  int bits = 8;
  std::size_t frames = 1;    ///< images of the same size in the file: a video's frames
  std::size_t columns = 0;   ///< frames in a row, where they are a grid of views
  std::size_t bandRows = 1;  ///< rows that are read together best: bands begin at multiples of it
  /// How the stored rows lie in the upright picture: EXIF's orientation, 1 (as they are) … 8.
  int orientation = 1;
  /// Pictures in the file, where read() has them all as one or leaves some out; 0: more than one.
  std::size_t pictures = 1;
  bool isVideo = false;  ///< whether the frames follow each other in time
  double rate = 0;       ///< frames of a video shown in a second; 0: unknown
};

/// Returns the rows of about a million pixels, in whole tiles.
constexpr std::size_t bandRowsOf(std::size_t width, std::size_t tileRows = 1) {
  constexpr std::size_t bandPixels = std::size_t{1} << 20U;
  return (bandPixels / width / tileRows + 1) * tileRows;
}

/// A rectangle of pixels; y points down.
struct PixelWindow {
  int x = 0;  ///< of the first pixel
  int y = 0;
  int width = 0;
  int height = 0;
  bool operator==(const PixelWindow&) const = default;
};

/// A picture of a file whose pictures may have other sizes and channels, such as a part of OpenEXR.
struct PicturePart {
  std::string name;     ///< "" if it has none
  PixelWindow data;     ///< the pixels that are stored
  PixelWindow display;  ///< the picture, in the same coordinates
  std::vector<std::string> channels{};
};

struct ImageFacts : ImageNumbers {
  std::string format;  ///< such as "png"
  /// The names of all channels, as the file has them; empty where only colours can be read.
  std::vector<std::string> channelNames{};
  /// What the reader assumes, or what the file says or has beyond the pictures that are read, for
  /// users: sentences without subject, such as "has two streams of pictures, …".
  std::vector<std::string> notes{};
  std::vector<PicturePart> parts{};  ///< of formats that have windows; frame k of read() is part k
};

/// An image or a video that is being read.
class ImageInput {
 public:
  virtual ~ImageInput() = default;
  [[nodiscard]] const ImageFacts& facts() const { return m_facts; }
  /// Works for about half a second to be ready for read() of a frame; returns whether it is ready.
  /// For videos, whose frames are decoded one after the other: a long way is gone in requests that
  /// each keep the limit of Isolated.
  virtual bool prepare(std::size_t /*frame*/) { return true; }
  /// Reads rows as 3·width·rows values of the type; grey becomes RGB, colours come multiplied by
  /// alpha.
  using Rows = std::variant<std::uint8_t*, std::uint16_t*, float*>;
  virtual void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) = 0;
  /// Makes facts() those of one of the file's pictures, and read() take red, green and blue from
  /// these of its channels; none: from the first ones.
  virtual void choose(std::size_t /*picture*/,
                      const std::optional<std::array<int, 3>>& /*colours*/) {
    throw std::logic_error("ImageInput: one picture");
  }
  /// Reads rows of the channel channelNames[channel] of the first frame as width·rows floats.
  /// Throws InputError that names the channel if it has whole numbers, whose scale is unknown, or
  /// if the file has other pictures too.
  virtual void readChannel(std::size_t /*channel*/, std::size_t /*first*/, std::size_t /*rows*/,
                           float* /*to*/) {
    throw std::logic_error("ImageInput: channels without names");
  }

 protected:
  ImageFacts m_facts;
};

/// An image that is written from the top.
class ImageOutput {
 public:
  virtual ~ImageOutput() = default;
  /// Writes the next rows: channels·width·rows values of the output's type.
  virtual void write(const StoredRows& values, std::size_t rows) = 0;
  /// Completes the image after the last row; without it the image is unusable.
  virtual void finish() = 0;
};

struct ImageSpec {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::string> channels{"R", "G", "B"};
  StoredType type = StoredType::uint8;
};

/// The destination of an image's bytes. Errors are kept, because codecs do not notice them in time.
class ByteOutput {
 public:
  virtual ~ByteOutput() = default;
  virtual void seek(std::int64_t pos) = 0;
  virtual void write(const void* data, std::size_t size) = 0;
  virtual std::size_t read(void* data, std::size_t size) = 0;
  [[nodiscard]] virtual std::size_t size() const = 0;
  virtual void flush() = 0;
};

class Codecs {
 public:
  virtual ~Codecs() = default;
  /// Opens a file. `format` is OpenImageIO's name of the only format to try; empty for any.
  [[nodiscard]] virtual std::unique_ptr<ImageInput> open(const std::filesystem::path& file,
                                                         const std::string& format) const = 0;
  /// Opens a video; `format` is FFmpeg's name of its container (videoFormatOf()). The facts are
  /// known after prepare(0).
  [[nodiscard]] virtual std::unique_ptr<ImageInput> openVideo(const std::filesystem::path& file,
                                                              const std::string& format) const = 0;
  /// Creates an image; the file's extension gives the format. `bytes` must outlive the output.
  [[nodiscard]] virtual std::unique_ptr<ImageOutput> create(const std::filesystem::path& file,
                                                            const ImageSpec& spec,
                                                            ByteOutput& bytes) const = 0;
  /// Encodes and decodes RGB with OpenCV's JPEG (4:2:0), in place; rows are `stride` bytes apart.
  virtual void throughJpeg(int quality, int width, int height, std::uint8_t* rgb,
                           std::size_t stride) const = 0;
};

/// Returns the codecs. Throws InputError if the library cannot be loaded.
const Codecs& codecs();

}  // namespace hogelscope
