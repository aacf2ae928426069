// SPDX-License-Identifier: BSD-3-Clause
// Tests that folders of views put each pixel at the right directional pixel.
#include <QTemporaryDir>
#include <QTest>

#include "io/scene/view_source.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"
#include "tests/io/light_fields.h"
#include "tests/io/texels.h"

using namespace hogelscope;

namespace {

constexpr int width = 5;
constexpr int height = 4;

/// Pixel (x, y) of the view in a row and column as the file names count them, from 0.
Rgb colourOf(int row, int column, int x, int y) {
  return {50.0 * row + 10 * column + 1, 40.0 * x + 9 * y + 2, 77};
}

void writeView(const QString& file, int row, int column) {
  writeImageFile(
      file, width, height,
      [row, column](int x, int y, int channel) {
        const Rgb colour = colourOf(row, column, x, y);
        return float((channel == 0 ? colour.r : channel == 1 ? colour.g : colour.b) / 255);
      },
      PictureKind{});
}

void writeViews(const QString& folder, int rows, int columns) {
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      writeView(QString("%1/00%2_00%3.png").arg(folder).arg(row).arg(column), row, column);
}

LightFieldParams viewsIn(const QString& file) {
  LightFieldParams params;
  params.file = file.toStdString();
  params.layout = Layout::views;
  return params;
}

/// From the top left.
Rgb inPlace(const TexelIndex& at) {
  return colourOf(at.v, at.u, at.i, at.j);
}

}  // namespace

class TestViewFolders : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void orders_data();
  void orders();
  void names_data();
  void names();
  void numbersCount();
  void otherFilesAreLeftAlone();
  void numbersOfAnyGrid();
  void shear_data();
  void shear();
  void shearIsOfTheDisplaysDirections();
  void displayTakesTheFoldersSize();
  void theFirstViewSaysTheType();
  void missingViewsAreBlack_data();
  void missingViewsAreBlack();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestViewFolders::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestViewFolders::orders_data() {
  QTest::addColumn<bool>("bottomUp");
  QTest::addColumn<bool>("rightLeft");
  QTest::addColumn<bool>("incoming");
  for (const bool bottomUp : {false, true})
    for (const bool rightLeft : {false, true})
      for (const bool incoming : {false, true})
        QTest::addRow("%s, %s%s", bottomUp ? "bottom-up" : "top-down",
                      rightLeft ? "right-left" : "left-right", incoming ? ", incoming" : "")
            << bottomUp << rightLeft << incoming;
}

void TestViewFolders::orders() {
  QFETCH(bool, bottomUp);
  QFETCH(bool, rightLeft);
  QFETCH(bool, incoming);
  writeViews("views", 3, 4);
  LightFieldParams params = viewsIn("views");
  params.rows = bottomUp ? RowOrder::bottomUp : RowOrder::topDown;
  params.columns = rightLeft ? ColumnOrder::rightLeft : ColumnOrder::leftRight;
  params.incoming = incoming;
  const LightField lightField = openLightField(params, {})->read({});
  QVERIFY(lightField.size() == (LightFieldSize{width, height, 4, 3}));
  const auto expected = [=](const TexelIndex& at) {
    return colourOf(bottomUp != incoming ? 2 - at.v : at.v, rightLeft != incoming ? 3 - at.u : at.u,
                    at.i, at.j);
  };
  QCOMPARE(firstWrong(lightField, expected), QString());
}

/// Printf formats of the names that 3×3 views have, numbered from `first` in steps of `step`.
void TestViewFolders::names_data() {
  QTest::addColumn<QByteArray>("names");
  QTest::addColumn<int>("first");
  QTest::addColumn<int>("step");
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("pattern");
  const auto row = [](const char* what, const char* names, int first, int step,
                      const char* pattern = "", const char* file = "v") {
    QTest::newRow(what) << QByteArray(names) << first << step << QString(file) << QString(pattern);
  };
  row("JPEG Pleno", "%03d_%03d.ppm", 0, 1);
  row("JPEG Pleno, every second", "%03d_%03d.png", 1, 2);
  row("Stanford", "out_%02d_%02d_-776.880371_+1.5e-05_.png", 0, 1, "out_RR_CC_y_x_");
  row("Stanford, known", "out_%02d_%02d_-776.880371_781.3.png", 0, 1);
  row("shop", "Original Camera_%02d_%02d_-0.000000_369.230769_30_36.png", 1, 2,
      "Original Camera_RR_CC_*");
  row("columns first", "c_%d-r_%d.tif", 0, 1, "c_C-r_R");
  row("columns first, alone", "%d-%d.tif", 5, 7, "C-R");
  row("with its extension", "view %d,%d.png", 0, 1, "view R,C.png");
  row("signs of regular expressions", "a+(b)[%d]{%d}^$.png", 0, 1, "a+(b)[RR]{CC}^$.png");
  row("any beginning and end", "left_%d_%d_x.png", 0, 1, "*_RR_CC_*");
  row("UTF-8", "Größe_%d_%d.png", 0, 1, "Größe_RR_CC");
  row("%d", "%d-%d.png", 8, 1, "", "v/%d-%d.png");
  row("%02d", "im_%02d_%02d.png", 1, 2, "", "v/im_%02d_%02d.png");
}

