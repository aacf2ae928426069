// SPDX-License-Identifier: BSD-3-Clause
// Twins against closed forms: each imperfection has a law of optics or of statistics that rays and
// light must follow (docs/formulas.md, Twin). test_twin.cpp has the engines and the inverse.
#include "core/panel/twin.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>

#include "tests/core/random_twin.h"

using namespace hogelscope;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double p = 0.001;                  ///< pitch of the hogels, metres
const double T = 2 * std::tan(radians(20));  ///< width of the field in slopes
const double g = p / T;                      ///< metres behind the lens for each unit of slope

/// The display that the laws are looked at with: hogels of 1 mm, fields of 40 degrees.
PanelParams displayOf(int nx = 80, int ny = 60, int directions = 24) {
  PanelParams display;
  display.size = {p * nx, p * ny};
  display.hogels = {nx, ny};
  display.directions = {directions, directions};
  display.fov = {40, 40};
  return display;
}

Twin twinOf(const LensArrayErrors& errors, const PanelParams& display = displayOf()) {
  TwinParams params;
  params.lensArray = errors;
  return {params, {}, display};
}

struct Ray {
  Vec3 eye;
  Vec3 direction;
};

Ray rayFrom(const Vec3& eye, const Vec2& place) {
  return {eye, {place.x - eye.x, place.y - eye.y, -eye.z}};
}

/// The ray that an eye one metre away sees through a point of the panel's plane.
Ray rayAlong(const PanelRay& ray) {
  const auto& [at, slopes] = ray;
  return {{at.x + slopes.x, at.y + slopes.y, 1}, {-slopes.x, -slopes.y, -1}};
}

Hit met(const Twin& twin, const Ray& ray, std::size_t channel = 1) {
  return twin.meet(ray.eye, ray.direction, channel).value();
}

Hit met(const Display& design, const Ray& ray) {
  return design.intersectPlane(ray.eye, ray.direction).value();
}

bool isSameHogel(const Hit& a, const Hit& b) {
  return std::floor(a.i) == std::floor(b.i) && std::floor(a.j) == std::floor(b.j);
}

/// Returns how many pixels apart the directions of two hits are.
double between(const Hit& a, const Hit& b) {
  return std::max(std::abs(a.u - b.u), std::abs(a.v - b.v));
}

/// Light that leaves all of the panel into `field` of the field of 40 degrees. The rays cover
/// places and slopes evenly: the k-th point of Roberts' sequence in four dimensions.
PanelRay evenRay(int k, const PanelParams& display = displayOf(), double field = 1) {
  const auto spread = [k](double step) { return k * step - std::floor(k * step) - 0.5; };
  return {
      {display.size[0] * spread(0.8566748838545029), display.size[1] * spread(0.733891856627126)},
      {field * T * spread(0.6287067210378087), field * T * spread(0.5385972572236101)}};
}

QByteArray text(double measured, double law) {
  return QString("%1, law %2").arg(measured, 0, 'g', 8).arg(law, 0, 'g', 8).toUtf8();
}

double sinc(double x) {
  return x == 0 ? 1 : std::sin(pi * x) / (pi * x);
}

/// Returns the frequency of phases (in periods) of which only the fractions are known: the slope
/// of their regression line. They are `step` metres apart.
double frequencyOf(const std::vector<double>& phases, double step) {
  double unwrapped = 0;
  double sum = 0;
  double squares = 0;
  for (std::size_t k = 1; k < phases.size(); ++k) {
    const double more = phases[k] - phases[k - 1];
    unwrapped += more - std::round(more);
    const double fromMiddle = double(k) - double(phases.size() - 1) / 2;
    sum += fromMiddle * unwrapped;
    squares += fromMiddle * fromMiddle;
  }
  const double first = double(phases.size() - 1) / 2;
  return sum / (squares + first * first) / step;
}

