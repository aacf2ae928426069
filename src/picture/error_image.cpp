// SPDX-License-Identifier: BSD-3-Clause
#include "picture/error_image.h"

#include <QStringList>
#include <array>

#include "core/base/parallel.h"

namespace hogelscope {

namespace {

std::size_t rowBytes(const QImage& image) {
  return 3 * static_cast<std::size_t>(image.width());
}

}  // namespace

QImage toned(const QImage& image, const Tone& tone) {
  if (tone == Tone()) return image;
  const std::array<std::uint8_t, 256> table = toneTable(tone);
  QImage result = image.convertToFormat(QImage::Format_RGB888);
  for (int y = 0; y < result.height(); ++y)
    for (uchar& value : std::span(result.scanLine(y), rowBytes(result))) value = table[value];
  return result;
}

QImage errorImage(const QImage& reference, const QImage& test, const ErrorMap& map) {
  if (reference.size() != test.size()) return {};
  const QImage from = reference.convertToFormat(QImage::Format_RGB888);
  const QImage to = test.convertToFormat(QImage::Format_RGB888);
  QImage result(from.size(), QImage::Format_RGB888);
  uchar* first = result.bits();
  parallelRows(result.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      map.write({from.constScanLine(y), rowBytes(from)}, {to.constScanLine(y), rowBytes(to)},
                {first + y * result.bytesPerLine(), rowBytes(result)});
  });
  return result;
}

QString ErrorText::name(ErrorKind kind) {
  const std::array names{tr("Absolute error"), tr("Signed error"), tr("Squared error"),
                         tr("Relative error"), tr("Luma error")};
  return names.at(std::size_t(kind));
}

QString ErrorText::unit(ErrorKind kind) {
  if (kind == ErrorKind::relative) return tr("%");
  return kind == ErrorKind::squared ? tr("of 255²") : tr("of 255");
}

QString ErrorText::tone(const Tone& tone) {
  QStringList parts;
  if (tone.gain != 1) parts << tr("× %1").arg(tone.gain);
  if (tone.gamma != 1) parts << tr("gamma %1").arg(tone.gamma);
  return parts.join(", ");
}

QString ErrorText::values(ErrorKind kind, QRgb reference, QRgb test) {
  const auto number = [](double error) { return QString::number(error, 'g', 4); };
  const std::array from{std::uint8_t(qRed(reference)), std::uint8_t(qGreen(reference)),
                        std::uint8_t(qBlue(reference))};
  const std::array to{std::uint8_t(qRed(test)), std::uint8_t(qGreen(test)),
                      std::uint8_t(qBlue(test))};
  if (kind == ErrorKind::luma) return number(pixelError(kind, from, to));
  QStringList channels;
  for (std::size_t k = 0; k < 3; ++k) channels << number(errorOf(kind, from[k], to[k]));
  return channels.join(' ');
}

}  // namespace hogelscope
