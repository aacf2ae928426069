// SPDX-License-Identifier: BSD-3-Clause
// What an eye sees through a lens sheet, against closed forms (docs/formulas.md, Lens sheet) for a
// unit of round figures like a 16 inch Looking Glass.
#include "core/panel/lens_sheet.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/light_field/light_field.h"
#include "core/optics/simulate.h"
#include "tests/core/random.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

constexpr double inch = 0.0254;
constexpr double views = 48;

SheetDisplay unit(double slope = -6.87, std::vector<SubPixels> cells = SheetCalibration{}.cells) {
  SheetDisplay display;
  display.calibration.params = {44.75, slope, 0.17, 283, {3840, 2160}, 50};
  display.calibration.pattern = cells.size() > 1 ? 2 : 0;
  display.calibration.cells = std::move(cells);
  return display;
}

/// Delta cells, as the 16 inch unit has.
std::vector<SubPixels> delta() {
  return {{{{-0.31, 0.25}, {0.28, 0.25}, {0, -0.25}}},
          {{{-0.31, -0.25}, {0.28, -0.25}, {0, 0.25}}}};
}

/// The figures of the formulas, written out again.
struct Figures {
  explicit Figures(const SheetDisplay& display) {
    const SheetParams& s = display.calibration.params;
    slope = s.slope;
    q = inch / s.dpi;
    p = inch / s.pitch / std::cos(std::atan(1 / slope));
    width = s.panel[0] * q;
    height = s.panel[1] * q;
    lenses = width / p;
    const double tilt = double(s.panel[1]) / (s.panel[0] * slope);
    phase = lenses * (1 + tilt) / 2 - s.center;
    tangent = std::tan(s.cone * M_PI / 360);
    g = p / (2 * tangent);
    distance = display.viewingDistance;
  }
  /// The real-valued view that a place of the panel shows, k + 1/2 in the middle of view k.
  [[nodiscard]] double viewAt(double x, double y) const {
    const double turns = (x + y / slope) / p + phase;
    return views * (1 - (turns - std::floor(turns)));
  }
  double slope, q, p, width, height, lenses, phase, tangent, g, distance;
};

/// The views that an eye sees over the panel, for each colour: minus what is expected, wrapped to
/// half a turn of views.
struct Seen {
  double mean = 0;
  double rms = 0;
  int count = 0;
};

Seen seen(const LensSheet& sheet, const SheetDisplay& woven, const Vec3& eye, std::size_t channel,
          const std::function<double(double, double)>& expected) {
  const Figures f(woven);
  const SubPixels first = woven.calibration.cells.front();
  Seen result;
  double squares = 0;
  for (double x = -0.16; x < 0.16; x += 0.00117)
    for (double y = -0.09; y < 0.09; y += 0.00131) {
      const auto hit = sheet.meet(eye, {x - eye.x, y - eye.y, -eye.z}, channel);
      if (!hit) qFatal("the sheet is missed");
      const int column = int(std::floor(hit->column));
      const int rowUp = woven.calibration.params.panel[1] - 1 - int(std::floor(hit->row));
      const SubPixels& cell = woven.calibration.cells.size() == 1
                                  ? first
                                  : woven.calibration.cells[std::size_t(column % 2)];
      const double view = f.viewAt((column + 0.5 + cell[channel][0]) * f.q - f.width / 2,
                                   (rowUp + 0.5 + cell[channel][1]) * f.q - f.height / 2);
      const double off = std::remainder(view - expected(x, y), views);
      result.mean += off;
      squares += off * off;
      ++result.count;
    }
  result.mean /= result.count;
  result.rms = std::sqrt(squares / result.count);
  return result;
}

/// A panel that is woven for the very sheet before it.
Seen seen(const SheetDisplay& display, const Vec3& eye, std::size_t channel,
          const std::function<double(double, double)>& expected) {
  return seen(LensSheet(display), display, eye, channel, expected);
}

/// The place on the panel behind a ray through (x, y) of the sheet, metres from its middle.
Vec2 behind(const Figures& f, const Vec3& eye, double x, double y) {
  const double period = f.p / (1 + f.g / f.distance);
  const double a = (eye.x - x) / eye.z;
  const double b = (eye.y - y) / eye.z;
  const double lens = std::floor((x + y / f.slope) / period + f.phase);
  const double across = (lens + 0.5 - f.phase) * period - f.g * (a + b / f.slope);
  const double along = y - x / f.slope - f.g * (b - a / f.slope);
  const double square = 1 + 1 / (f.slope * f.slope);
  return {(across - along / f.slope) / square, (across / f.slope + along) / square};
}

