// SPDX-License-Identifier: BSD-3-Clause
// Image files of any kind, written and read by OpenImageIO only.
#pragma once

#include <OpenImageIO/imageio.h>

#include "tests/io/images.h"

struct PictureKind {
  OIIO::TypeDesc::BASETYPE type = OIIO::TypeDesc::UINT8;
  int channels = 3;
  int tile = 0;  ///< side of a tile; 0: rows
};

/// Writes an image file, and creates its folder.
inline void writeImageFile(const QString& file, int width, int height, const PictureValue& value,
                           const PictureKind& kind) {
  QDir().mkpath(QFileInfo(file).path());
  OIIO::ImageSpec spec(width, height, kind.channels, kind.type);
  spec.tile_width = spec.tile_height = kind.tile;
  spec.attribute("oiio:UnassociatedAlpha", 1);  // writes colours unchanged
  spec.attribute("png:compressionLevel", 1);
  spec.attribute("pnm:pfmflip", 0);  // OpenImageIO 2.5 would flip PPMs too
  std::vector<float> values;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < kind.channels; ++c) values.push_back(value(x, y, c));
  const auto out = OIIO::ImageOutput::create(file.toStdString());
  if (!out || !out->open(file.toStdString(), spec) ||
      !out->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !out->close())
    qFatal("cannot write %s", qPrintable(file));
}

inline OIIO::ImageSpec specOf(const QString& file) {
  const auto in = OIIO::ImageInput::open(file.toStdString());
  return in ? in->spec() : OIIO::ImageSpec();
}

/// Returns all channels of all pixels as T (unsigned char, unsigned short or float); empty if
/// unreadable.
template <class T>
std::vector<T> valuesOf(const QString& file) {
  const auto in = OIIO::ImageInput::open(file.toStdString());
  if (!in) return {};
  const OIIO::ImageSpec& spec = in->spec();
  std::vector<T> values(spec.image_pixels() * std::size_t(spec.nchannels));
  const bool isRead =
      in->read_image(0, 0, 0, spec.nchannels, OIIO::BaseTypeFromC<T>::value, values.data());
  return isRead && !in->has_error() ? values : std::vector<T>();
}
