// SPDX-License-Identifier: BSD-3-Clause
// Tests pictures taken through lenslets against a plenoptic camera traced ray by ray, closed forms
// and a real light field microscope.
#include <QTemporaryDir>
#include <QTest>

#include "core/base/random_numbers.h"
#include "io/documents/session_file.h"
#include "io/layouts/layouts.h"
#include "io/opening/opening.h"
#include "io/opening/session_around.h"
#include "io/scene/light_field_export.h"
#include "io/scene/view_source.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"
#include "tests/io/lenslet_camera.h"
#include "tests/io/texels.h"

using namespace hogelscope;

namespace {

constexpr PictureKind grey16{PictureType::UInt16, 1, 0};
constexpr PictureKind greyReal{PictureType::Float, 1, 0};
constexpr double darkLevel = 0.01;

/// `full` of the range, above the dark level, with noise of a hundredth of it.
void writePicture(const QString& file, const LensletCamera& camera, double full, double noise) {
  const std::vector<double> light = camera.picture();
  RandomNumbers random(7);
  writeImageFile(
      file, camera.width, camera.height,
      [&](int x, int y, int) {
        const double value = full * light[camera.indexOf(x, y)];
        return float(std::clamp(darkLevel + value + noise * full * random.normal(), 0.0, 1.0));
      },
      grey16);
}

LightFieldParams lenslets(const char* file, const char* white = "") {
  LightFieldParams params;
  params.file = file;
  params.layout = Layout::lenslets;
  params.lenslets.white = white;
  return params;
}

/// Smooth, so that it can be sampled.
double waves(double x, double y) {
  return 0.5 + 0.2 * std::cos(0.9 * x + 0.3) + 0.2 * std::sin(0.8 * y);
}

/// How far a point lies from the nearest of the camera's lenslets.
double distanceFromImages(const LensletCamera& camera, const PicturePoint& at) {
  double least = 1e30;
  for (int j = -30; j <= 30; ++j)
    for (int n = -30; n <= 30; ++n) {
      const auto [x, y] = camera.image(n, j);
      least = std::min(least, std::hypot(x - at.real(), y - at.imag()));
    }
  return least;
}

const QString guv = HOGELSCOPE_SOURCE_DIR "/../shared/data/napari_LF_GUV/";

}  // namespace

class TestLenslets : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void aCameraIsFound_data();
  void aCameraIsFound();
  void inTheLightFieldItself();
  void someIsGiven();
  void texelsAreTheScene_data();
  void texelsAreTheScene();
  void nearerThingsMoveAgainstTheEye();
  void rowsOfAHexagonalGrid();
  void directionsAreBilinear();
  void beyondALenslet_data();
  void beyondALenslet();
  void blocksAreLargest_data();
  void blocksAreLargest();
  void darkAndWhite();
  void allWaysToReadAreOne();
  void sessionsKeepIt();
  void notByMistake();
  void mistakes_data();
  void mistakes();
  void poorLattices();
  void vesicle();

 private:
  QTemporaryDir m_folder;
};

void TestLenslets::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
}

void TestLenslets::aCameraIsFound_data() {
  QTest::addColumn<bool>("isHexagonal");
  QTest::addColumn<double>("pitch");
  QTest::addColumn<double>("degrees");
  QTest::addColumn<double>("noise");
  QTest::newRow("square") << false << 15.3846 << 0.7 << 0.01;
  QTest::newRow("square, turned back") << false << 11.27 << -2.4 << 0.01;
  QTest::newRow("square, small") << false << 7.9 << 0.0 << 0.02;
  QTest::newRow("hexagonal") << true << 15.3846 << 0.7 << 0.01;
  QTest::newRow("hexagonal, turned back") << true << 14.03 << -1.3 << 0.01;
}

