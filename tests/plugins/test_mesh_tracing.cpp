// SPDX-License-Identifier: BSD-3-Clause
// Tests which surface a ray meets: against a caster in double precision, against closed forms, and
// that no ray's result depends on the others of its call.
#include <QTest>
#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>
#include <thread>

#include "tests/plugins/caster.h"
#include "tests/plugins/mesh_scene.h"

using namespace hogelscope;
using namespace hogelscope::test;

namespace {

using Rays = std::vector<plugin::Ray>;

double uniform(std::mt19937& random, double from, double to) {
  return from + (to - from) * double(random()) / 4294967296.0;
}

/// Rays in blocks of 4 × 4, as neighbouring texels are; on the grids of a display whose numbers are
/// powers of two they hit corners and edges exactly.
Rays gridRays(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  Rays rays;
  while (rays.size() < count) {
    const double a = (int(random() % 33) - 16) / 32.0;
    const double b = (int(random() % 33) - 16) / 32.0;
    const double x = (int(random() % 64) - 32) / 64.0;
    const double y = (int(random() % 64) - 32) / 64.0;
    for (int k = 0; k < 16; ++k) {
      const double slope = a + k % 2 / 32.0;
      rays.push_back({x + k % 4 / 64.0 + slope, y + double(k / 4) / 64 + b, 1, slope, b, 4});
    }
  }
  return rays;
}

Rays randomRays(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  Rays rays;
  for (std::size_t k = 0; k < count; ++k) {
    const double a = uniform(random, -0.6, 0.6);
    const double b = uniform(random, -0.6, 0.6);
    rays.push_back({uniform(random, -0.6, 0.6) + a, uniform(random, -0.6, 0.6) + b, 1, a, b, 4});
  }
  return rays;
}

/// Triangles anywhere, each of its own colour; `grid` puts corners on multiples of 1/32.
Gltf soup(int count, bool grid) {
  std::mt19937 random(7);
  std::vector<float> points;
  std::vector<float> colours;
  for (int k = 0; k < count; ++k) {
    const Vec3 middle{uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5),
                      uniform(random, -0.5, 0.5)};
    const double red = uniform(random, 0, 1);
    for (int corner = 0; corner < 3; ++corner) {
      for (const double x : {middle.x, middle.y, middle.z}) {
        const double place = x + uniform(random, -0.12, 0.12);
        points.push_back(float(grid ? std::round(place * 32) / 32 : place));
      }
      colours.insert(colours.end(), {float(red), float(k) / float(count), 0.5F});
    }
  }
  Gltf gltf;
  gltf.triangles(points);
  gltf.lastAttributes()["COLOR_0"] = gltf.accessor(colours, 5126, "VEC3", 3);
  return gltf;
}

