// SPDX-License-Identifier: BSD-3-Clause
#include "chart/depth_budget_chart.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "chart/depth_bar.h"
#include "core/panel/design_numbers.h"

namespace hogelscope {

namespace {

const QColor inFront(0xd1495b);
const QColor behind(0x2e6f9e);
const QColor good(0x3ba56f);

/// Returns a colour over the chart's ground.
QColor over(const ChartColours& colours, const QColor& colour, double share) {
  const auto mixed = [share](int ground, int top) {
    return int(std::lround(ground + share * (top - ground)));
  };
  const QColor& ground = colours.background;
  return {mixed(ground.red(), colour.red()), mixed(ground.green(), colour.green()),
          mixed(ground.blue(), colour.blue())};
}

constexpr double tintShare = 0.55;

/// Returns the tint of content at the depth z; invalid within both limits.
QColor tintOf(double z, const DepthLimits& limits) {
  const double dioptres = z < limits.distance ? dioptresAt(z, limits.distance) : 0;
  if (DepthLimits::isWithin(dioptres, limits.both())) return {};
  return dioptres > 0 ? inFront : behind;
}

constexpr double rowHeight = 272;
constexpr double headerHeight = 72;
constexpr double margin = 40;

QString percent(double share) {
  return QString::number(100 * share, 'f', share < 0.1 && share > 0 ? 1 : 0) + " %";
}

QFont larger(QFont font, int pixels, bool isBold = false) {
  font.setPixelSize(pixels);
  font.setBold(isBold);
  return font;
}

/// A histogram's axes.
struct DepthAxes {
  QRectF area;
  double end;  ///< dioptres