void TestLenslets::aCameraIsFound() {
  QFETCH(bool, isHexagonal);
  QFETCH(double, pitch);
  QFETCH(double, degrees);
  QFETCH(double, noise);
  LensletCamera camera;
  camera.isHexagonal = isHexagonal;
  camera.pitch = pitch;
  camera.degrees = degrees;
  writePicture("white.tif", camera, 0.8, noise);
  LightFieldParams params = lenslets("white.tif", "white.tif");
  if (isHexagonal) params.lenslets.grid = LensletGrid::hexagonal;
  const FoundLenslets found = lensletsOf(params, {});
  const QByteArray figures = QString("pitch %1, rotation %2, residual %3")
                                 .arg(found.lattice.pitch() - camera.pitch, 0, 'g', 3)
                                 .arg(found.lattice.rotation() - camera.degrees, 0, 'g', 3)
                                 .arg(found.residual, 0, 'g', 3)
                                 .toUtf8();
  qInfo("off by: %s", figures.constData());
  QVERIFY2(std::abs(found.lattice.pitch() - camera.pitch) < 1e-3, figures);
  QVERIFY2(std::abs(found.lattice.rotation() - camera.degrees) < 0.01, figures);
  QVERIFY2(found.residual > 0 && found.residual < 0.1, figures);
  QCOMPARE(warningOf(params, found), std::string());
  const LightFieldSize size = openLightField(params, {})->size();
  QCOMPARE(size.du, int(camera.pitch));
  const double height = (camera.height - camera.pitch) / found.lattice.rowDistance();
  QVERIFY(size.nx >= int((camera.width - camera.pitch) / camera.pitch) - 1);
  QVERIFY(size.ny >= int(height / camera.pitch) - 1);
  for (int j = 0; j < size.ny; ++j)
    QVERIFY(distanceFromImages(camera, found.lattice.middle(j % 3, j)) < 0.05);
  // Opened without a session it is recognised, as a guess.
  const OrderedSession around = orderedSessionAround("white.tif");
  QCOMPARE(around.session.lightField.layout, Layout::lenslets);
  QCOMPARE(around.session.lightField.lenslets.grid, params.lenslets.grid);
  QCOMPARE(around.hogels, Sureness::likely);
  const char* const grid = isHexagonal ? "hexagonal" : "square";
  QVERIFY2(around.assumed.starts_with(std::string("lenslets on a ") + grid + " grid of pitch "),
           around.assumed.c_str());
}

/// Without a white picture, if the scene has some light everywhere.
void TestLenslets::inTheLightFieldItself() {
  LensletCamera camera;
  camera.farLight = waves;
  writePicture("own.tif", camera, 0.8, 0.01);
  const FoundLenslets found = lensletsOf(lenslets("own.tif"), {});
  QVERIFY(std::abs(found.lattice.pitch() - camera.pitch) < 0.01);
  QVERIFY(distanceFromImages(camera, found.lattice.origin) < 0.2);
  QCOMPARE(sessionAround("own.tif").lightField.layout, Layout::lenslets);
}

/// What is given stays, and what is not given is found around it.
void TestLenslets::someIsGiven() {
  const LensletCamera camera;
  writePicture("white.tif", camera, 0.8, 0.01);
  LightFieldParams params = lenslets("white.tif", "white.tif");
  const FoundLenslets all = lensletsOf(params, {});
  params.lenslets.pitch = 15.4;
  FoundLenslets found = lensletsOf(params, {});
  QVERIFY(std::abs(found.lattice.pitch() - 15.4) < 1e-12);
  QVERIFY(std::abs(found.lattice.rotation() - 0.7) < 0.01);
  QVERIFY(found.residual > all.residual);
  params.lenslets.pitch = notGiven;
  params.lenslets.rotation = 0.8;
  found = lensletsOf(params, {});
  QVERIFY(std::abs(found.lattice.rotation() - 0.8) < 1e-12);
  QVERIFY(std::abs(found.lattice.pitch() - camera.pitch) < 2e-3);
  params.lenslets.rotation = notGiven;
  const auto [x, y] = camera.image(-3, -2);
  params.lenslets.origin = {x + 0.1, y};
  found = lensletsOf(params, {});
  QCOMPARE(found.lattice.origin, PicturePoint(x + 0.1, y));
  // A tenth too far to the right on the left: the others are nearer to it.
  QVERIFY(found.lattice.pitch() < camera.pitch - 2e-3);
  QVERIFY(found.lattice.pitch() > camera.pitch - 0.02);
  params.lenslets.origin = {x + 7.7, y};
  QVERIFY(errorOf([&] { (void)lensletsOf(params, {}); }).contains("lenslets: are not found"));
  params.lenslets.origin = {x + 0.1, y};
  params.lenslets.pitch = 15.5;
  params.lenslets.rotation = 0;
  found = lensletsOf(params, {});
  QCOMPARE(found.count, 0);
  QVERIFY(std::abs(found.lattice.middle(2, 1) - PicturePoint(x + 31.1, y + 15.5)) < 1e-9);
}

