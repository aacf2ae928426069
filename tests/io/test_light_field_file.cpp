// SPDX-License-Identifier: BSD-3-Clause
// Tests that hogel images, quilts and mosaics of any format put each pixel at the right directional
// pixel.
#include <QTemporaryDir>
#include <QTest>

#include "io/documents/session_file.h"
#include "io/layouts/layouts.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "tests/io/any_images.h"
#include "tests/io/texels.h"

using namespace hogelscope;

namespace {

constexpr LightFieldSize size{4, 3, 3, 2};

PanelParams display() {
  PanelParams params;
  params.hogels = {size.nx, size.ny};
  params.directions = {size.du, size.dv};
  return params;
}

/// Differs in each of the four indices and between the channels; a little off whole code values.
Rgb colourOf(const TexelIndex& at) {
  return {40.25 * at.i + 10 * at.j + 5, 30.25 * at.u + 20 * at.v + 7,
          230.0 - 30 * at.i - 25 * at.j - 11 * at.u - 5 * at.v};
}

float channelOf(const Rgb& colour, int channel) {
  return float((channel == 0 ? colour.r : channel == 1 ? colour.g : colour.b) / 255);
}

/// Tile (i, j) of the picture is hogel (i, j).
float hogelImage(int x, int y, int channel) {
  if (channel == 3) return 1;
  return channelOf(colourOf({x / size.du, y / size.dv, x % size.du, y % size.dv}), channel);
}

constexpr int quiltColumns = 3;
constexpr int quiltRows = 2;

/// Views of 4×3 px; the first one is at the bottom left.
float quilt(int x, int y, int channel) {
  const int view = (quiltRows - 1 - y / size.ny) * quiltColumns + x / size.nx;
  return channelOf(colourOf({x % size.nx, y % size.ny, view, 0}), channel);
}

LightFieldParams paramsOf(const QString& file, bool incoming = false) {
  LightFieldParams params;
  params.file = file.toStdString();
  params.incoming = incoming;
  return params;
}

LightFieldParams quiltOf(const QString& file, int columns, int rows, bool incoming = false) {
  LightFieldParams params = paramsOf(file, incoming);
  params.layout = Layout::quilt;
  params.quiltColumns = columns;
  params.quiltRows = rows;
  return params;
}

LightField read(const LightFieldParams& params, const PanelParams& given = display()) {
  return openLightField(params, given)->read({});
}

}  // namespace

class TestLightFieldFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(m_folder.path())); }
  void formats_data();
  void formats();
  void grey_data();
  void grey();
  void jpeg();
  void alphaIsLightOverBlack_data();
  void alphaIsLightOverBlack();
  void incomingFlipsBoth();
  void quilts_data();
  void quilts();
  void quiltsWithARest_data();
  void quiltsWithARest();
  void mosaics_data();
  void mosaics();
  void tilesFromName_data();
  void tilesFromName();
  void aspectFromName();
  void displayTakesTheFilesSize();
  void canBeStopped();

 private:
  QTemporaryDir m_folder;
};

void TestLightFieldFile::formats_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("type");
  QTest::addColumn<int>("channels");
  QTest::addColumn<int>("tile");
  QTest::addColumn<double>("tolerance");
  constexpr double eight = 0.5001;
  constexpr double sixteen = 0.5001 / 257;
  constexpr double half = 0.1;
  constexpr double single = 1e-4;
  QTest::newRow("PNG") << "a.png" << int(PictureType::UInt8) << 3 << 0 << eight;
  QTest::newRow("PNG, 16 bit") << "b.png" << int(PictureType::UInt16) << 3 << 0 << sixteen;
  QTest::newRow("PNG, RGBA") << "c.png" << int(PictureType::UInt8) << 4 << 0 << eight;
  QTest::newRow("TIFF") << "d.tif" << int(PictureType::UInt8) << 3 << 0 << eight;
  QTest::newRow("TIFF, 16 bit, tiles") << "e.tif" << int(PictureType::UInt16) << 3 << 16 << sixteen;
  QTest::newRow("TIFF, float, RGBA") << "f.tif" << int(PictureType::Float) << 4 << 0 << single;
  QTest::newRow("TIFF, double") << "g.tif" << int(PictureType::Double) << 3 << 0 << single;
  QTest::newRow("EXR") << "h.exr" << int(PictureType::Float) << 3 << 0 << single;
  QTest::newRow("EXR, half, tiles, RGBA") << "i.exr" << int(PictureType::Half) << 4 << 16 << half;
  QTest::newRow("BMP") << "j.bmp" << int(PictureType::UInt8) << 3 << 0 << eight;
  QTest::newRow("PPM") << "k.ppm" << int(PictureType::UInt8) << 3 << 0 << eight;
}