/// The contrast that is left of bars of `f` periods a metre along an axis, as all views show them.
double contrastOf(const SheetDisplay& display, double frequency, std::size_t axis) {
  const LensSheet sheet(display);
  const double q = inch / display.calibration.params.dpi;
  const double farther = 1 + sheet.gap() / 0.6;  // the pixels are behind the lenses
  const auto [width, height] = display.calibration.params.panel;
  double sine = 0;
  double cosine = 0;
  int count = 0;
  for (double x = -0.16; x < 0.16; x += 0.000317)
    for (double y = -0.09; y < 0.09; y += 0.000531, ++count) {
      const auto hit = sheet.meet({0, 0, 0.6}, {x, y, -0.6}, 1);
      const double place = axis == 0 ? (std::floor(hit->column) + 0.5 - width / 2.0) * q
                                     : (height / 2.0 - std::floor(hit->row) - 0.5) * q;
      const double there = 2 * M_PI * frequency * farther * (axis == 0 ? x : y);
      const double value = std::cos(2 * M_PI * frequency * place);
      cosine += value * std::cos(there);
      sine += value * std::sin(there);
    }
  return 2 * std::hypot(sine, cosine) / count;
}

double sinc(double t) {
  return t == 0 ? 1 : std::sin(M_PI * t) / (M_PI * t);
}

QByteArray text(double measured, double law) {
  return QString("%1, law %2").arg(measured, 0, 'g', 6).arg(law, 0, 'g', 6).toUtf8();
}

}  // namespace

class TestLensSheet : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aViewsMiddleShowsThatView_data();
  void aViewsMiddleShowsThatView();
  void viewsTurnAwayFromTheDistance_data();
  void viewsTurnAwayFromTheDistance();
  void aLowerEyeSeesOtherViews();
  void lightGoesStraightAlongTheLenses();
  void aWrongCenterShiftsViews();
  void aWrongPitchTurnsViews();
  void aWrongSlopeTurnsViews();
  void wrongCellsShiftColours();
  void viewsFlipAtTheConesEdge();
  void aSpotWidensViews_data();
  void aSpotWidensViews();
  void spotWeightsHaveTheVariance();
  void detailIsLost_data();
  void detailIsLost();
  void emittersOfTheirTrueArea_data();
  void emittersOfTheirTrueArea();
  void uprightLensesColourWhite();
  void aMountedSheet_data();
  void aMountedSheet();
  void weaveIsItsFormula_data();
  void weaveIsItsFormula();
  void enginesAgree();
  void refusesWhatItCannotDo();
  void beyondTheSheet();
  void missingFigures();

 private:
  static RenderJob jobOf(std::uint64_t seed);
};

void TestLensSheet::aViewsMiddleShowsThatView_data() {
  QTest::addColumn<double>("slope");
  QTest::addColumn<bool>("isDelta");
  QTest::newRow("leans to the right") << -6.87 << true;
  QTest::newRow("leans to the left") << 5.5 << false;
  QTest::newRow("upright sub-pixels") << -6.87 << false;
}

/// From the middle of view k at the viewing distance, at x = ((k + 1/2)/N − 1/2)·2D tan(cone/2) −
/// y/slope, all of the panel shows view k but for the size of a sub-pixel: within its width w and a
/// row, rms (N q/p)·√((w² + slope⁻²)/12).
void TestLensSheet::aViewsMiddleShowsThatView() {
  QFETCH(double, slope);
  QFETCH(bool, isDelta);
  const SheetDisplay display = unit(slope, isDelta ? delta() : SheetCalibration{}.cells);
  const Figures f(display);
  for (const int k : {0, 11, 24, 47})
    for (const double y : {0.0, 0.1})
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double x = ((k + 0.5) / views - 0.5) * 2 * f.distance * f.tangent - y / slope;
        const Seen all =
            seen(display, {x, y, f.distance}, channel, [k](double, double) { return k + 0.5; });
        const double w = display.emitter[0];
        const double law = views * f.q / f.p * std::sqrt((w * w + 1 / slope / slope) / 12);
        QVERIFY2(std::abs(all.mean) < 0.03, text(all.mean, 0).constData());
        QVERIFY2(std::abs(all.rms - law) < 0.03 * law, text(all.rms, law).constData());
      }
}

void TestLensSheet::viewsTurnAwayFromTheDistance_data() {
  QTest::addColumn<double>("z");
  for (const double z : {0.4, 0.5, 0.8, 1.2}) QTest::newRow(qPrintable(QString::number(z))) << z;
}

