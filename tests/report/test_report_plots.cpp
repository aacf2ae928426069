// SPDX-License-Identifier: BSD-3-Clause
// Tests the report's plots: well-formed, points where the states are, scales that are equal and
// ticks that tell them.
#include "report/page/report_plots.h"

#include <QTest>
#include <QXmlStreamReader>
#include <cmath>

#include "core/base/colour_map.h"
#include "page/plot.h"
#include "report/page/window_plots.h"
#include "tests/core/random.h"
#include "tests/report/metric_values.h"

using namespace hogelscope;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Element {
  QString name;
  QString style;  ///< class
  QXmlStreamAttributes attributes;
  QString title;
  QString text;
  [[nodiscard]] double number(const char* attribute) const {
    return attributes.value(QLatin1String(attribute)).toDouble();
  }
};

/// Elements of each drawing.
QList<QList<Element>> drawingsOf(const std::string& html) {
  QXmlStreamReader xml("<all>" + QByteArray::fromStdString(html) + "</all>");
  QList<QList<Element>> drawings;
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isCharacters() && !drawings.isEmpty()) drawings.last().last().text += xml.text();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("svg")) drawings.push_back({});
    if (drawings.isEmpty()) continue;
    const QString style = xml.attributes().value("class").toString();
    if (xml.name() == QLatin1String("title"))
      drawings.last().last().title = xml.readElementText();
    else
      drawings.last().push_back({xml.name().toString(), style, xml.attributes(), {}, {}});
  }
  if (xml.hasError()) qFatal("%s", qPrintable(xml.errorString()));
  return drawings;
}

QList<Element> named(const QList<Element>& elements, const QString& name) {
  QList<Element> found;
  for (const Element& element : elements)
    if (element.name == name) found.push_back(element);
  return found;
}

Element pointOf(const QList<Element>& elements, const QString& state) {
  for (const Element& element : elements)
    if (element.title.startsWith(state + ":")) return element;
  return {};
}

ReportRow row(const std::string& state, const Vec3& eye, double db,
              const std::string& test = "t.png") {
  const double mse = 255 * 255 / std::pow(10, db / 10);
  return {state, test, metricValues(mse), eye};
}

ReportRow blind(const std::string& state, const Vec3& eye) {
  return {state, "t.png", MetricSet().noValues(), eye, 1, "sees nothing"};
}

PanelParams displayOf(double width = 0.5, double height = 0.5) {
  PanelParams display;
  display.size = {width, height};
  display.hogels = display.directions = {4, 4};
  return display;
}

/// SVG units per metre across and along the other axis, from two points.
std::array<double, 2> scalesOf(const Element& a, const Element& b, double dx, double dy) {
  return {(b.number("cx") - a.number("cx")) / dx, (b.number("cy") - a.number("cy")) / dy};
}

QString hex(double share) {
  const auto [r, g, b] = falseColour(share);
  return QString("#%1%2%3")
      .arg(r, 2, 16, QChar('0'))
      .arg(g, 2, 16, QChar('0'))
      .arg(b, 2, 16, QChar('0'));
}

}  // namespace

class TestReportPlots : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void circlesFollowTheEyes();
  void displayFrame();
  void colours();
  void kinds();
  void aMapWithoutEyesHasAxes();
  void theWorstIsOnTop();
  void everythingLiesInside_data();
  void everythingLiesInside();
  void angles();
  void seriesDiffer();
  void nothingToPlot();
  void namesAreEscaped();
  void curvesFollowRates();
  void ratesOfIdenticalTests();
};

