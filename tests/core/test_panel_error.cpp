// SPDX-License-Identifier: BSD-3-Clause
// Tests the error on the panel: its sums against a brute-force loop, its figures and images
// against what was put in.
#include "core/metrics/panel_error.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <thread>

#include "core/base/colour_map.h"
#include "core/metrics/panel_error_figures.h"
#include "tests/core/random_scene.h"
#include "tests/core/sample_view.h"

using namespace hogelscope;

namespace {

using Cells = std::vector<PanelError::Cell>;

LightFieldSize sizeOf(const PanelParams& display) {
  return {display.hogels[0], display.hogels[1], display.directions[0], display.directions[1]};
}

/// Any values, and a mask with holes.
Image noise(Random& random, const CameraParams& camera) {
  Image image(camera.res[0], camera.res[1]);
  for (std::uint8_t& value : image.rgb) value = std::uint8_t(random.integer(0, 255));
  for (std::uint8_t& seen : image.seen) seen = random.integer(0, 4) == 0 ? 0 : 255;
  return image;
}

/// The sums of one view, from the second simulator's rays; where rounding decides, the pixel is
/// taken out of `test`.
struct Expected {
  Cells hogels;
  Cells directions;
  int met = 0;
  Expected(const RandomScene& scene, const Image& reference, Image& test)
      : hogels(std::size_t(scene.content.size.nx) * std::size_t(scene.content.size.ny)),
        directions(std::size_t(scene.content.size.du) * std::size_t(scene.content.size.dv)) {
    const brute::Simulator rays(scene.job, scene.content);
    for (std::size_t at = 0; at < test.pixelCount(); ++at) {
      const brute::Ray ray = rayOf(rays, int(at) % test.width, int(at) / test.width);
      if (ray.meets == brute::Ray::Meets::unclear) test.seen[at] = 0;
      if (ray.meets == brute::Ray::Meets::display && reference.seen[at] && test.seen[at])
        add(scene.content.size, ray.hit, &reference.rgb[3 * at], &test.rgb[3 * at]);
    }
  }
  static brute::Ray rayOf(const brute::Simulator& rays, int x, int y) { return rays.ray(x, y); }
  void add(const LightFieldSize& size, const std::array<double, 4>& hit, const std::uint8_t* a,
           const std::uint8_t* b) {
    const auto [i, j, u, v] = hit;
    ++met;
    const auto hogel = std::size_t(j) * std::size_t(size.nx) + std::size_t(i);
    const auto direction = std::size_t(v) * std::size_t(size.du) + std::size_t(u);
    for (auto* cell : {&hogels[hogel], &directions[direction]}) {
      ++cell->pixels;
      for (int c = 0; c < 3; ++c) cell->squares += std::uint64_t(std::pow(a[c] - b[c], 2));
    }
  }
};

void onThreeThreads(int count, const std::function<void(int, int)>& rows) {
  std::vector<std::thread> threads;
  threads.reserve(3);
  for (int k = 0; k < 3; ++k)
    threads.emplace_back([&rows, count, k] { rows(count * k / 3, count * (k + 1) / 3); });
  for (std::thread& thread : threads) thread.join();
}

PanelParams displayOf(std::array<int, 2> hogels, std::array<int, 2> directions) {
  PanelParams display;
  display.hogels = hogels;
  display.directions = directions;
  return display;
}

/// One cell in which each squared difference is `square`, per channel.
PanelError::Cell cell(std::uint64_t square, std::uint64_t pixels) {
  return {3 * square * pixels, pixels};
}

std::array<std::uint8_t, 3> colourAt(const Image& image, int x, int y) {
  const std::size_t at = 3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

}  // namespace

class TestPanelError : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sumsAreThoseOfALoop();
  void orderAndThreadsDoNotMatter();
  void samplesAndMethodsDoNotMatter();
  void keptSumsGoOn();
  void anEyeBehindThePanel();
  void badSizes();
  void figures();
  void directionsAreThoseOfTheLens();
  void noError();
  void deepImages();
  void outliersDoNotHideTheRest();
  void planes();
  void pictures();
  void shapes_data();
  void shapes();
};