void TestLenslets::texelsAreTheScene_data() {
  QTest::addColumn<bool>("isHexagonal");
  QTest::addColumn<int>("directions");
  QTest::newRow("square, odd") << false << 15;
  QTest::newRow("square, even") << false << 12;
  QTest::newRow("hexagonal, odd") << true << 13;
}

/// Texels are what the camera's rays see: without vignetting, with the dark frame subtracted.
void TestLenslets::texelsAreTheScene() {
  QFETCH(bool, isHexagonal);
  QFETCH(int, directions);
  LensletCamera camera;
  camera.isHexagonal = isHexagonal;
  writePicture("white.tif", camera, 0.8, 0.001);
  const LensletCamera white = camera;
  camera.farLight = waves;
  writePicture("scene.tif", camera, 0.8, 0.001);
  writeImageFile(
      "dark.tif", camera.width, camera.height, [](int, int, int) { return float(darkLevel); },
      grey16);
  LightFieldParams params = lenslets("scene.tif", "white.tif");
  params.lenslets.dark = "dark.tif";
  if (isHexagonal) params.lenslets.grid = LensletGrid::hexagonal;
  PanelParams display;
  display.directions = {directions, directions};
  const auto file = openLightField(params, display);
  const LightField lightField = file->read({});
  const LensletLattice lattice = lensletsOf(params, display).lattice;
  const double side = isHexagonal ? std::sqrt(0.75) : 1;
  const double angle = 0.7 * std::numbers::pi / 180;
  double worst = 0;
  int lit = 0;
  const auto [nx, ny, du, dv] = lightField.size();
  QCOMPARE(du, directions);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      for (int v = 0; v < dv; ++v)
        for (int u = 0; u < du; ++u) {
          const Rgb texel = lightField.texel({i, j, u, v});
          QVERIFY(texel.r == texel.g && texel.g == texel.b);
          const double radius = std::hypot(u - (du - 1) / 2.0, v - (dv - 1) / 2.0);
          if (radius > 0.5 * camera.pitch) QCOMPARE(texel.r, 0.0);
          if (radius > 0.47 * camera.pitch - 1) continue;
          // The middle of the hogel, and of the direction under it.
          const double across = i * side * lattice.pitch();
          const double down = j * side * lattice.pitch();
          const LensletCamera::Point at{
              lattice.origin.real() + across * std::cos(angle) - down * std::sin(angle),
              lattice.origin.imag() + across * std::sin(angle) + down * std::cos(angle)};
          const double offsetX = u - (du - 1) / 2.0;
          const double offsetY = v - (dv - 1) / 2.0;
          const LensletCamera::Point under{
              at.x + offsetX * std::cos(angle) - offsetY * std::sin(angle),
              at.y + offsetX * std::sin(angle) + offsetY * std::cos(angle)};
          const double expected = 0.8 * camera.light(under, at) / white.light(under, at);
          worst = std::max(worst, std::abs(texel.r / 255 - expected));
          ++lit;
        }
  qInfo("%d texels, at most %.4f of full scale off", lit, worst);
  QVERIFY(lit > nx * ny * directions * directions / 2);
  QVERIFY(worst < (isHexagonal ? 0.03 : 0.006));
}

/// The edge of a near thing in the middle: an eye on the right sees it farther to the left, so u
/// grows for light that leaves to the right, and v for light that leaves downwards.
void TestLenslets::nearerThingsMoveAgainstTheEye() {
  LensletCamera camera;
  writePicture("white.tif", camera, 0.8, 0);
  camera.isHidden = [](double x, double y) { return std::abs(x) < 2.5 && std::abs(y) < 2.5; };
  writePicture("scene.tif", camera, 0.8, 0);
  LightFieldParams params = lenslets("scene.tif", "white.tif");
  const auto middleOfThing = [&](int u, int v) {
    const LightField lightField = openLightField(params, {})->read({});
    double sum = 0;
    double x = 0;
    double y = 0;
    for (int j = 0; j < lightField.size().ny; ++j)
      for (int i = 0; i < lightField.size().nx; ++i) {
        const double hidden = std::max(0.0, 1 - lightField.texel({i, j, u, v}).r / 204);
        sum += hidden;
        x += hidden * i;
        y += hidden * j;
      }
    return std::array{x / sum, y / sum};
  };
  QVERIFY(middleOfThing(12, 7)[0] < middleOfThing(2, 7)[0] - 1);
  QVERIFY(std::abs(middleOfThing(12, 7)[1] - middleOfThing(2, 7)[1]) < 0.2);
  QVERIFY(middleOfThing(7, 12)[1] < middleOfThing(7, 2)[1] - 1);
  params.incoming = true;
  QVERIFY(middleOfThing(12, 7)[0] > middleOfThing(2, 7)[0] + 1);
  QVERIFY(middleOfThing(7, 12)[1] > middleOfThing(7, 2)[1] + 1);
}

