// SPDX-License-Identifier: BSD-3-Clause
// Tone changes of images, and error images.
#pragma once

#include <QCoreApplication>
#include <QImage>

#include "core/metrics/error_map.h"

namespace hogelscope {

/// Returns the image with the tone applied; the image itself if the tone changes nothing.
QImage toned(const QImage& image, const Tone& tone);

/// Returns the error of `test` against `reference`; null if the sizes differ.
QImage errorImage(const QImage& reference, const QImage& test, const ErrorMap& map);

class ErrorText {
  Q_DECLARE_TR_FUNCTIONS(ErrorText)

 public:
  /// Returns the kind's name, such as "Absolute error".
  static QString name(ErrorKind kind);
  /// Returns the unit of the colour scale.
  static QString unit(ErrorKind kind);
  /// Returns a text such as "× 8, gamma 1.4"; parts without effect are omitted.
  static QString tone(const Tone& tone);
  /// Returns a pixel's error, for each channel if there are three.
  static QString values(ErrorKind kind, QRgb reference, QRgb test);
};

}  // namespace hogelscope
