// SPDX-License-Identifier: BSD-3-Clause
// Tests that the order of views is found from their pictures alone, in every order of the files,
// and that nothing is said to be sure that is not.
#include <QTest>

#include "core/base/error.h"
#include "tests/io/layered_views.h"

using namespace hogelscope;

namespace {

std::vector<GridSymmetry> symmetries() {
  std::vector<GridSymmetry> all;
  for (const bool isTransposed : {false, true})
    for (const bool isUp : {false, true})
      for (const bool isLeft : {false, true}) all.push_back({isUp, isLeft, isTransposed});
  return all;
}

bool isRight(const ViewOrder& order, const GridSymmetry& truth) {
  return order.isTransposed == truth.isTransposed &&
         (order.rows == RowOrder::bottomUp) == truth.isUp &&
         (order.columns == ColumnOrder::rightLeft) == truth.isLeft;
}

QString said(const ViewOrder& order) {
  return QString("%1%2 %3, sureness %4, correlation %5, %6 places, occlusions %7/%8 and %9/%10")
      .arg(order.isTransposed ? "transposed, " : "",
           order.rows == RowOrder::bottomUp ? "bottom-up" : "top-down",
           order.columns == ColumnOrder::rightLeft ? "right-left" : "left-right")
      .arg(int(order.sureness))
      .arg(order.correlation)
      .arg(order.places)
      .arg(order.alongColumns.ordered)
      .arg(order.alongColumns.reversed)
      .arg(order.alongRows.ordered)
      .arg(order.alongRows.reversed);
}

}  // namespace

