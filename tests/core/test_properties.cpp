// SPDX-License-Identifier: BSD-3-Clause
// What holds of every image, over random scenes at the ends of what parameters allow.
#include <QTest>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "tests/core/light.h"
#include "tests/core/rendered.h"

using namespace hogelscope;
using extreme::Eye;

namespace {

constexpr double floatRounding = 1e-3;

/// Content of 0 … 255 gives light of 0 … 255, and what is not seen is black.
Problem rangeProblem(const RenderJob& job, const Light& light) {
  for (std::size_t k = 0; k < light.rgb.size(); ++k) {
    const double value = light.rgb[k];
    const std::uint8_t seen = light.seen[k / 3];
    if (seen != 0 && seen != 255) return problemAt("a mask of neither", k / 3, job, seen);
    if (seen == 0 && value != 0) return problemAt("unseen, not black", k / 3, job, value);
    if (!(value >= 0 && value <= 255 + floatRounding))
      return problemAt("no light", k / 3, job, value);
  }
  return {};
}

/// The image is the light, rounded.
Problem pictureProblem(const RenderJob& job, const Light& light, const Image& image) {
  for (std::size_t k = 0; k < light.rgb.size(); ++k) {
    if (image.seen[k / 3] != light.seen[k / 3])
      return problemAt("another mask", k / 3, job, image.seen[k / 3]);
    if (!(std::abs(image.rgb[k] - light.rgb[k]) <= 0.5 + floatRounding))
      return problemAt("another pixel", k / 3, job, light.rgb[k]);
  }
  return {};
}

struct Counts {
  int seen = 0;
  int unclear = 0;
};

Problem firstProblem(const RandomScene& scene, Counts& counts) {
  const RenderJob& job = scene.job;
  const Light reference = referenceLight(job);
  const Light fast = fastLight(job);
  counts.seen += int(std::count(fast.seen.begin(), fast.seen.end(), 255));
  for (const Problem& problem :
       {rangeProblem(job, reference), rangeProblem(job, fast),
        pictureProblem(job, reference, simulate(job)), pictureProblem(job, fast, rendered(job)),
        difference(scene, reference, fast, counts.unclear)})
    if (!problem.isEmpty()) return problem;
  return {};
}

/// Each scene has a seed of its own.
Random randomOf(Eye eye, int scene) {
  return Random(std::uint64_t(eye) << 32U | std::uint64_t(scene));
}

bool isAll(const Image& image, int codeValue) {
  for (std::size_t k = 0; k < image.rgb.size(); ++k)
    if (image.rgb[k] != (image.seen[k / 3] == 255 ? codeValue : 0)) return false;
  return true;
}

/// Takes the state's camera frame away.
void spoil(Random& random, CameraParams& camera) {
  const Vec3 forward = camera.lookat - camera.eye;
  const double scale = extreme::anyScale(random, 1e-6, 1) * (random.flip() ? 1 : -1);
  const double number = random.flip() ? std::numeric_limits<double>::quiet_NaN()
                                      : std::numeric_limits<double>::infinity();
  switch (random.integer(0, 4)) {
    case 0:
      camera.lookat = camera.eye;
      break;
    case 1:
      camera.up = {};
      break;
    case 2:
      camera.up = scale * forward;
      break;
    case 3:
      camera.eye.z = number;
      break;
    default:
      camera.lookat.x = number;
      break;
  }
}

}  // namespace

class TestProperties : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyPicture_data();
  void everyPicture();
  void constantLightStaysConstant();
  void whatIsLeftOutIsTooLittle();
  void partsOfRows();
  void partsOfSeveralRows();
  void noFrameNoPicture();
  void noSigmaNoState();
};

