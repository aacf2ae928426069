// SPDX-License-Identifier: BSD-3-Clause
// Tests the colours of the mesh plugin against closed forms: base colours, textures, their mip
// levels, lamps and shadows.
#include <QTest>
#include <cmath>
#include <numbers>

#include "tests/plugins/mesh_scene.h"

using namespace hogelscope;
using namespace hogelscope::test;

namespace {

/// sRGB's formula, written once more.
double codeOf(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}
double linearOf(double code) {
  const double x = code / 255;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

std::vector<std::uint8_t> randomPixels(int count) {
  std::vector<std::uint8_t> pixels;
  std::uint32_t state = 5;
  for (int k = 0; k < 3 * count; ++k) {
    state = state * 1664525U + 1013904223U;
    pixels.push_back(std::uint8_t(state >> 24U));
  }
  return pixels;
}

int wrapped(int k, int n, int wrap) {
  if (wrap == 33071) return std::clamp(k, 0, n - 1);
  const int period = wrap == 10497 ? n : 2 * n;
  const int place = ((k % period) + period) % period;
  return place < n ? place : period - 1 - place;
}

/// The red of a picture at a place in texels from its corner, bilinear in linear light.
double bilinear(const std::vector<std::uint8_t>& rgb, int width, int height, double x, double y,
                int wrapS, int wrapT) {
  const int left = int(std::floor(x - 0.5));
  const int top = int(std::floor(y - 0.5));
  double sum = 0;
  for (int j = top; j <= top + 1; ++j)
    for (int i = left; i <= left + 1; ++i) {
      const double weight = (1 - std::abs(x - 0.5 - i)) * (1 - std::abs(y - 0.5 - j));
      const int texel = wrapped(j, height, wrapT) * width + wrapped(i, width, wrapS);
      sum += weight * linearOf(rgb[3 * std::size_t(texel)]);
    }
  return codeOf(sum);
}

void compare(double found, double expected, double tolerance = 0.02) {
  QVERIFY2(std::abs(found - expected) < tolerance,
           qPrintable(QString("%1 instead of %2").arg(found).arg(expected)));
}

}  // namespace

class TestMeshShading : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void baseColoursAreLinear();
  void vertexColoursBlend();
  void interlacedTextures();
  void texturesAreBilinear_data();
  void texturesAreBilinear();
  void farTexturesAreMeans();
  void texturesAreTransformed();
  void aTurnedTexture();
  void emittedLight();
  void aHeadlightLightsBothSides();
  void aPointLightFallsWithTheSquare();
  void aSpotEndsAtItsCone();
  void normalsBlend();
  void shadowsEndWhereTheyMust();
  void shadowsDoNotFallOnTheirOwnSurface();
  void unlitMaterialsStayUnlit();
  void scaleChangesNoLight();
};

void TestMeshShading::baseColoursAreLinear() {
  Gltf gltf;
  gltf.card(-1, -1, 1, 1, 0, gltf.material(0.5, 0.001, 1));
  Scene scene;
  scene.open(gltf, {{"shading", "unlit"}});
  const plugin::Colour colour = scene.see(0.1, 0.2);
  compare(colour.r, codeOf(0.5));
  compare(colour.g, codeOf(0.001));
  compare(colour.b, 255);
}

void TestMeshShading::vertexColoursBlend() {
  Gltf gltf;
  gltf.triangles({0, 0, 0, 1, 0, 0, 0, 1, 0}, gltf.material(0.5, 1, 1));
  const std::vector<std::uint8_t> codes{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255};
  gltf.lastAttributes()["COLOR_0"] = gltf.accessor(codes, 5121, "VEC4", 4);
  gltf.json["accessors"].back()["normalized"] = true;
  Scene scene;
  scene.open(gltf, {{"shading", "unlit"}});
  const plugin::Colour colour = scene.see(0.2, 0.3);
  compare(colour.r, codeOf(0.5 * 0.5));
  compare(colour.g, codeOf(0.2));
  compare(colour.b, codeOf(0.3));
}

void TestMeshShading::interlacedTextures() {
  const std::vector<std::uint8_t> pixels = randomPixels(13 * 11);
  std::vector<plugin::Colour> seen;
  for (const bool isInterlaced : {false, true}) {
    Gltf gltf;
    gltf.card(0, 0, 13, 11, 0, gltf.textured(makePng(13, 11, pixels, isInterlaced)));
    Scene scene;
    scene.open(gltf, {{"shading", "unlit"}});
    for (int k = 0; k < 13 * 11; ++k) seen.push_back(scene.see(k % 13 + 0.4, k / 13 + 0.3));
  }
  for (std::size_t k = 0; k < 13 * 11; ++k) QCOMPARE(seen[k].g, seen[k + 13 * 11].g);
}

