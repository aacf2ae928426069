// SPDX-License-Identifier: BSD-3-Clause
// Tests what is said of a pixel against the reference engine: its light is the sum of its taps, a
// hogel's pixels are those whose traces end there.
#include "core/optics/pixel_inspection.h"

#include <QTest>
#include <numeric>

#include "core/engine/hogel_pixels.h"
#include "tests/core/random_scene.h"

using namespace hogelscope;

class TestPixelInspection : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theTapsAddUpToTheLight();
  void fates();
  void aHogelsPixelsAreThoseThatSeeIt();
  void rayEndsAreThoseOfTheTraces();
  void aHogelsImage();
};

void TestPixelInspection::theTapsAddUpToTheLight() {
  Random random(20261123);
  for (int k = 0; k < 200; ++k) {
    RandomScene scene = randomScene(random);
    const LightFieldSource& lightField = *scene.job.lightField;
    const LightFieldSize size = lightField.size();
    PsfParams& psf = scene.job.state.psf;
    psf.border = static_cast<PsfBorder>(k % 3);
    const TexelIndex at{0, size.ny - 1, random.integer(0, size.du - 1),
                        random.integer(0, size.dv - 1)};
    const std::vector<double> weights = psfKernelAt(psf, size, at.u, at.v);
    const int side = psf.windowSize;
    QCOMPARE(weights.size(), std::size_t(side) * std::size_t(side));
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    QVERIFY(psf.border == PsfBorder::black ? sum <= 1 + 1e-12 : std::abs(sum - 1) < 1e-12);
    Rgb light;
    for (int n = 0; n < side * side; ++n) {
      const TexelIndex tap{at.i, at.j, at.u + n % side - side / 2, at.v + n / side - side / 2};
      const double weight = weights[std::size_t(n)];
      const bool isInside = tap.u >= 0 && tap.u < size.du && tap.v >= 0 && tap.v < size.dv;
      if (isInside)
        light = light + weight * decoded(psf.light, lightField.texel(tap));
      else
        QCOMPARE(weight, 0.0);
    }
    const Rgb expected = Psf(psf).leaked(lightField, at);
    QVERIFY(std::abs(light.r - expected.r) < 1e-9 && std::abs(light.b - expected.b) < 1e-9);
  }
}

void TestPixelInspection::fates() {
  PixelTrace trace;
  QVERIFY(fateOf(trace) == PixelFate::noRay);
  for (const RayEnd end : {RayEnd::misses, RayEnd::outsideField}) {
    trace.end = end;
    QVERIFY(fateOf(trace) == PixelFate::outside);
  }
  trace.colour = Rgb{0, 0.4, 0};  // another ray than the middle one sees the display
  QVERIFY(fateOf(trace) == PixelFate::dark);
  trace.colour = Rgb{0, 0.5, 0};
  QVERIFY(fateOf(trace) == PixelFate::lit);
}

void TestPixelInspection::aHogelsPixelsAreThoseThatSeeIt() {
  Random random(5);
  int found = 0;
  for (int k = 0; k < 60; ++k) {
    RandomScene scene = randomScene(random);
    if (k % 2 == 0) scene.job.state.pupil = {scene.job.display.size[0] / 2, 1, 5};
    const LightFieldSize size = scene.job.lightField->size();
    const auto [width, height] = scene.job.state.camera.res;
    std::vector<PixelRun> runs;
    for (int j = 0; j < size.ny; ++j)
      for (int i = 0; i < size.nx; ++i)
        for (const PixelRun& run : pixelsSeeing(scene.job, i, j, serialRows)) {
          for (int x = run.x0; x < run.x1; ++x) {
            const PixelTrace trace = pixelTrace(scene.job, x, run.y);
            QVERIFY(trace.place && std::abs(trace.place->i - (i + 0.5)) < 0.5 + 1e-3 &&
                    std::abs(trace.place->j - (j + 0.5)) < 0.5 + 1e-3);
          }
          runs.push_back(run);
        }
    int count = 0;
    for (const PixelRun& run : runs) count += run.x1 - run.x0;
    int seen = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (pixelTrace(scene.job, x, y).end == RayEnd::seen) ++seen;
    QVERIFY2(std::abs(count - seen) <= 2, qPrintable(QString("%1, %2").arg(count).arg(seen)));
    found += count;
  }
  QVERIFY(found > 1000);
}

/// Of all kinds; also behind the panel, where no ray meets it, and until it is stopped.
void TestPixelInspection::rayEndsAreThoseOfTheTraces() {
  Random random(11);
  std::array<int, 4> counts{};
  for (int k = 0; k < 40; ++k) {
    RandomScene scene = randomScene(random);
    if (k % 4 == 0) scene.job.state.distortion = {.k1 = -1.5};  // folds
    if (k % 8 == 1) scene.job.state.camera.eye.z -= 10;
    const auto [width, height] = scene.job.state.camera.res;
    const std::vector<std::uint8_t> unseen(std::size_t(width) * std::size_t(height), 0);
    const std::vector<RayEnd> ends = rayEnds(scene.job, unseen, parallelRows);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const RayEnd end = ends[std::size_t(y * width + x)];
        QCOMPARE(int(end), int(pixelTrace(scene.job, x, y).end));
        ++counts[std::size_t(end)];
      }
    const std::vector<std::uint8_t> seen(unseen.size(), 255);
    for (const RayEnd end : rayEnds(scene.job, seen, serialRows)) QVERIFY(end == RayEnd::seen);
    QVERIFY_EXCEPTION_THROWN(rayEnds(scene.job, unseen, parallelRows, [](double) { return false; }),
                             Cancelled);
  }
  for (const int count : counts) QVERIFY(count > 100);
}

void TestPixelInspection::aHogelsImage() {
  Random random(6);
  const RandomScene scene = randomScene(random);
  const LightFieldSource& lightField = *scene.job.lightField;
  const LightFieldSize size = lightField.size();
  const Image image = hogelImage(lightField, size.nx - 1, 0);
  QCOMPARE(image.width, size.du);
  QCOMPARE(image.height, size.dv);
  for (int v = 0; v < size.dv; ++v)
    for (int u = 0; u < size.du; ++u) {
      const Rgb texel = lightField.texel({size.nx - 1, 0, u, v});
      QCOMPARE(image.rgb[3 * std::size_t(v * size.du + u)], quantised(texel.r));
    }
}

QTEST_MAIN(TestPixelInspection)
#include "test_pixel_inspection.moc"
