// SPDX-License-Identifier: BSD-3-Clause
// Tests the chart of speed against accuracy: numbers cover nothing, points lie where axes say.
#include <QFontMetricsF>
#include <QImage>
#include <QRegularExpression>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "chart/painting.h"
#include "chart/recommendations.h"
#include "chart/tradeoff_chart.h"
#include "chart/tradeoff_numbers.h"
#include "tests/chart/sample_rows.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

using Rows = std::vector<TradeoffRow>;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

Paint paintOf(const TradeoffChart& chart) {
  return [&](QPainter& painter, const QSizeF& size) { chart.paint(painter, size); };
}

QFont chartFont() {
  QFont font;
  font.setFamilies({"DejaVu Sans", "Liberation Sans", "sans-serif"});
  return font;
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

/// The centre of all places where the chart finds the row.
std::optional<QPointF> centreOf(const TradeoffChart& chart, std::size_t row, const QSize& size) {
  QPointF sum;
  int count = 0;
  for (int y = 0; y < size.height(); ++y)
    for (int x = 0; x < size.width(); ++x)
      if (chart.rowAt(QPointF(x, y), size) == row) {
        sum += QPointF(x, y);
        ++count;
      }
  if (count == 0) return std::nullopt;
  return sum / count;
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

std::string chartSvg(const Rows& rows, const QSize& size = {900, 640}) {
  const TradeoffChart chart(rows, "Error against the display as built");
  return svgOf(paintOf(chart), size, "speed against accuracy");
}

}  // namespace

class TestTradeoffChart : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void numbersCoverNothing_data();
  void numbersCoverNothing();
  void legendIsSorted_data() { numbersCoverNothing_data(); }
  void legendIsSorted();
  void pointsLieOnALogarithmicScale();
  void ticksAgreeWithPoints();
  void everyPointIsFound();
  void nearPointsShareABox();
  void zeroLiesBelowAllOthers();
  void recommendationsAreWritten();
  void svgNamesEveryMethod();
  void paintsTheSameTwice();
  void selectionShows();
  void unmeasuredRowsAreLeftOut();
  void aSampleHasAnAsterisk();
  void theSpreadIsALineThroughThePoint();
  void oddRows_data();
  void oddRows();
};

void TestTradeoffChart::numbersCoverNothing_data() {
  QTest::addColumn<QSize>("size");
  QTest::addColumn<std::vector<TradeoffRow>>("rows");
  for (const QSize& size : {QSize(900, 640), QSize(600, 450)}) {
    const std::string suffix = " at " + std::to_string(size.width());
    QTest::addRow("sample%s", suffix.c_str()) << size << sampleRows();
    QTest::addRow("agreeing%s", suffix.c_str()) << size << agreeingRows();
    for (int seed = 1; seed <= 20; ++seed)
      QTest::addRow("random %d%s", seed, suffix.c_str())
          << size << randomRows(static_cast<std::uint64_t>(seed));
  }
}

void TestTradeoffChart::numbersCoverNothing() {
  QFETCH(QSize, size);
  QFETCH(std::vector<TradeoffRow>, rows);
  const TradeoffAxes axes = TradeoffChart(rows, "Error").axes(size);
  const QFont font = sized(chartFont(), 0.8 * axes.em(), true);
  std::set<std::size_t> seen;
  std::vector<QRectF> boxes;
  for (const PointNumbers& group : numbersBesidePoints(rows, axes, font)) {
    seen.insert(group.numbers.begin(), group.numbers.end());
    const QString text = textOf(group);
    QVERIFY(group.box.width() >= QFontMetricsF(font).horizontalAdvance(text));
    const auto holds = [&](const QRectF& area) { return area.contains(group.box); };
    QCOMPARE(std::ranges::count_if(axes.areas(), holds), 1);
    const auto covers = [&](const QRectF& other) { return other.intersects(group.box); };
    QVERIFY2(std::ranges::none_of(boxes, covers), qPrintable(text));
    QVERIFY2(!axes.zeroCaption(font).intersects(group.box), qPrintable(text));
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const double radius = 0.9 * axes.em() * markerRadius(rows, k);
      const QPointF reach(radius, radius);
      const QPointF point = *axes.positionOf(rows[k]);
      QVERIFY2(!covers({point - reach, point + reach}), qPrintable(text));
    }
    boxes.push_back(group.box);
  }
  QCOMPARE(seen.size(), rows.size());
}