void TestViewFolders::names() {
  QFETCH(QByteArray, names);
  QFETCH(int, first);
  QFETCH(int, step);
  QFETCH(QString, file);
  QFETCH(QString, pattern);
  const bool columnsFirst = QByteArray(QTest::currentDataTag()).startsWith("columns first");
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const int one = first + step * (columnsFirst ? column : row);
      const int other = first + step * (columnsFirst ? row : column);
      writeView("v/" + QString::asprintf(names.constData(), one, other), row, column);
    }
  }
  LightFieldParams params = viewsIn(file);
  params.pattern = pattern.toStdString();
  QCOMPARE(firstWrong(openLightField(params, {})->read({}), inPlace), QString());
}

/// Not their text: 9 comes before 10.
void TestViewFolders::numbersCount() {
  for (int k = 0; k < 4; ++k) writeView(QString("v/input_Cam%1.png").arg(k + 8), k / 2, k % 2);
  QCOMPARE(firstWrong(openLightField(viewsIn("v"), {})->read({}), inPlace), QString());
}

void TestViewFolders::otherFilesAreLeftAlone() {
  writeViews("v", 2, 2);
  for (const char* other : {"README.md", "LICENSE", "000_000.png.bak.d/x", ".000_000.png",
                            "thumb_000_000.png", "000_000_small.png", "depth.png"})
    writeFile(QString("v/") + other, "not a view");
  QCOMPARE(firstWrong(openLightField(viewsIn("v"), {})->read({}), inPlace), QString());
}

/// One running number: row by row; a square, unless the display says otherwise.
void TestViewFolders::numbersOfAnyGrid() {
  for (int k = 0; k < 6; ++k) writeView(QString("v/im%1.png").arg(k), k / 3, k % 3);
  PanelParams display;
  display.directions = {3, 2};
  LightFieldParams params = viewsIn("v/im%d.png");
  QCOMPARE(firstWrong(openLightField(params, display)->read({}), inPlace), QString());
  params = viewsIn("v");
  params.pattern = "imNNN";
  QCOMPARE(firstWrong(openLightField(params, display)->read({}), inPlace), QString());
  display.directions = {2, 3};
  const LightField tall = openLightField(params, display)->read({});
  QVERIFY(tall.size() == (LightFieldSize{width, height, 2, 3}));
  QVERIFY(tall.texel({0, 0, 1, 1}) == colourOf(1, 0, 0, 0));
}

void TestViewFolders::shear_data() {
  QTest::addColumn<double>("right");
  QTest::addColumn<double>("down");
  QTest::newRow("none") << 0.0 << 0.0;
  QTest::newRow("to the right") << 1.0 << 0.0;
  QTest::newRow("up") << 0.0 << -1.0;
  QTest::newRow("both") << -2.0 << 1.0;
  QTest::newRow("fractions") << 0.5 << 1.4;
  QTest::newRow("fractions, the other way") << -0.6 << -1.5;
  QTest::newRow("out of the picture") << 100.0 << 0.0;
}

/// 4 columns and 3 rows: view (u, v) moves by right·(u - 1.5), down·(v - 1), to the nearest pixel.
void TestViewFolders::shear() {
  QFETCH(double, right);
  QFETCH(double, down);
  writeViews("v", 3, 4);
  LightFieldParams params = viewsIn("v");
  params.shear = {right, down};
  const auto expected = [=](const TexelIndex& at) {
    const int x = at.i - int(std::floor(right * (at.u - 1.5) + 0.5));
    const int y = at.j - int(std::floor(down * (at.v - 1) + 0.5));
    const bool isInside = x >= 0 && x < width && y >= 0 && y < height;
    return isInside ? colourOf(at.v, at.u, x, y) : Rgb();
  };
  QCOMPARE(firstWrong(openLightField(params, {})->read({}), expected), QString());
}