void TestPanelError::sumsAreThoseOfALoop() {
  int met = 0;
  int distorted = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const RandomScene scene = randomScene(random);
    const CameraParams& camera = scene.job.state.camera;
    const Image reference = noise(random, camera);
    Image test = noise(random, camera);
    const Expected expected(scene, reference, test);
    LensTables tables;
    PanelError error(scene.content.size);
    error.add(scene.job, tables, serialRows, reference, test);
    QVERIFY2(error.hogels() == expected.hogels, qPrintable(QString("hogels, seed %1").arg(seed)));
    QVERIFY2(error.directions() == expected.directions,
             qPrintable(QString("directions, seed %1").arg(seed)));
    met += expected.met;
    if (!Distortion(scene.job.state.distortion).isIdentity()) ++distorted;
  }
  QVERIFY(met > 10000 && distorted > 100);
}

/// Three states of one display, forwards on one thread and backwards on three.
void TestPanelError::orderAndThreadsDoNotMatter() {
  Random random(5);
  RandomScene scene = randomScene(random);
  scene.job.display.fov = {120, 120};
  std::vector<RenderJob> views;
  std::vector<Image> pictures;
  for (int k = 0; k < 3; ++k) {
    scene.job.state.camera = randomCamera(random, scene.job.display);
    views.push_back(scene.job);
    pictures.push_back(noise(random, scene.job.state.camera));
    pictures.push_back(noise(random, scene.job.state.camera));
  }
  LensTables tables;
  PanelError forwards(scene.content.size);
  PanelError backwards(scene.content.size);
  for (std::size_t k = 0; k < 3; ++k) {
    forwards.add(views[k], tables, serialRows, pictures[2 * k], pictures[2 * k + 1]);
    const std::size_t last = 2 - k;
    backwards.add(views[last], tables, onThreeThreads, pictures[2 * last], pictures[2 * last + 1]);
  }
  QVERIFY(forwards.hogels() != PanelError(scene.content.size).hogels());
  QVERIFY(forwards.hogels() == backwards.hogels());
  QVERIFY(forwards.directions() == backwards.directions());
}

/// A pixel counts where its centre falls, whatever the image was made of.
void TestPanelError::samplesAndMethodsDoNotMatter() {
  Random random(9);
  RandomScene scene = randomScene(random);
  scene.job.state.distortion = {0.2, 0.1, 0.01, -0.01, 0.05};
  const Image reference = noise(random, scene.job.state.camera);
  const Image test = noise(random, scene.job.state.camera);
  LensTables tables;
  PanelError plain(scene.content.size);
  plain.add(scene.job, tables, serialRows, reference, test);
  scene.job.sampling.samplesPerPixel = 2;
  scene.job.sampling.reconstruction = Reconstruction::quadrilinear;
  scene.job.state.psf = {2, 9};
  scene.job.state.pupil = {scene.job.display.size[0] / 2, 1, 5};
  scene.job.method.lens = LensInverse::table;
  scene.job.method.lensSteps = 8;
  PanelError other(scene.content.size);
  other.add(scene.job, tables, serialRows, reference, test);
  QVERIFY(plain.hogels() == other.hogels() && plain.directions() == other.directions());
}

void TestPanelError::keptSumsGoOn() {
  Random random(3);
  const RandomScene scene = randomScene(random);
  const Image a = noise(random, scene.job.state.camera);
  const Image b = noise(random, scene.job.state.camera);
  LensTables tables;
  PanelError whole(scene.content.size);
  whole.add(scene.job, tables, serialRows, a, b);
  PanelError resumed(scene.content.size, whole.hogels(), whole.directions());
  whole.add(scene.job, tables, serialRows, b, a);
  resumed.add(scene.job, tables, serialRows, b, a);
  QVERIFY(whole.hogels() == resumed.hogels() && whole.directions() == resumed.directions());
}

void TestPanelError::anEyeBehindThePanel() {
  Random random(4);
  RandomScene scene = randomScene(random);
  scene.job.display.position = {};
  scene.job.display.orientation = {};
  scene.job.state.camera.eye = {0, 0, -1};
  scene.job.state.camera.lookat = {0, 0, 0};
  scene.job.state.camera.up = {0, 1, 0};
  const Image a = noise(random, scene.job.state.camera);
  LensTables tables;
  PanelError error(scene.content.size);
  error.add(scene.job, tables, serialRows, a, a);
  QVERIFY(error.hogels() == PanelError(scene.content.size).hogels());
}