void TestMeshShading::texturesAreBilinear_data() {
  QTest::addColumn<int>("wrapS");
  QTest::addColumn<int>("wrapT");
  QTest::newRow("repeat, mirror") << 10497 << 33648;
  QTest::newRow("clamp, repeat") << 33071 << 10497;
  QTest::newRow("mirror, clamp") << 33648 << 33071;
}

/// A picture of 5 × 3 texels on a card of 5 m × 3 m, with uv −1 … 2.
void TestMeshShading::texturesAreBilinear() {
  QFETCH(const int, wrapS);
  QFETCH(const int, wrapT);
  const std::vector<std::uint8_t> pixels = randomPixels(15);
  Gltf gltf;
  gltf.card(0, 0, 15, 9, 0, gltf.textured(makePng(5, 3, pixels), wrapS, wrapT));
  const std::vector<float> uv{-1, 2, 2, 2, 2, -1, -1, 2, 2, -1, -1, -1};
  gltf.lastAttributes()["TEXCOORD_0"] = gltf.accessor(uv, 5126, "VEC2", 2);
  Scene scene;
  scene.open(gltf, {{"shading", "unlit"}});
  for (int k = 0; k < 500; ++k) {
    const double x = 0.01 + 0.0299 * k;
    const double y = std::fmod(0.37 * k, 8.9) + 0.05;
    const double expected = bilinear(pixels, 5, 3, x - 5, 9 - y - 3, wrapS, wrapT);
    compare(scene.see(x, y).r, expected, 0.05);
  }
}

/// A directional pixel's light is as wide as 2ⁿ texels: level n is the mean of 2ⁿ × 2ⁿ of them.
void TestMeshShading::farTexturesAreMeans() {
  constexpr int n = 64;
  const std::vector<std::uint8_t> pixels = randomPixels(n * n);
  Gltf gltf;
  const float half = n * 0.01F / 2;  // texels of 1 cm
  gltf.card(-half, -half, half, half, 0, gltf.textured(makePng(n, n, pixels), 33071, 33071));
  Scene scene;
  scene.panel = {{1.28, 1.28}, {128, 128}, {20, 20}, {0.05, 0.05}};  // hogels of 1 cm
  for (const auto& [z, block] : {std::pair{0.0, 1}, {-0.2, 2}, {-0.6, 4}, {0.6, 4}, {-1.4, 8}}) {
    scene.open(gltf, {{"shading", "unlit"}, {"position", {0, 0, z}}});
    for (int k = 0; k < n / block; ++k) {
      const int column = k;
      const int row = (5 * k) % (n / block);
      double mean = 0;
      for (int j = 0; j < block; ++j)
        for (int i = 0; i < block; ++i)
          mean += linearOf(pixels[3 * std::size_t((row * block + j) * n + column * block + i)]);
      const double x = (column + 0.5) * block * 0.01 - double(half);
      const double y = double(half) - (row + 0.5) * block * 0.01;
      compare(scene.see(x, y).r, codeOf(mean / (block * block)), 0.1);
    }
  }
}

