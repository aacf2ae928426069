// SPDX-License-Identifier: BSD-3-Clause
// Tests the order of light fields' views: found for a folder, said against a session, mended.
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <numeric>
#include <random>

#include "io/documents/session_file.h"
#include "io/opening/contrast.h"
#include "io/opening/grey_views.h"
#include "io/opening/light_field_order.h"
#include "io/opening/opening.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"
#include "tests/io/layered_views.h"

using namespace hogelscope;

namespace {

const QString data = HOGELSCOPE_SOURCE_DIR "/../shared/data/";

void writeGreyPicture(const QString& file, const GreyPicture& picture) {
  writeImageFile(file, picture.width, picture.height, [&](int x, int y, int) {
    return float(picture.values[std::size_t(y * picture.width + x)]) / 255;
  });
}

/// `names` is a printf format of row and column.
void writeGrid(const QString& folder, const GreyGrid& grid, const char* names = "%03d_%03d.png") {
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      writeGreyPicture(folder + "/" + QString::asprintf(names, row, column),
                       grid.view(row, column));
}

/// One picture of the grid's views.
void writeTiles(const QString& file, const GreyGrid& grid) {
  std::vector<GreyPicture> views;
  for (int k = 0; k < grid.rows * grid.columns; ++k)
    views.push_back(grid.view(k / grid.columns, k % grid.columns));
  const auto [width, height, values] = views.front();
  writeImageFile(file, width * grid.columns, height * grid.rows,
                 [&, width = width, height = height](int x, int y, int) {
                   const GreyPicture& view =
                       views[std::size_t(y / height * grid.columns + x / width)];
                   return float(view.values[std::size_t(y % height * width + x % width)]) / 255;
                 });
}

LightFieldParams viewsIn(const QString& folder) {
  LightFieldParams params;
  params.file = folder.toStdString();
  params.layout = Layout::views;
  return params;
}

}  // namespace