/// `least` and `most` pixels seen.
void TestProperties::everyPicture_data() {
  QTest::addColumn<Eye>("eye");
  QTest::addColumn<int>("least");
  QTest::addColumn<int>("most");
  const int any = std::numeric_limits<int>::max();
  QTest::newRow("usual") << Eye::usual << 10000 << any;
  QTest::newRow("close") << Eye::close << 15000 << any;
  QTest::newRow("distant") << Eye::distant << 6000 << any;
  QTest::newRow("in the plane") << Eye::inPlane << 0 << 0;
  QTest::newRow("behind") << Eye::behind << 0 << 0;
  QTest::newRow("grazing") << Eye::grazing << 1000 << any;
  QTest::newRow("parallel") << Eye::parallel << 100 << any;
  QTest::newRow("away") << Eye::away << 0 << 0;
}

void TestProperties::everyPicture() {
  QFETCH(const Eye, eye);
  QFETCH(const int, least);
  QFETCH(const int, most);
  Counts counts;
  for (int repeat = 0; repeat < 1000; ++repeat) {
    Random random = randomOf(eye, repeat);
    const Problem problem = firstProblem(extreme::scene(random, eye), counts);
    QVERIFY2(problem.isEmpty(), qPrintable(QString("scene %1: ").arg(repeat) + problem));
  }
  QVERIFY2(counts.seen >= least && counts.seen <= most, qPrintable(QString::number(counts.seen)));
  QVERIFY2(counts.unclear <= 10, qPrintable(QString::number(counts.unclear)));
}

/// Where a hogel's edge loses no light: to the last bit of the image.
void TestProperties::constantLightStaysConstant() {
  int seen = 0;
  for (int repeat = 0; repeat < 2000; ++repeat) {
    Random random(100000 + std::uint64_t(repeat));
    RandomScene scene = extreme::sceneWithoutLight(random, static_cast<Eye>(random.integer(0, 2)));
    if (scene.job.state.psf.border == PsfBorder::black)
      scene.job.state.psf.border = PsfBorder::renormalise;
    scene.job.sampling.samplesPerPixel = 1;
    const int codeValue = random.flip() ? 255 : random.integer(0, 254);
    extreme::fill(random, scene, [codeValue] { return double(codeValue); });
    const Image fast = rendered(scene.job);
    seen += int(std::count(fast.seen.begin(), fast.seen.end(), 255));
    QVERIFY2(isAll(fast, codeValue), qPrintable(QString("fast, scene %1").arg(repeat)));
    QVERIFY2(isAll(simulate(scene.job), codeValue), qPrintable(QString("scene %1").arg(repeat)));
  }
  QVERIFY2(seen > 20000, qPrintable(QString::number(seen)));
}

/// Dark directions within bright ones: taps that the plan drops must not have been seen, least of
/// all in linear light, which is steepest at black.
void TestProperties::whatIsLeftOutIsTooLittle() {
  constexpr int directions = 41;
  const LightFieldSize size{1, 1, directions, directions};
  for (int repeat = 0; repeat < 500; ++repeat) {
    Random random(200000 + std::uint64_t(repeat));
    RenderJob job;
    job.display.hogels = {1, 1};
    job.display.directions = {directions, directions};
    job.state.camera.res = {1, 1};
    const int dark = random.integer(0, 12);
    job.state.psf = {(dark + 1) / random.uniform(5, 6.5), directions, PsfBorder::renormalise,
                     random.flip() ? LightModel::linear : LightModel::encoded};
    LightField content(size, StoredType::uint8);
    const std::array<std::uint8_t, 3> white{255, 255, 255};
    for (int u = 0; u < directions; ++u)
      for (int v = 0; v < directions; ++v)
        if (std::max(std::abs(u - directions / 2), std::abs(v - directions / 2)) > dark)
          content.set({0, 0, u, v}, white.data());
    job.lightField = std::make_shared<LightField>(std::move(content));
    const double lost = std::abs(referenceLight(job).rgb[0] - fastLight(job).rgb[0]);
    QVERIFY2(lost <= 1e-3, qPrintable(QString("scene %1: %2").arg(repeat).arg(lost)));
  }
}