void TestPanelError::badSizes() {
  Random random(4);
  const RandomScene scene = randomScene(random);
  const Image good = noise(random, scene.job.state.camera);
  LensTables tables;
  PanelError error(scene.content.size);
  QVERIFY_EXCEPTION_THROWN(error.add(scene.job, tables, serialRows, good, Image(3, 3)),
                           std::invalid_argument);
  LightFieldSize other = scene.content.size;
  ++other.nx;
  PanelError wrong(other);
  QVERIFY_EXCEPTION_THROWN(wrong.add(scene.job, tables, serialRows, good, good),
                           std::invalid_argument);
  QVERIFY_EXCEPTION_THROWN(PanelError(other, error.hogels(), error.directions()),
                           std::invalid_argument);
}

/// Four hogels seen of six: squares 600, 300, 150, 150 (of 1200): one holds half.
void TestPanelError::figures() {
  const PanelParams display = displayOf({3, 2}, {4, 2});
  const Cells hogels{{150, 10}, {300, 100}, {}, {150, 10}, {600, 1}, {}};
  Cells directions(8, {300, 10});
  directions[3] = {301, 10};
  const PanelErrorFigures f = figuresOf(PanelError(sizeOf(display), hogels, directions), display);
  QCOMPARE(f.hogelShare, 0.25);
  QCOMPARE(f.directionShare, 0.5);
  QVERIFY((f.hogel == std::array{1, 1}));
  QCOMPARE(f.hogelScale, 200.0);
  // Direction (3, 0) of 4×2 over ±30°: 3/4 of the way to the right, half of the way up, in slope.
  const double edge = std::tan(30 * brute::degree);
  QVERIFY(std::abs(f.direction.x - std::atan(0.75 * edge) / brute::degree) < 1e-9);
  QVERIFY(std::abs(f.direction.y - std::atan(0.5 * edge) / brute::degree) < 1e-9);
  QCOMPARE(QString::fromStdString(panelErrorText(f)),
           QString("Half of the squared error comes from 25 % of the hogels seen and from 50 % of "
                   "the directions seen; the costliest hogel is (1, 1), the costliest direction "
                   "is 23.4° right, 16.1° up."));
}

void TestPanelError::directionsAreThoseOfTheLens() {
  PanelParams display = displayOf({1, 1}, {4, 2});
  display.lens = HogelLensModel::equiangular;
  display.fov = {80, 40};
  Cells directions(8);
  directions[4] = {1, 1};  // (0, 1)
  const PanelErrorFigures f = figuresOf(PanelError(sizeOf(display), {{1, 1}}, directions), display);
  QVERIFY(std::abs(f.direction.x + 30) < 1e-9);
  QVERIFY(std::abs(f.direction.y + 10) < 1e-9);
  QVERIFY(panelErrorText(f).find("30.0° left, 10.0° down") != std::string::npos);
}

void TestPanelError::noError() {
  const PanelParams display = displayOf({2, 1}, {1, 1});
  const PanelError error(sizeOf(display), {{0, 5}, {}}, {{0, 5}});
  const PanelErrorFigures f = figuresOf(error, display);
  QCOMPARE(f.hogelShare, 0.0);
  QCOMPARE(f.hogelScale, 0.0);
  QCOMPARE(panelErrorText(f), std::string("No pixel seen in both pictures differs."));
  const Image image = hogelErrorImage(error, display);
  QVERIFY(colourAt(image, 0, 0) == falseColour(0));
  QVERIFY(colourAt(image, image.width - 1, 0) == falseColour(std::nan("")));
  QVERIFY(panelErrorText(figuresOf(PanelError(sizeOf(display)), display)) == panelErrorText(f));
}