class TestLightFieldOrder : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir::setCurrent(m_folder->path()));
  }

  /// Each two properties of an order in every combination; io.view_order has all eight.
  void aFolderGetsOrderAndShear_data() {
    QTest::addColumn<bool>("isUp");
    QTest::addColumn<bool>("isLeft");
    QTest::addColumn<bool>("isTransposed");
    for (const bool isUp : {false, true})
      for (const bool isLeft : {false, true})
        QTest::addRow("%d%d", isUp, isLeft) << isUp << isLeft << (isUp != isLeft);
  }

  /// And once they are used, nothing is left to find; used the other way round, it is said.
  void aFolderGetsOrderAndShear() {
    QFETCH(bool, isUp);
    QFETCH(bool, isLeft);
    QFETCH(bool, isTransposed);
    writeGrid("v", gridOf(randomScene(7, 1, 6), 3, 5, {isUp, isLeft, isTransposed}));
    const auto [session, order, note, hogels] = orderedSessionAround("v");
    QCOMPARE(order.sureness, Sureness::sure);
    const LightFieldParams& used = session.lightField;
    QCOMPARE(used.rows == RowOrder::bottomUp, isUp);
    QCOMPARE(used.columns == ColumnOrder::rightLeft, isLeft);
    QCOMPARE(QString::fromStdString(used.pattern), QString(isTransposed ? "CCC_RRR" : ""));
    for (const double shear : used.shear)
      QVERIFY(shear > 0.95 && shear < 6);  // half is background, at 1
    QVERIFY((openLightField(used, {})->size() == LightFieldSize{240, 180, 5, 3}));
    QCOMPARE(contradictionOf(used, order), std::string());
    if (isUp && isLeft) QVERIFY(mendingOf(used, findLightFieldOrder(used, {})).empty());
    LightFieldParams wrong = used;
    wrong.rows = reversed(wrong.rows);
    const std::string line = contradictionOf(wrong, order);
    const std::string mending = std::string("mend it with lightField.rows=") + nameOf(used.rows);
    QVERIFY2(line.find(mending) != std::string::npos, line.c_str());
  }

  /// A circle of 9×9 views, with the one in the middle missing or not: as the whole grid's.
  void holes() {
    const GreyGrid grid = gridOf(randomScene(7, 1, 6), 9, 9, {true, false, false});
    for (int row = 0; row < 9; ++row)
      for (int column = 0; column < 9; ++column) {
        const GreyPicture view = grid.view(row, column);
        const QString name = QString::asprintf("/%03d_%03d.png", row, column);
        const double off = std::hypot(row - 4, column - 4);
        writeGreyPicture("full" + name, view);
        if (off < 4.3) writeGreyPicture("circle" + name, view);
        if (off < 4.3 && off > 0) writeGreyPicture("ring" + name, view);
        if (row == 4 || column == 4 || std::abs(row - 4) == std::abs(column - 4))
          writeGreyPicture(QString("star/input_Cam%1.png").arg(9 * row + column), view);
      }
    const auto full = orderedSessionAround("full");
    QCOMPARE(full.order.sureness, Sureness::sure);
    QVERIFY(full.order.warnings.empty());
    for (const char* folder : {"circle", "ring"}) {
      const auto [session, order, note, hogels] = orderedSessionAround(folder);
      QCOMPARE(order.sureness, Sureness::sure);
      QVERIFY(session.lightField.rows == RowOrder::bottomUp);
      QVERIFY(session.lightField.columns == ColumnOrder::leftRight);
      for (const std::size_t k : {0, 1})
        QVERIFY(std::abs(session.lightField.shear[k] - full.session.lightField.shear[k]) <
                (folder == std::string("ring") ? 0.3 : 0.005));
      QCOMPARE(order.warnings.size(), std::size_t(1));
      // Next to a hole the votes of one direction would be lost.
      const int votes = order.measured.alongRows.count();
      const int ofFull = full.order.measured.alongRows.count();
      QVERIFY2(votes > 0.6 * ofFull, qPrintable(QString("%1 of %2").arg(votes).arg(ofFull)));
      const AssumedOrder assumed = assumedOrder(session.lightField, {240, 180, 9, 9}, order);
      QVERIFY(orderDocument(assumed).find(folder == std::string("ring")
                                              ? "21 of 81 views are missing"
                                              : "20 of 81 views are missing") != std::string::npos);
      QVERIFY(!contactSheet(order, assumed, {}).image.rgb.empty());
    }
    const auto [star, order, note, hogels] =
        orderedSessionAround("star", {"display.directions=[9,9]"});
    QCOMPARE(order.sureness, Sureness::sure);
    QVERIFY(star.lightField.rows == RowOrder::bottomUp);
    QVERIFY(star.lightField.columns == ColumnOrder::leftRight);
    QCOMPARE(order.warnings.size(), std::size_t(1));
    QVERIFY(
        (openLightField(star.lightField, star.display)->size() == LightFieldSize{240, 180, 9, 9}));
  }

  /// A running number that counts from top to bottom.
  void aColumnOfViews() {
    const GreyGrid grid = gridOf(randomScene(4, -2.5, 2.5), 12, 1);
    for (int k = 0; k < 12; ++k)
      writeGreyPicture(QString("v/view%1.png").arg(k + 1), grid.view(k, 0));
    const LightFieldOrder order = findLightFieldOrder(viewsIn("v"), {});
    QCOMPARE(order.warnings.size(), std::size_t(1));
    QVERIFY2(order.warnings[0].find("give [1,12]") != std::string::npos, order.warnings[0].c_str());
    const LightFieldOrder mended = orderedSessionAround("v", {"display.directions=[1,12]"}).order;
    QVERIFY(mended.warnings.empty());
    QCOMPARE(mended.sureness, Sureness::sure);
  }

  /// Views that are counted by columns, straight or to and fro, are found to be, and no others.
  void numbersThatRunByColumns_data() {
    QTest::addColumn<std::vector<int>>("cameras");  // of a grid of 4 × 4, or in one row, by number
    QTest::addColumn<bool>("isOneRow");
    QTest::addColumn<int>("scan");
    std::vector<int> row(16);
    std::iota(row.begin(), row.end(), 0);
    for (const ViewScan scan :
         {ViewScan::raster, ViewScan::serpentine, ViewScan::columns, ViewScan::columnsSerpentine}) {
      std::vector<int> cameras;
      for (const int k : row) {
        const bool isBack =
            k / 4 % 2 == 1 && (scan == ViewScan::serpentine || scan == ViewScan::columnsSerpentine);
        const int at = isBack ? 3 - k % 4 : k % 4;
        const bool isByColumns = scan == ViewScan::columns || scan == ViewScan::columnsSerpentine;
        cameras.push_back(isByColumns ? at * 4 + k / 4 : k / 4 * 4 + at);
      }
      QTest::newRow(nameOf(scan)) << cameras << false << int(scan);
    }
    QTest::newRow("one row, read as 4 × 4") << row << true << 0;
    // The first of a hundred shuffles whose motion is mostly up and down along the numbers.
    std::mt19937 random(1);
    for (int k = 0; k <= 30; ++k) std::ranges::shuffle(row, random);
    QTest::newRow("shuffled") << row << false << 0;
  }

  void numbersThatRunByColumns() {
    QFETCH(const std::vector<int>, cameras);
    QFETCH(const bool, isOneRow);
    QFETCH(const int, scan);
    const GreyGrid grid = gridOf(randomScene(7, 1, 6), isOneRow ? 1 : 4, isOneRow ? 16 : 4);
    for (int k = 0; k < 16; ++k) {
      const int camera = cameras[std::size_t(k)];
      writeGreyPicture(QString("v/view%1.png").arg(k + 1, 2, 10, QChar('0')),
                       isOneRow ? grid.view(0, camera) : grid.view(camera / 4, camera % 4));
    }
    const LightFieldOrder order = findLightFieldOrder(viewsIn("v"), {});
    QCOMPARE(int(order.found.scan), scan);
    const bool isKnown = !isOneRow && QByteArray(QTest::currentDataTag()) != "shuffled";
    QVERIFY2(isKnown == (order.sureness != Sureness::unknown), order.reason.c_str());
    QVERIFY(order.warnings.empty());
    LightFieldParams used = viewsIn("v");
    used.scan = order.found.scan;
    used.shear = order.found.shear;
    QCOMPARE(contradictionOf(used, order), std::string());
    used.scan = used.scan == ViewScan::columns ? ViewScan::raster : ViewScan::columns;
    const std::string line = contradictionOf(used, order);
    QVERIFY2(
        line.find(std::string("lightField.scan=") + nameOf(order.found.scan)) != std::string::npos,
        line.c_str());
  }

  /// x and y are exchanged, which the pictures tell.
  void coordinatesAlone() {
    const GreyGrid grid = gridOf(randomScene(7, 1, 6), 3, 5);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 5; ++column)
        writeGreyPicture(QString("v/cam_%1_%2.png").arg(20.5 - 10 * row).arg(5 * column - 7),
                         grid.view(row, column));
    const auto [session, order, note, hogels] = orderedSessionAround("v");
    QCOMPARE(order.sureness, Sureness::sure);
    QCOMPARE(QByteArray::fromStdString(session.lightField.pattern), QByteArray("cam_y_x.png"));
    QVERIFY(session.lightField.rows == RowOrder::bottomUp);  // y is upwards there
    QVERIFY(session.lightField.columns == ColumnOrder::leftRight);
  }

  void coordinatesOfSmallSteps_data() {
    QTest::addColumn<bool>("isYFirst");
    QTest::newRow("image_Y_X") << true;
    QTest::newRow("image_X_Y") << false;
  }

  /// Six steps move the middle depth by 0.6 px sideways, and by 0.1 px down: the cameras' rows
  /// rise.
  void coordinatesOfSmallSteps() {
    QFETCH(const bool, isYFirst);
    const ViewScene scene = randomScene(7, 0.1, 0.11);
    for (int row = 0; row < 7; ++row)
      for (int column = 0; column < 7; ++column) {
        const double x = column - 3, y = row - 3;
        const double first = isYFirst ? y : x, second = isYFirst ? x : y;
        writeGreyPicture(QString("v/image_%1_%2.png").arg(first / 2).arg(second / 2),
                         viewOf(scene, x, y - x / 6, 7 * row + column));
      }
    const auto [session, order, note, hogels] = orderedSessionAround("v");
    QCOMPARE(QByteArray::fromStdString(session.lightField.pattern),
             QByteArray(isYFirst ? "image_y_x.png" : ""));
    QCOMPARE(order.sureness, Sureness::likely);  // by the names
    QVERIFY(order.rows == RowOrder::topDown && order.columns == ColumnOrder::leftRight);
    for (const double shear : session.lightField.shear)
      QVERIFY2(std::abs(shear - 0.1) < 0.02, qPrintable(QString::number(shear)));
  }

  /// Rows and columns are exchanged in the arrows, too.
  void theSheetOfATransposedFolder() {
    std::array<Image, 2> sheets;
    for (const bool isTransposed : {false, true}) {
      const std::string folder = isTransposed ? "transposed" : "usual";
      writeGrid(QString::fromStdString(folder),
                gridOf(randomScene(7, 1, 6), 3, 5, {false, false, isTransposed}));
      const auto [session, order, note, hogels] = orderedSessionAround(folder);
      sheets[isTransposed ? 1 : 0] =
          contactSheet(order, assumedOrder(session.lightField, {240, 180, 5, 3}, order), {}).image;
    }
    QVERIFY(sheets[0].rgb == sheets[1].rgb);
  }

  /// With another row order its shear goes the other way, so that the middle depth stays.
  void whatTheUserSaysStays() {
    writeGrid("v", gridOf(randomScene(7, 1, 6), 3, 5));
    const auto [session, order, note, hogels] =
        orderedSessionAround("v", {"lightField.rows=bottom-up"});
    QVERIFY(session.lightField.rows == RowOrder::bottomUp);
    QVERIFY(session.lightField.shear[0] > 0.95 && session.lightField.shear[1] < -0.95);
    QVERIFY(!contradictionOf(session.lightField, order).empty());
    const auto given = orderedSessionAround("v", {"lightField.shear=[0.5,0]"});
    QVERIFY((given.session.lightField.shear == std::array{0.5, 0.0}));
  }

  void incomingTurnsTheOrderRound() {
    writeGrid("v", gridOf(randomScene(7, 1, 6), 3, 5));
    LightFieldParams params = viewsIn("v");
    params.incoming = true;
    const LightFieldOrder order = findLightFieldOrder(params, {});
    QVERIFY(order.found.rows == RowOrder::bottomUp && order.found.incoming);
    QVERIFY(order.found.columns == ColumnOrder::rightLeft);
    QVERIFY(order.found.shear[0] < -0.95);  // of u as it is before it is flipped
    QVERIFY(mendingOf(order.found, findLightFieldOrder(order.found, {})).empty());
  }

  /// Stanford's names: y downwards, x to the right. The pictures hardly tell.
  void positionsInNames() {
    ViewScene scene = randomScene(7, -0.02, 0.02);
    const GreyGrid grid = gridOf(scene, 3, 3, {true, true, false});
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        writeGreyPicture(QString("v/out_0%1_0%2_%3_%4_.png")
                             .arg(row)
                             .arg(column)
                             .arg(380.5 - 10 * row)
                             .arg(-1.5 - 9.0 * column),
                         grid.view(row, column));
    const LightFieldOrder order = findLightFieldOrder(viewsIn("v"), {});
    QVERIFY(order.found.rows == RowOrder::bottomUp);
    QVERIFY(order.found.columns == ColumnOrder::rightLeft);
    QCOMPARE(order.sureness, Sureness::likely);
    QVERIFY2(order.reason.starts_with("positions in the file names"), order.reason.c_str());
  }

  /// Few places show what hides what: where more of them speak against the names, nothing is
  /// likely.
  void positionsThatAreOutvoted() {
    int outvoted = 0;
    for (const double near : {2.5, 2.7, 2.9, 3.1, 3.3}) {
      const QString folder = QString("near%1/").arg(near);
      const GreyGrid grid = gridOf(randomScene(7, 1, near), 3, 5);
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 5; ++column)
          writeGreyPicture(
              folder + QString("out_0%1_0%2_%3_%4.png").arg(row).arg(column).arg(-row).arg(-column),
              grid.view(row, column));
      const LightFieldOrder order = findLightFieldOrder(viewsIn(folder), {});
      Occlusions votes = order.measured.alongColumns;
      votes += order.measured.alongRows;
      if (order.measured.sureness != Sureness::unknown || votes.ordered < votes.reversed + 3)
        continue;
      ++outvoted;
      QVERIFY2(order.sureness == Sureness::unknown, order.reason.c_str());
    }
    QVERIFY(outvoted > 0);
  }

  /// The pictures are believed, but they are not called sure.
  void positionsThatContradictThePictures() {
    const GreyGrid grid = gridOf(randomScene(7, 1, 6), 3, 5);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 5; ++column)
        writeGreyPicture(
            QString("v/out_0%1_0%2_%3_%4.png").arg(row).arg(column).arg(-row).arg(column),
            grid.view(row, column));
    const LightFieldOrder order = findLightFieldOrder(viewsIn("v"), {});
    QVERIFY(order.found.rows == RowOrder::topDown);
    QCOMPARE(order.sureness, Sureness::likely);
    QVERIFY2(order.reason.find("say the opposite") != std::string::npos, order.reason.c_str());
  }

  /// A slope hides nothing: its motion is that of its reversed depth, too, whatever the order is.
  void motionAloneIsNoEvidence() {
    ViewScene scene = randomScene(7, 0, 0);
    scene.layers.resize(1);
    scene.layers[0].slope = 2;
    for (const bool isReversed : {false, true}) {
      const std::string folder = isReversed ? "reversed" : "usual";
      writeGrid(QString::fromStdString(folder), gridOf(scene, 3, 5, {isReversed, isReversed}));
      const auto [session, order, note, hogels] = orderedSessionAround(folder);
      QVERIFY(std::abs(order.measured.correlation) > 0.9);
      QCOMPARE(order.sureness, Sureness::unknown);
      QVERIFY2(order.reason.ends_with("little tells near from far"), order.reason.c_str());
      // The sheet has words below the views then.
      AssumedOrder assumed = assumedOrder(session.lightField, {240, 180, 5, 3}, order);
      const Image sheet = contactSheet(order, assumed, session.display).image;
      assumed.sureness = Sureness::likely;
      const Image other = contactSheet(order, assumed, session.display).image;
      QVERIFY(sheet.height > other.height);
      const auto words =
          std::count_if(sheet.rgb.begin() + std::ptrdiff_t(other.rgb.size()), sheet.rgb.end(),
                        [](std::uint8_t value) { return value > 150; });
      QVERIFY(words > 1000);
    }
  }

  /// A hogel image has both directions reversed, or one, which nothing mends.
  void directionsOfHogels() {
    const ViewScene scene = randomScene(7, 1, 6);
    for (const bool isBoth : {false, true}) {
      const GreyGrid grid = gridOf(scene, 3, 5, {true, isBoth, false});
      std::vector<GreyPicture> views;
      for (int k = 0; k < 15; ++k) views.push_back(grid.view(k / 5, k % 5));
      writeImageFile("h.png", 240 * 5, 180 * 3, [&](int x, int y, int) {
        const GreyPicture& view = views[std::size_t(y % 3 * 5 + x % 5)];
        return float(view.values[std::size_t(y / 3 * 240 + x / 5)]) / 255;
      });
      LightFieldParams params;
      params.file = "h.png";
      PanelParams display;
      display.hogels = {240, 180};
      display.directions = {5, 3};
      const LightFieldOrder order = findLightFieldOrder(params, display);
      QCOMPARE(order.sureness, Sureness::sure);
      QCOMPARE(order.found.incoming, isBoth);
      QCOMPARE(order.warnings.empty(), isBoth);
      params.incoming = isBoth;
      QCOMPARE(contradictionOf(params, order), std::string());
    }
  }

  void aQuilt() {
    const GreyGrid grid = gridOf(randomScene(4, -2.5, 2.5), 1, 12, {false, true, false});
    writeTiles("q_qs4x3a1.png",
               {3, 4, [&](int y, int x) { return grid.view(0, (2 - y) * 4 + x); }});
    const auto [session, order, note, hogels] = orderedSessionAround("q_qs4x3a1.png");
    QCOMPARE(order.sureness, Sureness::sure);
    QVERIFY(order.columns == ColumnOrder::rightLeft);
    QVERIFY(session.lightField.incoming);
    // A lens sheet of a panel of another size weaves the same views.
    DisplayParams display;
    display.sheet.emplace().calibration.params = {
        .pitch = 5, .slope = -6, .center = 0.1, .dpi = 50, .panel = {180, 120}, .cone = 40};
    const LightFieldOrder onSheet = findLightFieldOrder(session.lightField, display);
    QCOMPARE(onSheet.sureness, Sureness::sure);
    QVERIFY(onSheet.columns == order.columns);
    QCOMPARE(onSheet.reason, order.reason);
  }

  void aMosaic_data() {
    QTest::addColumn<bool>("isUp");
    QTest::addColumn<bool>("isLeft");
    for (const bool isUp : {false, true})
      for (const bool isLeft : {false, true}) QTest::addRow("%d%d", isUp, isLeft) << isUp << isLeft;
  }

  /// One picture of many rows of cameras is no quilt, whatever its name says.
  void aMosaic() {
    QFETCH(const bool, isUp);
    QFETCH(const bool, isLeft);
    const GreyGrid grid = gridOf(randomScene(7, 1, 6), 5, 7, {isUp, isLeft, false});
    for (const char* name : {"m.png", "m_qs7x5a1.png"}) writeTiles(name, grid);
    const auto [session, order, note, hogels] = orderedSessionAround("m.png");
    QVERIFY(session.lightField.layout == Layout::mosaic);
    QCOMPARE(session.display.directions, (std::array{7, 5}));
    QCOMPARE(hogels, Sureness::likely);
    QCOMPARE(QByteArray::fromStdString(note),
             QByteArray("a mosaic of 7×5 views, found by parallax along both axes"));
    QCOMPARE(order.sureness, Sureness::sure);
    QVERIFY((session.lightField.rows == RowOrder::bottomUp) == isUp);
    QVERIFY((session.lightField.columns == ColumnOrder::rightLeft) == isLeft);
    for (const double shear : session.lightField.shear)
      QVERIFY(shear > 0.95 && shear < 6);  // half is background, at 1
    QVERIFY(mendingOf(session.lightField, findLightFieldOrder(session.lightField, session.display))
                .empty());
    const OrderedSession named = orderedSessionAround("m_qs7x5a1.png");
    QVERIFY(named.session.lightField.layout == Layout::quilt);
    QCOMPARE(named.order.sureness, Sureness::unknown);
    QCOMPARE(named.order.warnings.size(), std::size_t(1));
    const std::string advice = "try lightField.layout=mosaic display.directions=[7,5]";
    QVERIFY2(named.order.warnings[0].ends_with(advice), named.order.warnings[0].c_str());
  }

  void aMosaicThatNothingMends() {
    writeTiles("m.png", gridOf(randomScene(7, 1, 6), 5, 7, {false, false, true}));
    const auto [session, order, note, hogels] = orderedSessionAround("m.png");
    QVERIFY(session.lightField.layout == Layout::mosaic);
    QCOMPARE(order.sureness, Sureness::unknown);
    QCOMPARE(order.warnings.size(), std::size_t(1));
    QVERIFY(order.warnings[0].find("rows of tiles are columns") != std::string::npos);
  }

  /// Cameras of one row, tile after tile from the bottom left.
  void aQuiltWithoutAName() {
    const GreyGrid row = gridOf(randomScene(4, -2.5, 2.5), 1, 12);
    writeTiles("q.png", {3, 4, [&](int y, int x) { return row.view(0, (2 - y) * 4 + x); }});
    const auto [session, order, note, hogels] = orderedSessionAround("q.png");
    QVERIFY(session.lightField.layout == Layout::quilt);
    QCOMPARE(session.lightField.quiltColumns, 4);
    QCOMPARE(session.lightField.quiltRows, 3);
    QVERIFY(order.warnings.empty());
  }

  /// From the top left, from the right, with tiles that are empty at the end; as a JPEG.
  void quiltsFromTheTop() {
    for (const bool isLeft : {false, true}) {
      const GreyGrid row = gridOf(randomScene(4, -2.5, 2.5), 1, 12, {false, isLeft, false});
      const auto viewAt = [&](int y, int x) {
        GreyPicture view = row.view(0, y * 4 + x);
        if (y == 2 && x > 1) std::ranges::fill(view.values, 0);
        return view;
      };
      writeTiles("q.jpg", {3, 4, viewAt});
      const auto [session, order, note, hogels] = orderedSessionAround("q.jpg");
      QVERIFY(session.lightField.layout == Layout::quilt);
      QCOMPARE(session.lightField.quiltColumns, 4);
      QVERIFY(session.lightField.quiltStart == QuiltStart::topLeft);
      QVERIFY(order.sureness != Sureness::unknown);
      QCOMPARE(session.lightField.incoming, isLeft);
      QCOMPARE(order.warnings.size(), std::size_t(1));
      QVERIFY2(order.warnings[0].find("2 of 12 tiles are empty") != std::string::npos,
               order.warnings[0].c_str());
      LightFieldParams used = session.lightField;
      used.quiltStart = QuiltStart::bottomLeft;
      const std::string line = contradictionOf(used, order);
      QVERIFY2(line.find("lightField.start=top-left") != std::string::npos, line.c_str());
    }
  }

  /// What is said of a quilt is not guessed: 16 views are 4×4 tiles, and 20 are none of this one.
  void aLayoutThatIsGiven() {
    const GreyGrid row = gridOf(randomScene(4, -2.5, 2.5), 1, 16);
    writeTiles("q.jpg", {4, 4, [&](int y, int x) { return row.view(0, (3 - y) * 4 + x); }});
    const auto given = [](const std::string& views) {
      return sessionAround("q.jpg", {"lightField.layout=quilt", "display.directions=" + views});
    };
    const LightFieldParams quilt = given("[16,1]").lightField;
    QVERIFY(quilt.layout == Layout::quilt && quilt.quiltColumns == 4 && quilt.quiltRows == 4);
    const QString error = errorOf([&] { (void)given("[20,1]"); });
    QVERIFY2(error.contains("lightField.columns"), qPrintable(error));
  }

  /// Without a known order there is no shear; so many missing numbers leave none.
  void noShearOfAGuess() {
    const GreyGrid row = gridOf(randomScene(7, 1, 6), 1, 17);
    for (const int k : {0, 1, 4, 5, 7, 10, 11, 12, 14, 16})
      writeGreyPicture(QString("v/view%1.png").arg(k), row.view(0, k));
    const auto [session, order, note, hogels] = orderedSessionAround("v");
    QCOMPARE(order.sureness, Sureness::unknown);
    QVERIFY2(order.reason.starts_with("so many numbers are missing"), order.reason.c_str());
    QVERIFY((session.lightField.shear == std::array{0.0, 0.0}));
  }

  /// Names with row and column say the grid, and so does a warning.
  void directionsThatAreIgnored() {
    writeGrid("v", gridOf(randomScene(7, 1, 6), 3, 4));
    const OrderedSession around = orderedSessionAround("v", {"display.directions=[5,5]"});
    QCOMPARE(around.order.warnings.size(), std::size_t(1));
    QVERIFY(around.order.warnings[0].starts_with("display.directions: 5×5 is ignored"));
    QVERIFY(orderedSessionAround("v", {"display.directions=[4,3]"}).order.warnings.empty());
  }

  void documentForPrograms() {
    LightFieldOrder order;
    order.found.layout = Layout::views;
    order.found.rows = RowOrder::bottomUp;
    order.sureness = Sureness::likely;
    LightFieldParams used = order.found;
    used.shear = {1.5, -2};
    QCOMPARE(QByteArray::fromStdString(orderDocument(assumedOrder(used, {9, 8, 3, 2}, order))),
             QByteArray(R"({"layout":"views","hogels":[9,8],"directions":[3,2],)"
                        R"("rows":"bottom-up","columns":"left-right","shear":[1.5,-2.0],)"
                        R"("confidence":"likely","warnings":[]})"
                        "\n"));
    used.rows = RowOrder::topDown;
    const AssumedOrder wrong = assumedOrder(used, {9, 8, 3, 2}, order);
    QVERIFY(wrong.rows == RowOrder::topDown && wrong.sureness == Sureness::unknown);
    QCOMPARE(wrong.warnings.size(), std::size_t(1));
  }

  /// A set made by others, with all reversed: its files are linked under other names.
  void realGrid() {
    if (!QFileInfo::exists(data + "shop_13x13")) QSKIP("no ../shared/data/shop_13x13 here");
    QVERIFY(QDir().mkdir("v"));
    const QDir folder(data + "shop_13x13");
    for (const QString& name : folder.entryList({"Original Camera_*.jpg"})) {
      // 1, 3 … 25 from the bottom right
      const int row = (name.section('_', 1, 1).toInt() - 1) / 2;
      const int column = (name.section('_', 2, 2).toInt() - 1) / 2;
      QVERIFY(
          QFile::link(folder.filePath(name), QString::asprintf("v/%03d_%03d.jpg", column, row)));
    }
    const auto [session, order, note, hogels] = orderedSessionAround("v");
    QCOMPARE(order.sureness, Sureness::sure);
    QVERIFY(session.lightField.rows == RowOrder::bottomUp);
    QVERIFY(session.lightField.columns == ColumnOrder::rightLeft);
    QVERIFY(!session.lightField.pattern.empty());
    for (const double shear : session.lightField.shear)
      QVERIFY2(std::abs(shear - 5.6) < 0.4, qPrintable(QString::number(shear)));
  }

  /// The same views as tiles of a picture; black in its corners, as those of a plenoptic camera.
  void realMosaic() {
    if (!QFileInfo::exists(data + "shop_13x13")) QSKIP("no ../shared/data/shop_13x13 here");
    const QDir folder(data + "shop_13x13");
    QImage mosaic(13 * 312, 13 * 208, QImage::Format_RGB32);
    mosaic.fill(Qt::black);
    QPainter painter(&mosaic);
    for (const QString& name : folder.entryList({"Original Camera_*.jpg"})) {
      // 1, 3 … 25 from the bottom right
      const int row = 12 - (name.section('_', 1, 1).toInt() - 1) / 2;
      const int column = 12 - (name.section('_', 2, 2).toInt() - 1) / 2;
      if (std::hypot(row - 6, column - 6) < 7.5)
        painter.drawImage(QRect(312 * column, 208 * row, 312, 208), QImage(folder.filePath(name)));
    }
    painter.end();
    QVERIFY(mosaic.save("m.png"));
    const auto [session, order, note, hogels] = orderedSessionAround("m.png");
    QVERIFY(session.lightField.layout == Layout::mosaic);
    QCOMPARE(session.display.directions, (std::array{13, 13}));
    QCOMPARE(order.sureness, Sureness::sure);
    QCOMPARE(order.warnings.size(), std::size_t(1));
    QVERIFY(order.warnings[0].find("of 169 tiles are empty") != std::string::npos);
    QVERIFY(session.lightField.rows == RowOrder::topDown);
    QVERIFY(session.lightField.columns == ColumnOrder::leftRight);
    for (const double shear : session.lightField.shear)
      QVERIFY2(std::abs(shear - 5.6 * 312 / 960) < 0.2, qPrintable(QString::number(shear)));
  }

  /// 4×8 tiles from the bottom left, taken from the left.
  void realQuilts() {
    if (!QFileInfo::exists(data + "quilt_kirurobo")) QSKIP("no ../shared/data/quilt_kirurobo here");
    for (const char* name : {"example01.png", "startup.png"}) {
      const LightFieldOrder order =
          orderedSessionAround(
              (data + "quilt_kirurobo/" + name).toStdString(),
              {"lightField.layout=quilt", "lightField.columns=4", "lightField.rows=8"})
              .order;
      QVERIFY(order.sureness == Sureness::unknown || !order.found.incoming);
      QCOMPARE(order.sureness != Sureness::unknown, QByteArray(name) != "startup.png");
      QVERIFY(!order.isLikeMosaic);
      // Its tiles are found too, in a name that says nothing.
      const auto [session, found, note, hogels] =
          orderedSessionAround((data + "quilt_kirurobo/" + name).toStdString());
      QCOMPARE(session.lightField.layout, Layout::quilt);
      QVERIFY(session.lightField.quiltColumns == 4 && session.lightField.quiltRows == 8);
      // One of them shows text without parallax, as the front of a house might repeat.
      QCOMPARE(hogels, name == std::string("startup.png") ? Sureness::unknown : Sureness::likely);
    }
  }

  void coloursOfEveryLayout_data() {
    QTest::addColumn<QString>("layout");
    for (const char* layout : {"views", "hogels", "quilt", "mosaic"})
      QTest::newRow(layout) << QString(layout);
  }

  /// The colours are those of the texels, in the order of the grey views.
  void coloursOfEveryLayout() {
    QFETCH(const QString, layout);
    constexpr int nx = 12, ny = 10, columns = 4, rows = 3;
    const auto light = [](int row, int column, int x, int y, int c) {
      return float((37 * row + 53 * column + 7 * x + 11 * y + 91 * c) % 256) / 255;
    };
    LightFieldParams params;
    DisplayParams display;
    params.file = layout == "views" ? "v" : "v/0.png";
    display.directions = {columns, rows};
    if (layout == "views") {
      params.layout = Layout::views;
      for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
          writeImageFile(QString("v/00%1_00%2.png").arg(row).arg(column), nx, ny,
                         [&](int x, int y, int c) { return light(row, column, x, y, c); });
    } else if (layout == "hogels") {
      display.hogels = {nx, ny};
      writeImageFile("v/0.png", nx * columns, ny * rows, [&](int x, int y, int c) {
        return light(y % rows, x % columns, x / columns, y / rows, c);
      });
    } else {
      params.layout = layout == "quilt" ? Layout::quilt : Layout::mosaic;
      params.quiltColumns = columns;
      params.quiltRows = rows;
      writeImageFile("v/0.png", nx * columns, ny * rows,
                     [&](int x, int y, int c) { return light(y / ny, x / nx, x % nx, y % ny, c); });
    }
    const auto views = greyViewsOf(params, display, {});
    QVERIFY(views && views->colours);
    for (int row = 0; row < views->grid.rows; ++row)
      for (int column = 0; column < views->grid.columns; ++column) {
        const FloatImage colours = views->colours(row, column, {});
        const GreyPicture grey = views->grid.view(row, column);
        QVERIFY(colours.width == nx && colours.height == ny && grey.width == nx);
        const int tile = layout == "quilt" ? (rows - 1 - column / columns) : row;
        for (int k = 0; k < nx * ny; ++k) {
          const float* rgb = &colours.rgb[std::size_t(3 * k)];
          for (int c = 0; c < 3; ++c)
            QVERIFY(std::abs(rgb[c] - 255 * light(tile, column % columns, k % nx, k / nx, c)) <
                    1e-3F);
          const float luma = 0.299F * rgb[0] + 0.587F * rgb[1] + 0.114F * rgb[2];
          QVERIFY(std::abs(luma - float(grey.values[std::size_t(k)])) < 0.51F);
        }
      }
  }

  /// 1000 values from 10 to 29.98: the 0.5th and 99.5th percentiles become 0 and 255. As bright as
  /// a quarter, or of one value, they stay.
  void contrastOfDarkValues() {
    std::vector<float> values;
    for (int k = 0; k < 1000; ++k) values.push_back(10 + 0.02F * float(k));
    const Contrast contrast(values);
    QVERIFY(contrast.isStretched());
    QCOMPARE(int(contrast(values[4])), 0);
    QCOMPARE(int(contrast(values[994])), 255);
    QCOMPARE(int(contrast(0)), 0);
    QCOMPARE(int(contrast(200)), 255);
    QCOMPARE(int(contrast((values[4] + values[994]) / 2)), 128);
    values.insert(values.end(), 10, 65);
    const Contrast usual(values);
    QVERIFY(!usual.isStretched());
    for (const int value : {0, 20, 255}) QCOMPARE(int(usual(float(value))), value);
    QVERIFY(!Contrast(std::vector<float>(50, 3)).isStretched());
    QVERIFY(!Contrast({}).isStretched());
  }

  void realTinyGrid() {
    if (!QFileInfo::exists(data + "jplm_small_greek_3x3")) QSKIP("no jplm_small_greek_3x3 here");
    const LightFieldOrder order = findLightFieldOrder(viewsIn(data + "jplm_small_greek_3x3"), {});
    QVERIFY(order.sureness != Sureness::sure);
  }

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestLightFieldOrder)
#include "test_light_field_order.moc"