/// Any part of rows has the rows' pixels, without a gap, and nothing is written behind it.
void TestProperties::partsOfSeveralRows() {
  constexpr std::uint8_t guard = 77;
  for (int repeat = 0; repeat < 300; ++repeat) {
    Random random(310000 + std::uint64_t(repeat));
    const RenderJob job = extreme::scene(random, static_cast<Eye>(random.integer(0, 2))).job;
    LensTables tables;
    const FastSimulation simulation(job, tables, serialRows);
    const auto [width, height] = job.state.camera.res;
    const Light whole = fastLight(job);
    const int top = random.integer(0, height - 1);
    const int bottom = random.integer(top + 1, height);
    const int left = random.integer(0, width - 1);
    const int right = random.integer(left + 1, width);
    const auto pixels = std::size_t(right - left) * std::size_t(bottom - top);
    std::vector<std::uint8_t> rgb(3 * pixels + 1, guard);
    std::vector<std::uint8_t> seen(pixels + 1, guard);
    simulation.rows(top, bottom, left, right, rgb.data(), seen.data());
    QCOMPARE(rgb.back(), guard);
    QCOMPARE(seen.back(), guard);
    for (int y = top, k = 0; y < bottom; ++y)
      for (int x = left; x < right; ++x, ++k) {
        const std::size_t at = std::size_t(y) * std::size_t(width) + std::size_t(x);
        QCOMPARE(seen[std::size_t(k)], whole.seen[at]);
        for (std::size_t c = 0; c < 3; ++c)
          QVERIFY(std::abs(rgb[3 * std::size_t(k) + c] - whole.rgb[3 * at + c]) <=
                  0.5 + floatRounding);
      }
  }
}

/// Any part of a row has the row's pixels, and nothing is written beside it.
void TestProperties::partsOfRows() {
  constexpr std::uint8_t guard = 77;
  for (int repeat = 0; repeat < 1000; ++repeat) {
    Random random(300000 + std::uint64_t(repeat));
    const RenderJob job = extreme::scene(random, static_cast<Eye>(random.integer(0, 2))).job;
    LensTables tables;
    const FastSimulation simulation(job, tables, serialRows);
    const auto [width, height] = job.state.camera.res;
    const Light whole = fastLight(job);
    const int y = random.integer(0, height - 1);
    const int begin = random.integer(0, width - 1);
    const int end = random.integer(begin + 1, width);
    std::vector<std::uint8_t> rgb(3 * std::size_t(width) + 3, guard);
    std::vector<std::uint8_t> seen(std::size_t(width) + 1, guard);
    simulation.rows(y, y + 1, begin, end, &rgb[3 * std::size_t(begin)], &seen[std::size_t(begin)]);
    for (std::size_t k = 0; k < rgb.size(); ++k) {
      const bool isInside = k / 3 >= std::size_t(begin) && k / 3 < std::size_t(end);
      const std::size_t at = 3 * std::size_t(y) * std::size_t(width) + k;
      QCOMPARE(seen[k / 3], isInside ? whole.seen[at / 3] : guard);
      if (isInside)
        QVERIFY(std::abs(rgb[k] - whole.rgb[at]) <= 0.5 + floatRounding);
      else
        QCOMPARE(rgb[k], guard);
    }
  }
}

/// What the session's check refuses for its frame, no engine takes.
void TestProperties::noFrameNoPicture() {
  for (int repeat = 0; repeat < 1000; ++repeat) {
    Random random(400000 + std::uint64_t(repeat));
    RenderJob job = extreme::scene(random, Eye::usual).job;
    check(job.state, "state");
    spoil(random, job.state.camera);
    LensTables tables;
    QVERIFY_THROWS_EXCEPTION(InputError, check(job.state, "state"));
    QVERIFY_THROWS_EXCEPTION(InputError, simulate(job));
    QVERIFY_THROWS_EXCEPTION(InputError, rendered(job));
    QVERIFY_THROWS_EXCEPTION(InputError, FastSimulation(job, tables, serialRows));
  }
}

void TestProperties::noSigmaNoState() {
  CameraState state;
  state.camera.name = "a";
  state.psf.windowSize = 3;
  for (const double sigma : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    state.psf.sigma = sigma;
    QVERIFY_THROWS_EXCEPTION(InputError, check(state, "state"));
  }
}

QTEST_APPLESS_MAIN(TestProperties)
#include "test_properties.moc"