  [[nodiscard]] double x(double dioptres) const {
    const double share = std::clamp(dioptres / end, -1.0, 1.0);
    return area.center().x() + area.width() / 2 * share;
  }
};

/// Depths in centimetres, the roundest first.
constexpr std::array<double, 17> roundDepths{10, 20, 30, 50,  100, 5,   15,  200, 2,
                                             1,  3,  7,  500, 70,  0.5, 0.2, 0.1};

void paintTicks(QPainter& painter, const DepthAxes& axes, double distance,
                const ChartColours& colours) {
  constexpr double room = 52;
  std::vector<double> placed;
  const auto tick = [&](double depth) {
    if (depth >= 0.999 * distance) return;
    const double dioptres = dioptresAt(depth, distance);
    const double x = axes.x(dioptres);
    if (std::abs(dioptres) > axes.end ||
        std::ranges::any_of(placed, [x](double other) { return std::abs(x - other) < room; }))
      return;
    placed.push_back(x);
    painter.setPen(colours.text);
    painter.drawLine(QPointF(x, axes.area.bottom()), QPointF(x, axes.area.bottom() + 4));
    const QString text = depth == 0 ? "0" : inCentimetres(depth) + " cm";
    painter.drawText(QRectF(x - room, axes.area.bottom() + 5, 2 * room, 16), Qt::AlignCenter, text);
  };
  tick(0);
  for (const double centimetres : roundDepths)
    for (const double sign : {-1.0, 1.0}) tick(sign * centimetres / 100);
  const QRectF below(axes.area.left(), axes.area.bottom() + 23, axes.area.width(), 16);
  painter.setPen(colours.text2);
  const QString title = "depth, even in dioptres of the eye";
  const QString left = "behind the panel";
  const QFontMetricsF metrics(painter.font());
  const double needed = metrics.horizontalAdvance(title) + 2.2 * metrics.horizontalAdvance(left);
  painter.drawText(below, Qt::AlignLeft, left);
  if (needed < below.width()) painter.drawText(below, Qt::AlignHCenter, title);
  painter.drawText(below, Qt::AlignRight, "in front");
}

/// Returns the height at which bars are cut, of the largest ones' shares.
double cutOf(std::vector<double> shares) {
  std::ranges::sort(shares);
  const double high = shares[std::size_t(0.985 * double(shares.size() - 1))];
  return high > 0 && shares.back() > 1.3 * high ? high : shares.back();
}

/// Returns the place of the note on bars that are cut off; empty if there are none.
QRectF paintBars(QPainter& painter, const DepthAxes& axes, const DepthHistogram& depths,
                 const ChartColours& colours) {
  const DepthBars& bars = depths.bars;
  const double most = cutOf(bars.shares);
  if (!(most > 0)) return {};
  const double limit = depths.figures.limits.both();
  double cutShare = 0;
  double leftmost = 0;
  int cutCount = 0;
  for (std::size_t bar = 0; bar < bars.shares.size(); ++bar) {
    const double middle = bars.middle(bar);
    const double left = axes.x(middle - bars.width / 2);
    const double right = axes.x(middle + bars.width / 2);
    const double height = 0.78 * axes.area.height() * std::min(bars.shares[bar] / most, 1.0);
    const bool isInside = std::abs(middle) <= limit + bars.width / 2;  // a part of the bar
    const QColor colour = isInside ? colours.text : middle > 0 ? inFront : behind;
    painter.fillRect(QRectF(left, axes.area.bottom() - height, right - left + 0.5, height), colour);
    if (bars.shares[bar] <= most) continue;
    if (cutCount++ == 0) leftmost = left;
    cutShare += bars.shares[bar];
  }
  if (cutCount == 0) return {};
  painter.setPen(colours.text2);
  const QString note =
      percent(cutShare) + (cutCount == 1 ? " in 1 bar, cut off"
                                         : " in " + QString::number(cutCount) + " bars, cut off");
  const double width = painter.fontMetrics().horizontalAdvance(note);
  const QPointF place(std::clamp(leftmost, axes.area.left(), axes.area.right() - width),
                      axes.area.bottom() - 0.78 * axes.area.height() - 4);
  painter.drawText(place, note);
  const QFontMetrics metrics = painter.fontMetrics();
  return {place.x() - 2, place.y() - metrics.ascent(), width + 4, double(metrics.height())};
}

/// Returns the smallest rectangle with all pixels that see the display.
QRect seenPart(const std::vector<std::uint8_t>& seen, int width) {
  QRect part;
  for (std::size_t pixel = 0; pixel < seen.size(); ++pixel)
    if (seen[pixel] != 0) part |= QRect(int(pixel) % width, int(pixel) / width, 1, 1);
  return part;
}

}  // namespace

void paintDepths(QPainter& painter, const QRectF& area, const DepthHistogram& depths,
                 const ChartColours& colours) {
  const DepthLimits& limits = depths.figures.limits;
  const DepthAxes axes{area.adjusted(0, 0, 0, -42), -depths.bars.low};
  painter.setRenderHint(QPainter::Antialiasing, false);
  const auto span = [&](double limit, const QColor& colour) {
    painter.fillRect(QRectF(QPointF(axes.x(-limit), axes.area.top()),
                            QPointF(axes.x(limit), axes.area.bottom())),
                     colour);
  };
  span(std::max(limits.display, limits.comfort), over(colours, good, 0.11));
  span(limits.both(), over(colours, good, 0.25));
  const QRectF note = paintBars(painter, axes, depths, colours);
  painter.setPen(colours.text);
  painter.drawLine(axes.area.bottomLeft(), axes.area.bottomRight());
  const double panel = axes.x(0);
  const bool isCrossed = note.left() < panel && panel < note.right();
  painter.drawLine(QPointF(panel, axes.area.top()),
                   QPointF(panel, isCrossed ? note.top() : axes.area.bottom()));
  if (isCrossed) painter.drawLine(QPointF(panel, note.bottom()), {panel, axes.area.bottom()});
  painter.setRenderHint(QPainter::Antialiasing, true);
  painter.drawText(QRectF(axes.area.topLeft(), QPointF(panel - 5, axes.area.top() + 16)),
                   Qt::AlignRight, "panel");
  painter.setPen(over(colours, good, 0.8));
  const auto name = [&](double limit, int line, const QString& text) {
    if (limit >= axes.end) return;
    const double width = painter.fontMetrics().horizontalAdvance(text);
    const double x = std::min(axes.x(limit) + 3, axes.area.right() - width);
    painter.drawText(QPointF(x, axes.area.top() + 12 + 13 * line), text);
  };
  name(limits.display, 0, "sharp on this display");
  name(limits.comfort, 1, "comfortable");
  paintTicks(painter, axes, limits.distance, colours);
}

QImage depthTint(const QSize& size, const PixelDepths& depths, const DepthLimits& limits) {
  QImage tint(size, QImage::Format_ARGB32);
  tint.fill(Qt::transparent);
  for (int y = 0; y < size.height(); ++y)
    for (int x = 0; x < size.width(); ++x) {
      const std::size_t pixel = std::size_t(y) * std::size_t(size.width()) + std::size_t(x);
      QColor colour = tintOf(depths.z[pixel], limits);
      if (!colour.isValid()) continue;
      colour.setAlphaF(tintShare);
      tint.setPixelColor(x, y, colour);
    }
  return tint;
}

QImage tintedByDepth(const Image& picture, const PixelDepths& depths, const DepthLimits& limits) {
  QImage tinted(picture.width, picture.height, QImage::Format_RGB32);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t pixel = std::size_t(y) * std::size_t(picture.width) + std::size_t(x);
      const std::uint8_t* const rgb = &picture.rgb[3 * pixel];
      const QColor tint = tintOf(depths.z[pixel], limits);
      const double grey = (rgb[0] + rgb[1] + rgb[2]) / 3.0;
      const auto mixed = [&](int value, int other) {
        return tint.isValid() ? int(0.45 * value + tintShare * other)
                              : int(0.55 * value + 0.45 * grey);
      };
      tinted.setPixel(
          x, y,
          qRgb(mixed(rgb[0], tint.red()), mixed(rgb[1], tint.green()), mixed(rgb[2], tint.blue())));
    }
  return tinted;
}