void TestLightFieldFile::formats() {
  QFETCH(QString, file);
  QFETCH(int, type);
  QFETCH(int, channels);
  QFETCH(int, tile);
  QFETCH(double, tolerance);
  writeImageFile(file, size.nx * size.du, size.ny * size.dv, hogelImage,
                 {PictureType(type), channels, tile});
  const LightField lightField = read(paramsOf(file));
  QCOMPARE(firstWrong(lightField, colourOf, tolerance), QString());
  QVERIFY(!firstWrong(
               lightField, [](const TexelIndex&) { return Rgb(); }, tolerance)
               .isEmpty());
}

void TestLightFieldFile::grey_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("channels");
  QTest::newRow("PNG") << "grey.png" << 1;
  QTest::newRow("PNG with alpha") << "alpha.png" << 2;
  QTest::newRow("TIFF") << "grey.tif" << 1;
}

void TestLightFieldFile::grey() {
  QFETCH(QString, file);
  QFETCH(int, channels);
  const auto value = [](int x, int y, int c) { return c == 1 ? 1 : hogelImage(x, y, 0); };
  writeImageFile(file, size.nx * size.du, size.ny * size.dv, value, {PictureType::UInt8, channels});
  const auto expected = [](const TexelIndex& at) {
    const double r = colourOf(at).r;
    return Rgb{r, r, r};
  };
  QCOMPARE(firstWrong(read(paramsOf(file)), expected, 0.5001), QString());
}

/// Lossy, so it is near only where the picture is smooth.
void TestLightFieldFile::jpeg() {
  const auto smooth = [](int x, int y, int c) { return float(x + y + 40 * c) / 255; };
  writeImageFile("smooth.jpg", 64, 48, smooth);
  PanelParams large;
  large.hogels = {16, 12};
  large.directions = {4, 4};
  const auto expected = [](const TexelIndex& at) {
    const double sum = 4 * at.i + at.u + 4 * at.j + at.v;
    return Rgb{sum, sum + 40, sum + 80};
  };
  QCOMPARE(firstWrong(read(paramsOf("smooth.jpg"), large), expected, 4), QString());
}

void TestLightFieldFile::alphaIsLightOverBlack_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("tile");
  QTest::newRow("PNG") << "half.png" << 0;
  QTest::newRow("TIFF") << "half.tif" << 0;
  QTest::newRow("TIFF, tiles") << "tiles.tif" << 16;
  QTest::newRow("TGA") << "half.tga" << 0;
}

void TestLightFieldFile::alphaIsLightOverBlack() {
  QFETCH(QString, file);
  QFETCH(int, tile);
  const auto value = [](int x, int y, int c) {
    return c == 3 ? 102.0F / 255 : hogelImage(x, y, c);
  };
  writeImageFile(file, size.nx * size.du, size.ny * size.dv, value, {PictureType::UInt8, 4, tile});
  const auto expected = [](const TexelIndex& at) { return 0.4 * colourOf(at); };
  QCOMPARE(firstWrong(read(paramsOf(file)), expected, 1), QString());
}

