// SPDX-License-Identifier: BSD-3-Clause
// Tests the straightening of distorted views by OpenCV: against the lens model, and
// against the views that the engine makes without the lens.
#include "study/undistortion.h"

#include <QTest>
#include <cmath>

#include "core/base/parallel.h"

using namespace hogelscope;

namespace {

constexpr int width = 120;
constexpr int height = 90;

std::uint8_t value(double x, double y, int channel) {
  return std::uint8_t(std::lround(127.5 + 100 * std::sin(0.05 * (channel == 1 ? y : x) + channel)));
}

CameraState tangentialCamera() {
  CameraState state;
  state.camera.res = {width, height};
  state.intrinsics = {100, 110, 55, 47};
  state.distortion = {0.2, -0.05, 0.03, -0.02, 0.01};
  return state;
}

/// A picture of waves whose left sixth is not seen.
Image waves() {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto at = std::size_t(y * width + x);
      image.seen[at] = x < 20 ? 0 : 255;
      for (int c = 0; c < 3; ++c) image.rgb[3 * at + std::size_t(c)] = value(x, y, c);
    }
  }
  return image;
}

}  // namespace

class TestUndistortion : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void openCvsPicture_data();
  void openCvsPicture();
  void differenceIsOfPixelsSeenInBoth();
  void equalPictures();
  void errors();
};

/// A pixel of the straightened picture shows the distorted picture where the lens images it. The
/// waves are smooth: their value at that place is the interpolated one.
void TestUndistortion::openCvsPicture_data() {
  QTest::addColumn<DistortionParams>("lens");
  QTest::newRow("brown") << tangentialCamera().distortion;
  QTest::newRow("rational") << DistortionParams{
      0.3, -0.2, 0.01, -0.02, 0.1, 0.2, 0.1, 0.05, DistortionModel::rational};
  QTest::newRow("fisheye") << DistortionParams{
      0.05, -0.02, 0, 0, 0.01, 0.01, 0, 0, DistortionModel::fisheye};
}

void TestUndistortion::openCvsPicture() {
  CameraState state = tangentialCamera();
  QFETCH(const DistortionParams, lens);
  state.distortion = lens;
  const Distortion model(lens);
  const auto [fx, fy, cx, cy] = state.intrinsics;
  const Image result = undistortedByOpenCv(waves(), state);
  int seen = 0;
  for (int py = 0; py < height; ++py) {
    for (int px = 0; px < width; ++px) {
      const Vec2 q = model.distort({(px - cx) / fx, (py - cy) / fy});
      const double qx = fx * q.x + cx;
      const double qy = fy * q.y + cy;
      const auto at = std::size_t(py * width + px);
      const double margin = 0.05;  // OpenCV's places are rounded to a 32nd of a pixel
      if (qx < 20 - 1 - margin || qx > width - 1 + margin || qy < -margin ||
          qy > height - 1 + margin) {
        QCOMPARE(result.seen[at], std::uint8_t{0});
      } else if (qx > 20 + margin && qx < width - 1 - margin && qy > margin &&
                 qy < height - 1 - margin) {
        ++seen;
        QCOMPARE(result.seen[at], std::uint8_t{255});
        for (int c = 0; c < 3; ++c)
          QVERIFY(std::abs(result.rgb[3 * at + std::size_t(c)] - value(qx, qy, c)) <= 1.5);
      }
    }
  }
  QVERIFY(seen > width * height / 2);
}

void TestUndistortion::differenceIsOfPixelsSeenInBoth() {
  Image undistorted = waves();
  for (int p = 0; p < width; ++p) undistorted.seen[std::size_t(p)] = 0;  // row 0
  const CameraState state = tangentialCamera();
  const Undistortion result = compareUndistortion(waves(), undistorted, state);
  double sum = 0;
  std::size_t points = 0;
  for (std::size_t p = 0; p < undistorted.pixelCount(); ++p) {
    const bool isSeen = undistorted.seen[p] != 0 && result.openCvs.seen[p] != 0;
    points += isSeen ? 1 : 0;
    for (std::size_t k = 3 * p; k < 3 * p + 3; ++k) {
      const int difference = std::abs(undistorted.rgb[k] - result.openCvs.rgb[k]);
      sum += isSeen ? difference * difference : 0;
      QCOMPARE(int(result.difference.image.rgb[k]),
               isSeen ? std::min(255, result.difference.gain * difference) : 0);
    }
  }
  QCOMPARE(result.points, points);
  const double mse = sum / (3 * double(points));
  QVERIFY(std::abs(result.psnr - 10 * std::log10(255 * 255 / mse)) < 1e-9);
}

void TestUndistortion::equalPictures() {
  const Undistortion result = compareUndistortion(waves(), waves(), [] {
    CameraState state = tangentialCamera();
    state.distortion = {};
    return state;
  }());
  QVERIFY(std::isinf(result.psnr));
}

/// The exact mapping is the inverse of OpenCV's formula, down to what resampling costs; the direct
/// one is not, and comes near it only as the coefficients vanish.
void TestUndistortion::errors() {
  const std::vector<InstabilityRow> rows = undistortionErrors(serialRows, {});
  QCOMPARE(rows.size(), std::size_t(10));
  double before = 0;
  for (const InstabilityRow& row : rows) {
    QCOMPARE(row.kind, std::string("undistortion"));
    QVERIFY(row.points.value() > 100000);
    if (row.method == "exact") {
      QVERIFY2(row.value > 40, qPrintable(QString::number(row.value)));
      continue;
    }
    QCOMPARE(row.method, std::string("direct"));
    QVERIFY(row.value > before);
    before = row.value;
    if (row.x == 1) QVERIFY2(row.value < 15, qPrintable(QString::number(row.value)));
  }
}

QTEST_GUILESS_MAIN(TestUndistortion)
#include "test_undistortion.moc"
