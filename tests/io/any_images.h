// SPDX-License-Identifier: BSD-3-Clause
// Image files of any kind, written and read by OpenImageIO only. Its headers take 3 s to compile:
// they are included once, in any_images.cpp.
#pragma once

#include <string>
#include <vector>

#include "tests/io/images.h"

enum class PictureType { UInt8, UInt16, UInt32, Half, Float, Double, Other };

struct PictureKind {
  PictureType type = PictureType::UInt8;
  int channels = 3;
  int tile = 0;                      ///< side of a tile; 0: rows
  std::vector<std::string> names{};  ///< of the channels, if they are not R, G, B
  int parts = 1;                     ///< pictures in the file, all the same
};

/// Writes an image file, and creates its folder.
void writeImageFile(const QString& file, int width, int height, const PictureValue& value,
                    const PictureKind& kind);

/// One of several pictures of a file. `display` is the whole picture's x, y, width and height;
/// empty: that of the values.
struct PicturePage {
  int width = 0, height = 0;
  int x = 0, y = 0;  ///< of the first value
  std::vector<int> display{};
  std::vector<std::string> channels{"R", "G", "B"};
  std::string name{};   ///< of a part
  int orientation = 1;  ///< EXIF's
  int tile = 0;         ///< side of a tile; 0: rows
  PictureType type = PictureType::UInt8;
  std::string description{};
};

/// Writes a file of several pictures: parts of OpenEXR, pages of TIFF, an animated GIF.
void writePages(const QString& file, const std::vector<PicturePage>& pages,
                const std::function<float(std::size_t page, int x, int y, int channel)>& value);

/// Zeros and Other if unreadable.
struct PictureSpec {
  int width = 0, height = 0, channels = 0;
  PictureType type = PictureType::Other;
};
PictureSpec specOf(const QString& file);

/// Returns all channels of all pixels as T (unsigned char, unsigned short or float), colours as
/// they are stored beside an alpha; empty if unreadable.
template <class T>
std::vector<T> valuesOf(const QString& file);