/// A closed surface of hills whose corners stand under the grid's rays, a colour for each corner.
Gltf hills(int n) {
  std::vector<float> points;
  std::vector<float> colours;
  std::vector<std::uint32_t> corners;
  for (int k = 0; k <= n * (n + 2); ++k) {
    const int i = k % (n + 1);
    const int j = k / (n + 1);
    points.insert(points.end(), {float(i) / float(n) - 0.5F, float(j) / float(n) - 0.5F,
                                 -float((i * 7 + j * 13) % 5) / 32});
    colours.insert(colours.end(), {float(i % 7) / 7, float(j % 5) / 5, float(k % 3) / 3});
  }
  const auto at = [&](int i, int j) { return std::uint32_t(j * (n + 1) + i); };
  for (int k = 0; k < n * n; ++k) {
    const int i = k % n;
    const int j = k / n;
    for (const auto c :
         {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
      corners.push_back(c);
  }
  Gltf gltf;
  gltf.triangles(points);
  gltf.lastAttributes()["COLOR_0"] = gltf.accessor(colours, 5126, "VEC3", 3);
  gltf.json["meshes"][0]["primitives"][0]["indices"] = gltf.accessor(corners, 5125, "SCALAR", 1);
  return gltf;
}

/// Cards in few planes, over each other: which is met first is anybody's guess, but one.
Gltf cardsInPlanes() {
  std::mt19937 random(3);
  Gltf gltf;
  for (int k = 0; k < 60; ++k) {
    const auto step = [&](int n) { return float(random() % unsigned(n)) / 64; };
    const float x = step(48) - 0.375F;
    const float y = step(48) - 0.375F;
    gltf.card(x, y, x + step(16) + 1 / 64.0F, y + step(16) + 1 / 64.0F, step(4),
              gltf.material(step(64), step(64), step(64)));
  }
  return gltf;
}

using Colours = std::vector<plugin::Colour>;

bool isSame(const plugin::Colour& a, const plugin::Colour& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

Colours trace(const mesh::MeshSource& source, const Rays& rays) {
  Colours colours(rays.size());
  source.trace(rays, colours);
  return colours;
}

/// Traces in other orders and groups, and counts the rays whose result has other bits.
std::size_t differing(const mesh::MeshSource& source, const Rays& rays) {
  const Colours whole = trace(source, rays);
  std::vector<std::size_t> order(rays.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  Rays shuffled;
  for (const std::size_t k : order) shuffled.push_back(rays[k]);
  const Colours other = trace(source, shuffled);
  std::size_t count = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    plugin::Colour alone;
    source.trace({&rays[k], 1}, {&alone, 1});
    if (!isSame(other[k], whole[order[k]])) ++count;
    if (!isSame(alone, whole[k])) ++count;
  }
  return count;
}

/// Compares depths and colours with the caster's; rays that pass an edge may see either side.
void compareWithCaster(const Scene& scene, const Rays& rays) {
  const plugin::Triangles shown = scene.source.triangles();
  const Colours seen = trace(scene.source, rays);
  std::size_t edges = 0;
  std::size_t hits = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto met = cast(shown, rays[k]);
    if (passesEdge(shown, rays[k], 2e-6)) {
      ++edges;
      continue;
    }
    const double z = scene.depth(rays[k]);
    QCOMPARE(!std::isnan(z), met.has_value());
    if (!met) continue;
    ++hits;
    QVERIFY2(std::abs(z - met->z) < 1e-6, qPrintable(QString::number(k)));
    if (met->gap < 1e-6) continue;  // two in one plane
    const std::uint8_t* code = &shown.colours[3 * std::size_t(shown.corners[3 * met->triangle])];
    QVERIFY(std::abs(seen[k].g - float(code[1])) < 0.6F);
    QVERIFY(std::abs(seen[k].r - float(code[0])) < 0.6F);
  }
  QVERIFY(hits > rays.size() / 5);
  QVERIFY(edges < rays.size() / 3);
}

}  // namespace

class TestMeshTracing : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void agreesWithTheCaster();
  void aBallOfTriangles();
  void aCardBeforeAWall();
  void aCardInThePanel();
  void repeatedTrianglesAreDropped();
  void raysDoNotDependOnEachOther_data();
  void raysDoNotDependOnEachOther();
  void threadsDoNotMatter();
  void raysThatMissSeeTheBackground();
  void depthsOfHits();
  void theSampleRoom();
};

void TestMeshTracing::agreesWithTheCaster() {
  Scene scene;
  scene.open(soup(300, false), {{"shading", "unlit"}});
  compareWithCaster(scene, randomRays(4000, 1));
  scene.open(soup(300, true), {{"shading", "unlit"}});
  compareWithCaster(scene, gridRays(4000, 2));
}

