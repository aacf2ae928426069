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

Seen seen(const SheetDisplay& display, const Vec3& eye, std::size_t channel,
          const std::function<double(double, double)>& expected) {
  const LensSheet sheet(display);
  const Figures f(display);
  const SubPixels first = display.calibration.cells.front();
  Seen result;
  double squares = 0;
  for (double x = -0.16; x < 0.16; x += 0.00117)
    for (double y = -0.09; y < 0.09; y += 0.00131) {
      const auto hit = sheet.meet(eye, {x - eye.x, y - eye.y, -eye.z}, channel);
      if (!hit) qFatal("the sheet is missed");
      const int column = int(std::floor(hit->column));
      const int rowUp = display.calibration.params.panel[1] - 1 - int(std::floor(hit->row));
      const SubPixels& cell = display.calibration.cells.size() == 1
                                  ? first
                                  : display.calibration.cells[std::size_t(column % 2)];
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
                          job.sampling.samplesPerPixel == 1;
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