void TestLightFieldFile::incomingFlipsBoth() {
  writeImageFile("hogels.tif", size.nx * size.du, size.ny * size.dv, hogelImage,
                 {PictureType::UInt16});
  const auto expected = [](const TexelIndex& at) {
    return colourOf({at.i, at.j, size.du - 1 - at.u, size.dv - 1 - at.v});
  };
  QCOMPARE(firstWrong(read(paramsOf("hogels.tif", true)), expected, 0.002), QString());
}

void TestLightFieldFile::quilts_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("columns");
  QTest::addColumn<int>("rows");
  QTest::addColumn<bool>("incoming");
  QTest::newRow("as the session says") << "q.png" << quiltColumns << quiltRows << false;
  QTest::newRow("as its name says") << "a_qs3x2a0.75.png" << 0 << 0 << false;
  QTest::newRow("the session overrules the name") << "a_qs2x3a1.png" << 3 << 2 << false;
  QTest::newRow("incoming") << "q.ppm" << quiltColumns << quiltRows << true;
}

void TestLightFieldFile::quilts() {
  QFETCH(QString, file);
  QFETCH(int, columns);
  QFETCH(int, rows);
  QFETCH(bool, incoming);
  writeImageFile(file, size.nx * quiltColumns, size.ny * quiltRows, quilt);
  LightFieldParams params = quiltOf(file, columns, rows, incoming);
  const LightField lightField = read(params, {});
  constexpr LightFieldSize expectedSize{size.nx, size.ny, quiltColumns * quiltRows, 1};
  QVERIFY(lightField.size() == expectedSize);
  const auto expected = [incoming](const TexelIndex& at) {
    return colourOf({at.i, at.j, incoming ? quiltColumns * quiltRows - 1 - at.u : at.u, 0});
  };
  QCOMPARE(firstWrong(lightField, expected, 0.5001), QString());
  // The same from the top left: the rows of tiles follow in the other direction.
  params.quiltStart = QuiltStart::topLeft;
  const auto fromTop = [&](const TexelIndex& at) {
    const int view = incoming ? quiltColumns * quiltRows - 1 - at.u : at.u;
    const int row = view / quiltColumns;
    return colourOf({at.i, at.j, (quiltRows - 1 - row) * quiltColumns + view % quiltColumns, 0});
  };
  QCOMPARE(firstWrong(read(params, {}), fromTop, 0.5001), QString());
}

void TestLightFieldFile::quiltsWithARest_data() {
  QTest::addColumn<int>("width");
  QTest::addColumn<int>("height");
  QTest::addColumn<int>("columns");
  QTest::addColumn<int>("rows");
  QTest::newRow("a pixel, as 5x9 in 4096x4096") << 41 << 91 << 5 << 9;
  QTest::newRow("across alone") << 44 << 90 << 5 << 9;
  QTest::newRow("down alone") << 40 << 98 << 5 << 9;
  QTest::newRow("more than a tile") << 19 << 17 << 10 << 9;
}

/// Tiles of ⌊w/c⌋ × ⌊h/r⌋ px count from the bottom left corner.
void TestLightFieldFile::quiltsWithARest() {
  QFETCH(int, width);
  QFETCH(int, height);
  QFETCH(int, columns);
  QFETCH(int, rows);
  const int nx = width / columns, ny = height / rows;
  writeImageFile("rest.png", width, height, [=](int x, int y, int channel) {
    const int right = x / nx, up = (height - 1 - y) / ny;
    if (right >= columns || up >= rows) return 1.0F;  // in no view
    return float(channel == 0   ? up * columns + right
                 : channel == 1 ? x % nx
                                : (height - 1 - y) % ny) /
           255;
  });
  const LightFieldParams params = quiltOf("rest.png", columns, rows, false);
  const auto file = openLightField(params, {});
  QCOMPARE(file->warnings().size(), 1U);
  QVERIFY(file->warnings()[0].find(std::to_string(width % columns) + " px at the right and " +
                                   std::to_string(height % rows) + " px at the top") !=
          std::string::npos);
  const LightField lightField = read(params, {});
  QVERIFY((lightField.size() == LightFieldSize{nx, ny, columns * rows, 1}));
  const auto expected = [ny](const TexelIndex& at) {
    return Rgb{double(at.u), double(at.i), double(ny - 1 - at.j)};
  };
  QCOMPARE(firstWrong(lightField, expected, 0.5001), QString());
}