/// Along the panel the view grows by (N g/p)(1/D − 1/z) for each metre.
void TestLensSheet::viewsTurnAwayFromTheDistance() {
  QFETCH(double, z);
  const SheetDisplay display = unit();
  const Figures f(display);
  const double perMetre = views * f.g / f.p * (1 / f.distance - 1 / z);
  const Seen all = seen(display, {0, 0, z}, 1, [&](double x, double y) {
    return views / 2 + perMetre * (x + y / f.slope);
  });
  QVERIFY2(std::abs(all.mean) < 0.03 && all.rms < 1, text(all.mean, 0).constData());
}

/// By N g y/(p slope D) views.
void TestLensSheet::aLowerEyeSeesOtherViews() {
  const SheetDisplay display = unit();
  const Figures f(display);
  const double law = views * f.g * -0.2 / (f.p * f.slope * f.distance);
  const Seen all =
      seen(display, {0, -0.2, f.distance}, 1, [&](double, double) { return views / 2 + law; });
  QVERIFY2(std::abs(all.mean) < 0.03, text(all.mean, 0).constData());
  QVERIFY2(std::abs(law - 2.5) < 0.1, text(law, 2.5).constData());
}

/// Along the lenses a ray ends where it would without them, g behind the sheet.
void TestLensSheet::lightGoesStraightAlongTheLenses() {
  const SheetDisplay display = unit(-6.87, delta());
  const LensSheet sheet(display);
  const Figures f(display);
  const Vec3 eye{0.2, 0.1, 0.6};
  double sum = 0;
  int count = 0;
  for (double x = -0.16; x < 0.16; x += 0.00117)
    for (double y = -0.09; y < 0.09; y += 0.00131, ++count) {
      const auto hit = sheet.meet(eye, {x - eye.x, y - eye.y, -eye.z}, 2);
      const SubPixels& cell = display.calibration.cells[std::size_t(int(hit->column) % 2)];
      const double right = (hit->column + cell[2][0]) * f.q - f.width / 2;
      const double up = f.height / 2 - (hit->row - cell[2][1]) * f.q;
      const double a = (eye.x - x) / eye.z;
      const double b = (eye.y - y) / eye.z;
      const double law = y - x / f.slope - f.g * (b - a / f.slope);
      sum += (up - right / f.slope - law) / f.q;
    }
  QVERIFY2(std::abs(sum / count) < 0.05, text(sum / count, 0).constData());
}

/// A lens sheet that is a share of its period aside shows as large a share of the views.
void TestLensSheet::aWrongCenterShiftsViews() {
  SheetDisplay display = unit();
  const SheetDisplay right = display;
  display.calibration.params.center += 0.02;
  const LensSheet sheet(display);
  const Figures woven(right);
  double sum = 0;
  int count = 0;
  for (double x = -0.16; x < 0.16; x += 0.00117, ++count) {
    const auto hit = sheet.meet({0, 0, 0.6}, {x, 0, -0.6}, 0);
    const double view = woven.viewAt(hit->column * woven.q - woven.width / 2,
                                     woven.height / 2 - hit->row * woven.q);
    sum += std::remainder(view - views / 2, views);
  }
  QVERIFY2(std::abs(std::abs(sum / count) - 0.96) < 0.1, text(sum / count, 0.96).constData());
}

/// A sheet whose pitch is e too large turns the views once for every p/e of the panel.
void TestLensSheet::aWrongPitchTurnsViews() {
  const SheetDisplay display = unit();
  const Figures f(display);
  constexpr double error = 5e-4;
  LensArrayErrors wide;
  wide.pitchError = {error, error};
  const double perMetre = views * error / f.p;
  // The sheet is stretched about the panel's middle.
  const Seen all =
      seen(LensSheet(display, wide), display, {0, 0, f.distance}, 1,
           [&](double x, double y) { return views / 2 - perMetre * (x + y / f.slope); });
  QVERIFY2(std::abs(all.mean) < 0.05 && all.rms < 1, text(all.rms, 0).constData());
  QVERIFY2(std::abs(perMetre - 41.8) < 0.5, text(perMetre, 41.8).constData());
}

