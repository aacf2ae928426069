// SPDX-License-Identifier: BSD-3-Clause
// Tests the FLIP plugin against the means of the authors' own tool, against sums written out over
// each filter's square, and at its limits.
#include <QFile>
#include <QTest>
#include <cmath>
#include <numbers>

#include "io/plugins/plugin_library.h"
#include "tests/core/random.h"
#include "tests/io/images.h"

using namespace hogelscope;

namespace {

const QString data = HOGELSCOPE_SOURCE_DIR "/../shared/data/flip/";

struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
  std::vector<std::uint8_t> seen{};

  [[nodiscard]] plugin::View view() const { return {width, height, rgb, {}, seen}; }
};

using Three = std::array<double, 3>;

double linear(std::uint8_t code) {
  const double s = code / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// XYZ over white; the matrix of IEC 61966-2-1 with five digits.
Three xyzOf(const Three& c) {
  return {(0.41239 * c[0] + 0.35758 * c[1] + 0.18048 * c[2]) / 0.95045,
          0.21264 * c[0] + 0.71517 * c[1] + 0.07219 * c[2],
          (0.01933 * c[0] + 0.11919 * c[1] + 0.95053 * c[2]) / 1.08905};
}

Three rgbOf(const Three& opponent) {
  const double y = (opponent[0] + 16) / 116;
  const Three xyz{0.95045 * (y + opponent[1] / 500), y, 1.08905 * (y - opponent[2] / 200)};
  Three rgb{3.24096 * xyz[0] - 1.53737 * xyz[1] - 0.49861 * xyz[2],
            -0.96924 * xyz[0] + 1.87596 * xyz[1] + 0.04155 * xyz[2],
            0.05563 * xyz[0] - 0.20398 * xyz[1] + 1.05697 * xyz[2]};
  for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
  return rgb;
}

Three labOf(const Three& rgb) {
  const auto f = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  const Three xyz = xyzOf(rgb);
  const double lightness = 116 * f(xyz[1]) - 16;
  return {lightness, 0.01 * lightness * 500 * (f(xyz[0]) - f(xyz[1])),
          0.01 * lightness * 200 * (f(xyz[1]) - f(xyz[2]))};
}

double distance(const Three& a, const Three& b) {
  return std::abs(a[0] - b[0]) + std::sqrt(std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
}

double colourDifference(double hyAb) {
  const double most = std::pow(distance(labOf({0, 1, 0}), labOf({0, 0, 1})), 0.7);
  const double d = std::pow(hyAb, 0.7);
  return d < 0.4 * most ? 0.95 / (0.4 * most) * d
                        : 0.95 + (d - 0.4 * most) / (most - 0.4 * most) * 0.05;
}

/// A filter as a square of weights.
struct Square {
  int radius = 0;
  std::vector<double> weights;

  template <class Function>
  Square(int reach, Function function) : radius(reach) {
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x) weights.push_back(function(double(x), double(y)));
  }
  Square& balance() {
    double up = 0, down = 0;
    for (const double w : weights) (w > 0 ? up : down) += w;
    for (double& w : weights)
      if (w != 0) w /= w > 0 ? up : -down;
    return *this;
  }
};

template <class Value>
double filtered(const Pixels& pixels, const Square& square, int x, int y, Value value) {
  double sum = 0;
  std::size_t k = 0;
  for (int dy = -square.radius; dy <= square.radius; ++dy)
    for (int dx = -square.radius; dx <= square.radius; ++dx) {
      const int column = std::clamp(x + dx, 0, pixels.width - 1);
      const int row = std::clamp(y + dy, 0, pixels.height - 1);
      const std::uint8_t* p = &pixels.rgb[3 * std::size_t(row * pixels.width + column)];
      const Three xyz = xyzOf({linear(p[0]), linear(p[1]), linear(p[2])});
      sum += square.weights[k++] *
             value(Three{116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])});
    }
  return sum;
}

/// FLIP of a pixel by the paper's formulas.
double flipAt(const Pixels& a, const Pixels& b, int x, int y, double perDegree) {
  const double pi = std::numbers::pi;
  const std::array<std::array<double, 4>, 3> sensitivities{
      {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};
  const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * perDegree));
  std::array<Three, 2> seen{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto& [a1, b1, a2, b2] = sensitivities[channel];
    Square square(radius, [&](double dx, double dy) {
      const double z = (dx * dx + dy * dy) / (perDegree * perDegree);
      return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * z / b1) +
             a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * z / b2);
    });
    square.balance();
    const auto take = [channel](const Three& opponent) { return opponent[channel]; };
    seen[0][channel] = filtered(a, square, x, y, take);
    seen[1][channel] = filtered(b, square, x, y, take);
  }
  const double colour = colourDifference(distance(labOf(rgbOf(seen[0])), labOf(rgbOf(seen[1]))));
  const double deviation = 0.5 * 0.082 * perDegree;
  const int reach = int(std::ceil(3 * deviation));
  double feature = 0;
  for (const bool isPoint : {false, true}) {
    const auto weight = [&](double along, double across) {
      const double gauss =
          std::exp(-(along * along + across * across) / (2 * deviation * deviation));
      return isPoint ? (along * along / (deviation * deviation) - 1) * gauss : -along * gauss;
    };
    const Square right =
        Square(reach, [&](double dx, double dy) { return weight(dx, dy); }).balance();
    const Square down =
        Square(reach, [&](double dx, double dy) { return weight(dy, dx); }).balance();
    const auto grey = [](const Three& opponent) { return (opponent[0] + 16) / 116; };
    const auto strength = [&](const Pixels& pixels) {
      return std::hypot(filtered(pixels, right, x, y, grey), filtered(pixels, down, x, y, grey));
    };
    feature = std::max(feature, std::abs(strength(a) - strength(b)));
  }
  return std::pow(colour, 1 - std::sqrt(feature / std::sqrt(2.0)));
}