/// Returns how often the phase of a pattern repeats in a metre, as an eye sees it on a line over
/// `length` metres of the panel.
double frequencyAlong(const Vec2& line, double length, const Vec3& eye,
                      const std::function<double(const Ray&)>& phaseOf) {
  constexpr int steps = 10000;
  std::vector<double> phases;
  for (int k = 0; k < steps; ++k) {
    const double along = length * ((k + 0.5) / steps - 0.5);
    phases.push_back(phaseOf(rayFrom(eye, {along * line.x, along * line.y})));
  }
  return frequencyOf(phases, length / steps);
}

/// Returns how much of its contrast a grating cos(2π frequency x) of content at the depth z keeps
/// for eyes that are far away.
double contrastOf(const Twin& twin, const PanelParams& display, double frequency, double z) {
  const Display design(display);
  constexpr int rays = 200000;
  std::complex<double> sum;
  for (int k = 0; k < rays; ++k) {
    const PanelRay ray = evenRay(k, display, 0.4);
    const Hit hit = met(twin, rayAlong(ray));
    if (!design.isOnPanel(hit)) continue;
    const PanelRay shown = design.rayOf({int(hit.i), int(hit.j), int(hit.u), int(hit.v)});
    const double light = std::cos(2 * pi * frequency * (shown.position.x + z * shown.slopes.x));
    sum += light * std::polar(2.0, -2 * pi * frequency * (ray.position.x + z * ray.slopes.x));
  }
  return std::abs(sum) / rays;
}

Rgb litAlike(const Twin& twin, const Hit& hit, const Rgb& content = {1, 1, 1}) {
  return twin.lit({hit, hit, hit}, content);
}

Twin twinOfSurface(const std::function<double(double, double)>& z) {
  const PanelParams display = displayOf();
  TwinPlane plane{800, 600, {}};
  for (int row = 0; row < plane.height; ++row)
    for (int column = 0; column < plane.width; ++column)
      plane.values.push_back(
          static_cast<float>(z(display.size[0] * ((column + 0.5) / plane.width - 0.5),
                               display.size[1] * (0.5 - (row + 0.5) / plane.height))));
  TwinMaps maps;
  maps.height = plane;
  return {{}, maps, display};
}

/// Returns the place on the panel whose pixel a ray shows: pixels are at the distance g(1 + γ)
/// behind thin lenses of the focal length g(1 + φ), which make a ray's slope larger by its distance
/// from their axis / the focal length.
Vec2 shownByThinLens(const LensArrayErrors& errors, const PanelRay& ray) {
  const auto [x, y] = ray.position;
  // The sheet of lenses, as places x + iy, is turned after its pitches changed.
  const auto turn = std::polar(1.0, radians(errors.rotation));
  const std::complex offset{errors.offset[0], errors.offset[1]};
  const auto onSheet = (std::complex{x, y} - offset) / turn;
  const auto middleOf = [](double place, double pitch) {
    return (std::floor(place / pitch) + 0.5) * pitch;
  };
  const std::complex middle{middleOf(onSheet.real(), p * (1 + errors.pitchError[0])),
                            middleOf(onSheet.imag(), p * (1 + errors.pitchError[1]))};
  const auto axis = middle * turn + offset;
  const auto [width, height] = displayOf().size;
  const double gap =
      g * (1 + errors.gapError + errors.wedge[0] * x / width + errors.wedge[1] * y / height);
  const double focal = g * (1 + errors.focalError);
  return {x - gap * (ray.slopes.x + (x - axis.real()) / focal),
          y - gap * (ray.slopes.y + (y - axis.imag()) / focal)};
}

}  // namespace

class TestTwinLaws : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lensesAreThin();
  void offsetMovesPixels_data();
  void offsetMovesPixels();
  void hogelsShiftAndTilt();
  void moire_data();
  void moire();
  void rotationMoire();
  void gapErrorScalesDepth_data();
  void gapErrorScalesDepth();
  void focalErrorDefocuses_data();
  void focalErrorDefocuses();
  void pitchErrorConverges();
  void randomShiftLowersContrast_data();
  void randomShiftLowersContrast();
  void coloursFringe();
  void bentPanelConverges();
  void tiltedSurfaceIsTurnedDisplay();
  void randomGain();
  void blackAndAmbient();
  void falloff();
  void fill();
  void gainsMultiply();
};