void TestLightFieldFile::mosaics_data() {
  QTest::addColumn<bool>("isUp");
  QTest::addColumn<bool>("isLeft");
  QTest::addColumn<bool>("incoming");
  for (const bool isUp : {false, true})
    for (const bool isLeft : {false, true})
      QTest::addRow("%d%d", isUp, isLeft) << isUp << isLeft << (isUp != isLeft);
}

/// Tile (u, v) of 4×3 px, counted from where `rows` and `columns` begin; the shear moves view u by
/// a pixel for each direction, and leaves black behind it.
void TestLightFieldFile::mosaics() {
  QFETCH(const bool, isUp);
  QFETCH(const bool, isLeft);
  QFETCH(const bool, incoming);
  LightFieldParams params = paramsOf("mosaic.png", incoming);
  params.layout = Layout::mosaic;
  params.rows = isUp ? RowOrder::bottomUp : RowOrder::topDown;
  params.columns = isLeft ? ColumnOrder::rightLeft : ColumnOrder::leftRight;
  params.shear = {1, 0};
  writeImageFile("mosaic.png", size.nx * size.du, size.ny * size.dv,
                 [&](int x, int y, int channel) {
                   const int u = isLeft ? size.du - 1 - x / size.nx : x / size.nx;
                   const int v = isUp ? size.dv - 1 - y / size.ny : y / size.ny;
                   return channelOf(colourOf({x % size.nx, y % size.ny, u, v}), channel);
                 });
  PanelParams display;
  display.directions = {size.du, size.dv};
  const LightField lightField = read(params, display);
  QVERIFY(lightField.size() == size);
  const auto expected = [incoming](TexelIndex at) {
    if (incoming) at = {at.i, at.j, size.du - 1 - at.u, size.dv - 1 - at.v};
    at.i -= at.u - 1;
    return at.i < 0 || at.i >= size.nx ? Rgb{0, 0, 0} : colourOf(at);
  };
  QCOMPARE(firstWrong(lightField, expected, 0.5001), QString());
}

void TestLightFieldFile::tilesFromName_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("columns");
  QTest::addColumn<int>("rows");
  QTest::newRow("Looking Glass") << "folder.d/name_qs8x6a0.75.png" << 8 << 6;
  QTest::newRow("whole aspect") << "n_qs5x9a1.jpg" << 5 << 9;
  QTest::newRow("no suffix") << "quilt.png" << 0 << 0;
  QTest::newRow("no aspect") << "n_qs8x6.png" << 8 << 6;
  QTest::newRow("not at the end") << "n_qs8x6a1_small.png" << 8 << 6;
  QTest::newRow("a version") << "n_qs8x6a0.75_v2.png" << 8 << 6;
  QTest::newRow("a second download") << "n_qs8x6a0.75 (1).png" << 8 << 6;
  QTest::newRow("upper case") << "N_QS8X6A0.75.PNG" << 8 << 6;
  QTest::newRow("a decimal comma") << "n_qs8x6a0,75.png" << 8 << 6;
  QTest::newRow("a frame's number") << "n_qs8x6a0.75.0001.png" << 8 << 6;
  QTest::newRow("no aspect, a frame's number") << "n_qs8x6.0001.png" << 8 << 6;
  QTest::newRow("no 0") << "n_qs8x6a.75.png" << 8 << 6;
  QTest::newRow("leading zeros") << "n_qs08x06a0.750.png" << 8 << 6;
  QTest::newRow("a space") << "n qs8x6a0.75.png" << 8 << 6;
  QTest::newRow("a hyphen, a copy") << "n-qs8x6a0.75 - Copy.png" << 8 << 6;
  QTest::newRow("the name alone") << "qs8x6a0.75.png" << 8 << 6;
  QTest::newRow("an earlier one") << "n_qs8x6a1_qsheet.png" << 8 << 6;
  QTest::newRow("in a word") << "faqs8x6.png" << 0 << 0;
  QTest::newRow("letters behind the rows") << "n_qs8x6b.png" << 0 << 0;
  QTest::newRow("many") << QString("qs").repeated(500000) + ".png" << 0 << 0;
  QTest::newRow("the folder's") << "n_qs8x6a1/quilt.png" << 0 << 0;
  QTest::newRow("too many digits") << "n_qs80000x6a1.png" << 0 << 0;
  QTest::newRow("no rows") << "n_qs8xa1.png" << 0 << 0;
  QTest::newRow("the last") << "n_qs3x3a1_qs8x6a1.png" << 8 << 6;
  QTest::newRow("letters behind") << "n_qs8x6a1b.png" << 0 << 0;
  QTest::newRow("many letters") << QString(1000000, 'x') << 0 << 0;
  QTest::newRow("many letters, a suffix") << QString(1000000, 'x') + "_qs8x6a1.png" << 8 << 6;
}

