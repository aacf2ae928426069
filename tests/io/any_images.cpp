// SPDX-License-Identifier: BSD-3-Clause
#include "tests/io/any_images.h"

#include <OpenImageIO/imageio.h>

namespace {

OIIO::TypeDesc::BASETYPE typeOf(PictureType type) {
  switch (type) {
    case PictureType::UInt8:
      return OIIO::TypeDesc::UINT8;
    case PictureType::UInt16:
      return OIIO::TypeDesc::UINT16;
    case PictureType::UInt32:
      return OIIO::TypeDesc::UINT32;
    case PictureType::Half:
      return OIIO::TypeDesc::HALF;
    case PictureType::Float:
      return OIIO::TypeDesc::FLOAT;
    case PictureType::Double:
      return OIIO::TypeDesc::DOUBLE;
    case PictureType::Other:
      break;
  }
  qFatal("no type to write");
}

PictureType typeOf(const OIIO::TypeDesc& type) {
  for (const PictureType each : {PictureType::UInt8, PictureType::UInt16, PictureType::UInt32,
                                 PictureType::Half, PictureType::Float, PictureType::Double})
    if (type == typeOf(each)) return each;
  return PictureType::Other;
}

OIIO::ImageSpec specOf(const PicturePage& page) {
  OIIO::ImageSpec spec(page.width, page.height, int(page.channels.size()), typeOf(page.type));
  spec.channelnames = page.channels;
  spec.x = page.x;
  spec.y = page.y;
  if (page.display.size() == 4) {
    spec.full_x = page.display[0];
    spec.full_y = page.display[1];
    spec.full_width = page.display[2];
    spec.full_height = page.display[3];
  } else {
    spec.full_x = page.x;
    spec.full_y = page.y;
  }
  spec.tile_width = spec.tile_height = page.tile;
  if (page.orientation != 1) spec.attribute("Orientation", page.orientation);
  if (!page.name.empty()) spec.attribute("oiio:subimagename", page.name);
  if (!page.description.empty()) spec.attribute("ImageDescription", page.description);
  spec.attribute("CompressionQuality", 100);
  return spec;
}

}  // namespace

void writePages(const QString& file, const std::vector<PicturePage>& pages,
                const std::function<float(std::size_t page, int x, int y, int channel)>& value) {
  QDir().mkpath(QFileInfo(file).path());
  std::vector<OIIO::ImageSpec> specs;
  for (const PicturePage& page : pages) specs.push_back(specOf(page));
  const auto out = OIIO::ImageOutput::create(file.toStdString());
  const bool isTogether = out && out->supports("multiimage") && !out->supports("appendsubimage");
  bool isWritten =
      out && (isTogether ? out->open(file.toStdString(), int(specs.size()), specs.data())
                         : out->open(file.toStdString(), specs[0]));
  for (std::size_t page = 0; page < pages.size() && isWritten; ++page) {
    const OIIO::ImageSpec& spec = specs[page];
    isWritten = page == 0 || out->open(file.toStdString(), spec, OIIO::ImageOutput::AppendSubimage);
    std::vector<float> values;
    for (int y = 0; y < spec.height; ++y)
      for (int x = 0; x < spec.width; ++x)
        for (int c = 0; c < spec.nchannels; ++c) values.push_back(value(page, x, y, c));
    isWritten = isWritten && out->write_image(OIIO::TypeDesc::FLOAT, values.data());
  }
  if (!isWritten || !out->close()) qFatal("cannot write %s", qPrintable(file));
}

void writeImageFile(const QString& file, int width, int height, const PictureValue& value,
                    const PictureKind& kind) {
  QDir().mkpath(QFileInfo(file).path());
  OIIO::ImageSpec spec(width, height, kind.channels, typeOf(kind.type));
  spec.tile_width = spec.tile_height = kind.tile;
  spec.attribute("oiio:UnassociatedAlpha", 1);  // writes colours unchanged
  spec.attribute("png:compressionLevel", 1);
  spec.attribute("pnm:pfmflip", 0);  // OpenImageIO 2.5 would flip PPMs too
  if (!kind.names.empty()) spec.channelnames = kind.names;
  const std::vector<OIIO::ImageSpec> parts(std::size_t(kind.parts), spec);
  std::vector<float> values;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < kind.channels; ++c) values.push_back(value(x, y, c));
  const auto out = OIIO::ImageOutput::create(file.toStdString());
  bool isWritten =
      out && (kind.parts == 1 ? out->open(file.toStdString(), spec)
                              : out->open(file.toStdString(), kind.parts, parts.data()));
  for (int part = 0; part < kind.parts && isWritten; ++part) {
    isWritten = part == 0 || out->open(file.toStdString(), spec, OIIO::ImageOutput::AppendSubimage);
    isWritten = isWritten && out->write_image(OIIO::TypeDesc::FLOAT, values.data());
  }
  if (!isWritten || !out->close()) qFatal("cannot write %s", qPrintable(file));
}

PictureSpec specOf(const QString& file) {
  const auto in = OIIO::ImageInput::open(file.toStdString());
  if (!in) return {};
  const OIIO::ImageSpec& spec = in->spec();
  return {spec.width, spec.height, spec.nchannels, typeOf(spec.format)};
}

template <class T>
std::vector<T> valuesOf(const QString& file) {
  OIIO::ImageSpec asStored;
  asStored.attribute("oiio:UnassociatedAlpha", 1);
  const auto in = OIIO::ImageInput::open(file.toStdString(), &asStored);
  if (!in) return {};
  const OIIO::ImageSpec& spec = in->spec();
  std::vector<T> values(spec.image_pixels() * std::size_t(spec.nchannels));
  const bool isRead =
      in->read_image(0, 0, 0, spec.nchannels, OIIO::BaseTypeFromC<T>::value, values.data());
  return isRead && !in->has_error() ? values : std::vector<T>();
}

template std::vector<unsigned char> valuesOf(const QString&);
template std::vector<unsigned short> valuesOf(const QString&);
template std::vector<float> valuesOf(const QString&);
