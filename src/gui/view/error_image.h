// SPDX-License-Identifier: BSD-3-Clause
// Images in other tones, and the error of two images as an image.
#pragma once

#include <QCoreApplication>
#include <QImage>

#include "core/metrics/error_map.h"

namespace hogelscope {

/// The image itself where the tone changes nothing.
QImage toned(const QImage& image, const Tone& tone);

/// Of `test` against `reference`. Null where the sizes differ.
QImage errorImage(const QImage& reference, const QImage& test, const ErrorMap& map);

class ErrorText {
  Q_DECLARE_TR_FUNCTIONS(ErrorText)

 public:
  /// "Absolute error"
  static QString name(ErrorKind kind);
  /// Of a colour scale's numbers.
  static QString unit(ErrorKind kind);
  /// "× 8, gamma 1.4"; nothing of what changes nothing.
  static QString tone(const Tone& tone);
  /// The error of a pixel, of each channel where there are three.
  static QString values(ErrorKind kind, QRgb reference, QRgb test);
};

}  // namespace hogelscope