/// T·R·S of KHR_texture_transform, and of a scale of 4 the level of texels a quarter as wide.
void TestMeshShading::texturesAreTransformed() {
  const std::vector<std::uint8_t> pixels = randomPixels(15);
  Gltf gltf;
  gltf.card(0, 0, 15, 9, 0, gltf.textured(makePng(5, 3, pixels)));
  Json& info = gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  info["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.3, -0.2}}, {"rotation", 0.5}, {"scale", {1.5, 0.7}}};
  Scene scene;
  scene.open(gltf, {{"shading", "unlit"}});
  for (int k = 0; k < 300; ++k) {
    const double x = 0.01 + 0.0499 * k;
    const double y = std::fmod(0.37 * k, 8.9) + 0.05;
    const double u = 1.5 * x / 15;
    const double v = 0.7 * (1 - y / 9);
    const double turnedU = 0.3 + std::cos(0.5) * u + std::sin(0.5) * v;
    const double turnedV = -0.2 - std::sin(0.5) * u + std::cos(0.5) * v;
    compare(scene.see(x, y).r, bilinear(pixels, 5, 3, 5 * turnedU, 3 * turnedV, 10497, 10497),
            0.05);
  }
  Gltf fine;
  fine.card(-0.32F, -0.32F, 0.32F, 0.32F, 0, fine.textured(makePng(64, 64, randomPixels(4096))));
  Json& dense = fine.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  dense["extensions"]["KHR_texture_transform"] = {{"scale", {4, 4}}};
  scene.panel = {{1.28, 1.28}, {128, 128}, {20, 20}, {0.05, 0.05}};  // hogels of 1 cm
  scene.open(fine, {{"shading", "unlit"}});
  const std::vector<std::uint8_t> texels = randomPixels(4096);
  double mean = 0;
  for (std::size_t k = 0; k < 16; ++k) mean += linearOf(texels[3 * (k / 4 * 64 + k % 4)]) / 16;
  compare(scene.see(-0.315, 0.315).r, codeOf(mean), 0.1);
}

/// A quarter counter-clockwise of the coordinates turns the picture clockwise: what is at its top
/// left is seen at the top right.
void TestMeshShading::aTurnedTexture() {
  Gltf gltf;
  gltf.card(0, 0, 1, 1, 0, gltf.textured(makePng(2, 2, {255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})));
  Json& info = gltf.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  info["extensions"]["KHR_texture_transform"] = {{"rotation", std::numbers::pi / 2}};
  Scene scene;
  scene.open(gltf, {{"shading", "unlit"}});
  compare(scene.see(0.75, 0.75).r, 255);
  for (const auto& [x, y] : {std::pair{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.25}})
    compare(scene.see(x, y).r, 0);
}

/// It is added to what lamps make of a surface, and not shaded.
void TestMeshShading::emittedLight() {
  Gltf gltf;
  gltf.card(-1, -1, 1, 1, 0, gltf.textured(makePng(1, 1, {0, 128, 255})));
  Json& material = gltf.json["materials"][0];
  material["pbrMetallicRoughness"] = {{"baseColorFactor", {0.5, 0, 0, 1}}};
  material["emissiveTexture"] = {{"index", 0}};
  material["emissiveFactor"] = {0.5, 0.25, 0.125};
  material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 2}};
  Scene scene;
  for (const char* shading : {"lambert", "unlit"}) {
    scene.open(gltf, {{"shading", shading}, {"orientation", {0, 60, 0}}});
    const plugin::Colour colour = scene.see(0.1, 0.1);
    compare(colour.r, codeOf(0.5 * (std::string(shading) == "unlit" ? 1 : 0.5)));
    compare(colour.g, codeOf(0.5 * linearOf(128)));
    compare(colour.b, codeOf(0.25));
  }
  material["extensions"]["KHR_materials_unlit"] = Json::object();
  scene.open(gltf);
  compare(scene.see(0.1, 0.1).g, 0);
}

void TestMeshShading::aHeadlightLightsBothSides() {
  Gltf gltf;
  gltf.card(-1, -1, 1, 1, 0, gltf.material(0.8, 0.8, 0.8));
  Scene scene;
  for (const double degrees : {0.0, 30.0, 60.0, 150.0, 180.0}) {
    scene.open(gltf, {{"orientation", {0, degrees, 0}}});
    const double cosine = std::abs(std::cos(degrees * std::numbers::pi / 180));
    compare(scene.see(0.05, 0.1).g, codeOf(0.8 * cosine));
  }
}

/// E = I cos θ / d², shown as E/π; a tenth of white comes from everywhere.
void TestMeshShading::aPointLightFallsWithTheSquare() {
  Gltf gltf;
  gltf.card(-2, -2, 2, 2, 0, gltf.material(0.6, 0.6, 0.6));
  gltf.light({{"type", "point"}, {"intensity", 2.5}, {"color", {1, 0.5, 0}}},
             {{"translation", {0.3, 0.2, 1.5}}});
  Scene scene;
  scene.open(gltf);
  for (const double x : {-1.0, 0.0, 0.3, 1.2}) {
    const double square = (x - 0.3) * (x - 0.3) + 0.01 + 2.25;
    const double strength = 2.5 * 1.5 / std::sqrt(square) / square / std::numbers::pi;
    const plugin::Colour colour = scene.see(x, 0.1);
    compare(colour.r, codeOf(0.6 * (0.1 + strength)));
    compare(colour.g, codeOf(0.6 * (0.1 + 0.5 * strength)));
    compare(colour.b, codeOf(0.06));
  }
}

