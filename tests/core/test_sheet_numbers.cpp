// SPDX-License-Identifier: BSD-3-Clause
// The closed forms of a lens sheet's views against counts over rays through LensSheet.
#include "core/panel/sheet_numbers.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>

#include "core/base/error.h"

using namespace hogelscope;

namespace {

constexpr int views = 48;
constexpr double inch = 0.0254;
constexpr std::size_t green = 1;

/// Like a 16 inch Looking Glass, or with lenses that lean to the left and wide sub-pixels.
SheetDisplay unit(bool isOther = false) {
  SheetDisplay display;
  display.calibration.params = {44.75, -6.87, 0.17, 283, {3840, 2160}, 50};
  if (isOther) {
    display.calibration.params = {30, 4.37, 0.6, 200, {2560, 1600}, 35};
    display.viewingDistance = 0.8;
    display.emitter[0] = 0.7;
    display.spot = 6e-5;
  }
  return display;
}

double periodOf(const SheetDisplay& display) {
  const SheetParams& s = display.calibration.params;
  return inch / s.pitch / std::cos(std::atan(1 / s.slope));
}

double tangentOf(const SheetDisplay& display) {
  return std::tan(display.calibration.params.cone * M_PI / 360);
}

/// Points of a rectangle about `middle`, even and in no step with pixels.
std::vector<Vec2> pointsIn(const Vec2& middle, double width, double height, int count) {
  std::vector<Vec2> points;
  for (int k = 0; k < count; ++k)
    points.push_back({middle.x + width * (std::fmod(0.7548776662 * (k + 1), 1) - 0.5),
                      middle.y + height * (std::fmod(0.5698402910 * (k + 1), 1) - 0.5)});
  return points;
}

/// The sub-pixel of green that an eye sees at a point: its real-valued view, and its pixel's middle
/// in metres.
struct SeenPlace {
  double view = 0;
  Vec2 middle;
};

SeenPlace placeSeen(const SheetDisplay& display, const LensSheet& sheet, const Vec3& eye,
                    const Vec2& point) {
  auto hit = sheet.meet(eye, Vec3{point.x, point.y, 0} - eye, green);
  if (!hit) qFatal("the sheet is missed");
  // A pixel of the spot, as often as its weight says.
  static int count = 0;
  double rest = std::fmod(0.41421356237 * ++count, 1);
  const std::vector<double>& weights = sheet.spot();
  hit->column -= double(weights.size() / 2);
  for (std::size_t k = 0; k + 1 < weights.size() && rest >= weights[k]; ++k, ++hit->column)
    rest -= weights[k];
  const double q = inch / display.calibration.params.dpi;
  const auto [columns, rows] = display.calibration.params.panel;
  constexpr int parts = 1 << 24;
  const int part = sheet.viewOf(int(hit->column), int(hit->row), green, parts);
  return {views * (part + 0.5) / parts,
          {(hit->column - columns / 2.0) * q, (rows / 2.0 - hit->row) * q}};
}

/// Returns the mean view over a spot, on the circle of all views, less `about`; −N/2 … N/2.
double meanView(const SheetDisplay& display, const Vec3& eye, const Vec2& middle, double about) {
  const LensSheet sheet(display);
  std::complex<double> sum;
  for (const Vec2& point : pointsIn(middle, 0.02, 0.1, 6000))
    sum += std::polar(1.0, 2 * M_PI * (placeSeen(display, sheet, eye, point).view - about) / views);
  return std::arg(sum) * views / (2 * M_PI);
}

/// Returns the contrast of a grating that views have in closed form, over many rays and the width
/// of a view.
double contrastSeen(const SheetDisplay& display, double frequency, double z, std::size_t axis) {
  const LensSheet sheet(display);
  const double slope = display.calibration.params.slope;
  const double distance = display.viewingDistance;
  const double gap = periodOf(display) / (2 * tangentOf(display));
  std::complex<double> sum;
  double count = 0;
  for (int phase = 0; phase < 40; ++phase) {
    const Vec3 eye{0.01 + distance * 2 * tangentOf(display) / views * phase / 40, 0, distance};
    for (const Vec2& point : pointsIn({0.0001 * phase, 0}, 0.2, 0.1, 1500)) {
      const auto [view, middle] = placeSeen(display, sheet, eye, point);
      const double camera =
          ((std::floor(view) + 0.5) / views - 0.5) * 2 * distance * tangentOf(display);
      const double part = z / distance;
      const double a = (eye.x - point.x) / eye.z;
      const double b = (eye.y - point.y) / eye.z;
      const double across = (point.x + point.y / slope) + distance * (a + b / slope);
      // What the view's camera has at its pixel, and what the eye should see there.
      const double shown =
          axis == 0 ? middle.x * (1 - part) + camera * part : middle.y * (1 - part);
      const double meant = axis == 0 ? (point.x - gap * a) * (1 - part) + across * part
                                     : (point.y - gap * b) * (1 - part);
      sum += std::polar(1.0, 2 * M_PI * frequency * (shown - meant));
      ++count;
    }
  }
  return std::abs(sum) / count;
}

QByteArray text(double counted, double law) {
  return QString("%1, law %2").arg(counted, 0, 'g', 6).arg(law, 0, 'g', 6).toUtf8();
}

bool isNear(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::abs(b);
}

}  // namespace

