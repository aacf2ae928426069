// SPDX-License-Identifier: BSD-3-Clause
// Tests the report's plots: well-formed, points where the states are, scales that are equal and
// ticks that tell them.
#include "report/page/report_plots.h"

#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>

#include "core/base/colour_map.h"
#include "page/plot.h"
#include "report/page/unit_plots.h"
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

/// The drawing of a figure of the first test by the end of its name; none if it is left out.
QList<Element> figureOf(const std::vector<ReportRow>& rows, const PanelParams& display,
                        const char* ending) {
  for (const Figure& figure : cameraFigures(rows, 0, display))
    if (figure.name == std::string("test1_t_") + ending) return drawingsOf(figure.svg())[0];
  return {};
}

std::vector<std::string> namesOf(const std::vector<Figure>& figures) {
  std::vector<std::string> names;
  for (const Figure& figure : figures) names.push_back(figure.name);
  return names;
}

}  // namespace

class TestReportPlots : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void unitsInOrder();
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
  void coincidingPointsAreLeftOut();
  void nothingToPlot();
  void namesAreEscaped();
  void curvesFollowRates();
  void ratesOfIdenticalTests();
};

/// From above x goes right and z down, from the front y goes up, at one scale; the panel too.
void TestReportPlots::circlesFollowTheEyes() {
  for (int k = 0; k < 2; ++k) {
    const auto map = figureOf({row("a", {0, 0, 0.5}, 30), row("b", {0.2, 0.1, 0.9}, 40)},
                              displayOf(0.5, 0.3), k == 0 ? "above" : "front");
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
  const auto map =
      figureOf({row("a", {1.6, 2.1, 3}, 30), row("b", {1.7, 2.1, 3}, 30)}, display, "above");
  QVERIFY2(pointOf(map, "a").title.endsWith("eye 0.000, 0.100, 0.600 m"),
           qPrintable(pointOf(map, "a").title));
}

void TestReportPlots::colours() {
  const auto map =
      figureOf({row("a", {0, 0, 1}, 20), row("b", {0, 0, 2}, 30), row("c", {0, 0, 3}, 27.5)},
               displayOf(), "above");
  const auto fill = [&](const char* state) {
    return pointOf(map, state).attributes.value("fill").toString();
  };
  QCOMPARE(fill("a"), hex(0));
  QCOMPARE(fill("b"), hex(1));
  QCOMPARE(fill("c"), hex(0.75));
  // The scale of colours: its lowest number stands at the map's bottom.
  const auto texts = named(map, "text");
  QCOMPARE(texts.back().text.trimmed(), QString("dB"));
  const auto lowest = std::ranges::find_if(
      texts, [](const Element& text) { return text.text == "20" && text.number("x") > 300; });
  QVERIFY(lowest != texts.end());
  const auto frames = named(map, "rect");
  const auto frame = std::ranges::find(frames, QString("frame"), &Element::style);
  QVERIFY(std::abs(lowest->number("y") - 4 - frame->number("y") - frame->number("height")) < 0.1);
}

void TestReportPlots::kinds() {
  const auto map =
      figureOf({row("a", {0, 0, 1}, infinite), blind("b", {0, 0, -1}), row("c", {1, 0, 1}, 9)},
               displayOf(), "above");
  QCOMPARE(pointOf(map, "a").style, QString("hollow"));
  QCOMPARE(pointOf(map, "b").style, QString("none"));
  QCOMPARE(pointOf(map, "b").title, QString("b: sees nothing; eye 0.000, 0.000, -1.000 m"));
  QVERIFY(pointOf(map, "c").style.isEmpty());
  QVERIFY(pointOf(map, "c").title.startsWith("c: 9.00 dB, SSIM 0.5000;"));
}

void TestReportPlots::theWorstIsOnTop() {
  const auto map =
      figureOf({row("a", {0, 0, 1}, 20), row("b", {0, 0, 2}, 10), row("c", {0, 0, 1}, infinite)},
               displayOf(), "above");
  const auto circles = named(map, "circle");
  QCOMPARE(circles.size(), 3);
  QVERIFY(circles[2].title.startsWith("b:") && circles[0].title.startsWith("c:"));
}

void TestReportPlots::everythingLiesInside_data() {
  QTest::addColumn<int>("states");
  QTest::addColumn<double>("size");
  QTest::newRow("two") << 2 << 1.0;
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
  for (const char* ending : {"above", "front", "angle"}) {
    const auto drawing = figureOf(rows, displayOf(), ending);
    QVERIFY2(!drawing.isEmpty(), ending);
    const QStringList box = drawing[0].attributes.value("viewBox").toString().split(' ');
    const auto circles = named(drawing, "circle");
    QCOMPARE(circles.size(), states);
    for (const Element& circle : circles) {
      QVERIFY(circle.number("cx") > 60 && circle.number("cx") < box[2].toDouble());
      QVERIFY(circle.number("cy") > 5 && circle.number("cy") < box[3].toDouble() - 40);
    }
    const auto labels = named(drawing, "text");
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
  const auto plot = figureOf({row("a", eye(-20), 30), row("b", eye(10), 35), row("c", eye(30), 50),
                              row("d", eye(0), infinite), blind("e", eye(5))},
                             displayOf(), "angle");
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

/// Twelve curves: no two with the same colour, marker and dashes; their names stand below them.
void TestReportPlots::seriesDiffer() {
  Plot plot{"x", "y", {1, 1}, true, false, {}};
  for (int k = 0; k < 12; ++k)
    plot.series.push_back({"curve number " + std::to_string(k), {{0, double(k), "point", 0, {}}}});
  const QList<Element> drawing = drawingsOf(svgOf(plot, {376, 296}, "map", ""))[0];
  const double height = drawing[0].attributes.value("viewBox").toString().split(' ')[3].toDouble();
  QStringList looks, greys;
  QString colour;
  Element last;
  for (const Element& element : drawing) {
    if (element.name == "g" && element.style == "points")
      colour = element.attributes.value("fill").toString();
    if (element.style == "curve") last = element;
    const bool isMark = element.name == "circle" || element.name == "polygon";
    if (!isMark || !element.title.isNull()) continue;  // a point of the plot has a title
    const QString grey = element.name +
                         QString::number(element.attributes.value("points").toString().count(' ')) +
                         last.attributes.value("stroke-dasharray").toString();
    looks.push_back(colour + grey);
    greys.push_back(grey);
  }
  QCOMPARE(looks.size(), 12);
  looks.removeDuplicates();
  QCOMPARE(looks.size(), 12);
  QStringList first = greys.mid(0, 4);
  first.removeDuplicates();
  QCOMPARE(first.size(), 4);  // also without colours
  int names = 0;
  for (const Element& text : named(drawing, "text")) {
    if (!text.text.startsWith("curve number")) continue;
    ++names;
    QVERIFY(text.number("y") > 296 && text.number("y") < height && text.number("x") < 376 - 90);
  }
  QCOMPARE(names, 12);
}

/// Six states of one eye are no plot over the eye's place; over the states they are.
void TestReportPlots::coincidingPointsAreLeftOut() {
  using Names = std::vector<std::string>;
  std::vector<ReportRow> rows{row("a", {0, 0, 1}, 20), row("b", {0, 0, 1}, 30)};
  QCOMPARE(namesOf(cameraFigures(rows, 0, displayOf())), Names{"test1_t_states"});
  rows[1].eye = {0, 0, 2};  // on one line of sight
  QCOMPARE(namesOf(cameraFigures(rows, 0, displayOf())),
           Names({"test1_t_above", "test1_t_states"}));
  rows[1].eye = {0, 0.1, 1};
  QCOMPARE(namesOf(cameraFigures(rows, 0, displayOf())),
           Names({"test1_t_front", "test1_t_states"}));
  rows[1].eye = {0.1, 0, 1};
  QCOMPARE(namesOf(cameraFigures(rows, 0, displayOf())),
           Names({"test1_t_above", "test1_t_front", "test1_t_angle"}));
  rows.pop_back();
  QVERIFY(cameraFigures(rows, 0, displayOf()).empty());
}

void TestReportPlots::nothingToPlot() {
  const std::vector<ReportRow> rows{blind("a", {0, 0, -1}), blind("b", {0.1, 0, 1})};
  const auto figures = cameraFigures(rows, 0, displayOf());
  QCOMPARE(namesOf(figures), (std::vector<std::string>{"test1_t_above", "test1_t_front"}));
  for (const Element& text : named(drawingsOf(figures[0].svg())[0], "text"))
    QVERIFY(text.text != "dB");  // no colours without a PSNR
  QVERIFY(figures[0].csv.find("a,0,0,-1,180,\n") != std::string::npos);
}

void TestReportPlots::namesAreEscaped() {
  const std::vector<ReportRow> rows{row("<b>&\"\x01", {0, 0, 1}, 30, "<i>&"),
                                    row("c", {0.1, 0, 1}, 30, "<i>&")};
  std::string all;
  for (const Figure& figure : cameraFigures(rows, 0, displayOf())) all += figure.svg();
  QVERIFY(pointOf(drawingsOf(all)[0], "<b>&\"\\x01").title.contains("30.00 dB"));
  QVERIFY(all.find("<i>") == std::string::npos && all.find("<b>") == std::string::npos);
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
  const auto figures = rateFigures(summariseTests(rows, metrics, groups), metrics, groups);
  QVERIFY(figures.size() >= 4);
  QCOMPARE(figures[0].name, std::string("rate_mean_psnr_seen"));
  const std::string text = figures[0].svg();
  const auto plots = drawingsOf(text);
  auto points = named(plots[0], "circle");
  QCOMPARE(points.size(), 5);  // one in the legend
  points.pop_back();
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
  QCOMPARE(curves.size(), 4);  // with those of the legend
  QVERIFY(curves[0].attributes.value("points").toString().startsWith(
      points[0].attributes.value("cx").toString() + "," +
      points[0].attributes.value("cy").toString()));
  QVERIFY(text.find("&lt;B&gt;") != std::string::npos);
  QVERIFY(figures[0].csv.find("A,t2,0.4,34,34,34,plain\n") != std::string::npos);
  QVERIFY(rateFigures({}, metrics, {}).empty());
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
  for (const Figure& figure : rateFigures(summariseTests(rows, metrics, groups), metrics, groups))
    QVERIFY(figure.svg().find("nan") == std::string::npos &&
            figure.svg().find("inf") == std::string::npos);
}

/// Units in the order of their mean, weighted where states have weights; all tests together are
/// none.
void TestReportPlots::unitsInOrder() {
  std::vector<ReportRow> rows;
  for (const auto& [unit, db] :
       {std::pair("u1", 30.0), std::pair("u2", 20.0), std::pair("u3", 25.0)})
    for (const double more : {0.0, 3.0}) {
      rows.push_back(row(more > 0 ? "b" : "a", {0, 0, 1}, db + more, unit));
      rows.back().weight = more > 0 ? 2 : 1;
    }
  const MetricSet metrics;
  const std::vector<Figure> figures = unitFigures(summariseTests(rows, metrics), metrics);
  QCOMPARE(namesOf(figures),
           (std::vector<std::string>{"units_mean_psnr_seen", "yield_mean_psnr_seen"}));
  const QStringList lines = QString::fromStdString(figures[0].csv).split('\n');
  QCOMPARE(lines[0], QString("unit,percent_of_units,mean_psnr_seen,low,high"));
  QCOMPARE(lines.size(), 5);
  const QStringList units{"u2", "u3", "u1"};
  for (int k = 0; k < 3; ++k) {
    const QStringList cells = lines[k + 1].split(',');
    QCOMPARE(cells[0], units[k]);
    QVERIFY(std::abs(cells[1].toDouble() - 100.0 * (k + 1) / 3) < 0.01);
    QVERIFY(std::abs(cells[2].toDouble() - (22 + 5 * k)) < 1e-6);  // (20 + 2·23)/3, …
    QVERIFY(cells[3].toDouble() < cells[2].toDouble() && cells[2] < cells[4]);
  }
  const auto points = drawingsOf(figures[0].svg())[0];
  QVERIFY(pointOf(points, "u2").number("cx") < pointOf(points, "u1").number("cx"));
  QVERIFY(pointOf(points, "u2").number("cy") > pointOf(points, "u1").number("cy"));

  // Three of three units have at least 22, two 27, one 32; intervals are Wilson's.
  const QStringList yields = QString::fromStdString(figures[1].csv).split('\n');
  QCOMPARE(yields[0], QString("limit,yield_percent,low,high"));
  for (int k = 0; k < 3; ++k) {
    const QStringList cells = yields[k + 1].split(',');
    QVERIFY(std::abs(cells[0].toDouble() - (22 + 5 * k)) < 1e-6);
    QVERIFY(std::abs(cells[1].toDouble() - 100.0 * (3 - k) / 3) < 0.01);
    const double n = 3, z = 1.959963984540054, share = (n - k) / n;
    const double half = z * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
    const double middle = share + z * z / (2 * n), whole = 1 + z * z / n;
    QVERIFY(std::abs(cells[2].toDouble() - 100 * (middle - half) / whole) < 0.01);
    QVERIFY(std::abs(cells[3].toDouble() - 100 * (middle + half) / whole) < 0.01);
  }
  QCOMPARE(
      unitSentences(summariseTests(rows, metrics), metrics),
      (std::vector<std::string>{"Of 3 units half have a mean PSNR of at least 27.00 dB, 95 % of "
                                "at least 22.00 dB; the worst, u2, 22.00 dB."}));

  rows.resize(2);
  QVERIFY(unitFigures(summariseTests(rows, metrics), metrics).empty());
}

QTEST_APPLESS_MAIN(TestReportPlots)
#include "test_report_plots.moc"