/// By −N d(1/slope)/p views a metre up the panel.
void TestLensSheet::aWrongSlopeTurnsViews() {
  const SheetDisplay display = unit();
  const Figures f(display);
  SheetDisplay other = display;
  other.calibration.params.slope *= 1.01;
  // The phase of the panel's middle stays, which the slope and the pitch along x have a part in.
  const Figures wrong(other);
  other.calibration.params.center += wrong.phase - f.phase;
  const double ratio = std::cos(std::atan(1 / f.slope)) / std::cos(std::atan(1 / wrong.slope));
  other.calibration.params.pitch *= ratio;  // the same period along x
  const Figures again(other);
  other.calibration.params.center += again.phase - f.phase;
  const double perMetre = views * (1 / f.slope - 1 / wrong.slope) / f.p;
  const Seen all = seen(LensSheet(other), display, {0, 0, f.distance}, 1,
                        [&](double, double y) { return views / 2 - perMetre * y; });
  QVERIFY2(std::abs(all.mean) < 0.06 && all.rms < 1, text(all.rms, 0).constData());
  QVERIFY2(std::abs(std::abs(perMetre) - 120.5) < 1, text(perMetre, 120.5).constData());
}

/// Views that are woven for stripes of red, green and blue on a panel of delta cells: each colour
/// is off by N/p of how far its sub-pixels are from where they are thought to be.
void TestLensSheet::wrongCellsShiftColours() {
  const SheetDisplay panel = unit(-6.87, delta());
  const SheetDisplay woven = unit();
  const Figures f(panel);
  const LensSheet sheet(panel);
  const auto [red, green, blue] = delta().front();
  const std::array real{red, green, blue};
  for (std::size_t c = 0; c < 3; ++c) {
    double off = 0;
    double law = 0;
    int count = 0;
    for (double x = -0.16; x < 0.16; x += 0.00117)
      for (double y = -0.09; y < 0.09; y += 0.00131, ++count) {
        const auto hit = sheet.meet({0, 0, 0.6}, {x, y, -0.6}, c);
        const double right = (hit->column + double(c) / 3) * f.q - f.width / 2;
        const double up = f.height / 2 - hit->row * f.q;
        off += std::remainder(f.viewAt(right, up) - views / 2, views);
      }
    law = -views * f.q / f.p * (double(c) / 3 - real[c][0]);  // up and down alternate
    QVERIFY2(std::abs(off / count - law) < 0.1, text(off / count, law).constData());
  }
}

void TestLensSheet::viewsFlipAtTheConesEdge() {
  const SheetDisplay display = unit();
  const Figures f(display);
  const double edge = f.distance * f.tangent;
  for (const double x : {-0.9 * edge, -0.4 * edge, 0.97 * edge, 1.03 * edge, 1.4 * edge}) {
    const double turns = 0.5 + x / (2 * edge);
    const double view = views * (turns - std::floor(turns));
    const Seen all = seen(display, {x, 0, f.distance}, 1, [&](double, double) { return view; });
    QVERIFY2(std::abs(all.mean) < 0.03, text(all.mean, 0).constData());
    QVERIFY2(x < edge || x > 1.1 * edge || view < 2, "the first view does not come again");
  }
}

void TestLensSheet::aSpotWidensViews_data() {
  QTest::addColumn<double>("spot");
  for (const double spot : {1e-5, 2e-5, 5e-5, 2e-4})
    QTest::newRow(qPrintable(QString::number(spot))) << spot;
}

/// To an rms of √(lobe² + (N spot/p)²) views.
void TestLensSheet::aSpotWidensViews() {
  QFETCH(double, spot);
  SheetDisplay display = unit(-6.87, delta());
  display.spot = spot;
  const Figures f(display);
  const LensSheet sheet(display);
  const std::vector<double>& weights = sheet.spot();
  const int reach = int(weights.size() / 2);
  double squares = 0;
  double lobe = 0;
  int count = 0;
  for (double x = -0.1; x < 0.1; x += 0.00117)
    for (double y = -0.06; y < 0.06; y += 0.00131, ++count) {
      const auto hit = sheet.meet({0, 0, 0.6}, {x, y, -0.6}, 0);
      const auto offAt = [&](int column) {
        const auto& [right, up] =
            display.calibration.cells[std::size_t(std::abs(int(hit->column)) % 2)][0];
        return std::remainder(f.viewAt((column + 0.5 + right) * f.q - f.width / 2,
                                       f.height / 2 - (hit->row - up) * f.q) -
                                  views / 2,
                              views);
      };
      lobe += offAt(int(hit->column)) * offAt(int(hit->column));
      for (int k = -reach; k <= reach; ++k) {
        const double off = offAt(int(hit->column)) - k * views * f.q / f.p;  // not wrapped
        squares += weights[std::size_t(k + reach)] * off * off;
      }
    }
  const double law = std::sqrt(lobe / count + std::pow(views * spot / f.p, 2));
  const double rms = std::sqrt(squares / count);
  QVERIFY2(std::abs(rms - law) < 0.01 * law, text(rms, law).constData());
}

