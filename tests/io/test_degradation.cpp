// SPDX-License-Identifier: BSD-3-Clause
// Tests --degrade: JPEG against OpenCV on the whole picture, noise against its law, blur against a
// brute-force sum.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "io/images/degradation.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

constexpr LightFieldSize size{6, 3, 16, 32};
constexpr int width = 96;
constexpr int height = 96;
using Picture = std::vector<std::uint8_t>;

Picture content() {
  Picture picture(3 * width * height);
  for (std::size_t k = 0; k < picture.size(); ++k)
    picture[k] = std::uint8_t(128 + 60 * std::sin(0.05 * double(k % (3 * width))) +
                              50 * std::cos(0.001 * double(k)));
  return picture;
}

Picture degraded(const std::string& how, std::uint64_t seed, Picture picture) {
  Degradation degradation = parseDegradation(how);
  degradation.seed = seed;
  const std::size_t band = picture.size() / 3;
  for (int j = 0; j < 3; ++j)
    degrade(degradation, size, j, {picture.data() + std::size_t(j) * band, band});
  return picture;
}

}  // namespace

class TestDegradation : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void jpeg();
  void noise();
  void noiseBySeed();
  void blur();
  void words_data();
  void words();
};

void TestDegradation::jpeg() {
  Picture picture = content();
  const cv::Mat rgb(height, width, CV_8UC3, picture.data());
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  std::vector<std::uint8_t> file;
  cv::imencode(".jpg", bgr, file, {cv::IMWRITE_JPEG_QUALITY, 40});
  cv::Mat expected;
  cv::cvtColor(cv::imdecode(file, cv::IMREAD_COLOR), expected, cv::COLOR_BGR2RGB);
  const Picture result = degraded("jpeg:40", 1, picture);
  QVERIFY(result != picture);
  // OpenCV smooths colour across blocks, so rows beside a band's border differ a little.
  for (int y = 0; y < height; ++y)
    for (int k = 0; k < 3 * width; ++k) {
      const int wanted = expected.ptr(y)[k];
      const int found = result[std::size_t(y * 3 * width + k)];
      const bool isBorder = y % 32 == 0 || y % 32 == 31;
      QVERIFY2(std::abs(found - wanted) <= (isBorder ? 12 : 0),
               qPrintable(QString("%1 %2: %3 %4").arg(y).arg(k).arg(found).arg(wanted)));
    }
}

/// Kolmogorov–Smirnov against the normal law of σ 5, rounded to whole values.
void TestDegradation::noise() {
  const Picture result = degraded("noise:5", 1, Picture(3 * width * height, 128));
  std::array<double, 256> counts{};
  for (const std::uint8_t value : result) counts[value] += 1.0 / double(result.size());
  double below = 0;
  double worst = 0;
  for (int value = 0; value < 256; ++value) {
    below += counts[std::size_t(value)];
    const double law = 0.5 * std::erfc(-(value + 0.5 - 128) / (5 * std::sqrt(2.0)));
    worst = std::max(worst, std::abs(below - law));
  }
  QVERIFY2(worst < 1.63 / std::sqrt(double(result.size())), qPrintable(QString::number(worst)));
  // Neighbours do not know of each other.
  double product = 0;
  for (std::size_t k = 1; k < result.size(); ++k)
    product += (result[k] - 128.0) * (result[k - 1] - 128.0);
  QVERIFY(std::abs(product / double(result.size())) < 25 * 4 / std::sqrt(double(result.size())));
}

void TestDegradation::noiseBySeed() {
  const Picture grey(3 * width * height, 128);
  QVERIFY(degraded("noise:5", 1, grey) == degraded("noise:5", 1, grey));
  QVERIFY(degraded("noise:5", 1, grey) != degraded("noise:5", 2, grey));
  QVERIFY(degraded("noise:0", 1, grey) == grey);
}

/// Only within a hogel: 16×32 pixels, its edge repeated.
void TestDegradation::blur() {
  const Picture picture = content();
  const Picture result = degraded("blur:1.2", 1, picture);
  for (const auto& [x, y, c] :
       {std::array{0, 0, 0}, {15, 31, 1}, {16, 32, 2}, {40, 50, 0}, {95, 95, 1}, {31, 10, 2}}) {
    double sum = 0;
    double weights = 0;
    for (int dy = -4; dy <= 4; ++dy)
      for (int dx = -4; dx <= 4; ++dx) {
        const int left = x / 16 * 16;
        const int top = y / 32 * 32;
        const int px = std::clamp(x + dx, left, left + 15);
        const int py = std::clamp(y + dy, top, top + 31);
        const double weight = std::exp(-(dx * dx + dy * dy) / (2 * 1.2 * 1.2));
        weights += weight;
        sum += weight * picture[std::size_t(3 * (py * width + px) + c)];
      }
    const int found = result[std::size_t(3 * (y * width + x) + c)];
    QVERIFY2(std::abs(found - sum / weights) < 1.1,
             qPrintable(QString("%1 %2: %3 %4").arg(x).arg(y).arg(found).arg(sum / weights)));
  }
  QVERIFY(result != picture);
}

void TestDegradation::words_data() {
  QTest::addColumn<QString>("how");
  QTest::addColumn<QString>("line");
  QTest::newRow("no number") << "jpeg"
                             << "degradation: jpeg: needs a number from 1 to 100 after jpeg:";
  QTest::newRow("too much") << "jpeg:101"
                            << "degradation: jpeg:101: needs a number from 1 to 100 after jpeg:";
  QTest::newRow("not a number")
      << "noise:nan"
      << "degradation: noise:nan: needs a number from 0 to 255 after noise:";
  QTest::newRow("more behind it")
      << "blur:1x"
      << "degradation: blur:1x: needs a number from 0 to 100 after blur:";
  QTest::newRow("unknown") << "fog:1"
                           << "degradation: fog:1: is not jpeg:QUALITY, noise:SIGMA or blur:SIGMA";
}

void TestDegradation::words() {
  QFETCH(QString, how);
  QTEST(errorOf([&] { (void)parseDegradation(how.toStdString()); }), "line");
}

QTEST_GUILESS_MAIN(TestDegradation)
#include "test_degradation.moc"
