// SPDX-License-Identifier: BSD-3-Clause
// Tests that a folder's views are found by their names as people give them, with holes, among
// other files, and that nothing hostile takes long.
#include <QTemporaryDir>
#include <QTest>
#include <random>

#include "capture/names/name_pattern.h"
#include "io/layouts/layouts.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

void writeTiny(const QString& file) {
  writeFile(file, "P5 2 1 255\nab");
}

LightFieldParams viewsIn(const QString& folder, const char* exclude = "") {
  LightFieldParams params;
  params.file = folder.toStdString();
  params.layout = Layout::views;
  params.exclude = exclude;
  return params;
}

ViewFiles found(const QString& folder, std::array<int, 2> directions = {0, 0}) {
  return findViews(viewsIn(folder), directions);
}

QStringList namesOf(const ViewFiles& views) {
  QStringList names;
  for (const auto& file : views.files)
    names.push_back(QString::fromStdString(file.filename().string()));
  return names;
}

QString gridText(const ViewFiles& views) {
  return QString("%1×%2").arg(views.rows).arg(views.columns);
}

}  // namespace

class TestViewNames : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> m_folder;

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir::setCurrent(m_folder->path()));
  }

  /// Names with {r}, {c} for row and column, {n} for a number, {x}, {y} for coordinates, 3×4 views.
  void grids_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("pattern");
    const auto row = [](const char* name, const char* pattern) {
      QTest::newRow(name) << QString(name) << QString(pattern);
    };
    row("00{r}_00{c}.pgm", "RRR_CCC");
    row("Bikes_00{r}_00{c}.pgm", "Bikes_RRR_CCC.pgm");
    row("kitchen_out_0{r}_0{c}_{y}_{x}_crop.pgm", "*_RR_CC_y_x_*");
    row("lego({y},{x})_{r}_{c} 8bit.pgm", "");
    row("scene2-{r}-{c}-v2.pgm", "scene2-RR-CC-v2.pgm");
    row("c_{c}-r_{r}.pgm", "c_CC-r_RR.pgm");
    row("x{c}y{r}.pgm", "*CC*RR.pgm");
    row("frame_0007_{r}_{c}.pgm", "frame_0007_RR_CC.pgm");
    row("cam_{x}_{y}.pgm", "cam_x_y.pgm");
    row("y{y}mm x{x}mm.pgm", "*y*x*");
    row("{n}: {x}, {y}.pgm", "*x, y.pgm");
    row("Größe {r}/{c}", "");
  }

  void grids() {
    QFETCH(QString, name);
    QFETCH(QString, pattern);
    name.replace('/', '+');
    QStringList expected;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) {
        QString own = name;
        own.replace("{r}", QString::number(row)).replace("{c}", QString::number(column));
        own.replace("{n}", QString::number((7 * row + 5 * column) % 12));
        own.replace("{x}", QString::number(-12.5 + 10 * column));
        own.replace("{y}", QString::number(20 * row - 25));
        expected.push_back(own);
        writeTiny("v/" + own);
      }
    const ViewFiles views = found("v");
    QCOMPARE(namesOf(views), expected);
    if (!pattern.isEmpty()) QCOMPARE(QString::fromStdString(views.pattern), pattern);
    QVERIFY(views.missing.empty() && views.others.empty());
    // The pattern that is told reads them in the same way.
    LightFieldParams again = viewsIn("v");
    again.pattern = views.pattern;
    QCOMPARE(namesOf(findViews(again, {0, 0})), expected);
  }

  /// Stanford's gantry stands up to a tenth of its step off; the names have no row and column.
  void positionsOfAGantry() {
    std::mt19937 random{5};
    std::uniform_real_distribution<double> off(-6, 6);
    QStringList expected;
    for (int row = 0; row < 9; ++row)
      for (int column = 0; column < 17; ++column) {
        expected.push_back(QString("g_%1_%2.pgm")
                               .arg(60.0 * column - 480 + off(random), 0, 'f', 6)
                               .arg(60.0 * row - 900 + off(random), 0, 'f', 6));
        if (row + column > 2) writeTiny("v/" + expected.back());
      }
    const ViewFiles views = found("v");
    QCOMPARE(gridText(views), QString("9×17"));
    for (qsizetype k = 0; k < expected.size(); ++k) {
      const bool isThere = k / 17 + k % 17 > 2;
      QCOMPARE(namesOf(views)[k], isThere ? expected[k] : QString());
    }
    QVERIFY(views.columnsFromTo && std::abs((*views.columnsFromTo)[0] + 480) < 6);
    QVERIFY(views.rowsFromTo && std::abs((*views.rowsFromTo)[1] + 420) < 6);
    QCOMPARE(QByteArray::fromStdString(transposedPattern(views.pattern)), QByteArray("g_y_x.pgm"));
  }

  void rows_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("columns");  // of display.directions
    QTest::addColumn<int>("rows");
    QTest::addColumn<QString>("grid");
    QTest::newRow("no square") << 12 << 0 << 0 << "1×12";
    QTest::newRow("a square") << 16 << 0 << 0 << "4×4";
    QTest::newRow("a row of a square") << 16 << 16 << 1 << "1×16";
    QTest::newRow("a column") << 12 << 1 << 12 << "12×1";
    QTest::newRow("a grid") << 12 << 4 << 3 << "3×4";
    QTest::newRow("the last one is missing") << 11 << 4 << 3 << "3×4";
  }

  /// Of numbers in any width, which count.
  void rows() {
    QFETCH(int, count);
    QFETCH(int, columns);
    QFETCH(int, rows);
    QFETCH(QString, grid);
    QStringList expected;
    for (int k = 1; k <= count; ++k) {
      expected.push_back(QString("view%1.pgm").arg(k));
      writeTiny("v/" + expected.back());
    }
    const ViewFiles views = found("v", {columns, rows});
    QCOMPARE(gridText(views), grid);
    QCOMPARE(namesOf(views).mid(0, count), expected);
    QCOMPARE(views.missing.empty(), count == views.rows * views.columns);
  }

  /// One row or column of a grid's names, and of positions.
  void rowsOfAGrid() {
    for (int k = 0; k < 9; ++k) {
      writeTiny(QString("a/Bikes_004_00%1.pgm").arg(k));
      writeTiny(QString("b/Bikes_00%1_004.pgm").arg(k));
      writeTiny(QString("c/cam_%1.pgm").arg(10 * k - 40.5));
      writeTiny(QString("d/y=%1.pgm").arg(10 * k - 40));
      writeTiny(QString("e/light_4_00%1.pgm").arg(k));
    }
    QCOMPARE(gridText(found("a")), QString("1×9"));
    QCOMPARE(gridText(found("b")), QString("9×1"));
    QCOMPARE(gridText(found("c")), QString("1×9"));
    QCOMPARE(namesOf(found("c")).front(), QString("cam_-40.5.pgm"));
    QCOMPARE(gridText(found("d")), QString("9×1"));
    QCOMPARE(gridText(found("e")), QString("3×3"));
  }

  void holesAreNamed() {
    for (const char* name : {"01_01", "01_05", "03_01", "03_03", "03_05"})
      writeTiny(QString("v/%1.pgm").arg(name));
    const ViewFiles views = found("v");
    QCOMPARE(namesOf(views),
             QStringList({"01_01.pgm", "", "01_05.pgm", "03_01.pgm", "03_03.pgm", "03_05.pgm"}));
    QCOMPARE(QByteArray::fromStdString(views.missing),
             QByteArray("lightField: 1 of 6 views are missing and shown black: (row, column) 1 3"));
    QCOMPARE(views.found().size(), std::size_t(5));
  }

  void sparseSets_data() {
    QTest::addColumn<QString>("shape");
    QTest::addColumn<int>("base");  ///< of the numbers; -1: names of rows and columns
    for (const char* shape : {"cross", "star", "diagonal"})
      for (const int base : {-1, 0, 1}) QTest::addRow("%s, %d", shape, base) << shape << base;
  }

  /// Few views of 9×9, as sets for training have them, or of 3×3: those who say so get them.
  void sparseSets() {
    QFETCH(const QString, shape);
    QFETCH(const int, base);
    for (const int side : {9, 3}) {
      const QString folder = QString("v%1").arg(side);
      QStringList expected;
      for (int k = 0; k < side * side; ++k) {
        const int x = k % side - side / 2, y = k / side - side / 2;
        const bool isDiagonal =
            shape != "cross" && (shape == "star" ? std::abs(x) == std::abs(y) : x == y);
        const bool isThere = isDiagonal || (shape != "diagonal" && (x == 0 || y == 0));
        const QString name = base < 0 ? QString::asprintf("%03d_%03d.pgm", k / side, k % side)
                                      : QString::asprintf("input_Cam%03d.pgm", k + base);
        expected.push_back(isThere ? name : QString());
        if (isThere) writeTiny(folder + "/" + name);
      }
      const ViewFiles views = found(folder, {side, side});
      QCOMPARE(namesOf(views), expected);
      QCOMPARE(views.missing.empty(), !expected.contains(QString()));
    }
    if (shape == "diagonal") return;
    const QString error = errorOf([] { (void)found("v9"); });
    QVERIFY2(error.contains("if the others are missing give display.directions, such as [9,9]"),
             qPrintable(error));
    LightFieldParams params = viewsIn("v9");
    params.pattern = base < 0 ? "RRR_CCC" : "input_CamNNN";
    const QString given = errorOf([&] { (void)findViews(params, {0, 0}); });
    QVERIFY2(given.contains("[9,9], or mend lightField.pattern, \""), qPrintable(given));
    const QString wrong = errorOf([&] { (void)findViews(params, {4, 4}); });
    QVERIFY2(wrong.contains("they are no part of a grid of 4×4: mend display.directions"),
             qPrintable(wrong));
  }

  /// 26 of which 25 would be a square; who says that they are a row hears nothing.
  void oneTooMany() {
    for (int k = 0; k < 26; ++k) writeTiny(QString("v/view_%1.pgm").arg(k));
    const ViewFiles views = found("v");
    QCOMPARE(gridText(views), QString("1×26"));
    QVERIFY2(views.surplus.find("without one they are 5×5: lightField.exclude=view_25.pgm") !=
                 std::string::npos,
             views.surplus.c_str());
    QCOMPARE(found("v", {26, 1}).surplus, std::string());
    const ViewFiles mended = findViews(viewsIn("v", "view_25.pgm"), {0, 0});
    QCOMPARE(gridText(mended), QString("5×5"));
    QCOMPARE(mended.surplus, std::string());
  }

  /// A row that no file has at all: its neighbours stay two apart.
  void anEmptyRow() {
    for (const int row : {0, 1, 3})
      for (const int column : {0, 1}) writeTiny(QString("v/%1_%2.pgm").arg(row).arg(column));
    QCOMPARE(gridText(found("v")), QString("4×2"));
    for (int k = 0; k < 8; ++k)
      if (k != 3 && k != 5) writeTiny(QString("n/input_Cam%1.pgm").arg(k + 1));
    const ViewFiles running = found("n", {4, 2});
    QCOMPARE(namesOf(running)[3], QString());
    QVERIFY2(running.missing.ends_with("number 4, 6"), running.missing.c_str());
  }

  /// What stands beside the views, in the numbers and kinds that real sets have.
  void otherFiles() {
    for (int k = 0; k < 9; ++k) {
      writeTiny(QString("v/Bikes_%1_%2.pgm").arg(k / 3).arg(k % 3));
      writeTiny(QString("v/Bikes_depth_%1_%2.pgm").arg(k / 3).arg(k % 3));
      writeFile(QString("v/Bikes_%1_%2.txt").arg(k / 3).arg(k % 3), "1 0 0 0");
      writeFile(QString("v/IMG_%1.txt").arg(k), "hello");
      writeFile(QString("v/IMG_1%1.txt").arg(k), "hello");
      if (k < 6) writeTiny(QString("v/preview%1.pgm").arg(k));
    }
    for (const char* name : {"README", "parameters.cfg", "gt_disp_lowres.pfm", ".DS_Store",
                             "._Bikes_0_0.pgm", "Bikes_0_0.pgm.d/a"})
      writeFile(QString("v/") + name, "x");
    const ViewFiles views = found("v");
    QCOMPARE(gridText(views), QString("3×3"));
    QCOMPARE(namesOf(views).back(), QString("Bikes_2_2.pgm"));
    QCOMPARE(views.others.size(), std::size_t(9 + 9 + 18 + 6 + 3));
  }

  /// Of names that agree, but for pictures of two sizes.
  void anotherSize() {
    for (int k = 0; k < 9; ++k) {
      writeTiny(QString("v/view_512_%1.pgm").arg(k));
      writeFile(QString("v/view_128_%1.pgm").arg(k), "P5 1 1 255\na");
    }
    const ViewFiles views = found("v");
    QCOMPARE(gridText(views), QString("3×3"));
    QCOMPARE(namesOf(views).front(), QString("view_512_0.pgm"));
    QCOMPARE(views.others.size(), std::size_t(9));
    QCOMPARE(namesOf(findViews(viewsIn("v", "*_512_*"), {0, 0})).front(),
             QString("view_128_0.pgm"));
  }

  /// The larger pictures, although there are more thumbnails of them; and what the others are.
  void thumbnails() {
    for (int k = 0; k < 9; ++k) {
      writeFile(QString("v/view_%1.pgm").arg(3 * k), "P5 4 2 255\nabcdefgh");
      for (int small : {1, 2}) writeTiny(QString("v/view_%1.pgm").arg(3 * k + small));
    }
    const ViewFiles views = found("v");
    QCOMPARE(gridText(views), QString("3×3"));
    QCOMPARE(namesOf(views).at(1), QString("view_3.pgm"));
    QCOMPARE(views.others.size(), std::size_t(18));
    QCOMPARE(QString::fromStdString(views.otherSizes), QString("18 pictures of 2×1 px"));
  }

  /// Numbers of views of a larger grid, `first` + pitch · row + step · column.
  void partsOfAGrid_data() {
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("step");
    QTest::addColumn<int>("pitch");
    QTest::addColumn<int>("rows");
    QTest::addColumn<int>("columns");
    QTest::newRow("HCI's 3×3 of 9×9") << 0 << 4 << 36 << 3 << 3;
    QTest::newRow("HCI's corners") << 0 << 8 << 72 << 2 << 2;
    QTest::newRow("9×9 of 17×17") << 0 << 2 << 34 << 9 << 9;
    QTest::newRow("from 10, row 1, column 1") << 10 << 2 << 18 << 4 << 4;
    QTest::newRow("a row and a column in one number") << 101 << 1 << 100 << 5 << 5;
    QTest::newRow("9 columns of 10") << 0 << 1 << 10 << 5 << 9;
    QTest::newRow("not square") << 3 << 3 << 24 << 3 << 5;
  }

  void partsOfAGrid() {
    QFETCH(const int, first);
    QFETCH(const int, step);
    QFETCH(const int, pitch);
    QFETCH(const int, rows);
    QFETCH(const int, columns);
    QStringList expected;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const int number = first + pitch * row + step * column;
        expected.push_back(QString("input_Cam%1.pgm").arg(number, 3, 10, QChar('0')));
        writeTiny("v/" + expected.back());
      }
    for (const std::array<int, 2> directions : {std::array{0, 0}, {columns, rows}}) {
      const ViewFiles views = found("v", directions);
      QCOMPARE(gridText(views), QString("%1×%2").arg(rows).arg(columns));
      QCOMPARE(namesOf(views), expected);
      QVERIFY(views.missing.empty() && !views.isLoose);
    }
    // One view fewer is missing, and the grid is the same.
    if (rows < 3) return;
    QVERIFY(QFile::remove("v/" + expected[columns + 1]));
    if (10 * (rows * columns - 1) < 9 * rows * columns) return;
    const ViewFiles views = found("v");
    QCOMPARE(gridText(views), QString("%1×%2").arg(rows).arg(columns));
    QVERIFY(views.missing.find("1 of ") != std::string::npos);
  }

  /// One or two missing views of a row are no gap that repeats.
  void gapsThatDoNotRepeat() {
    for (int k = 0; k < 20; ++k)
      if (k != 9 && k != 15) writeTiny(QString("v/view%1.pgm").arg(k));
    const ViewFiles views = found("v");
    QCOMPARE(gridText(views), QString("1×20"));
    QVERIFY(!views.isLoose);
    for (int k : {0, 1, 4, 5, 7, 10, 11, 12, 14, 16}) writeTiny(QString("loose/view%1.pgm").arg(k));
    QVERIFY(found("loose").isLoose);
  }

  /// Times, and a counter that began again, tell an order alone.
  void orders_data() {
    QTest::addColumn<QStringList>("names");
    QTest::newRow("seconds") << QStringList{
        "IMG_20240102_101530", "IMG_20240102_101531", "IMG_20240102_101533", "IMG_20240102_101541",
        "IMG_20240102_101600", "IMG_20240102_110000", "IMG_20240103_000001"};
    QTest::newRow("milliseconds") << QStringList{"20231231235959123", "20231231235959999",
                                                 "20240101000000001"};
    QTest::newRow("a screenshot's") << QStringList{"Shot 2024-01-02 at 1", "Shot 2024-01-02 at 2"};
    QTest::newRow("with hyphens") << QStringList{"2024-01-02 10.15.30", "2024-01-02 10.15.37",
                                                 "2024-01-02 10.16.02", "2024-01-03 09.00.00",
                                                 "2024-02-03 09.00.00"};
    QTest::newRow("since 1970") << QStringList{"1700000001", "1700000009", "1700000010"};
    QTest::newRow("nanoseconds") << QStringList{"1403636579763555584", "1403636579813555456",
                                                "1403636579963555584"};
    QTest::newRow("a counter") << QStringList{"DSC_9997", "DSC_9998", "DSC_9999", "DSC_0001",
                                              "DSC_0002"};
    QTest::newRow("with 0") << QStringList{"a998", "a999", "a000", "a001", "a002"};
  }

  void orders() {
    QFETCH(QStringList, names);
    for (QString& name : names) {
      name += ".pgm";
      writeTiny("v/" + name);
    }
    const ViewFiles views = found("v");
    QCOMPARE(namesOf(views), names);
    QCOMPARE(views.rows, 1);
    QVERIFY(views.missing.empty());
    QCOMPARE(gridText(found("v", {1, int(names.size())})), QString("%1×1").arg(names.size()));
  }

  /// Rows and columns by letters, by folders, and by numbers between points.
  void otherNames_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"{L}{c}.pgm", "view_{L}0{c}.pgm", "{l}{c}.pgm", "0{r}/0{c}.pgm",
                             "row{r}/column{c}.pgm", "render.{r}.{c}.pgm", "a.0{r}.0{c}.b.pgm"})
      QTest::newRow(name) << QString(name);
  }

  void otherNames() {
    QFETCH(const QString, name);
    QStringList expected;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) {
        QString file = name;
        file.replace("{L}", QString(QChar('A' + row)))
            .replace("{l}", QString(QChar('a' + row)))
            .replace("{r}", QString::number(row))
            .replace("{c}", QString::number(column));
        writeTiny("v/" + file);
        expected.push_back(file.section('/', -1));
      }
    const ViewFiles views = found("v");
    QCOMPARE(gridText(views), QString("3×4"));
    QCOMPARE(namesOf(views), expected);
    QVERIFY(views.others.empty());
    if (views.pattern.empty()) return;
    LightFieldParams params = viewsIn("v");
    params.pattern = views.pattern;
    QVERIFY(findViews(params, {0, 0}).files == views.files);
  }

  void foldersByPercent() {
    for (int k = 0; k < 12; ++k) writeTiny(QString("v/0%1/0%2.pgm").arg(k / 4).arg(k % 4));
    QCOMPARE(gridText(found("v/%02d/%02d.pgm")), QString("3×4"));
  }

  /// Several scenes in folders of their own, or colours beside depths, are not one light field.
  void foldersOfScenes() {
    for (int k = 0; k < 9; ++k)
      for (const char* scene : {"box", "dino"})
        writeTiny(QString("v/%1/input_Cam00%2.pgm").arg(scene).arg(k));
    QVERIFY(errorOf([] { (void)found("v"); }).contains("no files that could be views"));
    for (int k = 0; k < 9; ++k)
      for (const char* kind : {"c", "d"}) writeTiny(QString("w/%1%2.pgm").arg(kind).arg(k));
    QCOMPARE(gridText(found("w")), QString("3×3"));
  }

  /// Names with row and column say the grid.
  void directionsThatAreIgnored() {
    for (int k = 0; k < 12; ++k) writeTiny(QString("v/%1_%2.pgm").arg(k / 4).arg(k % 4));
    QVERIFY(found("v").ignored.empty() && found("v", {4, 3}).ignored.empty());
    const std::string line = found("v", {5, 5}).ignored;
    QVERIFY2(line.find("5×5 is ignored, because the file names say 4×3") != std::string::npos,
             line.c_str());
  }

  /// Known names come before a larger series.
  void knownNamesComeFirst() {
    for (int k = 0; k < 4; ++k) writeTiny(QString("v/00%1_00%2.pgm").arg(k / 2).arg(k % 2));
    for (int k = 0; k < 4; ++k) writeTiny(QString("v/00%1_00%2.ppm").arg(k / 2).arg(k % 2));
    for (int k = 0; k < 20; ++k) writeTiny(QString("v/holiday%1.pgm").arg(k));
    const ViewFiles views = found("v");
    QCOMPARE(namesOf(views).front(), QString("000_000.pgm"));
    QCOMPARE(QByteArray::fromStdString(views.pattern), QByteArray("RRR_CCC.pgm"));
  }

  /// Extensions with digits: the pattern that is told finds the same files, or none is told.
  void extensionsThatVary() {
    for (const char* name : {"input_Cam0.p00ng", "input_Cam03.p0ng", "input_Cam001.png"})
      writeTiny(QString("e/") + name);
    const ViewFiles views = found("e");
    QVERIFY(views.files.size() > 1);
    if (views.pattern.empty()) return;
    LightFieldParams again = viewsIn("e");
    again.pattern = views.pattern;
    QVERIFY(findViews(again, {0, 0}).files == views.files);
  }

  void someAreExcluded() {
    for (int k = 0; k < 9; ++k) writeTiny(QString("v/input_Cam00%1.pgm").arg(k));
    writeTiny("v/input_Cam099.pgm");
    QVERIFY(errorOf([] { (void)found("v"); }).isEmpty() == false);
    const ViewFiles views = findViews(viewsIn("v", "*_thumb.png;input_Cam09?.pgm"), {0, 0});
    QCOMPARE(gridText(views), QString("3×3"));
    QVERIFY(views.others.empty());
    QCOMPARE(findViews(viewsIn("v", "*9*;*[78].pgm"), {0, 0}).files.size(), std::size_t(7));
    const QString all = errorOf([] { (void)findViews(viewsIn("v", "*"), {0, 0}); });
    QVERIFY2(all.contains("no files that could be views"), qPrintable(all));
    QVERIFY(
        !findViews(viewsIn("v", "**************a*a*a*a*a*a*a*a*b;[;;;*9*"), {0, 0}).files.empty());
  }

  void numbersOfAnySize() {
    for (const char* name : {"0_0", "1000000000_1000000000", "999999999999999999_5"})
      writeTiny(QString("v/%1.pgm").arg(name));
    QVERIFY2(errorOf([] { (void)found("v"); }).contains("only 3 of 9 views are there"),
             qPrintable(errorOf([] { (void)found("v"); })));
    for (const char digit : {'1', '2'})
      for (const int length : {18, 240})
        writeTiny(QString("d%1/%2.pgm").arg(length).arg(QString(length, digit)));
    QCOMPARE(gridText(found("d18")), QString("1×2"));
    QVERIFY(errorOf([] { (void)found("d240"); }).contains("give lightField.pattern"));
  }

  void componentsOfTheirOwn() {
    for (int k = 0; k < 12; ++k) writeTiny(QString("v/%1/00%2_000.pgm").arg(k / 4).arg(k % 4));
    writeFile("v/README", "x");
    QCOMPARE(gridText(found("v")), QString("4×1"));
    LightFieldParams params = viewsIn("v");
    params.pattern = "CCC_RRR";
    const ViewFiles views = findViews(params, {0, 0});
    QCOMPARE(gridText(views), QString("1×4"));
    QCOMPARE(views.files.front().string(), std::string("v/0/000_000.pgm"));
  }

  /// Its folder of first components is itself.
  void aCircleOfFolders() {
    QVERIFY(QDir().mkdir("v"));
    QVERIFY(QFile::link(".", "v/0"));
    QVERIFY(errorOf([] { (void)found("v"); }).contains("no files that could be views"));
  }

  void manyFiles() {
    QVERIFY(QDir().mkdir("v"));
    for (int k = 0; k < 5000; ++k) {
      QFile file(QString("v/a%1_%2_%3.txt").arg(k / 100).arg(k % 7919).arg(k));
      QVERIFY(file.open(QIODevice::WriteOnly));
    }
    QVERIFY(!errorOf([] { (void)found("v"); }).isEmpty());
  }
};

QTEST_APPLESS_MAIN(TestViewNames)
#include "test_view_names.moc"