void TestLensSheet::spotWeightsHaveTheVariance() {
  for (const double sigma : {0.05, 0.3, 1.0, 4.0, 9.9, 10.1, 40.0, 4e4}) {
    const std::vector<double> weights = spotWeights(sigma);
    QCOMPARE(weights.size() % 2, std::size_t(1));
    double sum = 0;
    double variance = 0;
    for (std::size_t t = 0; t < weights.size(); ++t) {
      const double k = double(t) - double(weights.size() / 2);
      QCOMPARE(weights[t], weights[weights.size() - 1 - t]);
      sum += weights[t];
      variance += k * k * weights[t];
    }
    QVERIFY(std::abs(sum - 1) < 1e-12);
    QVERIFY2(std::abs(variance - sigma * sigma) < 3e-3 * sigma * sigma,
             text(variance, sigma * sigma).constData());
  }
}

void TestLensSheet::detailIsLost_data() {
  QTest::addColumn<double>("frequency");
  for (const double frequency : {100.0, 300.0, 600.0, 900.0})
    QTest::newRow(qPrintable(QString::number(frequency))) << frequency;
}

/// Over its period a lens shows one place of the panel, but for what it moves along the lens:
/// vertical bars keep sinc(f p slope²/(1 + slope²)) sinc(f q). Along a lens a ray slides to its
/// emitter: horizontal ones keep sinc(f q) sinc(f q (1 − w) slope).
void TestLensSheet::detailIsLost() {
  QFETCH(double, frequency);
  const SheetDisplay display = unit();
  const Figures f(display);
  const double w = display.emitter[0];
  const double vertical = contrastOf(display, frequency, 0);
  const double s2 = f.slope * f.slope;
  const double upright = sinc(frequency * f.p * s2 / (1 + s2)) * sinc(frequency * f.q);
  QVERIFY2(std::abs(vertical - upright) < 0.004, text(vertical, upright).constData());
  const double horizontal = contrastOf(display, frequency, 1);
  const double lying = sinc(frequency * f.p * f.slope / (1 + s2)) * sinc(frequency * f.q) *
                       sinc(frequency * f.q * (1 - w) * f.slope);
  QVERIFY2(std::abs(horizontal - lying) < 0.016, text(horizontal, lying).constData());
}

void TestLensSheet::emittersOfTheirTrueArea_data() {
  QTest::addColumn<double>("width");
  QTest::addColumn<double>("height");
  QTest::newRow("stripes") << 1.0 / 3 << 1.0;
  QTest::newRow("small") << 0.3 << 0.5;
}

/// The oracle: real rays, of which those give light that end on an emitter. Their views have the
/// mean of meet()'s, and an rms of (N q/p)√((w² + h²/slope²)/12), of which meet()'s is that of h =
/// 1.
void TestLensSheet::emittersOfTheirTrueArea() {
  QFETCH(double, width);
  QFETCH(double, height);
  SheetDisplay display = unit(-6.87, delta());
  display.emitter = {width, height};
  const Figures f(display);
  const LensSheet sheet(display);
  const Vec3 eye{0.11, 0.07, f.distance};
  const double view = views * (0.5 + (eye.x + eye.y / f.slope) / (2 * f.distance * f.tangent));
  for (std::size_t c = 0; c < 3; ++c) {
    double mean = 0;
    double squares = 0;
    int count = 0;
    for (double x = -0.15; x < 0.15; x += 0.000457)
      for (double y = -0.08; y < 0.08; y += 0.000391) {
        const Vec2 place = behind(f, eye, x, y);
        const double right = (place.x + f.width / 2) / f.q;
        const double up = (place.y + f.height / 2) / f.q;
        // The emitter that the ray ends on, if any.
        for (int column = int(right) - 1; column <= int(right) + 1; ++column)
          for (int row = int(up) - 1; row <= int(up) + 1; ++row) {
            const auto& [dx, dy] = display.calibration.cells[std::size_t(column % 2)][c];
            if (std::abs(right - (column + 0.5 + dx)) > width / 2 ||
                std::abs(up - (row + 0.5 + dy)) > height / 2)
              continue;
            const double off = std::remainder(f.viewAt((column + 0.5 + dx) * f.q - f.width / 2,
                                                       (row + 0.5 + dy) * f.q - f.height / 2) -
                                                  view,
                                              views);
            mean += off;
            squares += off * off;
            ++count;
          }
      }
    QVERIFY(count > 10000);
    const double rms = std::sqrt(squares / count);
    const auto lawOf = [&](double h) {
      return views * f.q / f.p * std::sqrt((width * width + h * h / (f.slope * f.slope)) / 12);
    };
    QVERIFY2(std::abs(mean / count) < 0.03, text(mean / count, 0).constData());
    QVERIFY2(std::abs(rms - lawOf(height)) < 0.02 * rms, text(rms, lawOf(height)).constData());
    const Seen met = seen(display, eye, c, [&](double, double) { return view; });
    QVERIFY2(std::abs(met.mean - mean / count) < 0.04, text(met.mean, mean / count).constData());
    QVERIFY2(std::abs(met.rms - lawOf(1)) < 0.03 * met.rms, text(met.rms, lawOf(1)).constData());
  }
}

