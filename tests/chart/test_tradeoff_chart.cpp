// SPDX-License-Identifier: BSD-3-Clause
// Tests the chart of speed against accuracy: names cover nothing, points lie where axes say.
#include <QFontMetricsF>
#include <QImage>
#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "chart/method_texts.h"
#include "chart/painting.h"
#include "chart/recommendations.h"
#include "chart/tradeoff_chart.h"
#include "chart/tradeoff_names.h"
#include "tests/chart/sample_rows.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

using Rows = std::vector<TradeoffRow>;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

constexpr QSize fileSize(720, 520);

/// As of files, chart/painting.h.
QFont chartFont() {
  QFont font;
  font.setFamilies({"DejaVu Sans", "Liberation Sans", "sans-serif"});
  font.setPixelSize(12);
  return font;
}

TradeoffAxes axesOf(const Rows& rows, const QSizeF& size = fileSize) {
  return TradeoffChart(rows, "Error").axes(size, chartFont());
}

Paint paintOf(const TradeoffChart& chart) {
  return [&](QPainter& painter, const QSizeF& size) { chart.paintFile(painter, size); };
}

/// Colours that are easy to tell apart.
ChartColours gaudy() {
  return {.background = 0x101010,
          .text = 0xf0f0f0,
          .text2 = 0xa0a0a0,
          .line = 0x404040,
          .grid = 0x303030,
          .accent = 0x0000ff,
          .series = {0x00ffff, 0xff8000, 0x00ff00, 0xff00ff}};
}

/// What a window shows, one pixel per point.
QImage windowOf(const TradeoffChart& chart, const QSize& size = fileSize) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(gaudy().background);
  QPainter painter(&image);
  painter.setFont(chartFont());
  chart.paint(painter, size, gaudy());
  return image;
}

/// The same methods with other times and errors, some of them equal or nearly.
Rows randomRows(std::uint64_t seed) {
  Random random(seed);
  Rows rows = sampleRows();
  for (TradeoffRow& row : rows) {
    setTimes(row, {std::pow(10.0, random.uniform(-0.5, 2.7))});
    row.rmse = random.integer(0, 3) == 0 ? 0 : std::pow(10.0, random.uniform(-3, 1.5));
    const TradeoffRow& other = rows[static_cast<std::size_t>(random.integer(0, 28))];
    if (other.milliseconds <= 0 || random.integer(0, 4) > 0) continue;
    setTimes(row, {other.milliseconds * (random.flip() ? 1 : 1.02)});
    row.rmse = other.rmse;
  }
  markPareto(rows);
  return rows;
}

/// Where the SVG begins to write `words`, before rotations.
std::optional<QPointF> textAt(const std::string& svg, const QString& words) {
  const QRegularExpression pattern("x=\"([-0-9.]+)\" y=\"([-0-9.]+)\"[^>]*>\\s*" +
                                   QRegularExpression::escape(words) + "\\s*</text>");
  const auto match = pattern.match(QString::fromStdString(svg));
  if (!match.hasMatch()) return std::nullopt;
  return QPointF(match.captured(1).toDouble(), match.captured(2).toDouble());
}

bool saysIt(const std::string& svg, const QString& words) {
  return textAt(svg, words).has_value();
}

std::string chartSvg(const Rows& rows, const QSize& size = fileSize) {
  const TradeoffChart chart(rows, "Error against the display as built");
  return svgOf(paintOf(chart), size, "speed against accuracy");
}

/// Whether the box is beside the segment, with a little room.
bool isOff(const QRectF& box, const QLineF& segment) {
  return !QRectF(segment.p1(), segment.p2())
              .normalized()
              .adjusted(-.5, -.5, .5, .5)
              .intersects(box);
}

}  // namespace

class TestTradeoffChart : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void namesCoverNothing_data();
  void namesCoverNothing();
  void namesOfTheFrontAreBelowLeft();
  void aFileNamesMore();
  void alikePointsShareAName();
  void pointsLieOnALogarithmicScale();
  void ticksAgreeWithPoints();
  void theNearestPointIsFound();
  void aNameStandsForItsPoint();
  void zeroLiesBelowAllOthers();
  void theFileSaysWhatIsRecommended();
  void paintsTheSameTwice();
  void coloursAreTheGivenOnes();
  void markersTellTheFamily();
  void selectionShowsInTheWindowOnly();
  void unmeasuredRowsAreLeftOut();
  void aSampleHasAnAsterisk();
  void theSpreadIsALineThroughThePoint();
  void anErrorOfPartOfThePixelsHasABar();
  void oddRows_data();
  void oddRows();
};

