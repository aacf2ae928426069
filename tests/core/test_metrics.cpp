// SPDX-License-Identifier: BSD-3-Clause
// Tests MSE, PSNR and SSIM by hand, by brute force and against OpenCV's.
#include <QTest>
#include <cmath>
#include <limits>
#include <opencv2/quality/qualityssim.hpp>
#include <stdexcept>

#include "core/metrics/metric.h"
#include "core/metrics/squared_error.h"
#include "core/metrics/ssim.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

Image filled(int width, int height, int value) {
  Image image(width, height);
  std::fill(image.rgb.begin(), image.rgb.end(), static_cast<std::uint8_t>(value));
  std::fill(image.seen.begin(), image.seen.end(), std::uint8_t{255});
  return image;
}

Image noise(int width, int height, std::uint64_t seed) {
  Random random(seed);
  Image image = filled(width, height, 0);
  for (std::uint8_t& value : image.rgb) value = static_cast<std::uint8_t>(random.integer(0, 255));
  return image;
}

/// An image like another one, but blurred by hand and a bit off.
Image similar(const Image& image) {
  Random random(9);
  Image other = image;
  for (std::size_t k = 3; k < other.rgb.size(); ++k)
    other.rgb[k] = static_cast<std::uint8_t>(
        (image.rgb[k] * 3 + image.rgb[k - 3] + random.integer(0, 40)) / 5);
  return other;
}

double luma(const Image& image, int x, int y) {
  const std::size_t at = 3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
  return 0.299 * image.rgb[at] + 0.587 * image.rgb[at + 1] + 0.114 * image.rgb[at + 2];
}

/// SSIM of the 11×11 window whose top left is (x0, y0): weighted moments about the means.
double windowsSsim(const Image& a, const Image& b, int x0, int y0) {
  double weights = 0, ma = 0, mb = 0, vaa = 0, vbb = 0, vab = 0;
  for (const bool second : {false, true}) {
    for (int k = 0; k < 121; ++k) {
      const double w = std::exp(-(std::pow(k % 11 - 5, 2) + std::pow(k / 11 - 5, 2)) / 4.5);
      const double pa = luma(a, x0 + k % 11, y0 + k / 11);
      const double pb = luma(b, x0 + k % 11, y0 + k / 11);
      if (!second) {
        weights += w;
        ma += w * pa;
        mb += w * pb;
      } else {
        vaa += w * std::pow(pa - ma / weights, 2) / weights;
        vbb += w * std::pow(pb - mb / weights, 2) / weights;
        vab += w * (pa - ma / weights) * (pb - mb / weights) / weights;
      }
    }
  }
  ma /= weights;
  mb /= weights;
  const double c1 = 6.5025;   // (0.01 · 255)²
  const double c2 = 58.5225;  // (0.03 · 255)²
  return (2 * ma * mb + c1) * (2 * vab + c2) / ((ma * ma + mb * mb + c1) * (vaa + vbb + c2));
}

double bruteForceSsim(const Image& a, const Image& b) {
  double sum = 0;
  for (int y = 0; y + 11 <= a.height; ++y)
    for (int x = 0; x + 11 <= a.width; ++x) sum += windowsSsim(a, b, x, y);
  return sum / ((a.width - 10) * (a.height - 10));
}

cv::Mat lumaMat(const Image& image) {
  cv::Mat mat(image.height, image.width, CV_32F);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) mat.at<float>(y, x) = float(luma(image, x, y));
  return mat;
}

}  // namespace

class TestMetrics : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void mseByHand();
  void psnrByHand();
  void identicalPictures();
  void onlyWhatBothSee();
  void nothingSeenInBoth();
  void differentSizesAreRefused();
  void ssimIsTheFormula();
  void ssimIsOpenCvsInside();
  void ssimOfNoiseIsNearZero();
  void ssimOfConstants();
  void ssimNeedsAWindow();
  void asScikitImage();
  void yuvByHand();
  void yuvOfGrey();
  void yuvIsTheMatrix();
  void psnrYuvWeighs();
  void largeSumsAreExact();
  void threadsChangeNothing();
  void identicalIsExactlyOne();
};

void TestMetrics::mseByHand() {
  Image a = filled(2, 1, 10);
  Image b = a;
  b.rgb = {11, 8, 13, 10, 10, 10};
  QCOMPARE(squaredError(a, b).mse, 14 / 6.0);
  QCOMPARE(squaredError(b, a).mse, 14 / 6.0);
  a.rgb = {255, 255, 255, 255, 255, 255};
  b.rgb = {0, 0, 0, 0, 0, 0};
  QCOMPARE(squaredError(a, b).mse, 65025.0);
}