/// Not of the rows and columns that the file names count.
void TestViewFolders::shearIsOfTheDisplaysDirections() {
  writeViews("v", 3, 3);
  LightFieldParams params = viewsIn("v");
  params.shear = {1, 2};
  params.rows = RowOrder::bottomUp;
  params.columns = ColumnOrder::rightLeft;
  const LightField lightField = openLightField(params, {})->read({});
  QVERIFY(lightField.texel({1, 2, 1, 1}) == colourOf(1, 1, 1, 2));
  QVERIFY(lightField.texel({2, 3, 2, 2}) == colourOf(0, 0, 1, 1));
  QVERIFY(lightField.texel({0, 0, 0, 0}) == colourOf(2, 2, 1, 2));
  QVERIFY(lightField.texel({0, 3, 2, 2}) == Rgb());
}

void TestViewFolders::displayTakesTheFoldersSize() {
  writeViews("v", 2, 3);
  Session session;
  session.lightField = viewsIn("v");
  const ViewSource scene = loadViewSource(session, {});
  QCOMPARE(scene.display.hogels, (std::array<int, 2>{width, height}));
  QCOMPARE(scene.display.directions, (std::array<int, 2>{3, 2}));
}

/// The others are converted to it.
void TestViewFolders::theFirstViewSaysTheType() {
  const auto value = [](int, int, int) { return 100.25F / 255; };
  writeImageFile("v/000_000.tif", 2, 2, value, {PictureType::Float});
  writeImageFile("v/000_001.tif", 2, 2, value, {PictureType::UInt8});
  writeImageFile("v/000_002.tif", 2, 2, value, {PictureType::UInt16, 1});
  const LightField lightField = openLightField(viewsIn("v"), {})->read({});
  QVERIFY(isNear(lightField.texel({0, 0, 0, 0}), {100.25, 100.25, 100.25}, 1e-4));
  QVERIFY(isNear(lightField.texel({1, 1, 1, 0}), {100, 100, 100}, 1e-4));
  QVERIFY(isNear(lightField.texel({0, 1, 2, 0}), {100.25, 100.25, 100.25}, 0.5 / 257));
}

void TestViewFolders::missingViewsAreBlack_data() {
  QTest::addColumn<int>("type");
  QTest::addColumn<int>("channels");
  QTest::newRow("8 bit") << int(PictureType::UInt8) << 3;
  QTest::newRow("16 bit grey") << int(PictureType::UInt16) << 1;
  QTest::newRow("floats") << int(PictureType::Float) << 3;
}

/// A circle of 9×9 is what it is with black files in place of its holes, read whole or in rows.
void TestViewFolders::missingViewsAreBlack() {
  QFETCH(int, type);
  QFETCH(int, channels);
  const PictureKind kind{PictureType(type), channels};
  for (int row = 0; row < 9; ++row)
    for (int column = 0; column < 9; ++column) {
      const bool isThere = std::hypot(row - 4, column - 4) < 4.3;
      const auto value = [=](int x, int y, int c) {
        return isThere ? float((9 * row + column) * 700 + 37 * x + 5 * y + c) / 65535 : 0;
      };
      const QString name = QString("%1_%2.tif").arg(row).arg(column);
      writeImageFile("full/" + name, width, height, value, kind);
      if (isThere) writeImageFile("holes/" + name, width, height, value, kind);
    }
  LightFieldParams params = viewsIn("full");
  params.shear = {0.5, -1};
  params.rows = RowOrder::bottomUp;
  const LightField full = openLightField(params, {})->read({});
  params.file = "holes";
  const auto file = openLightField(params, {});
  QCOMPARE(file->files().size(), std::size_t(61));
  QCOMPARE(file->warnings().size(), std::size_t(1));
  QVERIFY2(file->warnings().front().starts_with("lightField: 20 of 81 views are missing"),
           file->warnings().front().c_str());
  QCOMPARE(firstDifference(file->read({}), full), QString());
  QCOMPARE(firstDifference(streamed(*file), full), QString());
}

QTEST_APPLESS_MAIN(TestViewFolders)
#include "test_view_folders.moc"