class TestSheetNumbers : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void viewsPerMetre_data() { units(); }
  void viewsPerMetre();
  void flips_data() { units(); }
  void flips();
  void lobe_data() { units(); }
  void lobe();
  void slopesOfAView_data() { units(); }
  void slopesOfAView();
  void shareInTheCone_data() { units(); }
  void shareInTheCone();
  void contrast_data();
  void contrast();
  void depths_data() { units(); }
  void depths();
  void withoutAnEye();

 private:
  static void units() {
    QTest::addColumn<bool>("isOther");
    QTest::newRow("16 inch") << false;
    QTest::newRow("another") << true;
  }
};

void TestSheetNumbers::viewsPerMetre() {
  QFETCH(bool, isOther);
  const SheetDisplay display = unit(isOther);
  for (const double z : {0.45, display.viewingDistance, 1.1}) {
    const Vec3 eye{0.02, 0.03, z};
    const SheetNumbers numbers = sheetNumbers(display, views, eye);
    const double move = 0.1 * z;
    const auto viewAt = [&](double x, double place) {
      return meanView(display, {x, eye.y, z}, {place, 0}, views / 2.0);
    };
    const double sideways = (viewAt(move, 0) - viewAt(-move, 0)) / (2 * move);
    QVERIFY2(isNear(sideways, numbers.viewsPerMetre, 0.003),
             text(sideways, numbers.viewsPerMetre).constData());
    const double along = (viewAt(0, 0.1) - viewAt(0, -0.1)) / 0.2;
    QVERIFY2(std::abs(along - numbers.viewsPerPanelMetre) < 0.3,
             text(along, numbers.viewsPerPanelMetre).constData());
  }
}

/// Where most of the light in the panel's middle changes from one end of the views to the other;
/// and how many heads have their eyes on both sides.
void TestSheetNumbers::flips() {
  QFETCH(bool, isOther);
  const SheetDisplay display = unit(isOther);
  for (const double y : {-0.1, 0.0, 0.15}) {
    const double z = 0.7;
    const SheetNumbers numbers = sheetNumbers(display, views, {0, y, z});
    for (const std::size_t side : {0, 1}) {
      // About the ends of the views, 0 and N, the mean is −1/2 turn … +1/2 turn.
      const auto isBeyond = [&](double x) {
        const double beyond = meanView(display, {x, y, z}, {}, 0);
        return side == 1 ? beyond > 0 : beyond < 0;
      };
      const double middle = -y / display.calibration.params.slope;
      double inside = middle + (side == 1 ? 0.3 : -0.3) * numbers.width();
      double outside = middle + (side == 1 ? 0.7 : -0.7) * numbers.width();
      QVERIFY(!isBeyond(inside) && isBeyond(outside));
      for (int halving = 0; halving < 16; ++halving)
        (isBeyond((inside + outside) / 2) ? outside : inside) = (inside + outside) / 2;
      QVERIFY2(std::abs(inside - numbers.flips[side]) < 5e-4,
               text(inside, numbers.flips[side]).constData());
    }
  }
  const SheetNumbers numbers = sheetNumbers(display, views, {0, 0, 0.7});
  QVERIFY(isNear(numbers.width(), 2 * 0.7 * tangentOf(display), 1e-9));
  int exchanged = 0;
  constexpr int heads = 200;
  const double ipd = 0.063;
  for (int head = 0; head < heads; ++head) {
    const double x = numbers.width() * (head + 0.5) / heads;
    const auto viewAt = [&](double place) {
      return meanView(display, {place, 0, 0.7}, {}, views / 2.0);
    };
    exchanged += viewAt(x - ipd / 2) > viewAt(x + ipd / 2) ? 1 : 0;
  }
  QVERIFY2(std::abs(double(exchanged) / heads - numbers.pseudoscopic(ipd)) < 1.5 / heads,
           text(double(exchanged) / heads, numbers.pseudoscopic(ipd)).constData());
  QCOMPARE(numbers.pseudoscopic(100), 1.0);
}