void TestMetrics::psnrByHand() {
  QCOMPARE(psnr(65025), 0.0);
  QCOMPARE(psnr(650.25), 20.0);
  QVERIFY(std::abs(psnr(1) - 48.13080360867910) < 1e-12);
  QVERIFY(psnr(0) == std::numeric_limits<double>::infinity());
  QVERIFY(std::isnan(psnr(std::numeric_limits<double>::quiet_NaN())));
}

void TestMetrics::identicalPictures() {
  const Image a = noise(20, 15, 1);
  const SquaredError m = squaredError(a, a);
  QCOMPARE(m.mse, 0.0);
  QCOMPARE(m.mseSeen, 0.0);
  QCOMPARE(m.seen, 1.0);
  QVERIFY(std::abs(ssim(a, a) - 1) < 1e-12);
}

void TestMetrics::onlyWhatBothSee() {
  Image a = filled(4, 1, 100);
  Image b = filled(4, 1, 100);
  b.rgb = {101, 101, 101, 110, 110, 110, 120, 120, 120, 140, 140, 140};
  a.seen = {255, 255, 0, 0};
  b.seen = {255, 0, 255, 0};
  const SquaredError m = squaredError(a, b);
  QCOMPARE(m.mse, (1 + 100 + 400 + 1600) / 4.0);
  QCOMPARE(m.mseSeen, 1.0);
  QCOMPARE(m.seen, 0.25);
}

void TestMetrics::nothingSeenInBoth() {
  Image a = filled(2, 1, 100);
  Image b = filled(2, 1, 103);
  a.seen = {255, 0};
  b.seen = {0, 255};
  const SquaredError m = squaredError(a, b);
  QCOMPARE(m.mse, 9.0);
  QVERIFY(std::isnan(m.mseSeen));
  QCOMPARE(m.seen, 0.0);
}

void TestMetrics::differentSizesAreRefused() {
  QVERIFY_THROWS_EXCEPTION(std::invalid_argument,
                           (void)MetricSet().compare(Image(2, 3), Image(3, 2)));
  QVERIFY_THROWS_EXCEPTION(std::invalid_argument,
                           (void)MetricSet().compare(Image(2, 3), Image(2, 2)));
}

void TestMetrics::ssimIsTheFormula() {
  for (const auto& [width, height] :
       {std::pair(11, 11), std::pair(12, 30), std::pair(31, 17), std::pair(13, 90)}) {
    const Image a = noise(width, height, 5);
    QVERIFY(std::abs(ssim(a, similar(a)) - bruteForceSsim(a, similar(a))) < 1e-11);
    QVERIFY(std::abs(ssim(similar(a), a) - ssim(a, similar(a))) < 1e-13);
    QCOMPARE(MetricSet().compare(a, similar(a))[ssimColumn], ssim(a, similar(a)));
  }
}

void TestMetrics::ssimIsOpenCvsInside() {
  const Image a = noise(64, 48, 6);
  const Image b = similar(a);
  cv::Mat map;
  cv::quality::QualitySSIM::compute(lumaMat(a), lumaMat(b), map);
  // OpenCV continues the images beyond their borders.
  const cv::Mat inside = map(cv::Rect(5, 5, 54, 38));
  QVERIFY(std::abs(cv::mean(inside)[0] - ssim(a, b)) < 1e-4);
  QVERIFY(ssim(a, b) > 0.3 && ssim(a, b) < 0.99);
}

void TestMetrics::ssimOfNoiseIsNearZero() {
  QVERIFY(std::abs(ssim(noise(128, 128, 7), noise(128, 128, 8))) < 0.05);
}

void TestMetrics::ssimOfConstants() {
  const double expected = (2 * 100 * 101 + 6.5025) / (100 * 100 + 101 * 101 + 6.5025);
  QVERIFY(std::abs(ssim(filled(20, 20, 100), filled(20, 20, 101)) - expected) < 1e-10);
  QVERIFY(std::abs(ssim(filled(20, 20, 0), filled(20, 20, 255)) - 6.5025 / 65031.5025) < 1e-10);
}

void TestMetrics::ssimNeedsAWindow() {
  QVERIFY(std::isnan(ssim(Image(10, 11), Image(10, 11))));
  QVERIFY(std::isnan(ssim(Image(11, 10), Image(11, 10))));
  QVERIFY(std::isnan(ssim(Image(11, 3), Image(11, 3))));
  QVERIFY(std::isnan(ssim(Image(3, 11), Image(3, 11))));
  QCOMPARE(ssim(Image(11, 11), Image(11, 11)), 1.0);
}