void TestTradeoffChart::namesCoverNothing_data() {
  QTest::addColumn<QSize>("size");
  QTest::addColumn<std::vector<TradeoffRow>>("rows");
  for (const QSize& size : {QSize(900, 640), QSize(500, 380), QSize(700, 170)}) {
    const std::string suffix = " at " + std::to_string(size.width());
    QTest::addRow("sample%s", suffix.c_str()) << size << sampleRows();
    QTest::addRow("agreeing%s", suffix.c_str()) << size << agreeingRows();
    for (int seed = 1; seed <= 40; ++seed)
      QTest::addRow("random %d%s", seed, suffix.c_str())
          << size << randomRows(static_cast<std::uint64_t>(seed));
  }
}

void TestTradeoffChart::namesCoverNothing() {
  QFETCH(QSize, size);
  QFETCH(std::vector<TradeoffRow>, rows);
  const TradeoffAxes axes = axesOf(rows, size);
  const std::vector<QLineF> front = paretoSteps(rows, axes);
  for (const Names which : {Names::ofFront, Names::all}) {
    std::vector<QRectF> taken = axes.captionBoxes();
    for (const PlacedName& name : placeNames(rows, axes, which)) {
      const char* text = rows[name.row].method.c_str();
      const bool isWanted = rows[name.row].isPareto || rows[name.row].isDefault;
      QVERIFY2(which == Names::all || isWanted, text);
      QVERIFY(name.text.startsWith(text));
      QVERIFY(name.box.width() >= QFontMetricsF(chartFont()).horizontalAdvance(name.text));
      const auto holds = [&](const QRectF& area) {
        return area.contains(name.box) && area.contains(*axes.positionOf(rows[name.row]));
      };
      QCOMPARE(std::ranges::count_if(axes.areas(), holds), 1);
      const auto covers = [&](const QRectF& other) { return other.intersects(name.box); };
      QVERIFY2(std::ranges::none_of(taken, covers), text);
      QVERIFY2(std::ranges::all_of(front, [&](auto& line) { return isOff(name.box, line); }), text);
      for (std::size_t k = 0; k < rows.size(); ++k) {
        QVERIFY2(isOff(name.box, axes.quartilesOf(rows[k])), text);
        const double radius = 0.9 * markerRadius(rows, k, axes.em());
        const QPointF reach(radius, radius);
        const QPointF point = *axes.positionOf(rows[k]);
        QVERIFY2(!covers({point - reach, point + reach}), text);
      }
      taken.push_back(name.box);
    }
  }
}

void TestTradeoffChart::namesOfTheFrontAreBelowLeft() {
  const Rows rows = rowsOf({{"a", 1, 100}, {"b", 10, 10}, {"c", 100, 1}, {"beaten", 90, 30}});
  const TradeoffAxes axes = axesOf(rows);
  const std::vector<PlacedName> names = placeNames(rows, axes, Names::ofFront);
  QCOMPARE(names.size(), std::size_t{3});
  for (const PlacedName& name : names) {
    const QPointF point = *axes.positionOf(rows[name.row]);
    QVERIFY2(name.box.right() < point.x(), qPrintable(name.text));
    QVERIFY2(name.box.center().y() >= point.y(), qPrintable(name.text));
    QVERIFY2(QLineF(name.box.topRight(), point).length() < 2 * axes.em(), qPrintable(name.text));
  }
}

void TestTradeoffChart::aFileNamesMore() {
  const Rows rows = sampleRows();
  const auto count = [&](Names which) { return placeNames(rows, axesOf(rows), which).size(); };
  const auto front = std::size_t(std::ranges::count_if(rows, &TradeoffRow::isPareto));
  QVERIFY(3 * count(Names::ofFront) >= 2 * front);
  QVERIFY(count(Names::all) > count(Names::ofFront) + 5);
}