/// Rays meet pixels as behind thin lenses; beyond the field those of the hogels beside.
void TestTwinLaws::lensesAreThin() {
  const Display design(displayOf());
  Random random(5);
  const auto drawn = [&](double limit) { return random.uniform(-limit, limit); };
  double worst = 0;
  int aside = 0;
  for (int k = 0; k < 2000; ++k) {
    const LensArrayErrors errors{.offset = {drawn(0.02), drawn(0.02)},
                                 .rotation = drawn(180),
                                 .pitchError = {drawn(0.1), drawn(0.1)},
                                 .gapError = drawn(0.1),
                                 .wedge = {drawn(0.1), drawn(0.1)},
                                 .focalError = drawn(0.1),
                                 .outside = OutsideField::neighbour};
    const PanelRay ray{{drawn(0.01), drawn(0.01)}, {drawn(0.8), drawn(0.8)}};
    const Hit hit = met(twinOf(errors), rayAlong(ray));
    if (!design.isOnPanel(hit)) continue;
    QVERIFY(design.isInField(hit));
    const Vec2 tile = design.position(std::floor(hit.i) + 0.5, std::floor(hit.j) + 0.5);
    const Vec2 pixel = shownByThinLens(errors, ray);
    worst = std::max({worst, std::abs(tile.x - p * (hit.u / 24 - 0.5) - pixel.x),
                      std::abs(tile.y + p * (hit.v / 24 - 0.5) - pixel.y)});
    aside += std::abs(ray.slopes.x) > T / 2 ? 1 : 0;
  }
  QVERIFY2(worst < 1e-15 && aside > 500, text(worst, aside));
}

void TestTwinLaws::offsetMovesPixels_data() {
  QTest::addColumn<int>("right");
  QTest::addColumn<int>("up");
  QTest::newRow("three") << 3 << 0;
  QTest::newRow("left and up") << -5 << 2;
  QTest::newRow("down") << 0 << -7;
}

/// A shift by k pixels, of q = p/du behind the lens, makes u fall by k: the light of a ray comes
/// from the pixel that is k further right.
void TestTwinLaws::offsetMovesPixels() {
  QFETCH(const int, right);
  QFETCH(const int, up);
  const Display design(displayOf());
  const double q = p / 24;
  const Twin twin = twinOf({.offset = {right * q, up * q}});
  constexpr int rays = 5000;
  double worst = 0;
  int common = 0;
  for (int k = 0; k < rays; ++k) {
    const Ray ray = rayAlong(evenRay(k));
    Hit law = met(design, ray);
    law.u -= right;
    law.v += up;
    const Hit hit = met(twin, ray);
    if (!isSameHogel(hit, law)) continue;
    ++common;
    worst = std::max(worst, between(hit, law));
  }
  QVERIFY2(worst < 1e-12, text(worst, 0));
  const double share = (1 - std::abs(right) / 24.0) * (1 - std::abs(up) / 24.0);
  QVERIFY2(std::abs(common / double(rays) - share) < 0.01, text(common / double(rays), share));
}

/// A lens of its own that is aside moves pixels as the sheet does; one that is tilted sends all of
/// its light into slopes that are larger by the tilt.
void TestTwinLaws::hogelsShiftAndTilt() {
  const auto everywhere = [](double value) { return TwinPlane{1, 1, {static_cast<float>(value)}}; };
  TwinMaps maps;
  maps.shiftX = everywhere(3 * p / 24);
  maps.shiftY = everywhere(2 * p / 24);
  maps.tiltX = everywhere(0.01);
  maps.tiltY = everywhere(-0.03);
  const Twin twin({}, maps, displayOf());
  const Display design(displayOf());
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto [place, slopes] = evenRay(k);
    const Hit hit = met(twin, rayAlong({place, {slopes.x + 0.01, slopes.y - 0.03}}));
    Hit law = met(design, rayAlong({place, slopes}));
    QVERIFY(isSameHogel(hit, law));
    law.u -= 3;
    law.v += 2;
    worst = std::max(worst, between(hit, law));
  }
  QVERIFY2(worst < 1e-6, text(worst, 0));  // maps are floats
}