Pixels randomPixels(Random& random, int width, int height) {
  Pixels pixels{width, height, {}};
  for (int k = 0; k < 3 * width * height; ++k)
    pixels.rgb.push_back(std::uint8_t(random.integer(0, 255)));
  return pixels;
}

}  // namespace

class TestFlip : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void theAuthorsFigures();
  void writtenOut_data();
  void writtenOut();
  void evenPictures();
  void onlySeenPixels();
  void limits();

 private:
  [[nodiscard]] plugin::Figures flip(const Pixels& a, const Pixels& b, double perDegree) const {
    return m_metric->compareBoth(a.view(), b.view(), {perDegree, 1});
  }

  std::unique_ptr<plugin::Metric> m_metric;
};

void TestFlip::initTestCase() {
  m_metric = loadPlugin("flip", PluginKind::metric).makeMetric();
  QCOMPARE(m_metric->title(), "FLIP");
  QVERIFY(m_metric->hasSeen());
}

/// Means of FLIP 1.6 for perceived views, at three numbers of pixels per degree.
void TestFlip::theAuthorsFigures() {
  QFile table(data + "expected.csv");
  if (!table.open(QIODevice::ReadOnly)) QSKIP("no ../shared/data/flip here");
  const QList<QByteArray> lines = table.readAll().trimmed().split('\n');
  QVERIFY(lines.size() > 3);
  for (const QByteArray& line : lines.mid(1)) {
    const QList<QByteArray> cells = line.split(',');
    const auto read = [&](const char* which) {
      const QString file = data + QString::fromUtf8(cells[0]) + "_" + which + ".png";
      const QSize size = sizeOf(file);
      return Pixels{size.width(), size.height(), bytesOf(file)};
    };
    const double mean = flip(read("reference"), read("test"), cells[1].toDouble()).frame;
    QVERIFY2(std::abs(mean - cells[2].toDouble()) < 1e-4,
             qPrintable(QString("%1: %2").arg(QString::fromUtf8(line)).arg(mean)));
  }
}

void TestFlip::writtenOut_data() {
  QTest::addColumn<double>("perDegree");
  QTest::newRow("near") << 9.7;
  QTest::newRow("far") << 40.0;
  QTest::newRow("wider than the picture") << 150.0;
  QTest::newRow("pixels of a degree") << 1.0;
}

/// Small pictures: every filter reaches over their edges.
void TestFlip::writtenOut() {
  QFETCH(const double, perDegree);
  Random random(3);
  const Pixels a = randomPixels(random, 9, 6);
  Pixels b = a;
  for (int k = 0; k < 20; ++k)
    b.rgb[std::size_t(random.integer(0, 161))] = std::uint8_t(random.integer(0, 255));
  double sum = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) sum += flipAt(a, b, x, y, perDegree);
  const double expected = sum / double(a.width * a.height);
  const double found = flip(a, b, perDegree).frame;
  QVERIFY2(expected > 0.01 && std::abs(found - expected) < 2e-4,
           qPrintable(QString("%1 %2").arg(found).arg(expected)));
}

/// Without edges the colours alone count, and filters change nothing.
void TestFlip::evenPictures() {
  const auto even = [](std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    Pixels pixels{7, 5, {}};
    for (int k = 0; k < 35; ++k) pixels.rgb.insert(pixels.rgb.end(), {r, g, b});
    return pixels;
  };
  QVERIFY(flip(even(200, 10, 60), even(200, 10, 60), 30).frame < 1e-9);
  const double grey = 0.95 / (0.4 * std::pow(distance(labOf({0, 1, 0}), labOf({0, 0, 1})), 0.7)) *
                      std::pow(labOf({linear(120), linear(120), linear(120)})[0] -
                                   labOf({linear(100), linear(100), linear(100)})[0],
                               0.7);
  QVERIFY(std::abs(flip(even(120, 120, 120), even(100, 100, 100), 30).frame - grey) < 1e-4);
  QVERIFY(std::abs(flip(even(0, 255, 0), even(0, 0, 255), 30).frame - 1) < 1e-4);
}

void TestFlip::onlySeenPixels() {
  Random random(5);
  Pixels a = randomPixels(random, 8, 8), b = randomPixels(random, 8, 8);
  a.seen.assign(64, 0);
  b.seen.assign(64, 255);
  const plugin::Figures none = flip(a, b, 20);
  QVERIFY(std::isnan(none.seen) && none.frame > 0.1);
  a.seen[27] = a.seen[28] = 255;
  b.seen[28] = 0;
  const double expected = flipAt(a, b, 3, 3, 20);
  QVERIFY(std::abs(flip(a, b, 20).seen - expected) < 1e-3);
  QCOMPARE(flip(a, b, 20).frame, none.frame);
  QCOMPARE(m_metric->compare(a.view(), b.view(), {20, 1}), none.frame);
}

void TestFlip::limits() {
  Random random(7);
  const Pixels a = randomPixels(random, 3, 2), b = randomPixels(random, 3, 2);
  for (const double perDegree : {std::nan(""), 0.0, -3.0, 0.99, 2001.0, 1e300})
    QVERIFY(std::isnan(flip(a, b, perDegree).frame));
  for (const double perDegree : {1.0, 2000.0}) {
    const double mean = flip(a, b, perDegree).frame;
    QVERIFY(mean > 0 && mean <= 1);
  }
  const Pixels one = randomPixels(random, 1, 1);
  QVERIFY(flip(one, one, 60).frame < 1e-9);
}

QTEST_APPLESS_MAIN(TestFlip)
#include "test_flip.moc"