void TestMeshShading::aSpotEndsAtItsCone() {
  Gltf gltf;
  gltf.card(-2, -2, 2, 2, 0);
  const double angle = std::atan(0.5);
  gltf.light({{"type", "spot"},
              {"intensity", 2},
              {"spot", {{"innerConeAngle", angle - 0.001}, {"outerConeAngle", angle}}}},
             {{"translation", {0, 0, 1}}});
  Scene scene;
  scene.open(gltf);
  compare(scene.see(0, 0).r, codeOf(0.1 + 2 / std::numbers::pi));
  QVERIFY(scene.see(0.49, 0).r > 150);
  compare(scene.see(0.51, 0).r, codeOf(0.1));
}

void TestMeshShading::normalsBlend() {
  Gltf gltf;
  gltf.triangles({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::vector<float> normals{0, 0, 1, 0.6F, 0, 0.8F, 0, 0, 1};
  gltf.lastAttributes()["NORMAL"] = gltf.accessor(normals, 5126, "VEC3", 3);
  Scene scene;
  scene.open(gltf);
  // At x = 1/2 the mean of (0, 0, 1) and (0.6, 0, 0.8), of length 1 again.
  compare(scene.see(0.5, 0.25).r, codeOf(0.9 / std::hypot(0.3, 0.9)));
}

/// A card at height h under a lamp at height H throws a shadow H/(H − h) times as wide.
void TestMeshShading::shadowsEndWhereTheyMust() {
  Gltf gltf;
  gltf.card(-2, -2, 2, 2, -1);
  gltf.card(-0.2F, -0.2F, 0.2F, 0.2F, -0.5F);
  gltf.light({{"type", "point"}, {"intensity", 5}}, {{"translation", {0, 0, 1}}});
  Scene scene;
  scene.open(gltf);
  const double edge = 0.2 * 2 / 1.5;
  const double dark = codeOf(0.1);
  for (int k = 0; k < 2000; ++k) {
    const double x = 0.21 + 0.1 * k / 2000;
    if (std::abs(x - edge) < 1e-6) continue;
    const double code = scene.see(x, 0.01).r;
    QVERIFY(x < edge ? std::abs(code - dark) < 0.02 : code > dark + 50);
  }
}

void TestMeshShading::shadowsDoNotFallOnTheirOwnSurface() {
  Gltf gltf;
  for (int k = 0; k < 20; ++k) {  // a wavy floor
    const float x = -1 + 0.1F * float(k);
    const float z = 0.02F * float(k % 2);
    const float w = 0.02F - z;
    gltf.triangles({x, -1, z, x + 0.1F, -1, w, x + 0.1F, 1, w, x, -1, z, x + 0.1F, 1, w, x, 1, z});
  }
  Scene scene;
  scene.open(gltf, {{"orientation", {3, 5, 7}}, {"position", {0.1, 0.2, -0.3}}});
  for (int k = 0; k < 20000; ++k) QVERIFY(scene.see(-0.7 + 7e-5 * k, 0.3 - 4e-5 * k).r > 200);
}

void TestMeshShading::unlitMaterialsStayUnlit() {
  Gltf gltf;
  gltf.card(-1, -1, 0, 1, 0, gltf.material(0.5, 0.5, 0.5, true));
  gltf.card(0, -1, 1, 1, 0, gltf.material(0.5, 0.5, 0.5));
  gltf.json["extensionsRequired"] = {"KHR_materials_unlit"};
  Scene scene;
  scene.open(gltf, {{"orientation", {60, 0, 0}}});
  compare(scene.see(-0.5, 0).r, codeOf(0.5));
  compare(scene.see(0.5, 0).r, codeOf(0.25));
}

void TestMeshShading::scaleChangesNoLight() {
  Gltf gltf;
  gltf.card(-20, -20, 20, 20, -3);
  gltf.light({{"type", "point"}, {"intensity", 40}, {"range", 9}}, {{"translation", {1, 2, 3}}});
  Scene scene;
  scene.open(gltf);
  const float whole = scene.see(2, 1).r;
  scene.open(gltf, {{"scale", 0.05}});
  compare(scene.see(0.1, 0.05).r, whole);
  QVERIFY(whole > 100 && whole < 250);
}

QTEST_GUILESS_MAIN(TestMeshShading)
#include "test_mesh_shading.moc"