/// What one place sees about its view: rms, and the share of each part of it.
void TestSheetNumbers::lobe() {
  QFETCH(bool, isOther);
  const SheetDisplay display = unit(isOther);
  const LensSheet sheet(display);
  const Vec3 eye{0.03, 0, display.viewingDistance};
  const SheetNumbers numbers = sheetNumbers(display, views, eye);
  const double at = views / 2.0 + 0.03 * numbers.viewsPerMetre;
  std::vector<double> off;
  double squares = 0;
  for (const Vec2& point : pointsIn({}, 0.2, 0.1, 40000)) {
    off.push_back(std::remainder(placeSeen(display, sheet, eye, point).view - at, views));
    squares += off.back() * off.back() / 40000;
  }
  QVERIFY2(isNear(std::sqrt(squares), numbers.lobe, 0.02),
           text(std::sqrt(squares), numbers.lobe).constData());
  const auto last = double(std::ranges::max(off));
  for (double low = -last; low < last; low += last / 7) {
    const double high = low + last / 3;
    const double counted =
        double(std::ranges::count_if(off, [&](double o) { return o >= low && o < high; })) / 40000;
    QVERIFY2(std::abs(counted - lobeShare(display, views, low, high)) < 0.012,
             text(counted, lobeShare(display, views, low, high)).constData());
  }
}

/// The slopes in which light of a view is sent, less those of its middle: rms is s/√12.
void TestSheetNumbers::slopesOfAView() {
  QFETCH(bool, isOther);
  const SheetDisplay display = unit(isOther);
  const LensSheet sheet(display);
  double squares = 0;
  int count = 0;
  for (const Vec2& at : pointsIn({}, 0.3, 0, 200)) {
    const Vec3 eye{at.x, 0, display.viewingDistance};
    for (const Vec2& point : pointsIn({}, 0.2, 0.1, 300)) {
      const double view = placeSeen(display, sheet, eye, point).view;
      const double middle = ((std::floor(view) + 0.5) / views - 0.5) * 2 * tangentOf(display);
      // From all places of the panel a view is one of the eye's places.
      const double off = std::remainder(eye.x / eye.z - middle, 2 * tangentOf(display));
      squares += off * off;
      ++count;
    }
  }
  const double spread = std::sqrt(12 * squares / count);
  const double law = sheetNumbers(display, views, {0, 0, 1}).slopeSpread;
  QVERIFY2(isNear(spread, law, 0.02), text(spread, law).constData());
}

/// A place is in the cone if it shows the view of the place at which its ray crosses the viewing
/// distance, and not one that lies N views farther.
void TestSheetNumbers::shareInTheCone() {
  QFETCH(bool, isOther);
  SheetDisplay display = unit(isOther);
  display.spot = 0;  // a spot mixes places near a flip with others
  const LensSheet sheet(display);
  const double slope = display.calibration.params.slope;
  const auto [width, height] = sheet.size();
  for (const Vec3& eye : {Vec3{0, 0, 0.3}, Vec3{0.15, 0.1, 0.25}, Vec3{0.4, 0, 1.2},
                          Vec3{-0.2, 0.05, display.viewingDistance}, Vec3{0.5, 0, 0.601}}) {
    int inside = 0;
    constexpr int count = 20000;
    for (const Vec2& point : pointsIn({}, width, height, count)) {
      const double a = (eye.x - point.x) / eye.z + (eye.y - point.y) / eye.z / slope;
      const double crossing = point.x + point.y / slope + display.viewingDistance * a;
      const double expected =
          views * (0.5 + crossing / (2 * display.viewingDistance * tangentOf(display)));
      const double view = placeSeen(display, sheet, eye, point).view;
      inside += std::abs(view - expected) < views / 2.0 ? 1 : 0;
    }
    const double law = shareInCone(display, eye);
    QVERIFY2(std::abs(double(inside) / count - law) < 0.01,
             text(double(inside) / count, law).constData());
  }
  QCOMPARE(shareInCone(display, {0, 0, -1}), 0.0);
}