void TestTwinLaws::moire_data() {
  QTest::addColumn<double>("error");
  QTest::addColumn<double>("distance");
  QTest::addColumn<int>("pixels");  // in a period: a hogel's or one
  QTest::newRow("lobes, far away") << 0.02 << 1e6 << 24;
  QTest::newRow("lobes") << 0.01 << 2.0 << 24;
  QTest::newRow("pixel grid") << -0.004 << 2.0 << 1;
  QTest::newRow("pixel grid, far away") << 0.0005 << 1e6 << 1;
}

/// An array whose pitch is wrong by e shows an eye at the distance D bands of side lobes p/|e/(1 +
/// e) + g/D| wide, and bands of the pixel grid that are p/du, not p, over the same.
void TestTwinLaws::moire() {
  QFETCH(const double, error);
  QFETCH(const double, distance);
  QFETCH(const int, pixels);
  const PanelParams display = displayOf(800, 1);
  const Twin twin = twinOf({.pitchError = {error, 0}, .outside = OutsideField::neighbour}, display);
  const double measured =
      1 / std::abs(frequencyAlong({1, 0}, 0.75, {0, 0, distance},
                                  [&](const Ray& ray) { return met(twin, ray).u / pixels; }));
  const double law = p * pixels / 24 / std::abs(error / (1 + error) + g / distance);
  QVERIFY2(std::abs(measured / law - 1) < 0.005, text(measured, law));
}

/// Two grids of the pitch q that are turned by θ beat with the period q/(2 sin(θ/2)).
void TestTwinLaws::rotationMoire() {
  for (const double angle : {0.5, -0.2, 1.0}) {
    const Twin twin = twinOf({.rotation = angle});
    const auto along = [&](const Vec2& line) {
      return frequencyAlong(line, 0.058, {0, 0, 1e6},
                            [&](const Ray& ray) { return met(twin, ray).u; });
    };
    const double measured = 1 / std::hypot(along({1, 0}), along({0, 1}));
    const double law = p / 24 / (2 * std::abs(std::sin(radians(angle) / 2)));
    QVERIFY2(std::abs(measured / law - 1) < 0.005, text(measured, law));
  }
}

void TestTwinLaws::gapErrorScalesDepth_data() {
  QTest::addColumn<double>("error");
  QTest::addColumn<double>("depth");
  QTest::newRow("behind") << 0.05 << -0.03;
  QTest::newRow("in front") << -0.04 << 0.018;
  QTest::newRow("far in front") << 0.02 << 0.1;
}

/// Pixels that are (1 + e) times as far behind their lenses show a point of depth z at z(1 + e).
void TestTwinLaws::gapErrorScalesDepth() {
  QFETCH(const double, error);
  QFETCH(const double, depth);
  const Display design(displayOf());
  const Twin twin = twinOf({.gapError = error});
  const Vec2 point{0.007, -0.004};
  double worst = 0;
  int rays = 0;
  for (int j = 0; j < 60; ++j)
    for (int i = 0; i < 80; ++i) {
      const Vec2 place = design.position(i + 0.5, j + 0.5);
      const Vec2 slopes{(point.x - place.x) / depth, (point.y - place.y) / depth};
      const Hit content = met(design, rayAlong({place, slopes}));
      if (!design.isInField(content)) continue;
      const PanelRay shown = twin.rayOf(i, j, content.u, content.v, 1);
      const double z = depth * (1 + error);
      worst = std::max({worst, std::abs(shown.position.x + z * shown.slopes.x - point.x),
                        std::abs(shown.position.y + z * shown.slopes.y - point.y)});
      ++rays;
    }
  QVERIFY2(worst < 1e-15 && rays > 0, text(worst, rays));
}