/// From above x goes right and z down, from the front y goes up, at one scale; the panel too.
void TestReportPlots::circlesFollowTheEyes() {
  const std::string html =
      cameraMaps({row("a", {0, 0, 0.5}, 30), row("b", {0.2, 0.1, 0.9}, 40)}, displayOf(0.5, 0.3));
  const auto drawings = drawingsOf(html);
  QCOMPARE(drawings.size(), 3);  // two maps and the colours
  for (int k = 0; k < 2; ++k) {
    const auto& map = drawings[k];
    const Element a = pointOf(map, "a");
    const auto scales = scalesOf(a, pointOf(map, "b"), 0.2, k == 0 ? 0.4 : 0.1);
    QVERIFY(scales[0] > 100);
    QVERIFY(std::abs(scales[0] - (k == 0 ? 1 : -1) * scales[1]) < 0.3);
    Element panel;
    for (const Element& element : map)
      if (element.style == (k == 0 ? "bar" : "panel")) panel = element;
    QVERIFY(std::abs(panel.number("width") - 0.5 * scales[0]) < 0.1);
    QVERIFY(std::abs(panel.number("x") + panel.number("width") / 2 - a.number("cx")) < 0.1);
    const double middle = panel.number("y") + panel.number("height") / 2;
    QVERIFY(std::abs(a.number("cy") - middle - (k == 0 ? 0.5 * scales[0] : 0)) < 0.1);
    if (k == 1) QVERIFY(std::abs(panel.number("height") - 0.3 * scales[0]) < 0.1);
    // A tick's label stands where its value is.
    for (const Element& label : named(map, "text"))
      if (label.text == "0.2" && label.attributes.value("text-anchor") == QLatin1String("middle"))
        QVERIFY(std::abs(label.number("x") - pointOf(map, "b").number("cx")) < 0.1);
  }
}

/// A display that stands elsewhere and looks along the world's +x.
void TestReportPlots::displayFrame() {
  PanelParams display = displayOf();
  display.position = {1, 2, 3};
  display.orientation = {0, 90, 0};
  const auto map = drawingsOf(cameraMaps({row("a", {1.6, 2.1, 3}, 30)}, display))[0];
  QVERIFY2(pointOf(map, "a").title.endsWith("eye 0.000, 0.100, 0.600 m"),
           qPrintable(pointOf(map, "a").title));
}

void TestReportPlots::colours() {
  const auto drawings = drawingsOf(cameraMaps(
      {row("a", {0, 0, 1}, 20), row("b", {0, 0, 2}, 30), row("c", {0, 0, 3}, 27.5)}, displayOf()));
  const auto fill = [&](const char* state) {
    return pointOf(drawings[0], state).attributes.value("fill").toString();
  };
  QCOMPARE(fill("a"), hex(0));
  QCOMPARE(fill("b"), hex(1));
  QCOMPARE(fill("c"), hex(0.75));
  QCOMPARE(named(drawings[2], "text")[1].text, QString("20"));
}

void TestReportPlots::kinds() {
  const auto map = drawingsOf(
      cameraMaps({row("a", {0, 0, 1}, infinite), blind("b", {0, 0, -1}), row("c", {1, 0, 1}, 9)},
                 displayOf()))[0];
  QCOMPARE(pointOf(map, "a").style, QString("hollow"));
  QCOMPARE(pointOf(map, "b").style, QString("none"));
  QCOMPARE(pointOf(map, "b").title, QString("b: sees nothing; eye 0.000, 0.000, -1.000 m"));
  QVERIFY(pointOf(map, "c").style.isEmpty());
  QVERIFY(pointOf(map, "c").title.startsWith("c: 9.00 dB, SSIM 0.5000;"));
}

void TestReportPlots::theWorstIsOnTop() {
  const auto map = drawingsOf(
      cameraMaps({row("a", {0, 0, 1}, 20), row("b", {0, 0, 1}, 10), row("c", {0, 0, 1}, infinite)},
                 displayOf()))[0];
  const auto circles = named(map, "circle");
  QCOMPARE(circles.size(), 3);
  QVERIFY(circles[2].title.startsWith("b:") && circles[0].title.startsWith("c:"));
}

