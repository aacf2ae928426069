// SPDX-License-Identifier: BSD-3-Clause
// Tests MSE, PSNR and SSIM by hand, by brute force and against OpenCV's.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
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

/// Sees a panel in the middle.
void hideBorder(Image& image, int left, int top, int right, int bottom) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (x < left || y < top || x >= image.width - right || y >= image.height - bottom)
        image.seen[std::size_t(y) * std::size_t(image.width) + std::size_t(x)] = 0;
}

/// An image of so many bits from its values.
Image deepImage(int width, int height, int bits, const std::function<int(int, int, int)>& value) {
  Image image(width, height, bits);
  for (int k = 0; k < int(image.rgb.size()); ++k) {
    const int stored = value(k / 3 % width, k / 3 / width, k % 3);
    image.deep[std::size_t(k)] = static_cast<std::uint16_t>(stored);
    image.rgb[std::size_t(k)] = quantised(255.0 * stored / largestValue(bits));
  }
  std::fill(image.seen.begin(), image.seen.end(), std::uint8_t{255});
  return image;
}

int tenBitValue(int x, int y, int c) {
  return (x * 21 + y * 13 + c * 160 + x * y / 7) % 1024;
}

int otherTenBitValue(int x, int y, int c) {
  return std::clamp(tenBitValue(x, y, c) + (x * 7 + y * 13 + c * 29) % 23 - 8, 0, 1023);
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
  void ssimOfWhatIsSeen();
  void yuvOfWhatIsSeen();
  void blackSurroundingsRaiseTheFrameAlone();
  void tenBitsAsNumpy();
  void tenBitsByBruteForce();
  void anEightBitCopyIsNotIdentical();
  void deepIdentical();
  void deepGrey();
  void bitsOfAPair();
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
  QVERIFY(std::abs(ssim(a, a).frame - 1) < 1e-12);
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
    QVERIFY(std::abs(ssim(a, similar(a)).frame - bruteForceSsim(a, similar(a))) < 1e-11);
    QVERIFY(std::abs(ssim(similar(a), a).frame - ssim(a, similar(a)).frame) < 1e-13);
    QCOMPARE(MetricSet().compare(a, similar(a))[ssimColumn], ssim(a, similar(a)).frame);
  }
}

void TestMetrics::ssimIsOpenCvsInside() {
  const Image a = noise(64, 48, 6);
  const Image b = similar(a);
  cv::Mat map;
  cv::quality::QualitySSIM::compute(lumaMat(a), lumaMat(b), map);
  // OpenCV continues the images beyond their borders.
  const cv::Mat inside = map(cv::Rect(5, 5, 54, 38));
  QVERIFY(std::abs(cv::mean(inside)[0] - ssim(a, b).frame) < 1e-4);
  QVERIFY(ssim(a, b).frame > 0.3 && ssim(a, b).frame < 0.99);
}

void TestMetrics::ssimOfNoiseIsNearZero() {
  QVERIFY(std::abs(ssim(noise(128, 128, 7), noise(128, 128, 8)).frame) < 0.05);
}

void TestMetrics::ssimOfConstants() {
  const double expected = (2 * 100 * 101 + 6.5025) / (100 * 100 + 101 * 101 + 6.5025);
  QVERIFY(std::abs(ssim(filled(20, 20, 100), filled(20, 20, 101)).frame - expected) < 1e-10);
  QVERIFY(std::abs(ssim(filled(20, 20, 0), filled(20, 20, 255)).frame - 6.5025 / 65031.5025) <
          1e-10);
}

void TestMetrics::ssimNeedsAWindow() {
  QVERIFY(std::isnan(ssim(Image(10, 11), Image(10, 11)).frame));
  QVERIFY(std::isnan(ssim(Image(11, 10), Image(11, 10)).frame));
  QVERIFY(std::isnan(ssim(Image(11, 3), Image(11, 3)).frame));
  QVERIFY(std::isnan(ssim(Image(3, 11), Image(3, 11)).frame));
  QCOMPARE(ssim(Image(11, 11), Image(11, 11)).frame, 1.0);
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
  QVERIFY(std::abs(ssim(a, b).frame - 0.9740821607718232) < 1e-12);
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
    QVERIFY(ssim(a, a).frame == 1);
  }
}