/// Images of 10 bits that round to the same 8-bit one.
void TestPanelError::deepImages() {
  const RenderJob job = sampleView();
  const auto [width, height] = job.state.camera.res;
  const LightFieldSize size = job.lightField->size();
  Image a(width, height, 10), b(width, height, 10);
  std::fill(a.seen.begin(), a.seen.end(), std::uint8_t{255});
  b.seen = a.seen;
  std::fill(b.deep.begin(), b.deep.end(), std::uint16_t{1});  // 65535/1023 rounded: 64
  LensTables tables;
  PanelError error(size, true);
  error.add(job, tables, serialRows, a, b);
  std::uint64_t pixels = 0;
  for (const PanelError::Cell& one : error.hogels()) {
    QCOMPARE(one.squares, one.pixels * 3 * 64 * 64);
    pixels += one.pixels;
  }
  QVERIFY(pixels > 100);
  const PanelErrorFigures figures = figuresOf(error, job.display);
  QVERIFY(std::abs(figures.hogelScale - std::pow(64 / 257.0, 2)) < 1e-12);
  PanelError rounded(size);
  rounded.add(job, tables, serialRows, a, b);
  QCOMPARE(figuresOf(rounded, job.display).hogelScale, 0.0);
}

void TestPanelError::outliersDoNotHideTheRest() {
  Cells cells;
  for (std::uint64_t k = 1; k <= 200; ++k) cells.push_back(cell(k, 7));
  cells.insert(cells.end(), 500, PanelError::Cell{});
  QCOMPARE(scaleEnd(cells), 198.0);
  cells[199] = cell(60000, 7);
  QCOMPARE(scaleEnd(cells), 198.0);
  // Fewer than one cell in a hundred differ.
  Cells few(1000, cell(0, 1));
  few[3] = cell(9, 1);
  QCOMPARE(scaleEnd(few), 9.0);
  QCOMPARE(scaleEnd({}), 0.0);
}

void TestPanelError::planes() {
  const Cells cells{cell(40, 2), {}, {7, 3}};
  const std::vector<float> means = meanSquares(cells);
  QCOMPARE(means[0], 40.0F);
  QVERIFY(std::isnan(means[1]));
  QCOMPARE(means[2], 7.0F / 9);
  QVERIFY((pixelCounts(cells) == std::vector<float>{2, 0, 3}));
}

/// Row 0 is the top, every cell a block of its colour.
void TestPanelError::pictures() {
  const PanelParams display = displayOf({2, 2}, {2, 2});
  const Cells cells{cell(10, 1), cell(5, 2), {}, cell(0, 3)};
  const Image image = hogelErrorImage(PanelError(sizeOf(display), cells, Cells(4)), display);
  QCOMPARE(image.width, 256);
  QCOMPARE(image.height, 256);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      const bool isRight = x >= 128;
      const double share = y < 128 ? (isRight ? 0.5 : 1) : (isRight ? 0 : std::nan(""));
      QVERIFY(colourAt(image, x, y) == falseColour(share));
    }
}

void TestPanelError::shapes_data() {
  QTest::addColumn<int>("columns");
  QTest::addColumn<int>("rows");
  QTest::addColumn<double>("height");
  QTest::addColumn<QSize>("size");
  QTest::newRow("small") << 16 << 16 << 1.0 << QSize(256, 256);
  QTest::newRow("large") << 300 << 300 << 1.0 << QSize(300, 300);
  QTest::newRow("a quilt's views") << 48 << 1 << 1.0 << QSize(288, 288);
  QTest::newRow("a wide panel") << 32 << 16 << 0.5 << QSize(256, 128);
  QTest::newRow("oblong cells") << 16 << 16 << 0.5 << QSize(256, 128);
  QTest::newRow("one cell") << 1 << 1 << 1.0 << QSize(256, 256);
  QTest::newRow("never huge") << 20000 << 1 << 1.0 << QSize(20000, 512);
}

void TestPanelError::shapes() {
  QFETCH(const int, columns);
  QFETCH(const int, rows);
  QFETCH(const double, height);
  QFETCH(const QSize, size);
  PanelParams display = displayOf({columns, rows}, {1, 1});
  display.size = {1, height};
  const Image image = hogelErrorImage(PanelError(sizeOf(display)), display);
  QCOMPARE(QSize(image.width, image.height), size);
}

QTEST_APPLESS_MAIN(TestPanelError)
#include "test_panel_error.moc"