/// n × 2n faces: the silhouette is within r(1 − cos(π/n)) of the ball's, and so are depths.
void TestMeshTracing::aBallOfTriangles() {
  constexpr int n = 40;
  constexpr double r = 0.2;
  std::vector<float> points;
  const auto add = [&](int i, int j) {
    const double s = std::numbers::pi * i / n;
    const double t = std::numbers::pi * j / n;
    for (const double x : {std::sin(s) * std::cos(t), std::cos(s), std::sin(s) * std::sin(t)})
      points.push_back(float(r * x));
  };
  for (int k = 0; k < 2 * n * n; ++k) {
    const int i = k / (2 * n);
    const int j = k % (2 * n);
    for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
      add(i + di, j + dj);
  }
  Gltf gltf;
  gltf.triangles(points);
  Scene scene;
  scene.open(gltf);
  const double inner = r * std::cos(std::numbers::pi / n);
  for (const plugin::Ray& ray : randomRays(20000, 3)) {
    const double z = scene.depth(ray);
    // The ball along the line (x, y) + (a, b) z: z² + |(x, y) + (a, b) z|² = r².
    const double px = ray.x - ray.a;
    const double py = ray.y - ray.b;
    const double square = 1 + ray.a * ray.a + ray.b * ray.b;
    const double half = px * ray.a + py * ray.b;
    const auto depth = [&](double radius) {
      const double root = half * half - square * (px * px + py * py - radius * radius);
      return (std::sqrt(root) - half) / square;  // NaN where the line misses
    };
    if (std::isnan(z)) {
      QVERIFY(std::isnan(depth(inner)));
    } else {
      QVERIFY(z <= depth(r + 1e-7) + 1e-6);
      if (!std::isnan(depth(inner))) QVERIFY(z >= depth(inner) - 1e-6);
    }
  }
}

/// Which texels see the card follows from |x + z a − c| < w/2.
void TestMeshTracing::aCardBeforeAWall() {
  Gltf gltf;
  gltf.card(-1, -1, 1, 1, -0.3F, gltf.material(0, 0, 1));
  gltf.card(-0.07F, -0.11F, 0.13F, 0.09F, 0.08F, gltf.material(1, 0, 0));
  Scene scene;
  scene.open(gltf, {{"shading", "unlit"}});
  const Rays rays = randomRays(50000, 4);
  const Colours seen = trace(scene.source, rays);
  std::size_t cards = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const plugin::Ray& ray = rays[k];
    const double x = ray.x + ray.a * (0.08 - ray.z);
    const double y = ray.y + ray.b * (0.08 - ray.z);
    const double inside = std::min(0.1 - std::abs(x - 0.03), 0.1 - std::abs(y + 0.01));
    if (std::abs(inside) < 1e-6) continue;  // the card's edge in single precision
    const bool isWall = std::abs(ray.x + ray.a * (-0.3 - ray.z)) < 1 &&
                        std::abs(ray.y + ray.b * (-0.3 - ray.z)) < 1;
    if (inside > 0) ++cards;
    QCOMPARE(seen[k].r, inside > 0 ? 255.0F : 0.0F);
    if (inside < 0 && isWall) QCOMPARE(seen[k].b, 255.0F);
    if (inside > 0) QVERIFY(std::abs(scene.depth(ray) - 0.08) < 1e-6);
  }
  QVERIFY(cards > 1000);
}

/// Turned in the panel's plane and back by rounding, every ray still meets it.
void TestMeshTracing::aCardInThePanel() {
  Gltf gltf;
  gltf.card(-1, -1, 1, 1, 0);
  Scene scene;
  scene.open(gltf, {{"orientation", {0, 7, 0}}});
  scene.add("turned.glb", gltf.glb());
  for (const plugin::Ray& ray : randomRays(20000, 5)) QVERIFY(!std::isnan(scene.depth(ray)));
}