/// Where emitters have their true area, an eye sees white coloured through upright lenses, and
/// hardly so through slanted ones. meet() always finds an emitter, so that white stays white.
void TestLensSheet::uprightLensesColourWhite() {
  const auto colourOf = [](double slope) {
    const SheetDisplay display = unit(slope);
    const Figures f(display);
    double squares = 0;
    int count = 0;
    // Camera pixels of 1 mm.
    for (double x0 = -0.05; x0 < 0.05; x0 += 0.0031)
      for (double y0 = -0.05; y0 < 0.05; y0 += 0.0071, ++count) {
        std::array<double, 3> light{};
        for (double x = x0; x < x0 + 1e-3; x += 2.3e-5)
          for (double y = y0; y < y0 + 1e-3; y += 2.9e-5) {
            const double right = (behind(f, {0, 0, 0.6}, x, y).x + f.width / 2) / f.q;
            for (std::size_t c = 0; c < 3; ++c) {
              const double beside = right - 0.5 - double(c) / 3;
              if (std::abs(beside - std::round(beside)) < 1.0 / 6) ++light[c];
            }
          }
        const double sum = light[0] + light[1] + light[2];
        for (const double each : light) squares += std::pow(3 * each / sum - 1, 2) / 3;
      }
    return std::sqrt(squares / count);
  };
  const double slanted = colourOf(-6.87);
  const double upright = colourOf(-1e6);
  QVERIFY2(slanted < 0.15, text(slanted, 0).constData());
  QVERIFY2(upright > 0.4, text(upright, 0).constData());
}

void TestLensSheet::aMountedSheet_data() {
  QTest::addColumn<double>("rotation");
  QTest::addColumn<double>("wider");
  QTest::addColumn<double>("gap");
  QTest::addColumn<double>("right");
  QTest::addColumn<double>("up");
  QTest::newRow("turned") << 0.3 << 0.0 << 0.0 << 0.0 << 0.0;
  QTest::newRow("turned to the right") << -1.5 << 0.0 << 0.0 << 0.0 << 0.0;
  QTest::newRow("stretched") << 0.0 << 0.002 << 0.0 << 0.0 << 0.0;
  QTest::newRow("farther") << 0.0 << 0.0 << 0.05 << 0.0 << 0.0;
  QTest::newRow("moved") << 0.0 << 0.0 << 0.0 << 3e-5 << -2e-4;
  QTest::newRow("all") << 0.7 << -0.001 << -0.03 << 5e-5 << 1e-4;
}

