// SPDX-License-Identifier: BSD-3-Clause
// Each finder of a map finds the cells that the display says one ray after another.
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/engine/view_rays.h"
#include "tests/core/extreme_unit.h"
#include "tests/core/unclear_rays.h"

using namespace hogelscope;

namespace {

struct Counts {
  std::array<int, 6> scenes{};  ///< by finder
  int seen = 0;
  int unclear = 0;
};

bool isSame(const CellBatch& own, const CellBatch& any, std::size_t k) {
  if (own.seen[k] != any.seen[k]) return false;
  for (std::size_t axis = 0; axis < 4 && own.seen[k] != 0; ++axis)
    if (own.cell[axis][k] != any.cell[axis][k] ||
        !(std::abs(own.place[axis][k] - any.place[axis][k]) < 1e-3F))
      return false;
  return true;
}

/// Adds a unit, in two thirds of cases one without what a finder of its own does not know.
void addUnit(Random& random, RandomScene& scene) {
  RenderJob& job = scene.job;
  const int kind = random.integer(0, 2);
  if (kind > 0) job.display.lens = HogelLensModel::rectilinear;
  TwinParams params = randomTwinParams(random, job.display);
  TwinMaps maps = randomTwinMaps(random, job.display);
  if (kind > 0) {
    params.lensArray.outside = OutsideField::dark;
    maps.height = {};
  }
  if (kind == 1) maps.moveU = maps.moveV = {};
  if (kind == 2) {
    params.lensArray.wedge = {};
    params.colour.scale = {};
    maps.gap = {};
  }
  job.sampling.reconstruction = Reconstruction::nearest;
  job.twin = std::make_shared<const Twin>(params, maps, job.display);
}

QString firstDifference(const RenderJob& job, Counts& counts) {
  LensTables tables;
  const ViewRays view(job, tables, serialRows);
  if (view.seesNothing()) return {};
  const UnclearRays rays(job);
  const HitMap& map = view.map(0);
  HitMap slow = map;
  slow.finder = Finder::any;
  ++counts.scenes[std::size_t(map.finder)];
  IdealBatch ideals;
  CellBatch own, any;
  const auto [width, height] = job.state.camera.res;
  for (int y = 0; y < height; ++y)
    for (int x0 = 0; x0 < width; x0 += batchSize) {
      const int count = std::min(batchSize, width - x0);
      view.ideals(y, x0, count, {}, ideals);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        findCells(map, ideals.x, ideals.y, count, own, channel);
        findCells(slow, ideals.x, ideals.y, count, any, channel);
        for (int k = 0; k < count; ++k) {
          counts.seen += any.seen[std::size_t(k)] != 0 ? 1 : 0;
          if (isSame(own, any, std::size_t(k))) continue;
          if (!rays.isUnclear(x0 + k, y))
            return QString("finder %1, pixel (%2, %3), colour %4")
                .arg(int(map.finder))
                .arg(x0 + k)
                .arg(y)
                .arg(channel);
          ++counts.unclear;
        }
      }
    }
  return {};
}

}  // namespace

class TestFinders : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cellsAreThoseOfTheDisplay_data();
  void cellsAreThoseOfTheDisplay();
};

void TestFinders::cellsAreThoseOfTheDisplay_data() {
  QTest::addColumn<int>("kind");
  QTest::newRow("designs") << 0;
  QTest::newRow("units") << 1;
  QTest::newRow("sheets") << 2;
}

void TestFinders::cellsAreThoseOfTheDisplay() {
  QFETCH(const int, kind);
  Counts counts;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(3 * seed + std::uint64_t(kind));
    RandomScene scene = randomScene(random);
    scene.job.state.camera.res[0] = random.integer(20, 200);
    try {
      if (kind == 1) addUnit(random, scene);
      if (kind == 2) extreme::addSheet(random, scene);
      const QString difference = firstDifference(scene.job, counts);
      QVERIFY2(difference.isEmpty(), qPrintable(QString("seed %1: ").arg(seed) + difference));
    } catch (const InputError&) {
      continue;  // documents may not have it
    }
  }
  const auto has = [&](Finder finder) { return counts.scenes[std::size_t(finder)] > 5; };
  QVERIFY(kind != 0 || (has(Finder::design) && has(Finder::curved)));
  QVERIFY(kind != 1 || (has(Finder::unit) && has(Finder::affine) && has(Finder::any)));
  QVERIFY(kind != 2 || has(Finder::sheet));
  QVERIFY2(counts.seen > 10000 && counts.unclear < counts.seen / 50,
           qPrintable(QString("%1 %2").arg(counts.seen).arg(counts.unclear)));
}

QTEST_GUILESS_MAIN(TestFinders)
#include "test_finders.moc"