void TestSheetNumbers::contrast_data() {
  QTest::addColumn<bool>("isOther");
  QTest::addColumn<int>("axis");
  QTest::addColumn<double>("z");
  for (const bool isOther : {false, true})
    for (const double z : {0.0, -0.004, 0.004, -0.012, 0.02, 0.1})
      for (const int axis : {0, 1})
        QTest::addRow("%d, axis %d, z %g", isOther, axis, z) << isOther << axis << z;
}

void TestSheetNumbers::contrast() {
  QFETCH(bool, isOther);
  QFETCH(int, axis);
  QFETCH(double, z);
  const SheetDisplay display = unit(isOther);
  for (const double frequency : {100.0, 300.0, 600.0, 1000.0}) {
    const double counted = contrastSeen(display, frequency, z, std::size_t(axis));
    const double law = sheetContrast(display, views, frequency, z, std::size_t(axis));
    QVERIFY2(std::abs(counted - law) < 0.01, text(counted, law).constData());
  }
}

/// From a view's middle to the next one's, the picture of a point shifts on the panel; in
/// viewsFront and viewsBehind by a lens. At the sharp depths a grating that the eye sees as a lens
/// for each half period has sinc(1/2) of the contrast that it has on the panel, and more before.
void TestSheetNumbers::depths() {
  QFETCH(bool, isOther);
  const SheetDisplay display = unit(isOther);
  const SheetNumbers n = sheetNumbers(display, views, {0, 0, 0.5});
  for (const double z : {n.viewsFront, -n.viewsBehind}) {
    const double camera = 0.5 / n.viewsPerMetre;                      // half a view aside
    const auto place = [z](double x) { return -x * z / (0.5 - z); };  // of the point (0, 0, z)
    QVERIFY2(isNear(std::abs(place(camera) - place(-camera)), periodOf(display), 1e-9),
             text(place(camera) - place(-camera), periodOf(display)).constData());
  }
  const auto left = [&](double z) {
    const double f = 1 / (2 * periodOf(display));
    return sheetContrast(display, views, f * 0.5 / (0.5 - z), z, 0) /
           sheetContrast(display, views, f, 0, 0);
  };
  for (const double z : {n.depthFront, -n.depthBehind}) {
    QVERIFY2(isNear(left(z), 2 / M_PI, 1e-6), text(left(z), 2 / M_PI).constData());
    QVERIFY(left(0.9 * z) > 2 / M_PI && left(1.1 * z) < 2 / M_PI);
  }
  QVERIFY(n.depthFront < n.viewsFront && n.depthBehind < n.viewsBehind);
  // More views are sharp no deeper than their sub-pixels' light.
  const SheetNumbers most = sheetNumbers(display, 100000, {0, 0, 0.5});
  QVERIFY(isNear(most.depthBehind, n.depthBehind, 0.12) && most.viewsBehind > 0.4);
}

void TestSheetNumbers::withoutAnEye() {
  const SheetNumbers numbers = sheetNumbers(unit(), views, {0, 0, -1});
  QCOMPARE(numbers.distance, 0.0);
  QCOMPARE(numbers.viewsPerMetre, 0.0);
  QCOMPARE(numbers.pseudoscopic(0.063), 0.0);
  QVERIFY(numbers.lobe > 0.5);
  SheetDisplay missing = unit();
  missing.calibration.params.cone = notGiven;
  QVERIFY_EXCEPTION_THROWN((void)sheetNumbers(missing, views, {0, 0, 1}), InputError);
}

QTEST_GUILESS_MAIN(TestSheetNumbers)
#include "test_sheet_numbers.moc"