void TestTwinLaws::focalErrorDefocuses_data() {
  QTest::addColumn<double>("kappa");
  for (const double kappa : {0.0, -0.02, 0.02, -0.045, 0.045}) QTest::addRow("%g", kappa) << kappa;
}

/// With κ = 1/(1 + focal error) − 1, a hogel is (1 − zκ/g) times as wide on the plane of depth z as
/// it is itself, and a direction of the slope step s is s z wide, so that a grating of f periods in
/// a metre keeps sinc(f p (1 − zκ/g)) sinc(f s z) of its contrast.
void TestTwinLaws::focalErrorDefocuses() {
  QFETCH(const double, kappa);
  const PanelParams display = displayOf(80, 60, 96);
  const double frequency = 300;
  const double z = -0.03;
  const double measured =
      contrastOf(twinOf({.focalError = 1 / (1 + kappa) - 1}, display), display, frequency, z);
  const double law = sinc(frequency * p * (1 - z * kappa / g)) * sinc(frequency * z * T / 96);
  QVERIFY2(std::abs(measured - law) < 0.003, text(measured, law));
}

/// A pitch error of −g/D turns the hogels' fields to a point at the distance D, as viewingDistance
/// does for each ray. Their u differ by the place in the hogel, at most p/2: du p/(2 D T).
void TestTwinLaws::pitchErrorConverges() {
  const double distance = 0.6;
  PanelParams converging = displayOf();
  converging.viewingDistance = distance;
  const Display design(converging);
  const Twin twin = twinOf({.pitchError = {-g / distance, -g / distance}});
  double worst = 0;
  for (int k = 0; k < 20000; ++k) {
    const Ray ray = rayAlong(evenRay(k));
    const Hit one = met(twin, ray);
    const Hit other = met(design, ray);
    if (isSameHogel(one, other)) worst = std::max(worst, between(one, other));
  }
  const double law = 24 * p / (2 * distance * T);
  QVERIFY2(worst <= law && worst > 0.98 * law, text(worst, law));
}

void TestTwinLaws::randomShiftLowersContrast_data() {
  QTest::addColumn<double>("sigma");
  for (const double sigma : {5e-6, 10e-6, 20e-6, 40e-6}) QTest::addRow("%g m", sigma) << sigma;
}

/// A lens that is σ aside shows a point of depth z aside by σ z/g. The mean of cos of a normal
/// phase of variance s² is exp(−s²/2), s = 2π f z σ/g.
void TestTwinLaws::randomShiftLowersContrast() {
  QFETCH(const double, sigma);
  const PanelParams display = displayOf();
  const double frequency = 300;
  const double z = -0.012;
  TwinParams params;
  params.random.shift.sigma = sigma;
  const double measured = contrastOf({params, {}, display}, display, frequency, z) /
                          contrastOf({{}, {}, display}, display, frequency, z);
  const double law = std::exp(-2 * std::pow(pi * frequency * z * sigma / g, 2));
  QVERIFY2(std::abs(measured - law) < 0.012, text(measured, law));
}

/// An eye that looks along the slope a through a plane of content at the depth z sees there the
/// points of red and blue z a (χB − χR) apart.
void TestTwinLaws::coloursFringe() {
  const double z = -0.03;
  const Display design(displayOf());
  TwinParams params;
  params.colour.scale = {-0.004, 0, 0.006};
  const Twin twin(params, {}, displayOf());
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    const PanelRay ray = evenRay(k);
    const Hit red = met(twin, rayAlong(ray), 0);
    const Hit blue = met(twin, rayAlong(ray), 2);
    QVERIFY(isSameHogel(red, blue));
    const Vec2 inRed = design.slopes(red.u, red.v);
    const Vec2 inBlue = design.slopes(blue.u, blue.v);
    worst =
        std::max({worst, std::abs(z * (inBlue.x - inRed.x) - z * ray.slopes.x * (0.006 + 0.004)),
                  std::abs(z * (inBlue.y - inRed.y) - z * ray.slopes.y * (0.006 + 0.004))});
  }
  QVERIFY2(worst < 1e-15, text(worst, 0));
}