/// One line for each method from fast to slow, right of the plot, and none covers another.
void TestTradeoffChart::legendIsSorted() {
  QFETCH(QSize, size);
  QFETCH(std::vector<TradeoffRow>, rows);
  const TradeoffChart chart(rows, "Error");
  const std::vector<QRectF> boxes = chart.nameBoxes(size, chartFont());
  QCOMPARE(boxes.size(), rows.size());
  const double plotEnd = chart.axes(size).areas().front().right();
  const TradeoffRow* before = nullptr;
  double bottom = 0;
  for (const std::size_t row : numbered(rows)) {
    const QRectF& box = boxes[row];
    QVERIFY(box.height() > 6 && box.top() > bottom - 1e-6);
    QVERIFY(box.left() > plotEnd && QRectF({0, 0}, size).contains(box));
    QVERIFY(before == nullptr || before->milliseconds <= rows[row].milliseconds);
    before = &rows[row];
    bottom = box.bottom();
  }
}

void TestTradeoffChart::pointsLieOnALogarithmicScale() {
  const QSize size(600, 450);
  const Rows rows = rowsOf({{"a", 1, 0.1}, {"b", 10, 1}, {"c", 100, 10}, {"d", 2, 5}});
  const TradeoffChart chart(rows, "Error");
  const QPointF a = *centreOf(chart, 0, size);
  const QPointF b = *centreOf(chart, 1, size);
  const QPointF c = *centreOf(chart, 2, size);
  const QPointF d = *centreOf(chart, 3, size);
  const auto isNear = [](double x, double y) { return std::abs(x - y) < 0.5; };
  QVERIFY(isNear(b.x(), (a.x() + c.x()) / 2));
  QVERIFY(isNear(b.y(), (a.y() + c.y()) / 2));
  QVERIFY(isNear(d.x(), a.x() + (c.x() - a.x()) * std::log10(2.0) / 2));
  QVERIFY(isNear(d.y(), c.y() + (a.y() - c.y()) * std::log10(2.0) / 2));
  QVERIFY(a.x() < c.x() && a.y() > c.y());
}

void TestTradeoffChart::ticksAgreeWithPoints() {
  const QSize size(900, 640);
  const Rows rows = rowsOf({{"a", 1, 0.01}, {"b", 100, 8.0638}});
  const std::string svg = chartSvg(rows, size);
  const TradeoffChart chart(rows, "Error");
  const double em = chart.axes(size).em();
  const QFontMetricsF metrics(sized(chartFont(), 0.9 * em));
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const QPointF point = *centreOf(chart, k, size);
    const QString words = QString::number(rows[k].milliseconds);
    const double middle = textAt(svg, words)->x() + metrics.horizontalAdvance(words) / 2;
    QVERIFY2(std::abs(middle - point.x()) < 1.5, qPrintable(words));
  }
  // 20 log10(255 / 8.0638) = 30 dB lies on the right at the point's height, its text's base below.
  const double base = textAt(svg, "30")->y();
  const double height = centreOf(chart, 1, size)->y();
  QVERIFY(base > height && base < height + 0.6 * em);
}

void TestTradeoffChart::everyPointIsFound() {
  const QSizeF size(900, 640);
  const Rows rows = sampleRows();
  const TradeoffChart chart(rows, "Error");
  const TradeoffAxes axes = chart.axes(size);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::optional<std::size_t> found = chart.rowAt(*axes.positionOf(rows[k]), size);
    QVERIFY(found.has_value());
    QCOMPARE(QString::fromStdString(rows[*found].method), QString::fromStdString(rows[k].method));
  }
  QVERIFY(!chart.rowAt({0, 0}, size).has_value());
  QVERIFY(!chart.rowAt({450, 5}, size).has_value());
}