/// Over the windows that lie wholly in what both see.
void TestMetrics::ssimOfWhatIsSeen() {
  Image a = noise(60, 90, 5);
  Image b = similar(a);
  QVERIFY(ssim(a, b).seen == ssim(a, b).frame);  // to the last bit where all is seen
  hideBorder(a, 9, 20, 0, 3);
  hideBorder(b, 4, 22, 17, 0);
  b.seen[60 * 70 + 30] = 0;
  double sum = 0;
  int count = 0;
  for (int y = 22; y + 11 <= 87; ++y)
    for (int x = 9; x + 11 <= 43; ++x) {
      if (y <= 70 && 70 < y + 11 && x <= 30 && 30 < x + 11) continue;
      sum += windowsSsim(a, b, x, y);
      ++count;
    }
  QVERIFY(std::abs(ssim(a, b).seen - sum / count) < 1e-11);
  hideBorder(a, 9, 20, 60 - 19, 0);  // ten columns: no window
  QVERIFY(std::isnan(ssim(a, b).seen));
  QVERIFY(ssim(a, b).frame > 0);
}

void TestMetrics::yuvOfWhatIsSeen() {
  Image a = noise(150, 120, 3);
  Image b = similar(a);
  hideBorder(a, 30, 0, 20, 11);
  const SquaredError m = squaredError(a, b);
  Image cutA = filled(100, 109, 0);
  Image cutB = cutA;
  for (int y = 0; y < 109; ++y)
    for (int k = 0; k < 300; ++k) {
      cutA.rgb[std::size_t(300 * y + k)] = a.rgb[std::size_t(450 * y + 90 + k)];
      cutB.rgb[std::size_t(300 * y + k)] = b.rgb[std::size_t(450 * y + 90 + k)];
    }
  const SquaredError cut = squaredError(cutA, cutB);
  QCOMPARE(m.mseSeen, cut.mse);
  QVERIFY(m.mseYuvSeen == cut.mseYuv);
  QVERIFY(m.mseYuv != cut.mseYuv);
  QVERIFY(cut.mseYuvSeen == cut.mseYuv);
}

/// A panel over a quarter of the picture: 6.02 dB.
void TestMetrics::blackSurroundingsRaiseTheFrameAlone() {
  Image a = filled(80, 60, 0);
  hideBorder(a, 20, 15, 20, 15);
  Image b = a;
  for (std::size_t p = 0; p < a.pixelCount(); ++p)
    if (a.seen[p] != 0) b.rgb[3 * p] = b.rgb[3 * p + 1] = b.rgb[3 * p + 2] = 10;
  const std::vector<double> values = MetricSet().compare(a, b);
  QCOMPARE(values[psnrSeenColumn], psnr(100));
  QCOMPARE(values[psnrColumn], psnr(25));
  QCOMPARE(values[psnrYSeenColumn], psnr(100));
  QVERIFY(values[ssimSeenColumn] < values[ssimColumn]);
}

/// What numpy 1.24 and scikit-image 0.19.3 give for these values:
///   a, b = 10-bit values; mse = np.mean((a - b)**2.0); psnr = 10*np.log10(1023**2 / mse)
///   w = [.299, .587, .114]; structural_similarity(a @ w, b @ w, data_range=1023,
///     gaussian_weights=True, sigma=1.5, use_sample_covariance=False)
void TestMetrics::tenBitsAsNumpy() {
  const Image a = deepImage(48, 32, 10, tenBitValue);
  const Image b = deepImage(48, 32, 10, otherTenBitValue);
  const std::vector<double> values = MetricSet().compare(a, b);
  QVERIFY(std::abs(values[mseOfBitsColumn] - 52.570963541666664) < 1e-10);
  QVERIFY(std::abs(values[psnrColumn] - 42.99005330409813) < 1e-10);
  QVERIFY(std::abs(values[ssimColumn] - 0.9975976423529949) < 1e-12);
  QVERIFY(std::abs(values[psnrYuvColumn] - 45.70712044100887) < 1e-10);
  QCOMPARE(values[psnrSeenColumn], values[psnrColumn]);
  QCOMPARE(values[bitsColumn], 10.0);
}