/// A sheet with a unit's errors is the sheet of another calibration: its slope is cot(atan(1/slope)
/// + rotation), its lenses are wider, and the panel's middle is at another phase.
void TestLensSheet::aMountedSheet() {
  QFETCH(double, rotation);
  QFETCH(double, wider);
  QFETCH(double, gap);
  QFETCH(double, right);
  QFETCH(double, up);
  const SheetDisplay display = unit(-6.87, delta());
  const Figures f(display);
  LensArrayErrors errors;
  errors.rotation = rotation;
  errors.pitchError = {wider, wider};
  errors.gapError = gap;
  errors.offset = {right, up};
  SheetDisplay other = display;
  SheetParams& params = other.calibration.params;
  params.slope = 1 / std::tan(std::atan(1 / f.slope) + rotation * M_PI / 180);
  params.pitch /= 1 + wider;
  other.viewingDistance *= 1 + gap;  // keeps the lenses' period before the farther panel
  const double p = inch / params.pitch / std::cos(std::atan(1 / params.slope));
  params.cone = 2 * std::atan(p / (2 * f.g * (1 + gap))) * 180 / M_PI;
  // p/(1 + g/D) of the design is stretched, while the calibration's own is made of its gap.
  other.viewingDistance = f.distance * (1 + gap);
  const double lensPeriod = p / (1 + f.g / f.distance);
  const Figures moved(other);
  params.center += moved.phase - (f.phase - (right + up / params.slope) / lensPeriod);
  const LensSheet mounted(display, errors);
  const LensSheet same(other);
  int different = 0;
  int count = 0;
  for (double x = -0.16; x < 0.16; x += 0.00117)
    for (double y = -0.09; y < 0.09; y += 0.00131, ++count) {
      const Vec3 eye{0.1, 0.05, 0.5};
      const Vec3 direction{x - eye.x, y - eye.y, -eye.z};
      const auto a = mounted.meet(eye, direction, 1);
      const auto b = same.meet(eye, direction, 1);
      if (a->column != b->column || a->row != b->row) ++different;
    }
  QVERIFY2(different <= count / 10000, text(different, 0).constData());
}

void TestLensSheet::weaveIsItsFormula_data() {
  QTest::addColumn<int>("pattern");
  QTest::addColumn<double>("slope");
  for (int pattern = 0; pattern < 5; ++pattern)
    QTest::newRow(qPrintable(QString::number(pattern)))
        << pattern << (pattern % 2 == 0 ? -6.87 : 5.5);
}

/// A million sub-pixels, by the formula as the vendor's shaders have it.
void TestLensSheet::weaveIsItsFormula() {
  QFETCH(int, pattern);
  QFETCH(double, slope);
  SheetDisplay display = unit(slope, delta());
  if (pattern == 3) {
    for (const SubPixels& kind : delta()) display.calibration.cells.push_back(kind);
    display.calibration.cells[2][0] = {0.1, 0.1};
  }
  display.calibration.pattern = pattern;
  const LensSheet sheet(display);
  const Figures f(display);
  int different = 0;
  int count = 0;
  for (int row = 3; row < 2160; row += 13)
    for (int column = 1; column < 3840; column += 3)
      for (std::size_t c = 0; c < 3; ++c, ++count) {
        const int up = 2159 - row;
        const std::array kinds{0, (column + up) % 2, column % 2, (up + 2 * (column % 2)) % 4,
                               up % 2};
        const auto& [x, y] = display.calibration.cells[std::size_t(kinds[std::size_t(pattern)])][c];
        const double view =
            f.viewAt((column + 0.5 + x) * f.q - f.width / 2, (up + 0.5 + y) * f.q - f.height / 2);
        const int law = std::min(int(view), int(views) - 1);
        if (sheet.viewOf(column, row, c, int(views)) != law) ++different;
      }
  QVERIFY(count > 600000);
  QCOMPARE(different, 0);
}

RenderJob TestLensSheet::jobOf(std::uint64_t seed) {
  Random random(seed);
  SheetDisplay sheet = unit(random.flip() ? random.uniform(-9, -3) : random.uniform(3, 9), delta());
  sheet.calibration.params.panel = {random.integer(40, 200), random.integer(30, 120)};
  sheet.calibration.params.dpi = random.uniform(10, 80);
  sheet.calibration.params.pitch = random.uniform(2, 15);
  sheet.calibration.pattern = random.integer(0, 2);
  const bool isWide = random.integer(0, 3) == 0;
  if (isWide) sheet.spot = random.uniform(1e-4, 2e-3);
  const LensSheet lenses(sheet);
  RenderJob job;
  job.display.sheet = sheet;
  job.display.size = lenses.size();
  const auto [width, height] = sheet.calibration.params.panel;
  job.display.hogels = {width, height};
  job.display.directions = {1, 1};
  job.display.position = {0.1, 0.2, -0.1};
  job.display.orientation = {random.uniform(-20, 20), random.uniform(-20, 20), 5};
  std::vector<std::uint8_t> values(std::size_t(3) * std::size_t(width) * std::size_t(height));
  for (std::uint8_t& value : values) value = std::uint8_t(random.integer(0, 255));
  job.lightField = std::make_shared<const LightField>(LightFieldSize{width, height, 1, 1}, values);
  CameraParams& camera = job.state.camera;
  camera.lookat = job.display.position;
  camera.eye = job.display.position + Vec3{random.uniform(-0.1, 0.1), 0.05, 0.5};
  camera.fov = 2 * std::atan(lenses.size()[0]) * 180 / M_PI;
  camera.res = {150, 90};
  job.state.psf = {0.5, 1};
  if (random.flip()) job.state.distortion.k1 = 0.1;
  if (random.flip()) job.sampling.samplesPerPixel = 3;
  if (random.integer(0, 3) == 0) job.state.pupil = {0.01, 0, 7};
  return job;
}