void TestTradeoffChart::alikePointsShareAName() {
  Rows rows = rowsOf({{"first", 10, 1},
                      {"second", 10.1, 1},
                      {"third", 9.95, 1.02},
                      {"fast", 1, 5},
                      {"good", 12, 0.01}});
  for (std::size_t k = 0; k < 3; ++k) rows[k].isPareto = false;
  rows[1].isDefault = true;
  QStringList texts;
  for (const PlacedName& name : placeNames(rows, axesOf(rows), Names::ofFront)) texts += name.text;
  texts.sort();
  QCOMPARE(texts, (QStringList{"fast", "good", "second (default) and 2 alike"}));
}

void TestTradeoffChart::pointsLieOnALogarithmicScale() {
  const Rows rows = rowsOf({{"a", 1, 0.1}, {"b", 10, 1}, {"c", 100, 10}, {"d", 2, 5}});
  const TradeoffAxes axes = axesOf(rows);
  std::vector<QPointF> points;
  for (const TradeoffRow& row : rows) points.push_back(*axes.positionOf(row));
  const auto& [a, b, c, d] = std::tie(points[0], points[1], points[2], points[3]);
  const auto isNear = [](double x, double y) { return std::abs(x - y) < 1e-6; };
  QVERIFY(isNear(b.x(), (a.x() + c.x()) / 2));
  QVERIFY(isNear(b.y(), (a.y() + c.y()) / 2));
  QVERIFY(isNear(d.x(), a.x() + (c.x() - a.x()) * std::log10(2.0) / 2));
  QVERIFY(isNear(d.y(), c.y() + (a.y() - c.y()) * std::log10(2.0) / 2));
  QVERIFY(a.x() < c.x() && a.y() > c.y());
}

void TestTradeoffChart::ticksAgreeWithPoints() {
  const Rows rows = rowsOf({{"a", 1, 0.01}, {"b", 2000, 8.0638}});
  const std::string svg = chartSvg(rows);
  const TradeoffAxes axes = axesOf(rows);
  const QFontMetricsF metrics(chartFont());
  const std::array<QString, 2> texts{"1 ms", "2 s"};
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const std::optional<QPointF> place = textAt(svg, texts[k]);
    if (k == 1 && !place) continue;  // only 1 s and 10 s have a text where decades are narrow
    const double middle = place->x() + metrics.horizontalAdvance(texts[k]) / 2;
    QVERIFY2(std::abs(middle - axes.positionOf(rows[k])->x()) < 1.5, qPrintable(texts[k]));
  }
  // 20 log10(255 / 8.0638) = 30 dB lies on the right at the point's height, its text's base below.
  const double base = textAt(svg, "30")->y();
  const double height = axes.positionOf(rows[1])->y();
  QVERIFY(base > height && base < height + 0.6 * axes.em());
}

void TestTradeoffChart::theNearestPointIsFound() {
  Random random(7);
  for (int seed = 1; seed <= 10; ++seed) {
    const Rows rows = randomRows(std::uint64_t(seed));
    const TradeoffChart chart(rows, "Error");
    const TradeoffAxes axes = axesOf(rows);
    for (int k = 0; k < 20; ++k) {
      const QPointF start = *axes.positionOf(rows[std::size_t(random.integer(0, 28))]);
      const QPointF place = start + QPointF(random.uniform(-7, 7), random.uniform(-7, 7));
      const auto distance = [&](const TradeoffRow& row) {
        return QLineF(*axes.positionOf(row), place).length();
      };
      const std::optional<std::size_t> found = chart.rowAt(place, fileSize, chartFont());
      QVERIFY(found.has_value());
      QCOMPARE(distance(rows[*found]), distance(*std::ranges::min_element(rows, {}, distance)));
    }
    QVERIFY(!chart.rowAt({0, 0}, fileSize, chartFont()));
  }
}