/// A panel bent to the radius D faces the point at the distance D with all of its hogels, as
/// viewingDistance says.
void TestTwinLaws::bentPanelConverges() {
  const double radius = 0.6;
  PanelParams converging = displayOf();
  converging.viewingDistance = radius;
  const Display design(converging);
  const Twin twin =
      twinOfSurface([&](double x, double y) { return (x * x + y * y) / (2 * radius); });
  double worst = 0;
  for (const Vec3& eye : {Vec3{0, 0, radius}, Vec3{0, 0, 0.4}, Vec3{-0.05, 0.03, 1.2}})
    for (int k = 0; k < 20000; ++k) {
      const Ray ray = rayFrom(eye, evenRay(k).position);
      const Hit bent = met(twin, ray);
      const Hit turned = met(design, ray);
      worst = std::max(worst, between(bent, turned));
    }
  QVERIFY2(worst < 0.015, text(worst, 0.015));
}

/// The surface z = 0.01 x is the display turned about y by atan(0.01), its right to the viewer.
void TestTwinLaws::tiltedSurfaceIsTurnedDisplay() {
  PanelParams turned = displayOf();
  turned.orientation.y = -std::atan(0.01) * 180 / pi;
  const Display design(turned);
  const Twin twin = twinOfSurface([](double x, double) { return 0.01 * x; });
  constexpr int rays = 20000;
  double worst = 0;
  int others = 0;
  for (int k = 0; k < rays; ++k) {
    const Ray ray = rayFrom({0.01, -0.01, 0.6}, evenRay(k).position);
    const Hit tilted = met(twin, ray);
    const auto& toDisplay = design.displayFromWorld();
    const Hit other = met(design, {toDisplay.point(ray.eye), toDisplay.direction(ray.direction)});
    if (isSameHogel(tilted, other))
      worst = std::max(worst, between(tilted, other));
    else
      ++others;
  }
  QVERIFY2(worst < 0.003 && others < 0.003 * rays, text(worst, others / double(rays)));
}

void TestTwinLaws::randomGain() {
  TwinParams params;
  params.random.gain.sigma = 0.03;
  const Twin twin(params, {}, displayOf());
  double sum = 0;
  double squares = 0;
  for (int j = 0; j < 60; ++j)
    for (int i = 0; i < 80; ++i) {
      const Rgb grey = litAlike(twin, {i + 0.5, j + 0.5, 12.5, 12.5}, {0.5, 0.5, 0.5});
      QVERIFY(grey.r == grey.g && grey.g == grey.b);
      sum += grey.g / 0.5 - 1;
      squares += std::pow(grey.g / 0.5 - 1, 2);
    }
  const double rms = std::sqrt(squares / (80 * 60));
  QVERIFY2(std::abs(rms - 0.03) < 0.05 * 0.03, text(rms, 0.03));
  QVERIFY2(std::abs(sum / (80 * 60)) < 0.0015, text(sum / (80 * 60), 0));
}

/// White is 1 and black is `black`, both with the room's light on top: (1 + ambient)/(black +
/// ambient).
void TestTwinLaws::blackAndAmbient() {
  TwinParams params;
  params.light.black = 0.001;
  params.light.ambient = {0.004, 0, 0.02};
  const Twin twin(params, {}, displayOf());
  const Rgb white = litAlike(twin, {40.5, 30.5, 12.5, 12.5});
  const Rgb black = litAlike(twin, {40.5, 30.5, 12.5, 12.5}, {});
  QCOMPARE(white.r / black.r, 1.004 / 0.005);
  QCOMPARE(white.g / black.g, 1000.0);
  QCOMPARE(white.b / black.b, 1.02 / 0.021);
  QCOMPARE(white.r, 1.004);
}