void TestReportPlots::everythingLiesInside_data() {
  QTest::addColumn<int>("states");
  QTest::addColumn<double>("size");
  QTest::newRow("one") << 1 << 0.0;
  QTest::newRow("few") << 6 << 1.0;
  QTest::newRow("many") << 1000 << 1.0;
  QTest::newRow("far") << 50 << 1e5;
  QTest::newRow("tiny") << 50 << 1e-4;
}

void TestReportPlots::everythingLiesInside() {
  QFETCH(const int, states);
  QFETCH(const double, size);
  Random random(1);
  std::vector<ReportRow> rows;
  for (int k = 0; k < states; ++k) {
    const auto some = [&] { return size * random.uniform(-1, 1); };
    rows.push_back(row(std::to_string(k), {some(), some(), 0.5 + some()}, random.uniform(5, 60)));
  }
  const auto drawings = drawingsOf(cameraMaps(rows, displayOf()) + anglePlot(rows, displayOf()));
  QCOMPARE(drawings.size(), 5);  // and the legend's marker
  for (const int k : {0, 1, 3}) {
    const QStringList box = drawings[k][0].attributes.value("viewBox").toString().split(' ');
    const auto circles = named(drawings[k], "circle");
    QCOMPARE(circles.size(), states);
    for (const Element& circle : circles) {
      QVERIFY(circle.number("cx") > 60 && circle.number("cx") < box[2].toDouble());
      QVERIFY(circle.number("cy") > 5 && circle.number("cy") < box[3].toDouble() - 40);
    }
    const auto labels = named(drawings[k], "text");
    QVERIFY(labels.size() > 5 && labels.size() < 40);
    for (const Element& label : labels) QVERIFY(!label.text.contains("nan"));
  }
}

/// One degree is as wide everywhere, one dB as high.
void TestReportPlots::angles() {
  const auto eye = [](double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return Vec3{2 * std::sin(angle), 0.4, 2 * std::cos(angle)};
  };
  const auto plot =
      drawingsOf(anglePlot({row("a", eye(-20), 30), row("b", eye(10), 35), row("c", eye(30), 50),
                            row("d", eye(0), infinite), blind("e", eye(5))},
                           displayOf()))[0];
  const auto at = [&](const char* state) { return pointOf(plot, state); };
  const double degree = (at("c").number("cx") - at("a").number("cx")) / 50;
  QVERIFY(degree > 5);
  QVERIFY(std::abs(at("b").number("cx") - at("a").number("cx") - 30 * degree) < 0.05);
  const double decibel = (at("a").number("cy") - at("c").number("cy")) / 20;
  QVERIFY(decibel > 5);
  QVERIFY(std::abs(at("a").number("cy") - at("b").number("cy") - 5 * decibel) < 0.05);
  QCOMPARE(at("d").style, QString("hollow"));
  QVERIFY(at("d").number("cy") < at("c").number("cy"));
  QVERIFY(at("e").name.isEmpty());
}

/// Twelve tests: no two with the same colour and the same marker.
void TestReportPlots::seriesDiffer() {
  std::vector<ReportRow> rows;
  rows.reserve(12);
  for (int k = 0; k < 12; ++k) rows.push_back(row("a", {0, 0, 1}, 30, std::to_string(k)));
  const std::string html = anglePlot(rows, displayOf());
  const auto drawings = drawingsOf(html);
  QCOMPARE(drawings.size(), 13);
  QStringList markers;
  for (int k = 1; k < 13; ++k) {
    const Element& shape = drawings[k][1];
    markers.push_back(drawings[k][0].attributes.value("fill").toString() + shape.name +
                      shape.attributes.value("points").toString());
  }
  markers.removeDuplicates();
  QCOMPARE(markers.size(), 12);
}

void TestReportPlots::nothingToPlot() {
  QVERIFY(cameraMaps({}, displayOf()).empty());
  QVERIFY(anglePlot({}, displayOf()).empty());
  QVERIFY(anglePlot({row("a", {0, 0, 1}, infinite)}, displayOf()).empty());
  const auto drawings = drawingsOf(cameraMaps({blind("a", {0, 0, -1})}, displayOf()));
  QCOMPARE(drawings.size(), 2);  // no colours without a PSNR
}

