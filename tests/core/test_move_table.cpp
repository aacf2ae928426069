// SPDX-License-Identifier: BSD-3-Clause
// A twin's map of directions for kernels, against its own definition.
#include "core/panel/move_table.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/panel/twin.h"

using namespace hogelscope;

namespace {

constexpr std::array<int, 2> directions{12, 7};

/// Draws moves whose neighbours differ by `steepness` directions per direction at most, in u and in
/// v each.
TwinPlane moves(int width, int height, double steepness, std::mt19937& draws) {
  const double across = steepness / 2 * directions[0] / width;
  const double down = steepness / 2 * directions[1] / height;
  std::uniform_real_distribution<double> phase(0, 6);
  const double largest = std::min(across, down) / 2;
  TwinPlane plane{width, height, {}};
  for (int k = 0; k < width * height; ++k)
    plane.values.push_back(static_cast<float>(largest * std::sin(phase(draws))));
  return plane;
}

/// Returns u + m(u, v) or v + m(u, v).
double mapped(const TwinPlane& moves, double place, double u, double v) {
  return place + (moves.isEmpty() ? 0 : moves.at(u / directions[0], v / directions[1]));
}

}  // namespace

class TestMoveTable : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void solvesItsMap_data();
  void solvesItsMap();
  void tableIsWithinItsError_data();
  void tableIsWithinItsError();
  void hasNoTableOfOneColumn();
};

void TestMoveTable::solvesItsMap_data() {
  QTest::addColumn<int>("width");
  QTest::addColumn<int>("height");
  QTest::addColumn<double>("steepness");
  QTest::addColumn<bool>("hasV");
  QTest::newRow("as many cells as directions") << 12 << 7 << 0.3 << true;
  QTest::newRow("few cells") << 2 << 3 << 0.3 << true;
  QTest::newRow("many cells") << 50 << 40 << 0.1 << true;
  QTest::newRow("steep") << 12 << 7 << 0.8 << true;
  QTest::newRow("too steep for a table") << 12 << 7 << 1.9 << false;
  QTest::newRow("moves of u alone") << 5 << 9 << 0.2 << false;
}

/// Also of places that are outside the field; and Twin::moved() finds the same.
void TestMoveTable::solvesItsMap() {
  QFETCH(int, width);
  QFETCH(int, height);
  QFETCH(double, steepness);
  QFETCH(bool, hasV);
  std::mt19937 draws(3);
  const TwinPlane moveU = moves(width, height, steepness, draws);
  const TwinPlane moveV = hasV ? moves(width, height, steepness, draws) : TwinPlane{};
  const MoveTable table(moveU, moveV, directions);
  PanelParams display;
  display.hogels = {1, 1};
  display.directions = directions;
  TwinMaps maps;
  maps.moveU = moveU;
  maps.moveV = moveV;
  const Twin twin({}, maps, display);
  std::uniform_real_distribution<double> acrossField(-1, directions[0] + 1);
  std::uniform_real_distribution<double> downField(-1, directions[1] + 1);
  for (int k = 0; k < 2000; ++k) {
    const double u0 = acrossField(draws);
    const double v0 = downField(draws);
    const auto [u, v] = table.solve(u0, v0);
    QVERIFY2(std::abs(mapped(moveU, u, u, v) - u0) < 1e-9, qPrintable(QString::number(u0)));
    QVERIFY2(std::abs(mapped(moveV, v, u, v) - v0) < 1e-9, qPrintable(QString::number(v0)));
    const Hit moved = twin.moved({0.5, 0.5, u0, v0});
    QVERIFY2(std::abs(moved.u - u) < 1e-8 && std::abs(moved.v - v) < 1e-8,
             qPrintable(QString::number(moved.u - u)));
  }
}

void TestMoveTable::tableIsWithinItsError_data() {
  solvesItsMap_data();
}

void TestMoveTable::tableIsWithinItsError() {
  QFETCH(int, width);
  QFETCH(int, height);
  QFETCH(double, steepness);
  QFETCH(bool, hasV);
  std::mt19937 draws(4);
  const TwinPlane moveU = moves(width, height, steepness, draws);
  const TwinPlane moveV = hasV ? moves(width, height, steepness, draws) : TwinPlane{};
  const MoveTable table(moveU, moveV, directions);
  const int columns = directions[0] * table.perDirection();
  QCOMPARE(table.back().size(), std::size_t(columns * directions[1] * table.perDirection()));
  std::uniform_real_distribution<double> share(0, 1);
  std::array<double, 2> largest{};
  for (int cell = 0; cell < int(table.back().size()); ++cell)
    for (int k = 0; k < 8; ++k) {
      const double u0 = (cell % columns + share(draws)) / table.perDirection();
      const double v0 = (cell / columns + share(draws)) / table.perDirection();
      const auto [u, v] = table.solve(u0, v0);
      const auto& [backU, backV] = table.back()[std::size_t(cell)];
      largest[0] = std::max(largest[0], std::abs(u0 + double(backU) - u));
      largest[1] = std::max(largest[1], std::abs(v0 + double(backV) - v));
    }
  const QByteArray found = QString("%1, %2 of %3, %4")
                               .arg(largest[0])
                               .arg(largest[1])
                               .arg(table.error()[0])
                               .arg(table.error()[1])
                               .toUtf8();
  for (std::size_t axis = 0; axis < 2; ++axis)
    QVERIFY2(largest[axis] <= table.error()[axis], found.constData());
  // A bound that is far too wide would send all rays to solve().
  if (steepness <= 0.3) QVERIFY2(table.error()[0] < 0.12, found.constData());
}

void TestMoveTable::hasNoTableOfOneColumn() {
  QVERIFY(MoveTable(TwinPlane{1, 2, {0, 0}}, {}, directions).isEmpty());
  QVERIFY(MoveTable({}, TwinPlane{3, 1, {0, 0, 0}}, directions).isEmpty());
}

QTEST_GUILESS_MAIN(TestMoveTable)
#include "test_move_table.moc"