void TestLightFieldFile::tilesFromName() {
  QFETCH(QString, file);
  QFETCH(int, columns);
  QFETCH(int, rows);
  const auto [c, r] = quiltNameOf(file.toStdString()).tiles;
  QCOMPARE(c, columns);
  QCOMPARE(r, rows);
}

/// Tiles need not have the display's shape.
void TestLightFieldFile::aspectFromName() {
  QCOMPARE(quiltNameOf("folder.d/name_qs8x6a0.75.png").aspect, 0.75);
  QCOMPARE(quiltNameOf("n_qs5x9a1.jpg").aspect, 1.0);
  QCOMPARE(quiltNameOf("n_qs5x9a1.2.3.jpg").aspect, 1.2);
  QCOMPARE(quiltNameOf("n_qs5x9a0.75.0001.jpg").aspect, 0.75);
  QCOMPARE(quiltNameOf("n_qs5x9a0,75 (2).jpg").aspect, 0.75);
  QCOMPARE(quiltNameOf("n_qs5x9a.75_v2.jpg").aspect, 0.75);
  QCOMPARE(quiltNameOf("n_qs8x6.png").aspect, 0.0);
  writeImageFile("n_qs2x1a0.8.png", 2 * 10, 10, [](int, int, int) { return 0.5F; });
  QCOMPARE(sessionAround("n_qs2x1a0.8.png").display.size, (std::array<double, 2>{0.4, 0.5}));
}

void TestLightFieldFile::displayTakesTheFilesSize() {
  writeImageFile("q.png", size.nx * quiltColumns, size.ny * quiltRows, quilt);
  Session session;
  session.lightField = quiltOf("q.png", quiltColumns, quiltRows);
  const ViewSource scene = loadViewSource(session, {});
  QCOMPARE(scene.display.hogels, (std::array<int, 2>{size.nx, size.ny}));
  QCOMPARE(scene.display.directions, (std::array<int, 2>{6, 1}));
  QVERIFY(scene.lightField->size() == (LightFieldSize{size.nx, size.ny, 6, 1}));
}

void TestLightFieldFile::canBeStopped() {
  writeImageFile("large.png", 300, 200, [](int, int, int) { return 0.5F; });
  PanelParams large;
  large.hogels = {30, 20};
  large.directions = {10, 10};
  const auto file = openLightField(paramsOf("large.png"), large);
  QVERIFY_EXCEPTION_THROWN((void)file->read([](double) { return false; }), Cancelled);
}

QTEST_APPLESS_MAIN(TestLightFieldFile)
#include "test_light_field_file.moc"