QSize DepthBudgetChart::size() const {
  return {960, int(headerHeight + rowHeight * (m_budget.proposal ? 2 : 1))};
}

double DepthBudgetChart::end() const {
  return barsEnd(m_budget.now.states.front(),
                 m_budget.proposal ? &m_budget.proposal->depths.states.front() : nullptr);
}

void DepthBudgetChart::paintRow(QPainter& painter, const QRectF& area, const QString& heading,
                                const StatesDepths& depths) const {
  const DepthFigures& figures = depths.states.front();
  painter.setPen(printColours().text);
  const QFont font = painter.font();
  painter.setFont(larger(font, 14));
  painter.drawText(QRectF(area.left(), area.top(), area.width(), 20), Qt::AlignLeft,
                   heading + "   ·   " + percent(figures.inside) + " inside both limits");
  painter.setFont(font);
  const double height = rowHeight - 44;
  const QRectF plot(area.left(), area.top() + 24, 0.6 * area.width(), height);
  paintDepths(painter, plot, {figures, depthBars(figures, end())}, printColours());
  const QImage tinted = tintedByDepth(depths.picture, depths.first, figures.limits)
                            .copy(seenPart(depths.first.seen, depths.picture.width));
  const QRectF place(plot.right() + 30, plot.top(), area.right() - plot.right() - 30, height);
  const QSizeF fitted = QSizeF(tinted.size()).scaled(place.size(), Qt::KeepAspectRatio);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRectF(place.topLeft(), fitted), tinted);
}

void DepthBudgetChart::paint(QPainter& painter, const QSizeF& size) const {
  const DepthFigures& now = m_budget.now.states.front();
  const QFont font = painter.font();
  const QString name = QString::fromStdString(
      std::filesystem::path(contentName(m_session.lightField)).stem().string());
  painter.setPen(printColours().text);
  painter.setFont(larger(font, 20, true));
  painter.drawText(QPointF(margin, 30), "Does “" + name + "” fit this display?");
  painter.setFont(font);
  painter.setPen(printColours().text2);
  const DepthRange range = now.limits.inMetres(now.limits.display);
  painter.drawText(
      QPointF(margin, 52),
      QString::fromStdString(now.state) + ", " + QString::number(now.limits.distance, 'g', 3) +
          " m from the panel: sharp from " + inCentimetres(-range.behind) + " cm to " +
          inCentimetres(range.front) + " cm. Blue: too far behind; red: too far in front.");
  const QRectF first(margin, headerHeight, size.width() - 1.5 * margin, rowHeight);
  paintRow(painter, first, "now", m_budget.now);
  if (m_budget.proposal)
    paintRow(painter, first.translated(0, rowHeight),
             "proposed: " + QString::fromStdString(placeText(*m_budget.proposal)),
             m_budget.proposal->depths);
}

}  // namespace hogelscope