/// Light is cosⁿθ of the angle θ at which its pixel is meant to be seen. If gap and focal length
/// are a tenth too long, the slopes a and b show the pixels of 1.1 a and 1.1 b.
void TestTwinLaws::falloff() {
  for (const double exponent : {1.0, 2.7, 4.0}) {
    TwinParams params;
    params.lensArray.gapError = 0.1;
    params.lensArray.focalError = 0.1;
    params.light.falloff = exponent;
    const Twin twin(params, {}, displayOf());
    for (int k = 0; k < 1000; ++k) {
      const PanelRay ray = evenRay(k);
      const double cosine = normalise({1.1 * ray.slopes.x, 1.1 * ray.slopes.y, 1}).z;
      const double law = std::pow(cosine, exponent);
      const Rgb light = litAlike(twin, met(twin, rayAlong(ray)), {1, 0.5, 0});
      QVERIFY2(std::abs(light.r - law) < 1e-14, text(light.r, law));
      QVERIFY2(std::abs(light.g - 0.5 * law) < 1e-14, text(light.g, 0.5 * law));
      QCOMPARE(light.b, 0.0);
    }
  }
}

/// A pixel lights the share of its width and of its height that its middle has.
void TestTwinLaws::fill() {
  TwinParams params;
  params.light.fill = {0.8, 0.55};
  const Twin twin(params, {}, displayOf());
  constexpr int rays = 50000;
  int lights = 0;
  for (int k = 0; k < rays; ++k)
    lights += litAlike(twin, met(twin, rayAlong(evenRay(k)))).g > 0 ? 1 : 0;
  QVERIFY2(std::abs(lights / double(rays) - 0.8 * 0.55) < 0.003, text(lights / double(rays), 0.44));
  QCOMPARE(litAlike(twin, {1.5, 1.5, 7.89, 7.77}), Rgb({1, 1, 1}));
  QCOMPARE(litAlike(twin, {1.5, 1.5, 7.91, 7.5}), Rgb({0, 0, 0}));
  QCOMPARE(litAlike(twin, {1.5, 1.5, 7.5, 7.78}), Rgb({0, 0, 0}));
}

/// Given and drawn gains of the hogel and the gain of the direction multiply.
void TestTwinLaws::gainsMultiply() {
  const PanelParams display = displayOf();
  TwinParams params;
  params.random.gain = {{.sigma = 0.1, .length = 3}};
  const Twin drawn(params, {}, display);
  Random random(9);
  TwinMaps maps;
  for (auto& gain : maps.gain) gain = randomPlane(random, 80, 60, 0.5, 1.2);
  for (auto& gain : maps.directionGain) gain = randomPlane(random, 24, 24, 0.5, 1.2);
  const Twin twin(params, maps, display);
  for (int k = 0; k < 1000; ++k) {
    const int i = random.integer(0, 79);
    const int j = random.integer(0, 59);
    const int u = random.integer(0, 23);
    const int v = random.integer(0, 23);
    const Hit hit{i + random.uniform(0, 1), j + random.uniform(0, 1), u + 0.5, v + 0.5};
    const Rgb light = litAlike(twin, hit, {0.3, 0.6, 0.9});
    const auto law = [&](std::size_t c, double content) {
      return content * litAlike(drawn, hit).g *
             double(maps.gain[c].values[std::size_t(80 * j + i)]) *
             double(maps.directionGain[c].values[std::size_t(24 * v + u)]);
    };
    QVERIFY2(std::abs(light.r - law(0, 0.3)) < 1e-6, text(light.r, law(0, 0.3)));
    QVERIFY2(std::abs(light.g - law(1, 0.6)) < 1e-6, text(light.g, law(1, 0.6)));
    QVERIFY2(std::abs(light.b - law(2, 0.9)) < 1e-6, text(light.b, law(2, 0.9)));
  }
}

QTEST_GUILESS_MAIN(TestTwinLaws)
#include "test_twin_laws.moc"