class TestViewOrder : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyOrderOfAGrid_data() {
    QTest::addColumn<double>("far");
    QTest::addColumn<double>("near");
    QTest::newRow("parallel cameras") << 1.0 << 6.0;
    QTest::newRow("cameras that converge") << -2.5 << 2.5;
    QTest::newRow("all behind the panel") << -6.0 << -1.0;
  }

  /// The parallax of the middle depth is known, too: it lies between that of the layers.
  void everyOrderOfAGrid() {
    QFETCH(double, far);
    QFETCH(double, near);
    ViewScene scene = randomScene(7, far, near);
    scene.width = 180;
    scene.height = 135;
    for (const GridSymmetry& truth : symmetries()) {
      // Other depths in half of the orders: each two properties in every combination.
      if (far != 1 && truth.isTransposed != (truth.isUp != truth.isLeft)) continue;
      const ViewOrder order = findViewOrder(gridOf(scene, 5, 7, truth));
      QVERIFY2(isRight(order, truth) && order.sureness == Sureness::sure, qPrintable(said(order)));
      const auto [x, y] = order.middleMotion;
      for (const double motion : {truth.isLeft ? x : -x, truth.isUp ? y : -y})
        QVERIFY2(motion > far - 0.1 && motion < near + 0.1, qPrintable(QString::number(motion)));
    }
  }

  /// Columns or rows alone, by what hides what.
  void oneRowOrColumn() {
    ViewScene scene = randomScene(4, -2.5, 2.5);
    scene.width = 180;
    scene.height = 135;
    for (const bool isReversed : {false, true}) {
      const ViewOrder row = findViewOrder(gridOf(scene, 1, 11, {false, isReversed, false}));
      QVERIFY2(isRight(row, {false, isReversed, false}) && row.sureness == Sureness::sure,
               qPrintable(said(row)));
      const ViewOrder column = findViewOrder(gridOf(scene, 11, 1, {isReversed, false, false}));
      QVERIFY2(isRight(column, {isReversed, false, false}) && column.sureness == Sureness::sure,
               qPrintable(said(column)));
    }
  }

  /// Known to the hundredth of a pixel: all moves as one.
  void theMotionOfOnePlane() {
    ViewScene scene = randomScene(2, 0, 0);
    scene.layers.resize(1);
    scene.layers[0].parallax = 1.7;
    const ViewOrder order = findViewOrder(gridOf(scene, 5, 5, {true, false, false}));
    QCOMPARE(order.sureness, Sureness::unknown);
    QVERIFY(std::abs(order.middleMotion[0] + 1.7) < 0.02);
    QVERIFY(std::abs(order.middleMotion[1] - 1.7) < 0.02);
  }

  void large() {
    ViewScene scene = randomScene(5, -4, 4);
    scene.width = 900;
    scene.height = 600;
    for (ViewLayer& layer : scene.layers) {
      layer.x *= 3;
      layer.y *= 3;
      if (layer.width < 1e6) layer.width = layer.height = 90;
    }
    scene.layers[0].parallax = -4;
    const ViewOrder order = findViewOrder(gridOf(scene, 3, 5, {true, true, false}));
    QVERIFY2(isRight(order, {true, true, false}), qPrintable(said(order)));
    // Most is background, in the files' own pixels and not in those that are looked at.
    QVERIFY2(std::abs(order.middleMotion[0] + 4) < 0.1, qPrintable(said(order)));
  }

  void whatDeceives_data() {
    QTest::addColumn<int>("kind");
    const QStringList kinds{"a plane",
                            "a slanted plane",
                            "one colour",
                            "unrelated pictures",
                            "almost flat",
                            "too much noise",
                            "to and fro",
                            "a mirror",
                            "glass",
                            "fine stripes",
                            "single view",
                            "two views",
                            "a period of two motions"};
    for (int k = 0; k < kinds.size(); ++k) QTest::newRow(qPrintable(kinds[k])) << k;
  }

  /// Never sure and wrong.
  void whatDeceives() {
    QFETCH(int, kind);
    for (const GridSymmetry& truth : {GridSymmetry{}, GridSymmetry{true, true, true}}) {
      ViewScene scene = kind == 4 ? randomScene(11, -0.02, 0.02) : randomScene(11, -1.5, 1.5);
      scene.width = 160;
      scene.height = 120;
      std::vector<ViewLayer>& layers = scene.layers;
      if (kind <= 1) layers.resize(1);
      if (kind == 1) layers[0].slope = 2;
      if (kind == 2) scene.contrast = 0;
      if (kind == 5) scene.noise = 40;
      if (kind == 7) {
        layers.push_back(layers[0]);
        layers.back().parallax = -5;
        layers.back().opacity = 0.4;
        layers.back().texture += 99;
      }
      if (kind == 8)
        for (std::size_t k = 1; k < layers.size(); ++k) layers[k].opacity = 0.5;
      if (kind == 9)
        for (ViewLayer& layer : layers) layer.period = 5;
      if (kind == 12) {
        scene = randomScene(8 * 31 + 1, -4, 4);
        layers[0].period = 9;
        layers[3].period = 7;
        layers[5].period = 8;
      }
      GreyGrid grid = kind == 10   ? gridOf(scene, 1, 1)
                      : kind == 11 ? gridOf(scene, 1, 2, {false, truth.isLeft, false})
                      : kind == 12 ? gridOf(scene, 1, 15, {false, truth.isLeft, false})
                                   : gridOf(scene, 5, 5, truth);
      if (kind == 3)
        grid.view = [](int row, int column) {
          ViewScene other = randomScene(std::uint32_t(row * 100 + column), 0, 0);
          other.width = 160;
          other.height = 120;
          return viewOf(other, 0, 0);
        };
      if (kind == 6)
        grid.view = [view = grid.view](int row, int column) {
          return view(row, row % 2 == 0 ? column : 4 - column);
        };
      const ViewOrder order = findViewOrder(grid);
      const bool mayBeSure = kind == 7 || kind == 8;  // and then right
      QVERIFY2(order.sureness != Sureness::sure || (mayBeSure && isRight(order, truth)),
               qPrintable(said(order)));
    }
  }

  void toAndFroIsTold() {
    const ViewScene scene = randomScene(3, -2.5, 2.5);
    GreyGrid grid = gridOf(scene, 5, 7);
    grid.view = [view = grid.view](int row, int column) {
      return view(row, row % 2 == 0 ? column : 6 - column);
    };
    QVERIFY(findViewOrder(grid).isInconsistent);
  }

  void tinyPictures() {
    for (const int side : {1, 2, 3, 7, 16}) {
      ViewScene scene = randomScene(1, -1, 1);
      scene.width = side;
      scene.height = 1 + side / 2;
      QVERIFY(findViewOrder(gridOf(scene, 3, 3)).sureness != Sureness::sure);
    }
    ViewScene slender = randomScene(1, -1, 1);
    slender.width = 3000;
    slender.height = 2;
    QVERIFY(findViewOrder(gridOf(slender, 2, 2)).sureness != Sureness::sure);
  }

  void isStopped() {
    const GreyGrid grid = gridOf(randomScene(1, -1, 1), 3, 3);
    QVERIFY_EXCEPTION_THROWN((void)findViewOrder(grid, [](double done) { return done < 0.3; }),
                             Cancelled);
  }
};

QTEST_GUILESS_MAIN(TestViewOrder)
#include "test_view_order.moc"
