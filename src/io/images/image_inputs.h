// SPDX-License-Identifier: BSD-3-Clause
// Opens image files: those that this program reads itself, and those of codecs().
#pragma once

#include <functional>

#include "core/light_field/layout_params.h"
#include "io/images/codecs.h"

namespace hogelscope {

/// Reads rows of 8 or 16 bits from the top, and converts them to any type.
class RowInput : public ImageInput {
 public:
  void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) override;

 private:
  /// Sets the 3·width values of row `y`; T is the stored type. Rows are requested in their order,
  /// and again from row 0 on. Throws InputError that names a damaged row or sample.
  virtual void readRow(std::size_t y, std::uint8_t* rgb) = 0;
  virtual void readRow(std::size_t y, std::uint16_t* rgb) = 0;
  template <class From, class To>
  void readAs(std::size_t first, std::size_t rows, To* rgb);
};

/// Opens a file that begins as a PNG does; null for any other. Light fields of 283 GB are PNGs, and
/// OpenImageIO reads them at 0.4 times the speed and lets libpng write to stderr. Palettes become
/// their colours, grey becomes RGB, alpha is composited over black; 16 bits, or 8 for all files
/// with fewer. Throws InputError if it cannot be read or its header is damaged.
std::unique_ptr<ImageInput> openPng(const std::filesystem::path& file);

/// Opens a PGX file, by its first bytes or its name: an image of one component, as JPEG 2000 and
/// JPEG Pleno use them; null for any other. One component is a grey image. If its folder is named 0
/// and the folders 1 and 2 beside it have files of the same name, these are green and blue, as JPEG
/// Pleno's reference software writes them. Values are scaled to the full range of the type. Throws
/// InputError if it is damaged or the components differ in size or bits.
std::unique_ptr<ImageInput> openPgx(const std::filesystem::path& file);

/// Opens a file named .yuv, because raw YUV has no other mark; null for any other. Several pictures
/// one after the other are frames. If no size is given, the name gives it, as in
/// NAME_1920x1080_yuv420p10le.yuv, and the kind of samples. RGB is rounded to the file's bits and
/// scaled to the full range of the type. Throws InputError if there is no size or the length is not
/// that of whole pictures.
std::unique_ptr<ImageInput> openYuv(const std::filesystem::path& file, const YuvParams& params);

/// Opens an image or a video of any format but PNG, PGX and raw YUV. The content, not the ending,
/// determines the format. JPEG, TIFF, EXR, PNM, PFM and BMP are read by this process; all others by
/// a copy of it (Isolated), since their libraries crash, hang or take gigabytes for some damaged
/// files. Throws InputError that names the file.
std::unique_ptr<ImageInput> openPicture(const std::filesystem::path& file);

/// Opens an image by a function that runs, and reads it, in a copy of this process (Isolated).
/// Throws InputError that names the file.
std::unique_ptr<ImageInput> isolatedInput(const std::filesystem::path& file,
                                          std::function<std::unique_ptr<ImageInput>()> open);

/// Whether a file is HDF5, by its first bytes or those behind a block of 512, 1024 or 2048, as
/// MATLAB's files of version 7.3 have it.
bool isHdf5(const std::filesystem::path& file);

/// Opens the views of a data set, such as "LF" of the old HCI light field archive, or of the Light
/// Field Toolbox for MATLAB; viewAxesOf() says which axes are which. They are frames, row by row;
/// ImageFacts::columns is 0 if one axis has all of them. They are read only as values of their own
/// type. An empty `name` stands for the file's only data set that can be views, or "LF". Throws
/// InputError that names the file and its data sets.
std::unique_ptr<ImageInput> openHdf5(const std::filesystem::path& file,
                                     const std::string& name = {});

}  // namespace hogelscope
