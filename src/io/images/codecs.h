// SPDX-License-Identifier: BSD-3-Clause
// What needs OpenImageIO or OpenCV's codecs: all picture formats but PNG, PGX, raw YUV and our
// TIFFs. They bring 230 libraries along, which take longer to load than a picture of the sample to
// make: so io/codecs, which implements this, is a library that the program loads with the first
// file that needs it. All functions throw InputError that names the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/light_field/light_field.h"
#include "io/images/image_facts.h"

namespace hogelscope {

/// A picture or a video that is being read.
class ImageInput {
 public:
  virtual ~ImageInput() = default;
  [[nodiscard]] virtual const ImageFacts& facts() const = 0;
  /// Returns how many rows are read together best: pieces begin at multiples of it.
  [[nodiscard]] virtual std::size_t tileRows() const = 0;
  /// Reads rows as 3·width·rows values of the type; grey becomes RGB, colours come multiplied by
  /// alpha.
  using Rows = std::variant<std::uint8_t*, std::uint16_t*, float*>;
  virtual void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) = 0;
};

/// A picture that is being written from the top.
class ImageOutput {
 public:
  virtual ~ImageOutput() = default;
  /// Writes the next rows: channels·width·rows values of the type that the output was made for.
  virtual void write(const StoredRows& values, std::size_t rows) = 0;
  /// Called after the last row; without it what was written is of no use.
  virtual void finish() = 0;
};

struct ImageSpec {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::string> channels{"R", "G", "B"};
  StoredType type = StoredType::uint8;
};

/// Where the bytes of a picture go. Errors are kept, since codecs do not hear of them in time.
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
  /// `format` is OpenImageIO's name of the only one that is tried; empty for any.
  [[nodiscard]] virtual std::unique_ptr<ImageInput> open(const std::filesystem::path& file,
                                                         const std::string& format) const = 0;
  /// The file's extension chooses the format. `bytes` has to outlive the output.
  [[nodiscard]] virtual std::unique_ptr<ImageOutput> create(const std::filesystem::path& file,
                                                            const ImageSpec& spec,
                                                            ByteOutput& bytes) const = 0;
  /// Codes and decodes RGB by OpenCV's JPEG (4:2:0), in place; rows are `stride` bytes apart.
  virtual void throughJpeg(int quality, int width, int height, std::uint8_t* rgb,
                           std::size_t stride) const = 0;
};

/// Throws InputError if the library cannot be loaded.
const Codecs& codecs();

}  // namespace hogelscope
