// SPDX-License-Identifier: BSD-3-Clause
#include "chart/lens_pictures.h"

#include <QImage>
#include <algorithm>
#include <cmath>

#include "chart/outcome_legend.h"

namespace hogelscope {

namespace {

/// Distances in points.
constexpr double margin = 14;
constexpr double between = 16;
constexpr double top = 50;
constexpr double nameHeight = 22;
constexpr double captionHeight = 26;
constexpr double legendHeight = 76;
constexpr double width = 1000;

const OutcomeWords& words() {
  static const OutcomeWords all{"right: the pixel's own ray, to 0.001 px",
                                "no ray: the pixel has none, and the method says so",
                                "inexact: more than 0.001 px off, but nearer than at first",
                                "diverged: no nearer than at first, or not a number",
                                "wrong root: another pixel's ray, or one where there is none"};
  return all;
}

double pictureWidth() {
  const auto columns = double(inverseMethods().size());
  return (width - 2 * margin - (columns - 1) * between) / columns;
}

/// Returns a height with the camera's aspect ratio, within limits.
double pictureHeight(const LensKey& lens) {
  return pictureWidth() * std::clamp(double(lens.res[1]) / lens.res[0], 0.25, 1.5);
}

std::size_t endOf(const Stability& stability, std::size_t first) {
  return std::min(stability.lenses.size(), first + mostLensPictures);
}

QImage pictureOf(const LensOutcomes& outcomes) {
  const int side = int(std::lround(std::sqrt(double(outcomes.each.size()))));
  QImage image(side, side, QImage::Format_RGB32);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      image.setPixel(x, y,
                     colourOf(outcomes.each[std::size_t(y) * std::size_t(side) + std::size_t(x)]));
  return image;
}

/// Returns "all right", or the worst outcome and its share.
QString captionOf(const LensOutcomes& outcomes) {
  const Outcome worst = outcomes.worst();
  if (worst == Outcome::right) return "all right";
  const double share = double(outcomes[worst]) / double(outcomes.points());
  return QString::number(100 * share, 'f', 1) + " % " +
         QString::fromStdString(outcomeNames()[std::size_t(worst)]).replace('_', ' ');
}

}  // namespace

QSize lensPicturesSize(const Stability& stability, std::size_t first) {
  double height = top + legendHeight;
  for (std::size_t k = first; k < endOf(stability, first); ++k)
    height += nameHeight + pictureHeight(stability.lenses[k].key) + captionHeight;
  return {int(width), int(std::ceil(height))};
}

void paintLensPictures(QPainter& painter, const QSizeF& size, const Stability& stability,
                       std::size_t first) {
  const auto& methods = inverseMethods();
  const double across = pictureWidth();
  const auto left = [&](std::size_t m) { return margin + double(m) * (across + between); };
  paintTitle(painter, QRectF(0, 4, size.width(), 18),
             "Where in the picture of each lens each way to invert it holds");
  for (std::size_t m = 0; m < methods.size(); ++m)
    paintTitle(painter, QRectF(left(m), top - 24, across, 18), titleOf(methods[m]));
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  painter.setBrush(Qt::NoBrush);
  double y = top;
  for (std::size_t k = first; k < endOf(stability, first); ++k) {
    const double height = pictureHeight(stability.lenses[k].key);
    const QString name = painter.fontMetrics().elidedText(
        QString::fromStdString(stability.lenses[k].name), Qt::ElideRight, int(width - 2 * margin));
    painter.drawText(QRectF(margin, y, width - 2 * margin, nameHeight),
                     Qt::AlignLeft | Qt::AlignVCenter, name);
    y += nameHeight;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const QRectF area(left(m), y, across, height);
      painter.drawImage(area, pictureOf(stability.outcomes[k][m]));
      painter.drawRect(area);
      painter.drawText(QRectF(left(m), area.bottom() + 2, across, 16), Qt::AlignCenter,
                       captionOf(stability.outcomes[k][m]));
    }
    y += height + captionHeight;
  }
  paintOutcomeLegend(painter, QRectF(margin, y + 4, width - 2 * margin, legendHeight), words());
}

}  // namespace hogelscope
