// SPDX-License-Identifier: BSD-3-Clause
// Opens files as inputs: those that this program reads itself, and those of codecs().
#pragma once

#include <functional>

#include "core/light_field/yuv_params.h"
#include "io/images/codecs.h"

namespace hogelscope {

/// Reads rows of 8 or 16 bits from the top, and converts them to any type.
class RowInput : public ImageInput {
 public:
  void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) override;

 private:
  /// Sets the 3·width values of row `y`; T is the stored type. Rows are asked for in their order,
  /// and again from row 0 on. Throws InputError that names a damaged row or sample.
  virtual void readRow(std::size_t y, std::uint8_t* rgb) = 0;
  virtual void readRow(std::size_t y, std::uint16_t* rgb) = 0;
  template <class From, class To>
  void readAs(std::size_t first, std::size_t rows, To* rgb);
};

/// Opens a file that begins as a PNG does; null for any other. Light fields of 283 GB are PNGs, and
/// OpenImageIO reads them at 0.4 times the speed and lets libpng write to stderr. Palettes count as
/// their colours, grey becomes RGB, alpha is composited over black; 16 bits, or 8 for all files
/// with fewer. Throws InputError: it cannot be read, or its header is damaged.
std::unique_ptr<ImageInput> openPng(const std::filesystem::path& file);

/// Opens a file that begins as a PGX does, or is named like one, the pictures of one component that
/// JPEG 2000 and JPEG Pleno use; null for any other. One component
/// is a grey picture. If its folder is named 0 and the folders 1 and 2 beside it have files of the
/// same name, these are green and blue, as JPEG Pleno's reference software writes them. Values are
/// spread over all bits of the type. Throws InputError: damaged, or the components differ in size
/// or bits.
std::unique_ptr<ImageInput> openPgx(const std::filesystem::path& file);

/// Opens a file that is named as raw YUV is, since nothing in it says so; null for any other. RGB
/// is rounded to the file's bits and spread over all of the type's. Throws InputError: no size is
/// given, or the file is not as long as the parameters say.
std::unique_ptr<ImageInput> openYuv(const std::filesystem::path& file, const YuvParams& params);

/// Opens a picture or a video of any format but PNG, PGX and raw YUV. The content, not the ending,
/// tells the format. JPEG, TIFF, EXR, PNM, PFM and BMP are read by this process; all others by a
/// copy of it (Isolated), since their libraries crash, hang or take gigabytes for some damaged
/// files. Throws InputError that names the file.
std::unique_ptr<ImageInput> openPicture(const std::filesystem::path& file);

/// Opens a picture by a function that runs, and reads it, in a copy of this process (Isolated).
/// Throws InputError that names the file.
std::unique_ptr<ImageInput> isolatedInput(const std::filesystem::path& file,
                                          std::function<std::unique_ptr<ImageInput>()> open);

/// Whether a file is HDF5, by its first bytes.
bool isHdf5(const std::filesystem::path& file);

/// Opens the views of a data set of rows × columns × height × width × 3 values, as the old HCI
/// light field archive has them ("LF"), or without the last axis. They are frames, row by row
/// (ImageFacts::columns); they are read as values of their own type alone. `name` is the data
/// set's, or empty: then the file's only one that can be views, or "LF". Throws InputError that
/// names the file and the data sets that are there.
std::unique_ptr<ImageInput> openHdf5(const std::filesystem::path& file,
                                     const std::string& name = {});

}  // namespace hogelscope