/// What tests/cli/metrics.py gives for these images with scikit-image 0.19.3.
void TestMetrics::asScikitImage() {
  Image a = filled(48, 32, 0);
  Image b = a;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 48; ++x) {
      for (int c = 0; c < 3; ++c) {
        const auto at = std::size_t(3 * (48 * y + x) + c);
        const int value = (x * 5 + y * 3 + c * 40 + x * y / 7) % 256;
        a.rgb[at] = static_cast<std::uint8_t>(value);
        b.rgb[at] = quantised(value + (x * 7 + y * 13 + c * 29) % 23 - 8);
      }
    }
  }
  const SquaredError m = squaredError(a, b);
  QVERIFY(std::abs(m.mse - 51.752170138888886) < 1e-9);
  QVERIFY(std::abs(psnr(m.mse) - 30.991517949595636) < 1e-9);
  QVERIFY(std::abs(ssim(a, b) - 0.9740821607718232) < 1e-12);
  QVERIFY(std::abs(m.mseYuv[0] - 29.30305202145828) < 1e-9);
  QVERIFY(std::abs(m.mseYuv[1] - 22.126993423605754) < 1e-9);
  QVERIFY(std::abs(m.mseYuv[2] - 23.624828075680867) < 1e-9);
  QVERIFY(std::abs(psnrYuv(m.mseYuv) - 33.73109335864488) < 1e-9);
}

/// BT.709: a difference of d in R alone is 0.2126 d in Y, −0.2126 d / 1.8556 in Cb, d / 2 in Cr.
void TestMetrics::yuvByHand() {
  const Image a = filled(2, 1, 0);
  Image b = a;
  b.rgb = {255, 0, 0, 0, 0, 0};
  const auto [y, cb, cr] = squaredError(a, b).mseYuv;
  QVERIFY(std::abs(y - std::pow(0.2126 * 255, 2) / 2) < 1e-10);
  QVERIFY(std::abs(cb - std::pow(0.2126 * 255 / 1.8556, 2) / 2) < 1e-10);
  QVERIFY(std::abs(cr - std::pow(127.5, 2) / 2) < 1e-10);
}

/// Colour that does not differ is infinitely good, to the last bit.
void TestMetrics::yuvOfGrey() {
  const auto [y, cb, cr] = squaredError(filled(30, 20, 100), filled(30, 20, 103)).mseYuv;
  QCOMPARE(y, 9.0);
  QCOMPARE(cb, 0.0);
  QCOMPARE(cr, 0.0);
  QVERIFY(psnrYuv({y, cb, cr}) == std::numeric_limits<double>::infinity());
}

void TestMetrics::yuvIsTheMatrix() {
  const Image a = noise(40, 30, 3);
  const Image b = similar(a);
  std::array<double, 3> sums{};
  for (std::size_t p = 0; p < a.pixelCount(); ++p) {
    const auto yuv = [p](const Image& image) {
      const double red = image.rgb[3 * p], blue = image.rgb[3 * p + 2];
      const double y = 0.2126 * red + 0.7152 * image.rgb[3 * p + 1] + 0.0722 * blue;
      return std::array<double, 3>{y, (blue - y) / 1.8556 + 128, (red - y) / 1.5748 + 128};
    };
    for (std::size_t c = 0; c < 3; ++c) sums[c] += std::pow(yuv(a)[c] - yuv(b)[c], 2);
  }
  const SquaredError m = squaredError(a, b);
  for (std::size_t c = 0; c < 3; ++c) QVERIFY(std::abs(m.mseYuv[c] - sums[c] / 1200) < 1e-10);
}

void TestMetrics::psnrYuvWeighs() {
  QVERIFY(std::abs(psnrYuv({6.5025, 65.025, 650.25}) - (6 * 40 + 30 + 20) / 8.0) < 1e-12);
}

/// Black against white, over more pixels than 32 bits hold the squares of.
void TestMetrics::largeSumsAreExact() {
  const SquaredError m = squaredError(filled(700, 300, 0), filled(700, 300, 255));
  QCOMPARE(m.mse, 65025.0);
  QCOMPARE(m.mseSeen, 65025.0);
  QCOMPARE(m.mseYuv[0], 65025.0);
  Image blue = filled(700, 300, 0);
  for (std::size_t k = 2; k < blue.rgb.size(); k += 3) blue.rgb[k] = 255;
  QVERIFY(std::abs(squaredError(filled(700, 300, 0), blue).mseYuv[1] - 127.5 * 127.5) < 1e-9);
}

void TestMetrics::threadsChangeNothing() {
  const Image a = noise(30, 300, 2);
  const Image b = similar(a);
  const ParallelRows inPieces = [](int count, const std::function<void(int, int)>& rows) {
    for (int from = (count - 1) / 4 * 4; from >= 0; from -= 4)
      rows(from, std::min(from + 4, count));
  };
  QVERIFY(MetricSet().compare(a, b) == MetricSet().compare(a, b, inPieces));
}

/// 1 in report.csv, not 0.9999999999999998.
void TestMetrics::identicalIsExactlyOne() {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Image a = noise(61, 40, seed);
    QVERIFY(ssim(a, a) == 1);
  }
}

QTEST_APPLESS_MAIN(TestMetrics)
#include "test_metrics.moc"