/// Light that grows along the rows of lenslets grows so along the hogels, in every row.
void TestLenslets::rowsOfAHexagonalGrid() {
  constexpr double pitch = 16;
  const double row = pitch * std::sqrt(3.0) / 2;
  const auto valueUnder = [&](int x, int y, int) {
    const int j = int(std::lround((y - 20) / row));
    const double shift = j % 2 == 0 ? 0 : pitch / 2;
    const double n = std::floor((x - 20 - shift) / pitch + 0.5);
    return float((n * pitch + shift) / 1000 + 0.1);
  };
  writeImageFile("linear.exr", 200, 150, valueUnder, greyReal);
  LightFieldParams params = lenslets("linear.exr");
  params.lenslets.grid = LensletGrid::hexagonal;
  params.lenslets.pitch = pitch;
  params.lenslets.rotation = 0;
  params.lenslets.origin = {36, 20};
  PanelParams display;
  display.directions = {7, 7};
  const LightField lightField = openLightField(params, display)->read({});
  QCOMPARE(lightField.type(), StoredType::real);
  QVERIFY(lightField.size().nx >= 10 && lightField.size().ny >= 8);
  const auto expected = [&](const TexelIndex& at) {
    const double value = 255 * ((pitch + at.i * row) / 1000 + 0.1);
    return Rgb{value, value, value};
  };
  QCOMPARE(firstWrong(lightField, expected, 1e-4), QString());
}

/// A plane of light is sampled where the lattice says.
void TestLenslets::directionsAreBilinear() {
  const auto plane = [](double x, double y, int c) {
    return float(0.1 + (x + 2 * y + 3 * c) / 1000);
  };
  writeImageFile("plane.exr", 120, 90, [&](int x, int y, int c) { return plane(x, y, c); },
                 {PictureType::Float, 3, 0});
  LightFieldParams params = lenslets("plane.exr");
  params.lenslets.pitch = 10.3;
  params.lenslets.rotation = 20;
  params.lenslets.origin = {40.25, 12.5};
  params.lenslets.gain = 2;
  PanelParams display;
  display.hogels = {4, 3};
  display.directions = {10, 7};
  const LightField lightField = openLightField(params, display)->read({});
  const double angle = 20 * std::numbers::pi / 180;
  const auto expected = [&](const TexelIndex& at) {
    const double across = 10.3 * at.i + at.u - 4.5;
    const double down = 10.3 * at.j + at.v - 3;
    const double x = 40.25 + across * std::cos(angle) - down * std::sin(angle);
    const double y = 12.5 + across * std::sin(angle) + down * std::cos(angle);
    return Rgb{510.0 * plane(x, y, 0), 510.0 * plane(x, y, 1), 510.0 * plane(x, y, 2)};
  };
  QCOMPARE(firstWrong(lightField, expected, 1e-3), QString());
  params.incoming = true;
  const LightField flipped = openLightField(params, display)->read({});
  const auto fromBehind = [&](const TexelIndex& at) {
    return expected({at.i, at.j, 9 - at.u, 6 - at.v});
  };
  QCOMPARE(firstWrong(flipped, fromBehind, 1e-3), QString());
}

void TestLenslets::beyondALenslet_data() {
  QTest::addColumn<bool>("isHexagonal");
  QTest::newRow("square") << false;
  QTest::newRow("hexagonal") << true;
}

