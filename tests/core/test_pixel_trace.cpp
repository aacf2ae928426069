// SPDX-License-Identifier: BSD-3-Clause
// A traced pixel says what the image shows: against the reference image, an independent
// renderer's rays, and counted taps.
#include <QtTest>

#include "core/base/error.h"
#include "core/optics/pixel_inspection.h"
#include "tests/core/random_scene.h"

using namespace hogelscope;

namespace {

bool isNear(double a, double b, double tolerance = 1e-6) {
  return std::abs(a - b) <= tolerance * std::max(1.0, std::abs(b));
}

/// One hogel of 5×3 directions, all grey, and a camera before it.
RenderJob plainView() {
  RenderJob job;
  job.display.hogels = {4, 4};
  job.display.directions = {5, 3};
  job.lightField =
      std::make_shared<const LightField>(LightFieldSize{4, 4, 5, 3}, StoredType::uint8);
  job.state.camera.name = "plain";
  job.state.camera.eye = {0, 0, 1};
  job.state.camera.fov = 60;
  job.state.camera.res = {101, 101};
  return job;
}

}  // namespace

class TestPixelTrace : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void saysWhatThePictureShows() {
    Random random(20261121);
    int seen = 0;
    int others = 0;
    for (int k = 0; k < 150; ++k) {
      RandomScene scene = randomScene(random);
      scene.job.sampling.samplesPerPixel = random.integer(1, 3);
      scene.job.sampling.reconstruction = static_cast<Reconstruction>(random.integer(0, 2));
      const Image image = simulate(scene.job);
      for (int n = 0; n < 20; ++n) {
        const int x = random.integer(0, image.width - 1);
        const int y = random.integer(0, image.height - 1);
        const PixelTrace pixel = pixelTrace(scene.job, x, y);
        const std::size_t at = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
        QCOMPARE(pixel.colour.has_value(), image.seen[at] == 255);
        if (!pixel.colour) continue;
        QCOMPARE(quantised(pixel.colour->r), image.rgb[3 * at]);
        QCOMPARE(quantised(pixel.colour->g), image.rgb[3 * at + 1]);
        QCOMPARE(quantised(pixel.colour->b), image.rgb[3 * at + 2]);
        pixel.end == RayEnd::seen ? ++seen : ++others;
      }
    }
    QVERIFY2(seen > 500, qPrintable(QString::number(seen)));
    QVERIFY(others > 0);  // the middle ray sees nothing, another one of the pixel does
  }

  void theRayIsTheIndependentRenderers() {
    Random random(7);
    int seen = 0;
    int notSeen = 0;
    for (int k = 0; k < 150; ++k) {
      const RandomScene scene = randomScene(random);
      const brute::Simulator simulator(scene.job, scene.content);
      const auto [width, height] = scene.job.state.camera.res;
      for (int n = 0; n < 20; ++n) {
        const int x = random.integer(0, width - 1);
        const int y = random.integer(0, height - 1);
        const brute::Ray ray = simulator.ray(x, y);
        if (ray.meets == brute::Ray::Meets::unclear) continue;
        const PixelTrace pixel = pixelTrace(scene.job, x, y);
        QCOMPARE(pixel.end == RayEnd::seen, ray.meets == brute::Ray::Meets::display);
        if (pixel.end != RayEnd::seen) {
          ++notSeen;
          QCOMPARE(pixel.taps, 0);
          continue;
        }
        ++seen;
        QVERIFY(isNear(pixel.place->i, ray.hit[0]) && isNear(pixel.place->j, ray.hit[1]));
        QVERIFY(isNear(pixel.place->u, ray.hit[2]) && isNear(pixel.place->v, ray.hit[3]));
        checkGeometry(scene.job, pixel);
      }
    }
    QVERIFY(seen > 500 && notSeen > 100);
  }

  void countsTheTapsInsideTheHogel() {
    const LightFieldSize size{1, 1, 6, 4};
    for (const int window : {1, 3, 5, 11}) {
      for (int u = 0; u < size.du; ++u) {
        for (int v = 0; v < size.dv; ++v) {
          int taps = 0;
          for (int y = v - window / 2; y <= v + window / 2; ++y)
            for (int x = u - window / 2; x <= u + window / 2; ++x)
              taps += x >= 0 && x < size.du && y >= 0 && y < size.dv ? 1 : 0;
          PsfParams psf;
          psf.windowSize = window;
          QCOMPARE(tapsAt(psf, size, u, v), taps);
        }
      }
    }
  }

  void saysWhyNothingIsSeen() {
    RenderJob job = plainView();
    QCOMPARE(pixelTrace(job, 50, 50).end, RayEnd::seen);
    QCOMPARE(pixelTrace(job, 50, 50).taps, 1);
    QCOMPARE(pixelTrace(job, 0, 50).end, RayEnd::misses);
    QVERIFY(pixelTrace(job, 0, 50).place.has_value());
    QVERIFY(isNear(pixelTrace(job, 0, 50).target.z, 0, 1e-12));
    job.display.fov = {10, 10};
    QCOMPARE(pixelTrace(job, 30, 50).end, RayEnd::outsideField);
    job.state.camera.lookat = {0, 0, 2};  // away from the panel
    const PixelTrace away = pixelTrace(job, 50, 50);
    QCOMPARE(away.end, RayEnd::misses);
    QVERIFY(!away.place && !away.colour);
    QVERIFY(length(away.target - Vec3{0, 0, 2}) < 1e-9);
    job = plainView();
    job.state.distortion.k1 = -1;  // folds at r = 1/√3, before the corner
    QCOMPARE(pixelTrace(job, 0, 0).end, RayEnd::noRay);
    QVERIFY(!words(RayEnd::noRay).empty() && words(RayEnd::seen) != words(RayEnd::misses));
    job.state.camera.lookat = job.state.camera.eye;
    QVERIFY_EXCEPTION_THROWN((void)pixelTrace(job, 0, 0), InputError);
  }

 private:
  /// Eye, target, position and slopes are one line.
  void checkGeometry(const RenderJob& job, const PixelTrace& pixel) {
    const brute::Matrix turn = brute::transposed(brute::rotation(job.display.orientation));
    const auto inDisplay = [&](const Vec3& p) {
      return brute::times(turn,
                          brute::minus(brute::vector(p), brute::vector(job.display.position)));
    };
    const brute::Vector eye = inDisplay(pixel.eye);
    const brute::Vector target = inDisplay(pixel.target);
    QVERIFY(std::abs(target[2]) < 1e-9);
    QVERIFY(isNear(target[0], pixel.position.x) && isNear(target[1], pixel.position.y));
    QVERIFY(isNear((eye[0] - target[0]) / eye[2], pixel.slopes.x));
    QVERIFY(isNear((eye[1] - target[1]) / eye[2], pixel.slopes.y));
  }
};

QTEST_APPLESS_MAIN(TestPixelTrace)
#include "test_pixel_trace.moc"
