// SPDX-License-Identifier: BSD-3-Clause
// Tests the patterns of --generate against their formulas, pixel by pixel.
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/content/pattern_list.h"
#include "core/content/sphere_pattern.h"

using namespace hogelscope;

namespace {

PanelParams display(int nx, int ny, int du, int dv,
                    HogelLensModel lens = HogelLensModel::rectilinear) {
  PanelParams params;
  params.size = {0.4, 0.3};
  params.hogels = {nx, ny};
  params.directions = {du, dv};
  params.fov = {70, 50};
  params.lens = lens;
  return params;
}

/// The whole hogel image.
std::vector<std::uint8_t> imageOf(const Pattern& pattern, const PanelParams& params) {
  const LightFieldSize size = Display(params).size();
  std::vector<std::uint8_t> image(3 * size.width() * size.height());
  for (int y = 0; y < int(size.height()); ++y)
    pattern.row(y, &image[3 * size.width() * std::size_t(y)]);
  return image;
}

const std::uint8_t* at(const std::vector<std::uint8_t>& image, const PanelParams& params, int i,
                       int j, int u, int v) {
  const std::size_t width = std::size_t(params.hogels[0]) * std::size_t(params.directions[0]);
  const std::size_t x = std::size_t(i) * std::size_t(params.directions[0]) + std::size_t(u);
  const std::size_t y = std::size_t(j) * std::size_t(params.directions[1]) + std::size_t(v);
  return &image[3 * (y * width + x)];
}

}  // namespace

class TestPatterns : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void codes();
  void crosstalk();
  void checkerboard();
  void edge();
  void spheres_data();
  void spheres();
  void refused();
};

void TestPatterns::codes() {
  const PanelParams params = display(5, 3, 300, 2);
  const auto directions = imageOf(*makePattern("directions", params, {}), params);
  const auto hogels = imageOf(*makePattern("hogels", params, {}), params);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 3; ++j)
      for (int u = 0; u < 300; u += 7)
        for (int v = 0; v < 2; ++v) {
          const std::uint8_t* d = at(directions, params, i, j, u, v);
          QCOMPARE(d[0] + 256 * (d[2] % 16), u);
          QCOMPARE(d[1] + 256 * (d[2] / 16), v);
          const std::uint8_t* h = at(hogels, params, i, j, u, v);
          QCOMPARE(h[0] + 256 * (h[2] % 16), i);
          QCOMPARE(h[1] + 256 * (h[2] / 16), j);
        }
}

void TestPatterns::crosstalk() {
  const PanelParams params = display(2, 2, 5, 2);
  const auto image = imageOf(*makePattern("crosstalk", params, {}), params);
  for (int u = 0; u < 5; ++u) {
    const std::uint8_t* c = at(image, params, 1, 1, u, 0);
    QCOMPARE(int(c[0]), u < 2.5 ? 255 : 0);
    QCOMPARE(int(c[1]), 0);
    QCOMPARE(int(c[2]), u < 2.5 ? 0 : 255);
  }
}

/// From docs/formulas.md, Display, not by its code.
void TestPatterns::checkerboard() {
  const PanelParams params = display(8, 6, 10, 12);
  const double depth = -0.07;
  const auto image = imageOf(*makePattern("checkerboard", params, {depth, 0.05, 0}), params);
  int white = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 6; ++j)
      for (int u = 0; u < 10; ++u)
        for (int v = 0; v < 12; ++v) {
          const double a = 2 * std::tan(35 * M_PI / 180) * ((u + 0.5) / 10 - 0.5);
          const double b = 2 * std::tan(25 * M_PI / 180) * (0.5 - (v + 0.5) / 12);
          const double x = 0.4 * ((i + 0.5) / 8 - 0.5) + depth * a;
          const double y = 0.3 * (0.5 - (j + 0.5) / 6) + depth * b;
          const auto cell = long(std::floor(x / 0.025)) + long(std::floor(y / 0.025));
          const int expected = cell % 2 == 0 ? 255 : 0;
          QCOMPARE(int(*at(image, params, i, j, u, v)), expected);
          white += expected == 255 ? 1 : 0;
        }
  QVERIFY(white > 2000 && white < 3700);
}

/// At its depth the edge is where a viewer sees it from everywhere, turned by its angle.
void TestPatterns::edge() {
  const PanelParams params = display(40, 30, 9, 7);
  const double angle = 10;
  const auto image = imageOf(*makePattern("edge", params, {0.1, 1, angle}), params);
  const Display geometry(params);
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 30; ++j)
      for (int u = 0; u < 9; ++u)
        for (int v = 0; v < 7; ++v) {
          const PanelRay ray = geometry.rayOf({i, j, u, v});
          const double x = ray.position.x + 0.1 * ray.slopes.x;
          const double y = ray.position.y + 0.1 * ray.slopes.y;
          const double edgeX = -y * std::tan(angle * M_PI / 180);  // leans to the left, upwards
          if (std::abs(x - edgeX) < 1e-9) continue;
          QCOMPARE(int(*at(image, params, i, j, u, v)), x < edgeX ? 64 : 191);
        }
}

void TestPatterns::spheres_data() {
  QTest::addColumn<int>("lens");
  QTest::newRow("rectilinear") << int(HogelLensModel::rectilinear);
  QTest::newRow("equiangular") << int(HogelLensModel::equiangular);
}

/// Runs of slopes against tracing every ray.
void TestPatterns::spheres() {
  QFETCH(int, lens);
  const PanelParams params = display(24, 18, 40, 30, HogelLensModel(lens));
  const SpherePattern pattern(params, {});
  const auto image = imageOf(pattern, params);
  int lit = 0;
  int different = 0;
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 18; ++j)
      for (int u = 0; u < 40; ++u)
        for (int v = 0; v < 30; ++v) {
          const auto expected = pattern.texel({i, j, u, v});
          const std::uint8_t* c = at(image, params, i, j, u, v);
          different += std::equal(expected.begin(), expected.end(), c) ? 0 : 1;
          lit += expected[0] > 0 ? 1 : 0;
        }
  QVERIFY2(lit > 50000 && lit < 400000, qPrintable(QString::number(lit)));
  QCOMPARE(different, 0);
}

void TestPatterns::refused() {
  QVERIFY_THROWS_EXCEPTION(InputError, makePattern("directions", display(2, 2, 4097, 2), {}));
  QVERIFY_THROWS_EXCEPTION(InputError, makePattern("hogels", display(2, 4097, 2, 2), {}));
  QVERIFY_THROWS_EXCEPTION(InputError, makePattern("edge", display(0, 0, 2, 2), {}));
  QVERIFY_THROWS_EXCEPTION(InputError, makePattern("none", display(2, 2, 2, 2), {}));
}

QTEST_APPLESS_MAIN(TestPatterns)
#include "test_patterns.moc"