/// Without a white picture too, what is nearer to another lenslet is black.
void TestLenslets::beyondALenslet() {
  QFETCH(bool, isHexagonal);
  writeGrey("grey.png", 120, 90);
  LightFieldParams params = lenslets("grey.png");
  params.lenslets.grid = isHexagonal ? LensletGrid::hexagonal : LensletGrid::square;
  params.lenslets.pitch = 10.3;
  params.lenslets.rotation = 12;
  params.lenslets.origin = {40, 30};
  PanelParams display;
  display.directions = {14, 13};
  const LightField lightField = openLightField(params, display)->read({});
  LensletCamera camera;
  camera.pitch = 10.3;
  camera.degrees = 12;
  camera.isHexagonal = isHexagonal;
  const auto [x0, y0] = camera.image(0, 0);
  const double angle = 12 * std::numbers::pi / 180;
  int black = 0;
  for (int v = 0; v < 13; ++v)
    for (int u = 0; u < 14; ++u) {
      const double across = u - 6.5;
      const double down = v - 6.0;
      const PicturePoint at(x0 + across * std::cos(angle) - down * std::sin(angle),
                            y0 + across * std::sin(angle) + down * std::cos(angle));
      const bool isOwn = std::hypot(across, down) < distanceFromImages(camera, at) + 1e-9;
      QCOMPARE(lightField.texel({1, 1, u, v}).r, isOwn ? 128.0 : 0.0);
      black += isOwn ? 0 : 1;
    }
  QVERIFY(black > 70);
}

void TestLenslets::blocksAreLargest_data() {
  QTest::addColumn<bool>("isHexagonal");
  QTest::newRow("square") << false;
  QTest::newRow("hexagonal") << true;
}

/// Against a search over all lenslets for the first one; with all directions in the picture.
void TestLenslets::blocksAreLargest() {
  QFETCH(bool, isHexagonal);
  RandomNumbers random(11);
  for (int trial = 0; trial < 40; ++trial) {
    const double pitch = 5 + 4 * random.unit();
    const double angle = 0.2 * random.unit() - 0.1;
    const LensletLattice lattice{isHexagonal ? LensletGrid::hexagonal : LensletGrid::square,
                                 {60 * random.unit(), 50 * random.unit()},
                                 std::polar(pitch, angle)};
    const LensletArea area{60, 50, int(pitch), int(pitch)};
    const HogelBlock found = largestBlock(lattice, area);
    int most = 0;
    for (int j = -15; j <= 15; ++j)
      for (int n = -30; n <= 30; ++n) {
        LensletLattice from = lattice;
        from.origin = lattice.middle(n, j);
        const HogelBlock block = blockFromOrigin(from, area);
        most = std::max(most, block.nx * block.ny);
      }
    QVERIFY(found.nx > 3 && found.ny > 3);
    if (isHexagonal)
      QVERIFY(found.nx * found.ny > 0.85 * most);
    else
      QCOMPARE(found.nx * found.ny, most);
    const double reach = (area.du - 1) / 2.0 * std::numbers::sqrt2;
    for (const int i : {0, found.nx - 1})
      for (const int j : {0, found.ny - 1})
        for (const int corner : {0, 1, 2, 3}) {
          const PicturePoint at = found.lattice.middle(found.lattice.lensletOfHogel(i, j), j) +
                                  std::polar(reach, angle + (corner + 0.5) * std::numbers::pi / 2);
          QVERIFY(at.real() > -0.51 && at.real() < 59.51);
          QVERIFY(at.imag() > -0.51 && at.imag() < 49.51);
        }
  }
}

