// SPDX-License-Identifier: BSD-3-Clause
// Reads image files of any format from the top.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/progress.h"
#include "core/light_field/layout_params.h"
#include "io/images/codecs.h"

namespace hogelscope {

/// An opened image file; every error names it. Grey becomes RGB, alpha is composited over black,
/// and what the file says of its picture is done (io/images/picture_facts.h): it is upright and
/// whole.
class ImageFile {
 public:
  /// Opens a file. `yuv` has the properties that raw YUV (named .yuv) does not contain.
  explicit ImageFile(const std::filesystem::path& file, const YuvParams& yuv = {});
  /// Takes an input of another kind that is open already.
  ImageFile(std::filesystem::path file, std::unique_ptr<ImageInput> input);

  [[nodiscard]] std::size_t width() const { return m_input->facts().width; }
  [[nodiscard]] std::size_t height() const { return m_input->facts().height; }
  [[nodiscard]] int channels() const { return m_input->facts().channels; }
  [[nodiscard]] StoredType type() const { return m_input->facts().type; }
  [[nodiscard]] int bits() const { return m_input->facts().bits; }
  [[nodiscard]] std::string format() const { return m_input->facts().format; }
  [[nodiscard]] std::size_t frames() const { return m_input->facts().frames; }
  [[nodiscard]] bool isVideo() const { return m_input->facts().isVideo; }
  /// Returns the frames of a video that are shown in a second; 0 if it does not say it.
  [[nodiscard]] double rate() const { return m_input->facts().rate; }
  /// Returns the frames in a row of the grid that they are; 0 if the file does not say it.
  [[nodiscard]] std::size_t columns() const { return m_input->facts().columns; }
  /// Returns sentences without subject on what is assumed of the file, on what of it is not read if
  /// all frames are, and on values that are no light of 0 … 1. Of floats it reads some.
  [[nodiscard]] std::vector<std::string> notes();
  /// Returns notes() of a file of which only the selected frame is read, or, of a video, one at a
  /// time.
  [[nodiscard]] std::vector<std::string> notesOfOne();
  /// Selects the frame that read() reads; initially 0.
  void select(std::size_t frame) { m_frame = frame; }

  /// Receives rows [first, first + rows), three values per pixel, valid only during the call.
  using Band = std::function<void(std::size_t first, std::size_t rows, const StoredRows&)>;
  /// Reads all pixels from the top, some rows at a time. Throws InputError (damaged, NaN,
  /// infinite).
  void read(StoredType type, const Band& band, const Progress& progress);
  /// Receives row y, three values per pixel; 1 is full scale.
  using Row = std::function<void(std::size_t y, const float* rgb)>;
  /// Reads all pixels as floats; otherwise as read().
  void readRows(const Row& row, const Progress& progress);

  [[nodiscard]] const std::filesystem::path& file() const { return m_file; }

 private:
  template <class T>
  void readAs(const Band& band, const Progress& progress);

  std::filesystem::path m_file;
  std::unique_ptr<ImageInput> m_input;
  std::size_t m_frame = 0;
};

/// Returns "JPEG", "HEIF" or "video" for a file whose pictures have lost something when they were
/// encoded; "" for others, and for files that cannot be read.
std::string lossyFormatOf(const std::filesystem::path& file);

/// Returns the version of the loaded library, not of its headers, such as "4.6.0".
std::string openCvVersion();
/// Returns the version of the headers, because querying the library would load it. The first two
/// numbers are the same.
std::string openImageIoVersion();

}  // namespace hogelscope
