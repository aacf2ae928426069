// SPDX-License-Identifier: BSD-3-Clause
// Joined images of two eyes: places of pixels, and Dubois' matrices by OpenCV.
#include "core/optics/stereo_image.h"

#include <QTest>
#include <cmath>
#include <opencv2/core.hpp>

#include "tests/core/random.h"

using namespace hogelscope;

namespace {

constexpr int width = 31;
constexpr int height = 17;

Image noise(std::uint64_t seed) {
  Random random(seed);
  Image image(width, height);
  for (std::uint8_t& value : image.rgb) value = std::uint8_t(random.integer(0, 255));
  for (std::uint8_t& value : image.seen) value = random.flip() ? 255 : 0;
  return image;
}

/// The picture in linear light, a column for each pixel.
cv::Mat linearOf(const Image& image) {
  cv::Mat light(3, width * height, CV_64F);
  for (int k = 0; k < width * height; ++k)
    for (int c = 0; c < 3; ++c) {
      const double s = image.rgb[std::size_t(3 * k + c)] / 255.0;
      light.at<double>(c, k) = s > 0.04045 ? std::pow((s + 0.055) / 1.055, 2.4) : s / 12.92;
    }
  return light;
}

const cv::Mat left = (cv::Mat_<double>(3, 3) << 0.4561, 0.500484, 0.176381, -0.0400822, -0.0378246,
                      -0.0157589, -0.0152161, -0.0205971, -0.00546856);
const cv::Mat right = (cv::Mat_<double>(3, 3) << -0.0434706, -0.0879388, -0.00155529, 0.378476,
                       0.73364, -0.0184503, -0.0721527, -0.112961, 1.2264);

}  // namespace

class TestStereoImage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eyesStandSideBySide() {
    const Image l = noise(1);
    const Image r = noise(2);
    const Image parallel = stereoImage(l, r, StereoMode::sideBySide);
    const Image crossed = stereoImage(l, r, StereoMode::crossEyed);
    QCOMPARE(parallel.width, 2 * width);
    QCOMPARE(parallel.height, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const auto from = std::size_t(y * width + x);
        const auto first = std::size_t(y * 2 * width + x);
        const auto second = first + width;
        for (std::size_t c = 0; c < 3; ++c) {
          QCOMPARE(parallel.rgb[3 * first + c], l.rgb[3 * from + c]);
          QCOMPARE(parallel.rgb[3 * second + c], r.rgb[3 * from + c]);
          QCOMPARE(crossed.rgb[3 * first + c], r.rgb[3 * from + c]);
          QCOMPARE(crossed.rgb[3 * second + c], l.rgb[3 * from + c]);
        }
        QCOMPARE(parallel.seen[first], l.seen[from]);
        QCOMPARE(parallel.seen[second], r.seen[from]);
      }
  }

  void anaglyphsAreDubois_data() {
    QTest::addColumn<bool>("isGrey");
    QTest::newRow("colour") << false;
    QTest::newRow("grey") << true;
  }
  void anaglyphsAreDubois() {
    QFETCH(const bool, isGrey);
    const Image l = noise(3);
    const Image r = noise(4);
    const cv::Mat luminance = (cv::Mat_<double>(3, 3) << 0.2126, 0.7152, 0.0722, 0.2126, 0.7152,
                               0.0722, 0.2126, 0.7152, 0.0722);
    const cv::Mat first = isGrey ? cv::Mat(luminance * linearOf(l)) : linearOf(l);
    const cv::Mat second = isGrey ? cv::Mat(luminance * linearOf(r)) : linearOf(r);
    const cv::Mat sum = left * first + right * second;
    const Image image = stereoImage(l, r, isGrey ? StereoMode::anaglyphGrey : StereoMode::anaglyph);
    int limited = 0;
    for (int k = 0; k < width * height; ++k) {
      for (int c = 0; c < 3; ++c) {
        const double light = std::clamp(sum.at<double>(c, k), 0.0, 1.0);
        limited += light != sum.at<double>(c, k) ? 1 : 0;
        const double code =
            255 * (light > 0.0031308 ? 1.055 * std::pow(light, 1 / 2.4) - 0.055 : 12.92 * light);
        QVERIFY(std::abs(double(image.rgb[std::size_t(3 * k + c)]) - code) <= 0.5 + 1e-9);
      }
      QCOMPARE(image.seen[std::size_t(k)],
               std::max(l.seen[std::size_t(k)], r.seen[std::size_t(k)]));
    }
    QVERIFY(limited > 0);
  }

  /// Bytes by tables are those of floats, which are not: for all pairs of greys, and of noise.
  void tablesAreExact() {
    Image l(256, 512);
    Image r(256, 512);
    Random random(5);
    for (std::size_t k = 0; k < 3 * 65536; ++k) {
      l.rgb[k] = std::uint8_t(k / 3 % 256);
      r.rgb[k] = std::uint8_t(k / 3 / 256);
      l.rgb[3 * 65536 + k] = std::uint8_t(random.integer(0, 255));
      r.rgb[3 * 65536 + k] = std::uint8_t(random.integer(0, 255));
    }
    const auto floatsOf = [](const Image& image) {
      FloatImage floats(image.width, image.height);
      std::copy(image.rgb.begin(), image.rgb.end(), floats.rgb.begin());
      return floats;
    };
    for (const StereoMode mode : {StereoMode::anaglyph, StereoMode::anaglyphGrey}) {
      const Image bytes = stereoImage(l, r, mode);
      const FloatImage floats = stereoImage(floatsOf(l), floatsOf(r), mode);
      for (std::size_t k = 0; k < bytes.rgb.size(); ++k) {
        const double code = floats.rgb[k];
        const bool isBetween = std::abs(code - std::floor(code) - 0.5) < 1e-4;  // for a float
        QVERIFY(bytes.rgb[k] == quantised(code) || isBetween);
      }
    }
  }
};

QTEST_APPLESS_MAIN(TestStereoImage)
#include "test_stereo_image.moc"
