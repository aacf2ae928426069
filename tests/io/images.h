// SPDX-License-Identifier: BSD-3-Clause
// PNGs, JPEGs and PPMs of 8 bit, written and read by Qt only. any_images.h has all formats, but
// loads 230 libraries.
#pragma once

#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QImageReader>
#include <QString>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

/// Returns a value; 0 … 1 is the range of an integer type.
using PictureValue = std::function<float(int x, int y, int channel)>;

/// Writes RGB, and creates the file's folder.
inline void writeImageFile(const QString& file, int width, int height, const PictureValue& value) {
  QDir().mkpath(QFileInfo(file).path());
  QImage image(width, height, QImage::Format_RGB888);
  for (int y = 0; y < height; ++y) {
    uchar* row = image.scanLine(y);
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        row[3 * x + c] = uchar(std::lround(255 * std::clamp(value(x, y, c), 0.0F, 1.0F)));
  }
  // For PNG this is zlib's effort, the least.
  if (const int quality = file.endsWith(".png") ? 80 : 95; !image.save(file, nullptr, quality))
    qFatal("cannot write %s", qPrintable(file));
}

/// Writes a hogel image of pieces of a wall before the panel, and of one behind it, which show that
/// columns run from the left to the right, and rows downwards.
inline void writeTwoWalls(const QString& file, int nx, int ny, int du, int dv) {
  writeImageFile(file, nx * du, ny * dv, [=](int px, int py, int c) {
    const double u = double(px % du) / du, v = double(py % dv) / dv;
    const double x = (px / du + 0.5) / nx, y = (py / dv + 0.5) / ny;
    const auto wall = [](double ofX, double ofY, int colour) {
      return float(0.5 + 0.2 * std::sin(31 * ofX + 5 * ofY + colour) +
                   0.2 * std::sin(17 * ofY - 8 * ofX));
    };
    const bool isNear = std::sin(14 * (x + 0.2 * u)) * std::sin(14 * (y + 0.2 * v)) > 0;
    return isNear ? wall(x + 0.2 * u, y + 0.2 * v, c)
                  : wall(2 * (x - 0.1 * u) + 1, 2 * (y - 0.1 * v), c + 2);
  });
}

inline void writeGrey(const QString& file, int width, int height) {
  writeImageFile(file, width, height, [](int, int, int) { return 0.5F; });
}

inline QSize sizeOf(const QString& file) {
  return QImageReader(file).size();
}

/// Returns RGB of all pixels, one channel for a grey image; empty if unreadable.
inline std::vector<std::uint8_t> bytesOf(const QString& file) {
  const QImage stored(file);
  if (stored.isNull()) return {};
  const bool isGrey = stored.format() == QImage::Format_Grayscale8;
  const QImage image = isGrey ? stored : stored.convertToFormat(QImage::Format_RGB888);
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < image.height(); ++y) {
    const uchar* row = image.constScanLine(y);
    bytes.insert(bytes.end(), row, row + (isGrey ? 1 : 3) * image.width());
  }
  return bytes;
}