/// (light − dark) / max((white − dark) / its mean over the middles, 0.2), in 16 bits; what the
/// white picture has too little light for in the mean is black.
void TestLenslets::darkAndWhite() {
  const auto white = [](int x, int y, int) {
    if (x < 5) return 0.05F;  // the first lenslet has little light
    const int u = x % 5;
    const int v = y % 5;
    return u == 0 || v == 0 ? 0.11F : u == 2 && v == 2 ? 0.6F : 0.3F;
  };
  writeImageFile(
      "light.tif", 20, 15, [](int x, int y, int) { return float(x * 15 + y + 30) / 1000; }, grey16);
  writeImageFile("white.exr", 20, 15, white, greyReal);
  writeImageFile(
      "dark.exr", 20, 15, [](int, int, int) { return 0.05F; }, greyReal);
  LightFieldParams params = lenslets("light.tif", "white.exr");
  params.lenslets.dark = "dark.exr";
  params.lenslets.pitch = 5;
  params.lenslets.rotation = 0;
  params.lenslets.origin = {2, 2};
  const LightField lightField = openLightField(params, {})->read({});
  QVERIFY(lightField.size() == (LightFieldSize{4, 3, 5, 5}));
  QCOMPARE(lightField.type(), StoredType::uint16);
  const double mean = 0.55 * 3 / 4;
  const auto expected = [&](const TexelIndex& at) {
    const int x = 5 * at.i + at.u;
    const int y = 5 * at.j + at.v;
    if (at.u == 0 || at.v == 0) return Rgb{};
    const double even = std::max((double(white(x, y, 0)) - 0.05) / mean, 0.2);
    const double light = std::round(double(x * 15 + y + 30) / 1000 * 65535) / 65535;
    const double value = std::clamp((light - 0.05) / even, 0.0, 1.0);
    const double code = std::round(value * 65535) / 257;
    return Rgb{code, code, code};
  };
  QCOMPARE(firstWrong(lightField, expected, 1.01 / 257), QString());
}

void TestLenslets::allWaysToReadAreOne() {
  LensletCamera camera;
  camera.farLight = waves;
  writePicture("scene.tif", camera, 0.8, 0.01);
  LightFieldParams params = lenslets("scene.tif");
  for (const bool incoming : {false, true}) {
    params.incoming = incoming;
    const auto file = openLightField(params, {});
    const LightField lightField = file->read({});
    exportHogels(*file, "hogels.png", {});
    LightFieldParams hogels;
    hogels.file = "hogels.png";
    PanelParams display;
    const auto [nx, ny, du, dv] = file->size();
    display.hogels = {nx, ny};
    display.directions = {du, dv};
    const LightField exported = openLightField(hogels, display)->read({});
    QCOMPARE(firstWrong(exported, [&](const TexelIndex& at) { return lightField.texel(at); }),
             QString());
  }
  QCOMPARE(int(openLightField(lenslets("scene.tif", "scene.tif"), {})->files().size()), 2);
}

void TestLenslets::sessionsKeepIt() {
  writePicture("in/scene.tif", {}, 0.8, 0.01);
  writeFile("in/s.json",
            text({.display = "{}",
                  .lightField = R"({"file": "scene.tif", "layout": "lenslets", "white": "scene.tif",
                                    "grid": "hexagonal", "origin": [1.5, 2]})"}));
  const Session session = loadSession("in/s.json");
  const LensletParams& params = session.lightField.lenslets;
  QCOMPARE(params.white, std::string("in/scene.tif"));
  QCOMPARE(params.dark, std::string());
  QCOMPARE(params.pitch, notGiven);
  QVERIFY(params.grid == LensletGrid::hexagonal && params.isOriginGiven());
  saveSession("copy.json", session);
  QVERIFY(contentOf("copy.json").contains("\"white\": \"in/scene.tif\""));
  QVERIFY(!contentOf("copy.json").contains("\"pitch\""));
  QVERIFY(loadSession("copy.json").lightField == session.lightField);
  const Session around = sessionAround("in/scene.tif", {"lightField.layout=lenslets"});
  QCOMPARE(around.lightField.layout, Layout::lenslets);
  QVERIFY(around.display.size[0] > around.display.size[1]);
}

void TestLenslets::notByMistake() {
  writePicture("scene.tif", {}, 0.8, 0.01);
  QCOMPARE(lightFieldOf("scene.tif").layout, Layout::hogels);
  writePicture("folder/scene.tif", {}, 0.8, 0.01);
  QCOMPARE(lightFieldOf("folder").layout, Layout::views);
  // Regular, but no spots with gaps: squares that touch, stripes, faint waves, gaps with less light
  // only between few. Spots too few to be a grid, and spots that lie anywhere.
  const auto spot = [](double x, double y) { return std::exp(-(x * x + y * y) / 20); };
  const std::vector<std::function<double(int, int)>> pictures{
      [](int x, int y) { return (x / 13 + y / 13) % 2 == 0 ? 0.9 : 0.1; },
      [](int x, int) { return x % 17 < 9 ? 0.9 : 0.1; },
      [](int x, int y) { return 0.5 + 0.04 * std::cos(0.4 * x) + 0.04 * std::cos(0.4 * y); },
      [&](int x, int y) {
        const double faint = (x / 15 + y / 15) % 3 == 0 ? 0.8 : -0.3;
        return 0.4 + 0.5 * faint * spot(x % 15 - 7, y % 15 - 7);
      },
      [&](int x, int y) { return spot(x % 50 - 25, y % 50 - 25); },
      [&](int x, int y) {
        const int n = x / 15, j = y / 15;
        return spot(x % 15 - 3 - (n * 7 + j * 5) % 9, y % 15 - 3 - (n * 5 + j * 11) % 9);
      }};
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    writeImageFile(
        "no.tif", 251, 223, [&](int x, int y, int) { return float(pictures[k](x, y)); }, grey16);
    QVERIFY2(sessionAround("no.tif").lightField.layout != Layout::lenslets,
             qPrintable(QString::number(k)));
  }
}

