// SPDX-License-Identifier: BSD-3-Clause
// Reads image files of any format from the top.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/light_field/light_field.h"
#include "core/light_field/yuv_params.h"
#include "io/images/image_facts.h"

namespace hogelscope {

class ImageInput;

/// An opened image file; every error names it. Grey becomes RGB, alpha is composited over black.
class ImageFile {
 public:
  /// Opens a file. `yuv` has the missing properties of raw YUV, named .yuv.
  explicit ImageFile(const std::filesystem::path& file, const YuvParams& yuv = {});
  ~ImageFile();
  ImageFile(ImageFile&&) noexcept;
  ImageFile& operator=(ImageFile&&) = delete;

  [[nodiscard]] std::size_t width() const { return m_facts.width; }
  [[nodiscard]] std::size_t height() const { return m_facts.height; }
  [[nodiscard]] int channels() const { return m_facts.channels; }
  [[nodiscard]] StoredType type() const { return m_facts.type; }
  [[nodiscard]] int bits() const { return m_facts.bits; }
  [[nodiscard]] std::string format() const { return m_facts.format; }
  [[nodiscard]] std::size_t frames() const { return m_facts.frames; }
  /// Selects the frame that read() reads, initially 0.
  void select(std::size_t frame) { m_frame = int(frame); }

  /// Receives rows [first, first + rows), three values per pixel, valid only during the call.
  using Band = std::function<void(std::size_t first, std::size_t rows, const StoredRows&)>;
  /// Reads all pixels from the top, some rows at a time. Throws InputError (damaged, NaN,
  /// infinite).
  void read(StoredType type, const Band& band, const Progress& progress);

  [[nodiscard]] const std::filesystem::path& file() const { return m_file; }

 private:
  template <class T>
  void readAs(const Band& band, const Progress& progress);
  template <class Rows>
  void take(const Rows& rows, const char* format);

  enum class Reader { png, pgx, yuv, codecs };
  std::filesystem::path m_file;
  YuvParams m_yuv;
  Reader m_reader = Reader::codecs;
  ImageFacts m_facts;
  int m_frame = 0;
  std::unique_ptr<ImageInput> m_input;  ///< of codecs(); null for the other readers
};

}  // namespace hogelscope
