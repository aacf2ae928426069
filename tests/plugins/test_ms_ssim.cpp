// SPDX-License-Identifier: BSD-3-Clause
// Tests the MS-SSIM plugin against sums written out over each window, against figures of numpy and
// scipy (ms_ssim.py), and at its limits.
#include <QTest>
#include <array>
#include <cmath>

#include "io/plugins/plugin_library.h"

using namespace hogelscope;

namespace {

struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  [[nodiscard]] plugin::View view() const { return {width, height, rgb, {}, {}}; }
};

/// The pictures of ms_ssim.py.
Pixels bars(int width, int height) {
  Pixels pixels{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        pixels.rgb.push_back(
            std::uint8_t((x * 3 + y * (c + 1) + 40 * ((x / 16 + y / 16) % 2)) % 256));
  return pixels;
}

Pixels noisy(Pixels pixels, std::uint32_t seed, int share) {
  for (std::uint8_t& value : pixels.rgb) {
    seed = 1664525 * seed + 1013904223;
    value = std::uint8_t((value * (8 - share) + int(seed >> 24U) * share) / 8);
  }
  return pixels;
}

using Grey = std::vector<std::vector<double>>;

Grey lumaOf(const Pixels& pixels) {
  Grey luma(std::size_t(pixels.height), std::vector<double>(std::size_t(pixels.width)));
  for (std::size_t y = 0; y < luma.size(); ++y)
    for (std::size_t x = 0; x < luma[y].size(); ++x) {
      const std::uint8_t* p = &pixels.rgb[3 * (y * luma[y].size() + x)];
      luma[y][x] = 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
    }
  return luma;
}

Grey halved(const Grey& from) {
  const std::size_t rows = from.size();
  const std::size_t columns = from[0].size();
  Grey half((rows + 1) / 2, std::vector<double>((columns + 1) / 2));
  for (std::size_t y = 0; y < 2 * half.size(); ++y)
    for (std::size_t x = 0; x < 2 * half[0].size(); ++x)
      half[y / 2][x / 2] += from[std::min(y, rows - 1)][std::min(x, columns - 1)] / 4;
  return half;
}

/// Means over all windows of luminance · contrast · structure, and of the latter two: variances by
/// their definition, about the window's own mean.
std::array<double, 2> similarities(const Grey& a, const Grey& b) {
  double total = 0;
  for (int y = -5; y <= 5; ++y)
    for (int x = -5; x <= 5; ++x) total += std::exp(-(x * x + y * y) / 4.5);
  std::array<double, 2> sums{};
  std::size_t count = 0;
  for (std::size_t top = 0; top + 11 <= a.size(); ++top)
    for (std::size_t left = 0; left + 11 <= a[0].size(); ++left, ++count) {
      const auto overWindow = [&](auto value) {
        double sum = 0;
        for (int y = 0; y < 11; ++y)
          for (int x = 0; x < 11; ++x)
            sum += std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / 4.5) / total *
                   value(a[top + std::size_t(y)][left + std::size_t(x)],
                         b[top + std::size_t(y)][left + std::size_t(x)]);
        return sum;
      };
      const double ma = overWindow([](double p, double) { return p; });
      const double mb = overWindow([](double, double q) { return q; });
      const double va = overWindow([&](double p, double) { return (p - ma) * (p - ma); });
      const double vb = overWindow([&](double, double q) { return (q - mb) * (q - mb); });
      const double both = overWindow([&](double p, double q) { return (p - ma) * (q - mb); });
      const double cs = (2 * both + 58.5225) / (va + vb + 58.5225);
      sums[0] += cs * (2 * ma * mb + 6.5025) / (ma * ma + mb * mb + 6.5025);
      sums[1] += cs;
    }
  return {sums[0] / double(count), sums[1] / double(count)};
}

double bruteForce(const Pixels& reference, const Pixels& test) {
  constexpr std::array<double, 5> weights{0.0448, 0.2856, 0.3001, 0.2363, 0.1333};
  Grey a = lumaOf(reference);
  Grey b = lumaOf(test);
  double product = 1;
  for (std::size_t scale = 0; scale < 5; ++scale) {
    product *= std::pow(similarities(a, b)[scale == 4 ? 0 : 1], weights[scale]);
    a = halved(a);
    b = halved(b);
  }
  return product;
}

}  // namespace

class TestMsSsim : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { m_metric = loadPlugin("ms-ssim", PluginKind::metric).makeMetric(); }
  void namesItself();
  void asSumsOverWindows();
  void asNumpy_data();
  void asNumpy();
  void ofCopies();
  void ofOpposites();
  void ofSmallPictures();

 private:
  [[nodiscard]] double compare(const Pixels& reference, const Pixels& test) const {
    return m_metric->compare(reference.view(), test.view(), {});
  }

  std::unique_ptr<plugin::Metric> m_metric;
};

void TestMsSsim::namesItself() {
  QCOMPARE(QString(m_metric->title()), QString("MS\u2011SSIM"));
  QCOMPARE(QString(m_metric->unit()), QString());
  QCOMPARE(m_metric->decimals(), 4);
}

void TestMsSsim::asSumsOverWindows() {
  for (const int share : {1, 3, 7}) {
    const Pixels reference = bars(163, 162);
    const Pixels test = noisy(reference, 5, share);
    const double figure = compare(reference, test);
    QVERIFY2(std::abs(figure - bruteForce(reference, test)) < 1e-12,
             qPrintable(QString::number(figure)));
  }
}

void TestMsSsim::asNumpy_data() {
  QTest::addColumn<int>("width");
  QTest::addColumn<int>("height");
  QTest::addColumn<int>("share");
  QTest::addColumn<double>("figure");
  QTest::newRow("little noise") << 176 << 176 << 1 << 0.9813823199750763;
  QTest::newRow("much noise, odd") << 200 << 161 << 4 << 0.7151977442375695;
  QTest::newRow("some noise, odd") << 255 << 177 << 2 << 0.9256626297793177;
}

void TestMsSsim::asNumpy() {
  QFETCH(int, width);
  QFETCH(int, height);
  QFETCH(int, share);
  QFETCH(double, figure);
  const Pixels reference = bars(width, height);
  QVERIFY(std::abs(compare(reference, noisy(reference, 7, share)) - figure) < 1e-12);
}

/// Exactly 1, and the same both ways round.
void TestMsSsim::ofCopies() {
  const Pixels reference = bars(200, 180);
  const Pixels test = noisy(reference, 3, 2);
  QCOMPARE(compare(reference, reference), 1.0);
  QCOMPARE(compare(test, reference), compare(reference, test));
}

/// A negative has contrasts below 0, which count as 0.
void TestMsSsim::ofOpposites() {
  const Pixels reference = bars(176, 176);
  Pixels negative = reference;
  for (std::uint8_t& value : negative.rgb) value = std::uint8_t(255 - value);
  QCOMPARE(compare(reference, negative), 0.0);
}

void TestMsSsim::ofSmallPictures() {
  QVERIFY(compare(bars(161, 161), bars(161, 161)) == 1);
  QVERIFY(std::isnan(compare(bars(160, 161), bars(160, 161))));
  QVERIFY(std::isnan(compare(bars(300, 160), bars(300, 160))));
  QVERIFY(std::isnan(compare(bars(1, 1), bars(1, 1))));
  QVERIFY(std::isnan(compare({}, {})));
}

QTEST_GUILESS_MAIN(TestMsSsim)
#include "test_ms_ssim.moc"
