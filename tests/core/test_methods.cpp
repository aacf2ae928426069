// SPDX-License-Identifier: BSD-3-Clause
// What each approximation of the fast engine does: against OpenCV where it has the same, against
// the exact way elsewhere.
#include <QTest>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/engine/fast_simulation.h"
#include "core/engine/scaled_view.h"
#include "tests/core/random_scene.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

constexpr int width = 61;
constexpr int height = 47;

LensKey keyOf(const DistortionParams& lens, LensInverse inverse, int steps) {
  CameraState state;
  state.camera.res = {width, height};
  state.distortion = lens;
  return lensKeyOf(state, {}, {.lens = inverse, .lensSteps = steps});
}

std::vector<Vec2> raysOf(const LensKey& key) {
  const LensRays rays(key);
  std::array<double, width> x{};
  std::array<double, width> y{};
  std::vector<Vec2> all;
  for (int row = 0; row < height; ++row) {
    rays.row(row, {}, 0, width, x.data(), y.data());
    for (std::size_t k = 0; k < width; ++k) all.push_back({x[k], y[k]});
  }
  return all;
}

/// Largest distance between rays, in pixels.
double worstDistance(const LensKey& key, const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    worst = std::max(worst, key.focalLength.x * std::hypot(a[k].x - b[k].x, a[k].y - b[k].y));
  return worst;
}

std::vector<Vec2> raysOfOpenCv(const LensKey& key, int iterations) {
  const cv::Mat camera = (cv::Mat_<double>(3, 3) << key.focalLength.x, 0, key.centre.x, 0,
                          key.focalLength.y, key.centre.y, 0, 0, 1);
  std::vector<cv::Point2d> points;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) points.emplace_back(x, y);
  std::vector<cv::Point2d> ideal;
  cv::undistortPoints(points, ideal, camera, vectorOf(key.distortion), cv::noArray(), cv::noArray(),
                      {cv::TermCriteria::COUNT, iterations, 0});
  std::vector<Vec2> rays;
  for (const cv::Point2d& p : ideal) rays.push_back({p.x, p.y});
  return rays;
}

const DistortionParams barrel{-0.2663726090966068, -0.03858889892230465, 0.0017831947042852964,
                              -0.0002812210044111547, 0.23839153080878486};
const DistortionParams figure3{0.6, 0.3, 0.2, 0.01, 0.2};

FloatImage toFloat(const Image& image) {
  FloatImage result(image.width, image.height);
  result.rgb.assign(image.rgb.begin(), image.rgb.end());
  result.seen = image.seen;
  return result;
}

double rmse(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.rgb.size(); ++k) sum += std::pow(a.rgb[k] - b.rgb[k], 2);
  return std::sqrt(sum / double(a.rgb.size()));
}

}  // namespace