void TestReportPlots::namesAreEscaped() {
  const std::vector<ReportRow> rows{row("<b>&\"\x01", {0, 0, 1}, 30, "<i>&")};
  const std::string html = cameraMaps(rows, displayOf()) + anglePlot(rows, displayOf());
  QVERIFY(pointOf(drawingsOf(html)[0], "<b>&\"\\x01").title.contains("30.00 dB"));
  QVERIFY(html.find("<i>") == std::string::npos && html.find("<b>") == std::string::npos);
}

/// Four tests at doubling rates lie evenly apart, and PSNR goes up evenly; the interval of one
/// state is its point.
void TestReportPlots::curvesFollowRates() {
  std::vector<ReportRow> rows;
  RateGroup a{"A", {}}, b{"<B>", {}};
  for (int k = 0; k < 4; ++k) {
    const std::string name = "t" + std::to_string(k);
    rows.push_back(row("s", {0, 0, 1}, 30 + 2 * k, name));
    a.tests.push_back({name, 0.1 * (1 << k)});
  }
  rows.push_back(row("s", {0, 0, 1}, 33, "u"));
  b.tests = {{"u", 0.4}};
  const MetricSet metrics;
  const std::vector<RateGroup> groups{a, b};
  const std::string text = ratePlots(summariseTests(rows, metrics, groups), metrics, groups);
  const auto plots = drawingsOf(text);
  QVERIFY(plots.size() >= 4);
  const auto points = named(plots[0], "circle");
  QCOMPARE(points.size(), 4);
  const double step = points[1].number("cx") - points[0].number("cx");
  QVERIFY(step > 60);
  for (int k = 1; k < 4; ++k) {
    QVERIFY(std::abs(points[k].number("cx") - points[k - 1].number("cx") - step) < 0.03);
    QVERIFY(std::abs(points[k].number("cy") - points[k - 1].number("cy") -
                     (points[1].number("cy") - points[0].number("cy"))) < 0.03);
    QVERIFY(points[k].number("cy") < points[k - 1].number("cy"));
  }
  QCOMPARE(points[2].title, QString("t2: 0.4 bits, 34.00 (34.00 … 34.00)"));
  const auto curves = named(plots[0], "polyline");
  QCOMPARE(curves.size(), 2);
  QVERIFY(curves[0].attributes.value("points").toString().startsWith(
      points[0].attributes.value("cx").toString() + "," +
      points[0].attributes.value("cy").toString()));
  QVERIFY(text.find("&lt;B&gt;") != std::string::npos);
  QVERIFY(ratePlots({}, metrics, {}).empty());
}

/// Before the first view of a report is done.
void TestReportPlots::aMapWithoutEyesHasAxes() {
  const PlotArea area = areaOf(eyeMap({}, 0, 1, DisplayParams{}), {300, 200});
  for (const Axis& axis : {area.across, area.up})
    QVERIFY(std::isfinite(axis.low) && axis.low < axis.high);
  QVERIFY(ticksUp(area.up).size() > 1);
}

/// A mean that is not finite is no point.
void TestReportPlots::ratesOfIdenticalTests() {
  const std::vector<ReportRow> rows{row("s", {0, 0, 1}, std::numeric_limits<double>::infinity())};
  const std::vector<RateGroup> groups{{"A", {{"t.png", 1}}}, {"B", {{"t.png", 1}}}};
  const MetricSet metrics;
  const std::string text = ratePlots(summariseTests(rows, metrics, groups), metrics, groups);
  QVERIFY(text.find("nan") == std::string::npos && text.find("inf") == std::string::npos);
}

QTEST_APPLESS_MAIN(TestReportPlots)
#include "test_report_plots.moc"