void TestLenslets::mistakes_data() {
  QTest::addColumn<QString>("fields");
  QTest::addColumn<QString>("error");
  const QString none =
      ": lenslets: are not found: it has no regular square grid of bright spots; give ";
  const QString others = ", grid hexagonal, or pitch, rotation and origin";
  QTest::newRow("white of another size")
      << "white=small.png"
      << "small.png: size: is 1×1 px, but the light field's is 60×50: give a picture of the same "
         "camera, cut alike";
  QTest::newRow("dark of another size")
      << "dark=small.png"
      << "small.png: size: is 1×1 px, but the light field's is 60×50: give a picture of the same "
         "camera, cut alike";
  QTest::newRow("all black") << "white=black.png"
                             << "black.png" + none + "another lightField.white" + others;
  QTest::newRow("all equal") << "file=equal.png"
                             << "equal.png" + none + "lightField.white" + others;
  QTest::newRow("noise") << "file=noise.png"
                         << "noise.png" + none + "lightField.white" + others;
  QTest::newRow("one pixel") << "file=small.png"
                             << "small.png" + none + "lightField.white" + others;
  QTest::newRow("black, but all is given")
      << "white=black.png pitch=9 rotation=0 origin=[10,10]"
      << "black.png: lenslets: are black in their middles: give another white picture, pitch or "
         "origin";
  QTest::newRow("too large")
      << "pitch=500 rotation=0 origin=[30,20]"
      << "equal.png: lenslets: are not in the picture: none of pitch 500.0000 px "
         "is whole in 60×50 px; give another lightField.pitch or origin";
  QTest::newRow("outside")
      << "pitch=9 rotation=0 origin=[300,20]"
      << "equal.png: lenslets: are not in the picture: none of pitch 9.0000 px is "
         "whole in 60×50 px; give another lightField.pitch or origin";
  QTest::newRow("too few") << "pitch=10 rotation=0 origin=[10,10] hogels=[9,9]"
                           << "equal.png: display.hogels: is 9×9, but only 5×4 whole lenslets are "
                              "in the picture: give no more, or none";
  QTest::newRow("too many directions")
      << "pitch=10 rotation=0 origin=[10,10] directions=[21,5]"
      << "equal.png: display.directions: is 21×5, but the lenslets' pitch is 10.0000 px: give no "
         "more than that, or none";
  QTest::newRow("not numbers") << "white=nan.exr"
                               << "nan.exr: ";
  QTest::newRow("missing") << "white=none.png"
                           << "none.png: ";
  QTest::newRow("colour and grey") << "white=colour.png pitch=9 rotation=0 origin=[10,10]"
                                   << "";
}

void TestLenslets::mistakes() {
  writeImageFile("small.png", 1, 1, [](int, int, int) { return 0.5F; });
  writeImageFile("equal.png", 60, 50, [](int, int, int) { return 0.5F; },
                 {PictureType::UInt8, 1, 0});
  writeImageFile("black.png", 60, 50, [](int, int, int) { return 0.0F; });
  writeImageFile("colour.png", 60, 50, [](int, int, int c) { return 0.2F * float(1 + c); });
  RandomNumbers random(3);
  writeImageFile("noise.png", 60, 50, [&](int, int, int) { return float(random.unit()); },
                 {PictureType::UInt8, 1, 0});
  writeImageFile(
      "nan.exr", 60, 50, [](int x, int, int) { return x == 7 ? std::nanf("") : 0.5F; }, greyReal);
  QFETCH(QString, fields);
  QFETCH(QString, error);
  std::vector<std::string> overrides{"lightField.layout=lenslets"};
  for (const QString& field : fields.split(' '))
    overrides.push_back(
        ((field.startsWith("hogels") || field.startsWith("directions") ? "display."
                                                                       : "lightField.") +
         field)
            .toStdString());
  writeFile("s.json", text({.display = "{}", .lightField = R"({"file": "equal.png"})"}));
  const QString caught = errorOf([&] {
    const Session session = loadSession("s.json", overrides);
    const LightField lightField = openLightField(session.lightField, session.display)->read({});
  });
  if (error.endsWith(": "))
    QVERIFY2(caught.startsWith(error) && !caught.contains('\n'), qPrintable(caught));
  else
    QCOMPARE(caught, error);
}