void TestTradeoffChart::nearPointsShareABox() {
  Rows rows;
  for (int k = 0; k < 4; ++k)
    rows.push_back(rowsOf({{("method " + std::to_string(k)).c_str(), 10, 1}}).front());
  rows.push_back(rowsOf({{"fast", 1, 5}}).front());
  rows.push_back(rowsOf({{"good", 12, 0.5}}).front());
  markPareto(rows);
  const QSizeF size(600, 450);
  const TradeoffChart chart(rows, "Error");
  QCOMPARE(chart.rowAt(*chart.axes(size).positionOf(rows[2]), size), std::optional<std::size_t>(0));
  QStringList texts;
  for (const PointNumbers& group : numbersBesidePoints(rows, chart.axes(size), chartFont()))
    texts += textOf(group);
  QCOMPARE(texts, (QStringList{"2–5", "1", "6"}));
  QCOMPARE(textOf({{1, 2, 4, 5, 6, 9, 11, 12, 13, 14}, {}, {}, {}}),
           QString("1, 2, 4–6, 9, 11–14"));
}

void TestTradeoffChart::zeroLiesBelowAllOthers() {
  const Rows rows = rowsOf({{"exact", 10, 0}, {"float", 5, 1e-3}, {"off", 1, 10}});
  const TradeoffAxes axes(rows, QSizeF(600, 450));
  QCOMPARE(axes.areas().size(), std::size_t{2});
  QVERIFY(axes.areas()[1].contains(*axes.positionOf(rows[0])));
  QVERIFY(axes.areas()[0].contains(*axes.positionOf(rows[1])));
  QVERIFY(axes.areas()[0].bottom() < axes.areas()[1].top());
  QVERIFY(saysIt(chartSvg(rows), "0: the reference’s own pixels"));
  QVERIFY(!saysIt(chartSvg(rowsOf({{"float", 5, 1e-3}})), "0: the reference’s own pixels"));
}

void TestTradeoffChart::recommendationsAreWritten() {
  const std::string svg = chartSvg(sampleRows());
  for (const char* words : {"for a moving view", "for a paper", "default", "60 views/s",
                            "30 views/s", "Error against the display as built",
                            "milliseconds per picture", "RMS error, code values", "PSNR, dB"})
    QVERIFY2(saysIt(svg, words), words);
  const std::vector<TradeoffRow> rows = rowsOf({{"only", 3, 0}});
  QCOMPARE(purposesOf(rows, 0), (std::vector{Purpose::movingView, Purpose::paper}));
}

void TestTradeoffChart::svgNamesEveryMethod() {
  for (const QSize& size : {QSize(900, 640), QSize(600, 450), QSize(500, 400)})
    for (const Rows& rows : {sampleRows(), agreeingRows()}) {
      const std::string svg = chartSvg(rows, size);
      for (const TradeoffRow& row : rows)
        QVERIFY2(saysIt(svg, QString::fromStdString(row.method)), row.method.c_str());
    }
}

void TestTradeoffChart::paintsTheSameTwice() {
  const TradeoffChart chart(sampleRows(), "Error");
  const std::string png = pngOf(paintOf(chart), {900, 640});
  QCOMPARE(png, pngOf(paintOf(chart), {900, 640}));
  const QImage image = QImage::fromData(QByteArray::fromStdString(png));
  QCOMPARE(image.size(), QSize(1800, 1280));
}

