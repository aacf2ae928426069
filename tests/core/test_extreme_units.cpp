// SPDX-License-Identifier: BSD-3-Clause
// Units with any errors and lens sheets with any calibration, in scenes at the limits of the
// parameters and through pupils: the fast engine gives the reference's pixels.
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "tests/core/extreme_unit.h"
#include "tests/core/rendered.h"
#include "tests/core/unclear_rays.h"

using namespace hogelscope;

namespace {

struct Counts {
  int seen = 0;
  int unclear = 0;
  int refused = 0;
};

QString firstDifference(const RenderJob& job, Counts& counts) {
  const Image fast = rendered(job);
  const Image reference = simulate(job);
  const UnclearRays rays(job);
  for (std::size_t at = 0; at < fast.pixelCount(); ++at) {
    counts.seen += reference.seen[at] != 0 ? 1 : 0;
    int most = 0;
    for (std::size_t k = 3 * at; k < 3 * at + 3; ++k)
      most = std::max(most, std::abs(fast.rgb[k] - reference.rgb[k]));
    if (fast.seen[at] == reference.seen[at] && most <= 1) continue;
    const auto [x, y] = std::pair(int(at) % fast.width, int(at) / fast.width);
    if (!rays.isUnclear(x, y)) return QString("pixel (%1, %2): off by %3").arg(x).arg(y).arg(most);
    ++counts.unclear;
  }
  return {};
}

}  // namespace

class TestExtremeUnits : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void enginesAgree_data();
  void enginesAgree();
  void aPupilReachesBehindThePanel();
  void endsBesideThePanel_data();
  void endsBesideThePanel();
};

void TestExtremeUnits::enginesAgree_data() {
  QTest::addColumn<bool>("hasSheet");
  QTest::newRow("units") << false;
  QTest::newRow("sheets") << true;
}

void TestExtremeUnits::enginesAgree() {
  QFETCH(const bool, hasSheet);
  Counts counts;
  for (int seed = 1; seed <= 3000; ++seed) {
    Random random(std::uint64_t(seed) << 1U | std::uint64_t(hasSheet ? 1 : 0));
    try {
      const RandomScene scene = extreme::unitScene(random, hasSheet);
      const QString difference = firstDifference(scene.job, counts);
      QVERIFY2(difference.isEmpty(), qPrintable(QString("seed %1: ").arg(seed) + difference));
    } catch (const InputError&) {
      ++counts.refused;
    }
  }
  QVERIFY2(
      counts.seen > 1000 && counts.unclear < counts.seen / 50 && counts.refused < 1500,
      qPrintable(QString("%1 %2 %3").arg(counts.seen).arg(counts.unclear).arg(counts.refused)));
}

/// An eye 1 mm in front of the panel that looks along it, whose pupil is 4 mm wide. Nothing may be
/// asked for its points behind; 800² hogels' errors have memory pages of their own.
void TestExtremeUnits::aPupilReachesBehindThePanel() {
  RenderJob job;
  job.display.size = {0.2, 0.2};
  job.display.hogels = {800, 800};
  job.display.directions = {2, 2};
  job.display.fov = {50, 50};
  job.lightField = std::make_shared<LightField>(LightFieldSize{800, 800, 2, 2}, StoredType::uint8);
  TwinParams params;
  params.lensArray.wedge = {0.1, 0.1};
  params.random.shift.sigma = 1e-5;
  job.twin = std::make_shared<const Twin>(params, TwinMaps{}, job.display);
  job.state.camera.eye = {0, 0, 0.001};
  job.state.camera.lookat = {0.1, 0, 0};
  job.state.camera.res = {60, 60};
  job.state.pupil = {0.004, 0, 16};
  Counts counts;
  QCOMPARE(firstDifference(job, counts), QString());
}

void TestExtremeUnits::endsBesideThePanel_data() {
  QTest::addColumn<double>("pitch");
  QTest::addColumn<double>("slope");
  QTest::newRow("rows") << 15.0 << 1e6;
  QTest::newRow("lenses") << 2000.0 << 1e6;
}

/// Lenses that are nearly upright move ends by rows onto the panel, from rows beside it that have
/// kinds of pixels too; and a sub-pixel's place is aside by many lenses that are small.
void TestExtremeUnits::endsBesideThePanel() {
  QFETCH(const double, pitch);
  QFETCH(const double, slope);
  Counts counts;
  for (int seed = 1; seed <= 60; ++seed) {
    Random random{std::uint64_t(seed)};
    SheetDisplay sheet;
    sheet.calibration.params = {pitch * random.uniform(0.7, 1.3), slope, 0, 20, {40, 20}, 40};
    sheet.calibration.pattern = 4;
    sheet.calibration.cells.clear();
    for (int kind = 0; kind < 2; ++kind) {
      SubPixels cells;
      const double aside = random.uniform(-0.9, 0.9);
      for (auto& place : cells) place = {aside + random.uniform(-0.1, 0.1), random.uniform(-1, 1)};
      sheet.calibration.cells.push_back(cells);
    }
    RenderJob job;
    job.display.sheet = sheet;
    job.display.size = LensSheet(sheet).size();
    job.display.hogels = {40, 20};
    job.display.directions = {1, 1};
    job.state.psf = {0.5, 1};
    job.state.camera.eye = {0, 0, 0.1};
    job.state.camera.res = {60, 60};
    std::vector<std::uint8_t> values(std::size_t(3 * 40 * 20));
    for (std::uint8_t& value : values) value = std::uint8_t(random.integer(0, 255));
    job.lightField = std::make_shared<LightField>(LightFieldSize{40, 20, 1, 1}, std::move(values));
    const QString difference = firstDifference(job, counts);
    QVERIFY2(difference.isEmpty(), qPrintable(QString("seed %1: ").arg(seed) + difference));
  }
  QVERIFY(counts.seen > 1000 && counts.unclear < counts.seen / 20);
}

QTEST_GUILESS_MAIN(TestExtremeUnits)
#include "test_extreme_units.moc"