/// A camera whose lenslets lie a pixel off, here and there.
void TestLenslets::poorLattices() {
  LightFieldParams params = lenslets("scene.tif", "white.tif");
  FoundLenslets found{{LensletGrid::square, 0, 15}, 100, 0.49};
  QCOMPARE(warningOf(params, found), std::string());
  found.residual = 0.72;
  QCOMPARE(QString::fromStdString(warningOf(params, found)),
           "white.tif: lenslets lie 0.72 px (rms) off a regular grid: give another "
           "lightField.grid, pitch or white, or take the lens's distortion out");
  found.residual = 0.1;
  found.lattice.step = std::polar(15.0, 0.5);
  QVERIFY(warningOf(params, found).starts_with("white.tif: rows of lenslets are turned by 28.65°"));
}

/// A light field microscope's: its own README says 100 µm of lenslets at 6.5 µm of pixels, 15.38.
void TestLenslets::vesicle() {
  if (!QFileInfo::exists(guv)) QSKIP("no ../shared/data/napari_LF_GUV here");
  const Session session = loadSession(HOGELSCOPE_SOURCE_DIR "/tests/real/vesicle_guv.json");
  LightFieldParams params = session.lightField;
  params.lenslets.gain = 1;
  const FoundLenslets found = lensletsOf(params, {});
  QVERIFY(std::abs(found.lattice.pitch() - 100 / 6.5) < 0.03);
  QVERIFY(found.residual < 0.2);
  const auto file = openLightField(params, {});
  QVERIFY(file->size() == (LightFieldSize{28, 28, 15, 15}));
  // The vesicle's membrane is a ring in the view from ahead: bright 8 hogels from its middle.
  const LightField lightField = file->read({});
  QCOMPARE(lightField.type(), StoredType::uint16);
  const auto lightAt = [&](double radius) {
    double sum = 0;
    for (int k = 0; k < 16; ++k) {
      const double angle = k * std::numbers::pi / 8;
      sum += lightField
                 .texel({int(std::lround(14 + radius * std::cos(angle))),
                         int(std::lround(14 + radius * std::sin(angle))), 7, 7})
                 .r;
    }
    return sum;
  };
  QVERIFY(lightAt(8) > 1.5 * lightAt(3));
  QVERIFY(lightAt(8) > 1.5 * lightAt(12));
  QCOMPARE(lightField.texel({14, 14, 0, 0}).r, 0.0);
  QVERIFY(lightField.texel({14, 14, 7, 0}).r > 0);
  // A transparent vesicle hides nothing, so little tells near from far: no order is sure.
  const LightFieldOrder order = findLightFieldOrder(session.lightField, session.display);
  QVERIFY(order.sureness != Sureness::sure);
  // Both pictures are recognised without a word, the light field's own as a poor grid.
  for (const char* name : {"Lightfield", "Radiometry"}) {
    const QString picture = guv + name + "_GUVExperim1.tif";
    const Opening opening = inspectFile(picture.toStdString(), {}, {});
    QCOMPARE(opening.around.session.lightField.layout, Layout::lenslets);
    QVERIFY(opening.size == (LightFieldSize{28, 28, 15, 15}));
    QCOMPARE(opening.around.hogels, Sureness::likely);
    QVERIFY(previewOf(opening, {}).isStretched == (name[0] == 'L'));
  }
  QCOMPARE(sessionAround((guv + "DarkFrame_GUVExperim1.tif").toStdString()).lightField.layout,
           Layout::hogels);
}

QTEST_GUILESS_MAIN(TestLenslets)
#include "test_lenslets.moc"