void TestTradeoffChart::selectionShows() {
  TradeoffChart chart(sampleRows(), "Error");
  const std::string plain = pngOf(paintOf(chart), {600, 450});
  chart.select(12);
  const std::string chosen = pngOf(paintOf(chart), {600, 450});
  const QImage picture = QImage::fromData(QByteArray::fromStdString(chosen));
  const QPointF point = *chart.axes(QSizeF(600, 450)).positionOf(chart.rows()[12]);
  const auto isYellow = [&](const QPointF& place) {
    const QColor colour = picture.pixelColor((2 * place).toPoint());
    return colour.red() > 200 && colour.green() > 200 && colour.blue() < 120;
  };
  QVERIFY(isYellow(point + QPointF(0, 4)) && isYellow(point - QPointF(0, 4)));
  QVERIFY(!isYellow(point));
  chart.select(std::nullopt);
  QCOMPARE(pngOf(paintOf(chart), {600, 450}), plain);
}

void TestTradeoffChart::unmeasuredRowsAreLeftOut() {
  Rows rows = rowsOf({{"no time", 0, 1},
                      {"backwards", -3, 1},
                      {"endless", infinite, 1},
                      {"unknown", none, 1},
                      {"no error", 1, none},
                      {"wild", 1, infinite},
                      {"negative", 1, -1}});
  const QSizeF size(600, 450);
  for (const TradeoffRow& row : rows)
    QVERIFY(!TradeoffAxes(rows, size).positionOf(row).has_value());
  QVERIFY(saysIt(chartSvg(rows), "Nothing measured yet"));
  const Rows good = sampleRows();
  rows.insert(rows.begin(), good.begin(), good.end());
  QCOMPARE(chartSvg(rows), chartSvg(good));
}

void TestTradeoffChart::aSampleHasAnAsterisk() {
  Rows rows = sampleRows();
  QVERIFY(!saysIt(chartSvg(rows), "* on part of the pixels"));
  rows[2].isSampled = true;
  const std::string svg = chartSvg(rows);
  QVERIFY(saysIt(svg, "* on part of the pixels") && saysIt(svg, "direct*"));
  QVERIFY(saysIt(svg, "fixed point 1"));
}

void TestTradeoffChart::theSpreadIsALineThroughThePoint() {
  Rows rows = sampleRows();
  TradeoffRow& row = rows[2];
  const double median = row.milliseconds;
  setTimes(row, {median / 3, median / 2, median, 1.5 * median, 4 * median});
  const QSize size(900, 640);
  const TradeoffAxes axes = TradeoffChart(rows, "Error").axes(size);
  const auto placeOf = [&](double milliseconds) {
    TradeoffRow there = row;
    there.milliseconds = milliseconds;
    return *axes.positionOf(there);
  };
  const QPointF from = placeOf(median / 2);
  const QPointF to = placeOf(1.5 * median);
  const QRegularExpression line("<polyline[^>]*points=\"([-0-9.]+),([-0-9.]+) ([-0-9.]+),");
  int found = 0;
  auto lines = line.globalMatch(QString::fromStdString(chartSvg(rows, size)));
  while (lines.hasNext()) {
    const auto match = lines.next();
    const auto isAt = [&match](int group, double place) {
      return std::abs(match.captured(group).toDouble() - place) < 0.1;
    };
    if (isAt(1, from.x()) && isAt(2, from.y()) && isAt(3, to.x())) ++found;
  }
  QCOMPARE(found, 1);
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
  for (const QSize& size : {QSize(900, 640), QSize(600, 450)}) {
    const std::string svg = chartSvg(rows, size);
    for (const TradeoffRow& row : rows)
      QVERIFY2(saysIt(svg, QString::fromStdString(row.method)), row.method.c_str());
    for (const char* number : {"nan", "inf"}) QVERIFY(svg.find(number) == std::string::npos);
  }
  // Too small for anything: no hang, no crash.
  const TradeoffChart chart(rows, "Error");
  for (const QSize& size : {QSize(120, 90), QSize(1, 1)})
    QVERIFY(!pngOf(paintOf(chart), size).empty());
}

QTEST_MAIN(TestTradeoffChart)
#include "test_tradeoff_chart.moc"