/// The fast engine and the reference, through lenses and pupils, over the sheet's edges.
void TestLensSheet::enginesAgree() {
  int pixels = 0;
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RenderJob job = jobOf(seed);
    const Image reference = simulate(job);
    const Image fast = rendered(job);
    QVERIFY(reference.seen == fast.seen);
    for (std::size_t at = 0; at < fast.rgb.size(); ++at)
      QVERIFY2(std::abs(fast.rgb[at] - reference.rgb[at]) <= 1, qPrintable(QString::number(seed)));
    // Without a lens or several rays a pixel's colours are those of the sub-pixels that are met.
    const bool isOneRay = job.state.distortion.k1 == 0 && job.state.pupil.diameter == 0 &&
                          job.sampling.samplesPerPixel == 1 && job.display.sheet->spot == 0;
    const Display display(job.display);
    const Camera camera(job.state.camera, job.state.intrinsics);
    const RigidTransform from = display.displayFromWorld() * camera.worldFromCamera();
    for (int at = 0; isOneRay && at < fast.width * fast.height; ++at) {
      if (fast.seen[std::size_t(at)] == 0) continue;
      const Vec2 place = camera.normalised(at % fast.width, at / fast.width);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto hit = LensSheet(*job.display.sheet)
                             .meet(from.origin, from.direction({place.x, place.y, 1}), c);
        const Rgb light = job.lightField->texel({int(hit->column), int(hit->row), 0, 0});
        const std::array values{light.r, light.g, light.b};
        QCOMPARE(double(fast.rgb[std::size_t(3 * at) + c]), values[c]);
        ++compared;
      }
    }
    pixels += int(std::count(fast.seen.begin(), fast.seen.end(), 255));
  }
  QVERIFY2(compared > 10000, qPrintable(QString::number(compared)));
  QVERIFY2(pixels > 20000, qPrintable(QString::number(pixels)));
}

void TestLensSheet::refusesWhatItCannotDo() {
  const auto error = [](const std::function<void(RenderJob&)>& change) {
    RenderJob job = jobOf(1);
    change(job);
    try {
      (void)rendered(job);
    } catch (const InputError& refusal) {
      return std::string(refusal.what());
    }
    return std::string();
  };
  QVERIFY(
      error([](RenderJob& job) { job.state.psf.windowSize = 3; }).starts_with("psf.windowSize"));
  QVERIFY(error([](RenderJob& job) {
            job.sampling.reconstruction = Reconstruction::bilinear;
          }).starts_with("sampling.reconstruction"));
  QVERIFY(error([](RenderJob& job) {
            job.display.hogels = {3, 2};
            job.lightField =
                std::make_shared<const LightField>(LightFieldSize{3, 2, 1, 1}, StoredType::uint8);
          }).starts_with("lightField: is not the picture"));
}

void TestLensSheet::beyondTheSheet() {
  const LensSheet sheet(unit());
  QVERIFY(!sheet.meet({0, 0, -0.6}, {0, 0, -1}, 0));  // from behind
  QVERIFY(!sheet.meet({0, 0, 0.6}, {0, 0, 1}, 0));    // away
  const auto beside = sheet.meet({0, 0, 0.6}, {0.3, 0, -0.6}, 0);
  QVERIFY(beside && beside->column > 3840);
  const auto far = sheet.meet({0, 0, 0.6}, {1, 1e-9, -1e-300}, 0);
  QVERIFY(!far || far->column > 3840 || far->column < 0);
}

void TestLensSheet::missingFigures() {
  const auto error = [](const SheetDisplay& display) {
    try {
      const LensSheet sheet(display);
    } catch (const InputError& refusal) {
      return std::string(refusal.what());
    }
    return std::string();
  };
  SheetDisplay display = unit();
  display.calibration.params.pitch = notGiven;
  QCOMPARE(error(display), std::string("pitch: is missing"));
  display = unit();
  display.calibration.params.panel = {0, 0};
  QCOMPARE(error(display), std::string("panel: is missing"));
  QVERIFY(error(unit(0)).starts_with("slope: is 0"));
}

QTEST_GUILESS_MAIN(TestLensSheet)
#include "test_lens_sheet.moc"