void TestTradeoffChart::aNameStandsForItsPoint() {
  const Rows rows = rowsOf({{"a fast method", 1, 100}, {"a good method", 100, 1}});
  const TradeoffChart chart(rows, "Error");
  const std::vector<PlacedName> names = placeNames(rows, axesOf(rows), Names::ofFront);
  QCOMPARE(names.size(), std::size_t{2});
  for (const PlacedName& name : names) {
    const QPointF far = name.box.left() + 3 < axesOf(rows).positionOf(rows[name.row])->x()
                            ? QPointF(name.box.left() + 3, name.box.center().y())
                            : QPointF(name.box.right() - 3, name.box.center().y());
    QCOMPARE(chart.rowAt(far, fileSize, chartFont()), std::optional(name.row));
  }
}

void TestTradeoffChart::zeroLiesBelowAllOthers() {
  const Rows rows = rowsOf({{"exact", 10, 0}, {"float", 5, 1e-3}, {"off", 1, 10}});
  const TradeoffAxes axes = axesOf(rows);
  QCOMPARE(axes.areas().size(), std::size_t{2});
  QVERIFY(axes.areas()[1].contains(*axes.positionOf(rows[0])));
  QVERIFY(axes.areas()[0].contains(*axes.positionOf(rows[1])));
  QVERIFY(axes.areas()[0].bottom() < axes.areas()[1].top());
  for (const char* words : {"the reference’s own pixels", "∞"}) {
    QVERIFY2(saysIt(chartSvg(rows), words), words);
    QVERIFY2(!saysIt(chartSvg(rowsOf({{"float", 5, 1e-3}})), words), words);
  }
}

void TestTradeoffChart::theFileSaysWhatIsRecommended() {
  const std::string svg = chartSvg(sampleRows());
  for (const char* words :
       {"PSF truncated (moving view)", "60 views/s", "30 views/s", "PSNR, dB",
        "Error against the display as built, RMS in code values", "Time of one picture",
        "Pareto front", "hollow: beaten by another", "leakage", "sampling", "several"})
    QVERIFY2(saysIt(svg, words), words);
  QVERIFY(!saysIt(svg, "hover names, click renders"));
  // 8 pt: 12 of 720 units that are 480 pt wide.
  QVERIFY(svg.find("width=\"169.333mm\"") != std::string::npos);
  QVERIFY(svg.find("font-size=\"12\"") != std::string::npos);
}

void TestTradeoffChart::paintsTheSameTwice() {
  const TradeoffChart chart(sampleRows(), "Error");
  const std::string png = pngOf(paintOf(chart), fileSize);
  QCOMPARE(png, pngOf(paintOf(chart), fileSize));
  const QImage image = QImage::fromData(QByteArray::fromStdString(png));
  QCOMPARE(image.size(), 2 * fileSize);
}

void TestTradeoffChart::coloursAreTheGivenOnes() {
  const Rows rows = rowsOf({{"half size", 1, 100}, {"quadrilinear", 100, 1}});
  const TradeoffChart chart(rows, "Error");
  const TradeoffAxes axes = axesOf(rows);
  const QImage window = windowOf(chart);
  const QImage file = QImage::fromData(QByteArray::fromStdString(pngOf(paintOf(chart), fileSize)));
  QCOMPARE(window.pixelColor(2, 40), gaudy().background);
  QCOMPARE(file.pixelColor(4, 80), QColor(Qt::white));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const QPointF point = *axes.positionOf(rows[k]);
    const std::size_t series = k == 0 ? 1 : 3;
    QCOMPARE(window.pixelColor(point.toPoint()), gaudy().series[series]);
    QCOMPARE(file.pixelColor((2 * point).toPoint()), printColours().series[series]);
  }
}

/// A colour and a shape for each way to save time, hollow where another row is better.
void TestTradeoffChart::markersTellTheFamily() {
  const auto painted = [](TradeoffRow row, bool isPareto) {
    row.isPareto = isPareto;
    QImage image(41, 41, QImage::Format_RGB32);
    image.fill(gaudy().background);
    QPainter painter(&image);
    paintMarker(painter, {20.5, 20.5}, 10, row, gaudy());
    return image;
  };
  const std::vector<std::pair<const char*, QColor>> families{
      {"exact", gaudy().series[0]},      {"exact, float", gaudy().series[0]},
      {"table 4 px", gaudy().series[0]}, {"half size", gaudy().series[1]},
      {"PSF off", gaudy().series[2]},    {"nearest 2×2", gaudy().series[3]},
      {"bilinear", gaudy().series[3]},   {"half size, PSF off", gaudy().text2}};
  for (const auto& [name, colour] : families) {
    const TradeoffRow row = rowsOf({{name, 1, 1}}).front();
    QVERIFY2(painted(row, true).pixelColor(20, 20) == colour, name);
    QVERIFY2(painted(row, false).pixelColor(20, 20) == gaudy().background, name);
  }
  // Only the square reaches its corners, only the triangle is wider below.
  const auto isFull = [&](const char* name, int x, int y) {
    return painted(rowsOf({{name, 1, 1}}).front(), true).pixelColor(x, y) != gaudy().background;
  };
  QVERIFY(isFull("half size", 12, 12) && !isFull("exact", 12, 12) && !isFull("bilinear", 12, 12));
  QVERIFY(isFull("PSF off", 12, 27) && !isFull("PSF off", 12, 13));
}