void TestMetrics::tenBitsByBruteForce() {
  Image a = deepImage(48, 32, 10, tenBitValue);
  const Image b = deepImage(48, 32, 10, otherTenBitValue);
  hideBorder(a, 5, 6, 7, 8);
  double all = 0, seen = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 48; ++x)
      for (int c = 0; c < 3; ++c) {
        const double square = std::pow(tenBitValue(x, y, c) - otherTenBitValue(x, y, c), 2);
        all += square;
        if (x >= 5 && x < 41 && y >= 6 && y < 24) seen += square;
      }
  const SquaredError m = squaredError(a, b);
  const double unit = std::pow(1023 / 255.0, 2);
  QVERIFY(std::abs(m.mse * unit - all / (3 * 48 * 32)) < 1e-10);
  QVERIFY(std::abs(m.mseSeen * unit - seen / (3 * 36 * 18)) < 1e-10);
}

/// Numpy: eight = np.floor(a * 255 / 1023 + .5); mse = np.mean((a * 255 / 1023 - eight)**2)
void TestMetrics::anEightBitCopyIsNotIdentical() {
  const Image a = deepImage(48, 32, 10, tenBitValue);
  Image b = a;
  b.bits = 8;
  b.deep.clear();
  QVERIFY(a.rgb == b.rgb);
  for (const SquaredError& m : {squaredError(a, b), squaredError(b, a)}) {
    QVERIFY(std::abs(m.mse - 0.08318660013542398) < 1e-12);
    QVERIFY(std::abs(psnr(m.mse) - 58.930269859705255) < 1e-10);
  }
  QVERIFY(ssim(a, b).frame < 1);
}

void TestMetrics::deepIdentical() {
  for (const int bits : {9, 10, 12, 16}) {
    const Image a = deepImage(40, 30, bits, [bits](int x, int y, int c) {
      return (x * 977 + y * 331 + c * 71) % (largestValue(bits) + 1);
    });
    const std::vector<double> values = MetricSet().compare(a, a);
    QCOMPARE(values[mseColumn], 0.0);
    QCOMPARE(values[ssimColumn], 1.0);
    QVERIFY(std::isinf(values[psnrYuvColumn]));
  }
}

/// Grey that differs has no error of its colour, to the last bit.
void TestMetrics::deepGrey() {
  const auto grey = [](int add) {
    return deepImage(40, 30, 12, [add](int x, int y, int) { return x * 61 + y * 3 + add; });
  };
  const auto [y, cb, cr] = squaredError(grey(0), grey(7)).mseYuv;
  QVERIFY(std::abs(y - std::pow(7 * 255 / 4095.0, 2)) < 1e-12);
  QCOMPARE(cb, 0.0);
  QCOMPARE(cr, 0.0);
}

void TestMetrics::bitsOfAPair() {
  const Image ten = deepImage(12, 12, 10, tenBitValue);
  const Image sixteen = deepImage(12, 12, 16, tenBitValue);
  const auto bits = [](const Image& a, const Image& b) {
    return MetricSet().compare(a, b)[bitsColumn];
  };
  QCOMPARE(bits(filled(12, 12, 1), filled(12, 12, 2)), 8.0);
  QCOMPARE(bits(ten, filled(12, 12, 2)), 10.0);
  QCOMPARE(bits(ten, sixteen), 16.0);
}

QTEST_APPLESS_MAIN(TestMetrics)
#include "test_metrics.moc"