class TestMethods : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theFixedPointIsOpenCvs_data() {
    QTest::addColumn<int>("iterations");
    for (const int n : {1, 2, 5, 20, 200}) QTest::addRow("%d", n) << n;
  }

  /// Also where the radial factor turns negative and OpenCV gives up.
  void theFixedPointIsOpenCvs() {
    QFETCH(const int, iterations);
    for (const DistortionParams& lens :
         {barrel, figure3, DistortionParams{-0.45, 0.25}, DistortionParams{-1.5, 0.1},
          DistortionParams{0.2958943955272433, -1.0354662043042675}}) {
      const LensKey key = keyOf(lens, LensInverse::fixedPoint, iterations);
      const auto ours = raysOf(key);
      const auto theirs = raysOfOpenCv(key, iterations);
      for (std::size_t k = 0; k < ours.size(); ++k) {
        if (!std::isfinite(theirs[k].x) || !std::isfinite(theirs[k].y)) continue;
        const double scale = 1 + std::hypot(theirs[k].x, theirs[k].y);
        QVERIFY(std::hypot(ours[k].x - theirs[k].x, ours[k].y - theirs[k].y) < 1e-9 * scale);
      }
    }
  }

  void newtonComesToTheExactRay() {
    const auto exact = raysOf(keyOf(barrel, LensInverse::exact, 0));
    const LensKey key = keyOf(barrel, LensInverse::newton, 5);
    QVERIFY(worstDistance(key, raysOf(key), exact) < 1e-9);
    const LensKey early = keyOf(barrel, LensInverse::newton, 1);
    QVERIFY(worstDistance(early, raysOf(early), exact) > 0.01);
  }

  /// Bilinear between nodes: half the spacing, a quarter of the error.
  void tablesGetBetterWithTheSquare() {
    const auto exact = raysOf(keyOf(figure3, LensInverse::exact, 0));
    std::vector<double> errors;
    for (const int spacing : {16, 8, 4, 2}) {
      const LensKey key = keyOf(figure3, LensInverse::table, spacing);
      errors.push_back(worstDistance(key, raysOf(key), exact));
    }
    QVERIFY(errors[0] > 0.01 && errors[0] < 3);
    for (std::size_t k = 1; k < errors.size(); ++k) {
      const double gain = errors[k - 1] / errors[k];
      QVERIFY2(gain > 2.5 && gain < 6, qPrintable(QString::number(gain)));
    }
  }

  /// A table has no ray where one of its nodes has none: only near the fold.
  void tablesKnowFolds() {
    const DistortionParams folds{0.2958943955272433, -1.0354662043042675};
    const auto exact = raysOf(keyOf(folds, LensInverse::exact, 0));
    const auto table = raysOf(keyOf(folds, LensInverse::table, 4));
    int both = 0;
    int onlyTable = 0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      if (std::isnan(exact[k].x))
        both += std::isnan(table[k].x) ? 1 : 0;
      else
        onlyTable += std::isnan(table[k].x) ? 1 : 0;
    }
    QVERIFY2(both > 100 && onlyTable < 500, qPrintable(QString("%1 %2").arg(both).arg(onlyTable)));
  }

  /// Many hogels: a float has no room for their number and four digits more.
  void floatsDifferOnlyAtBorders() {
    Random random(4);
    RenderJob job;
    job.display.hogels = {4096, 2};
    job.display.directions = {32, 2};
    RandomScene scene;
    scene.content.size = {4096, 2, 32, 2};
    fillWithNoise<std::uint8_t>(random, scene, 0, 256, 1);
    job.lightField = scene.job.lightField;
    job.state.camera.res = {300, 200};
    int different = 0;
    for (int repeat = 0; repeat < 10; ++repeat) {
      job.display.lens = repeat < 5 ? HogelLensModel::rectilinear : HogelLensModel::equiangular;
      job.state.camera.eye = {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0.5};
      job.method.isSingle = false;
      const Image exact = rendered(job);
      job.method.isSingle = true;
      const Image single = rendered(job);
      for (std::size_t k = 0; k < exact.seen.size(); ++k)
        different +=
            std::equal(&exact.rgb[3 * k], &exact.rgb[3 * k] + 3, &single.rgb[3 * k]) ? 0 : 1;
      if (repeat % 5 == 4) QVERIFY(std::exchange(different, 0) > 10);
      QVERIFY(different < 6000);
    }
  }

  void droppedTapsStayWithinTheirBound() {
    Random random(5);
    int changed = 0;
    for (int repeat = 0; repeat < 60; ++repeat) {
      RandomScene scene = randomScene(random);
      scene.job.state.psf.windowSize = 9;
      scene.job.state.psf.sigma = random.uniform(0.4, 1.2);
      const Image exact = rendered(scene.job);
      for (const double bound : {0.5, 3.0, 20.0}) {
        scene.job.method.droppedTaps = bound;
        const Image less = rendered(scene.job);
        for (std::size_t k = 0; k < exact.rgb.size(); ++k) {
          const int d = std::abs(exact.rgb[k] - less.rgb[k]);
          QVERIFY(d <= bound + 1);
          changed += d > 0 ? 1 : 0;
        }
      }
      scene.job.method.droppedTaps = std::numeric_limits<double>::infinity();
      RandomScene plain = scene;
      plain.job.method = {};
      plain.job.state.psf.windowSize = 1;
      QVERIFY(rendered(scene.job) == rendered(plain.job));
    }
    QVERIFY(changed > 100);
  }

  void reducedPixelsStandInTheMiddleOfTheirs() {
    RenderJob job;
    job.state.camera.res = {width, height};
    job.state.intrinsics = {55, 50, 31.5, 20};
    const Camera full(job.state.camera, job.state.intrinsics);
    for (const int scale : {2, 4}) {
      job.method.scale = scale;
      const RenderJob small = reduced(job);
      QVERIFY((small.state.camera.res ==
               std::array{(width + scale - 1) / scale, (height + scale - 1) / scale}));
      QCOMPARE(small.method.scale, 1);
      const Camera camera(small.state.camera, small.state.intrinsics);
      const Vec2 a = camera.normalised(3, 5);
      const Vec2 b = full.normalised(3 * scale + (scale - 1) / 2.0, 5 * scale + (scale - 1) / 2.0);
      QVERIFY(std::hypot(a.x - b.x, a.y - b.y) < 1e-14);
    }
  }

  /// cv::resize has the same convention of pixel centres.
  void enlargingIsOpenCvs() {
    Random random(6);
    for (const int scale : {2, 4}) {
      Image small(19, 13);
      for (auto& value : small.rgb) value = std::uint8_t(random.integer(0, 255));
      std::fill(small.seen.begin(), small.seen.end(), std::uint8_t{255});
      const Image full = enlarged(small, scale, {19 * scale, 13 * scale});
      const cv::Mat source(13, 19, CV_8UC3, small.rgb.data());
      cv::Mat expected;
      cv::resize(source, expected, {}, scale, scale, cv::INTER_LINEAR);
      for (int y = 0; y < full.height; ++y)
        for (int x = 0; x < full.width; ++x)
          for (int c = 0; c < 3; ++c) {
            const auto at = std::size_t(3 * (y * full.width + x) + c);
            QVERIFY(std::abs(full.rgb[at] - expected.at<cv::Vec3b>(y, x)[c]) <= 1);
            QCOMPARE(int(enlargedPixel(small, scale, x, y)[std::size_t(c)]), int(full.rgb[at]));
          }
      const std::vector<float> floats =
          enlarged(toFloat(small), scale, {19 * scale, 13 * scale}).rgb;
      for (std::size_t k = 0; k < floats.size(); ++k)
        QVERIFY(std::abs(floats[k] - float(full.rgb[k])) < 0.51F);
    }
  }

  void whatIsNotSeenStaysBlack() {
    Image small(2, 1);
    small.rgb = {200, 200, 200, 0, 0, 0};
    small.seen = {255, 0};
    const Image full = enlarged(small, 4, {7, 3});
    const std::vector<float> floats = enlarged(toFloat(small), 4, {7, 3}).rgb;
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 7; ++x) {
        const auto at = std::size_t(y * 7 + x);
        QCOMPARE(int(full.seen[at]), x < 4 ? 255 : 0);
        QCOMPARE(full.rgb[3 * at] > 0, x < 4);
        QCOMPARE(floats[3 * at] > 0, x < 4);
      }
  }

  void halfSizeIsCloser() {
    Random random(7);
    RandomScene scene = randomScene(random);
    scene.job.state.camera.res = {120, 90};
    const Image exact = rendered(scene.job);
    const auto error = [&](int scale) {
      scene.job.method.scale = scale;
      return rmse(exact, enlarged(rendered(reduced(scene.job)), scale, {120, 90}));
    };
    const double half = error(2);
    QVERIFY(half > 0 && half < error(4));
  }
};

QTEST_APPLESS_MAIN(TestMethods)
#include "test_methods.moc"