void TestTradeoffChart::selectionShowsInTheWindowOnly() {
  TradeoffChart chart(sampleRows(), "Error");
  const std::string file = svgOf(paintOf(chart), fileSize, "");
  const QImage plain = windowOf(chart);
  const QPoint point = axesOf(sampleRows()).positionOf(sampleRows()[18])->toPoint();
  chart.select(18);
  QVERIFY(windowOf(chart).pixelColor(point + QPoint(0, 9)).blue() >
          plain.pixelColor(point + QPoint(0, 9)).blue() + 40);
  chart.select(std::nullopt);
  chart.point(18);
  QVERIFY(windowOf(chart).pixelColor(point + QPoint(0, 9)).red() > 150);
  chart.select(18);
  QCOMPARE(svgOf(paintOf(chart), fileSize, ""), file);
  chart.select(std::nullopt);
  chart.point(std::nullopt);
  QCOMPARE(windowOf(chart), plain);
}

void TestTradeoffChart::unmeasuredRowsAreLeftOut() {
  Rows rows = rowsOf({{"no time", 0, 1},
                      {"backwards", -3, 1},
                      {"endless", infinite, 1},
                      {"unknown", none, 1},
                      {"no error", 1, none},
                      {"wild", 1, infinite},
                      {"negative", 1, -1}});
  for (const TradeoffRow& row : rows) QVERIFY(!axesOf(rows).positionOf(row).has_value());
  QVERIFY(!chartSvg(rows).empty());
  const Rows good = sampleRows();
  rows.insert(rows.begin(), good.begin(), good.end());
  QCOMPARE(chartSvg(rows), chartSvg(good));
}

void TestTradeoffChart::aSampleHasAnAsterisk() {
  Rows rows = rowsOf({{"fast", 1, 100}, {"good", 100, 1}});
  QVERIFY(chartSvg(rows).find("part of the pixels") == std::string::npos);
  rows[0].isSampled = true;
  const std::string svg = chartSvg(rows);
  QVERIFY(svg.find("* on part of the pixels") != std::string::npos);
  QCOMPARE(nameOf(rows, 0), QString("fast*"));
  QCOMPARE(nameOf(rows, 1), QString("good"));
  rows[1].isSampled = true;  // where all are, names need none
  QCOMPARE(nameOf(rows, 0), QString("fast"));
  QVERIFY(chartSvg(rows).find(">on part of the pixels") != std::string::npos);
}

void TestTradeoffChart::theSpreadIsALineThroughThePoint() {
  Rows rows = sampleRows();
  TradeoffRow& row = rows[2];
  const double median = row.milliseconds;
  setTimes(row, {median / 3, median / 2, median, 1.5 * median, 4 * median});
  const TradeoffAxes axes = axesOf(rows);
  const auto placeOf = [&](double milliseconds) {
    TradeoffRow there = row;
    there.milliseconds = milliseconds;
    return *axes.positionOf(there);
  };
  const QPointF from = placeOf(median / 2);
  const QPointF to = placeOf(1.5 * median);
  const QRegularExpression line("<polyline[^>]*points=\"([-0-9.]+),([-0-9.]+) ([-0-9.]+),");
  int found = 0;
  auto lines = line.globalMatch(QString::fromStdString(chartSvg(rows)));
  while (lines.hasNext()) {
    const auto match = lines.next();
    const auto isAt = [&match](int group, double place) {
      return std::abs(match.captured(group).toDouble() - place) < 0.1;
    };
    if (isAt(1, from.x()) && isAt(2, from.y()) && isAt(3, to.x())) ++found;
  }
  QCOMPARE(found, 1);
}