void TestMeshTracing::repeatedTrianglesAreDropped() {
  Gltf gltf;
  const int red = gltf.material(1, 0, 0);
  const int blue = gltf.material(0, 0, 1);
  gltf.triangles({0, 0, 0, 1, 0, 0, 0, 1, 0}, red);
  gltf.triangles({0, 1, 0, -0.0F, 0, 0, 1, 0, 0}, blue);
  gltf.triangles({0, 0, -1, 1, 0, -1, 0, 1, -1}, blue);
  Scene scene;
  scene.open(gltf, {{"shading", "unlit"}});
  QCOMPARE(scene.source.triangles().corners, (std::vector<std::uint32_t>{0, 1, 2, 6, 7, 8}));
  QCOMPARE(scene.see(0.2, 0.2).r, 255.0F);
}

void TestMeshTracing::raysDoNotDependOnEachOther_data() {
  QTest::addColumn<int>("number");
  QTest::addColumn<QString>("shading");
  for (const QString shading : {"unlit", "lambert"})
    for (const int number : {0, 1, 2, 3})
      QTest::addRow("scene %d %s", number, qPrintable(shading)) << number << shading;
}

void TestMeshTracing::raysDoNotDependOnEachOther() {
  QFETCH(const int, number);
  QFETCH(const QString, shading);
  Scene scene;
  scene.open(number == 0   ? soup(20000, false)
             : number == 1 ? soup(2000, true)
             : number == 2 ? hills(64)
                           : cardsInPlanes(),
             {{"shading", shading.toStdString()}});
  QCOMPARE(differing(scene.source, gridRays(30000, 6)), std::size_t(0));
  QCOMPARE(differing(scene.source, randomRays(20000, 7)), std::size_t(0));
}

void TestMeshTracing::threadsDoNotMatter() {
  Scene scene;
  scene.open(hills(64));
  const Rays rays = gridRays(100000, 8);
  const Colours one = trace(scene.source, rays);
  Colours two(rays.size());
  {
    const auto part = [&](std::size_t first, std::size_t count) {
      scene.source.trace(std::span(rays).subspan(first, count),
                         std::span(two).subspan(first, count));
    };
    const std::size_t half = rays.size() / 2 + 5;
    std::jthread first([&] { part(0, half); });
    std::jthread second([&] { part(half, rays.size() - half); });
  }
  for (std::size_t k = 0; k < rays.size(); ++k) QVERIFY(isSame(two[k], one[k]));
}

void TestMeshTracing::raysThatMissSeeTheBackground() {
  Gltf gltf;
  gltf.card(0, 0, 0.1F, 0.1F, -0.2F);
  Scene scene;
  scene.open(gltf, {{"background", {1, 2, 3}}});
  const plugin::Colour background = scene.see(0.2, 0.2);
  QCOMPARE(background.r, 1.0F);
  QCOMPARE(background.b, 3.0F);
  QVERIFY(
      isSame(scene.see({0.05, 0.05, 1, 0, 0, 1.1}), background));  // its reach ends before the card
}

/// As the caster has them, and NaN for the background.
void TestMeshTracing::depthsOfHits() {
  Scene scene;
  scene.open(soup(200, false));
  const plugin::Triangles shown = scene.source.triangles();
  const Rays rays = randomRays(3000, 5);
  std::vector<double> depths(rays.size(), 9);
  QVERIFY(scene.source.traceDepths(rays, depths));
  std::size_t missed = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    if (passesEdge(shown, rays[k], 1e-5)) continue;
    const auto met = cast(shown, rays[k]);
    missed += met ? 0 : 1;
    QVERIFY(met ? std::abs(depths[k] - met->z) < 1e-6 : std::isnan(depths[k]));
  }
  QVERIFY(missed > 100 && missed < rays.size() - 100);
}

void TestMeshTracing::theSampleRoom() {
  Scene scene;
  scene.open({{"file", HOGELSCOPE_SOURCE_DIR "/data/room.glb"}});
  double back = 0;
  double front = 0;
  scene.source.depths(back, front);
  QVERIFY(back < -0.2 && front > 0.05);
  QCOMPARE(differing(scene.source, gridRays(100000, 9)), std::size_t(0));
}

QTEST_GUILESS_MAIN(TestMeshTracing)
#include "test_mesh_tracing.moc"