void TestTradeoffChart::anErrorOfPartOfThePixelsHasABar() {
  Rows rows =
      rowsOf({{"whole", 1, 100}, {"part", 10, 10}, {"none seen", 100, 0}, {"least", 50, 1}});
  for (TradeoffRow& row : rows) row.psnrLow = row.psnrHigh = row.psnr;
  rows[1].psnrLow = 20 * std::log10(255 / 20.0);
  rows[1].psnrHigh = 20 * std::log10(255 / 4.0);
  rows[2].psnrLow = 20 * std::log10(255 / 50.0);
  const TradeoffAxes axes = axesOf(rows);
  const auto yOf = [&](double rmse) { return axes.positionOf(rowsOf({{"", 1, rmse}})[0])->y(); };
  QVERIFY(axes.errorBarOf(rows[0]).isNull() && axes.errorBarOf(rows[3]).isNull());
  const QLineF bar = axes.errorBarOf(rows[1]);
  QCOMPARE(bar.x1(), axes.positionOf(rows[1])->x());
  QCOMPARE(bar.x2(), bar.x1());
  QVERIFY(std::abs(bar.y1() - yOf(20)) < 1e-6 && std::abs(bar.y2() - yOf(4)) < 1e-6);
  const QLineF down = axes.errorBarOf(rows[2]);
  QVERIFY(std::abs(down.y1() - yOf(50)) < 1e-6 && down.y2() == axes.positionOf(rows[2])->y());
  rows[1].psnrLow = 0;  // outside the plot
  QCOMPARE(axes.errorBarOf(rows[1]).y1(), axes.areas().front().top());
  const QString with = detailsOf(rows, 1, gaudy(), 13);
  QVERIFY2(with.contains("(0.0 to 36.1)"), qPrintable(with));
  QVERIFY(detailsOf(rows, 2, gaudy(), 13).contains("no error seen"));
  QVERIFY(
      cardText({Purpose::standard}, rows[2], false, true, gaudy(), 13).contains("no error seen"));
  QCOMPARE(errorText(rows[0]), "100");
  QCOMPARE(errorText(rows[1]), "10 (4 to 255)");
}

void TestTradeoffChart::oddRows_data() {
  QTest::addColumn<std::vector<TradeoffRow>>("rows");
  QTest::newRow("one") << rowsOf({{"only", 3, 1}});
  QTest::newRow("one, error 0") << rowsOf({{"only", 3, 0}});
  QTest::newRow("all errors 0") << rowsOf({{"a", 3, 0}, {"b", 30, 0}, {"c", 3.01, 0}});
  QTest::newRow("no error 0") << rowsOf({{"a", 3, 1}, {"b", 30, 0.1}});
  QTest::newRow("two equal") << rowsOf({{"a", 3, 1}, {"b", 3, 1}});
  QTest::newRow("far apart") << rowsOf({{"a", 1e-300, 1e300}, {"b", 1e300, 1e-300}});
  Rows same = sampleRows();
  for (TradeoffRow& row : same) setTimes(row, {5});
  for (TradeoffRow& row : same) row.rmse = 0;
  markPareto(same);
  QTest::newRow("all equal") << same;
  for (TradeoffRow& row : same) row.isPareto = false;
  QTest::newRow("no front") << same;
}

void TestTradeoffChart::oddRows() {
  QFETCH(std::vector<TradeoffRow>, rows);
  for (const QSize& size : {QSize(900, 640), QSize(500, 380)}) {
    const std::string svg = chartSvg(rows, size);
    for (const char* number : {"nan", "inf"}) QVERIFY(svg.find(number) == std::string::npos);
  }
  // Too small for anything: no hang, no crash.
  const TradeoffChart chart(rows, "Error");
  for (const QSize& size : {QSize(120, 90), QSize(1, 1)})
    QVERIFY(!pngOf(paintOf(chart), size).empty());
}

QTEST_MAIN(TestTradeoffChart)
#include "test_tradeoff_chart.moc"
