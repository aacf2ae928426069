// SPDX-License-Identifier: BSD-3-Clause
// Tests what files say beyond one upright picture at its place: orientation, windows, layers,
// parts, pages, further pictures. Each is done, or told in one line.
#include <QImageReader>
#include <QTemporaryDir>
#include <QTest>
#include <array>

#include "core/base/error.h"
#include "io/images/exr_layers.h"
#include "io/images/image_file.h"
#include "io/images/tiff_directories.h"
#include "io/opening/opening.h"
#include "io/scene/view_source.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"
#include "tests/io/light_fields.h"

using namespace hogelscope;

namespace {

constexpr int width = 30;
constexpr int height = 20;

/// A code value, other in each picture, place and channel.
int storedCode(std::size_t page, int x, int y, int c) {
  return int(page) * 31 % 97 + (x * 5 + y * 3 + c * 40) % 150;
}

float wantedValue(std::size_t page, int x, int y, int c) {
  return float(storedCode(page, x, y, c)) / 255;
}

/// All pixels of the file's first frame, 255 for white.
std::vector<float> pixelsOf(ImageFile& image) {
  std::vector<float> pixels;
  image.readRows(
      [&](std::size_t, const float* rgb) {
        for (std::size_t k = 0; k < 3 * image.width(); ++k) pixels.push_back(255 * rgb[k]);
      },
      {});
  return pixels;
}

/// Where a pixel of an upright picture is stored, as EXIF 2.32 says in its table of orientations:
/// the side of the picture at which row 0 is, then the one at which column 0 is.
std::array<int, 2> storedAt(int orientation, int x, int y, int w, int h) {
  static const std::array<const char*, 9> sides{"", "TL", "TR", "BR", "BL", "LT", "RT", "RB", "LB"};
  const auto from = [&](char side) {
    return side == 'T' ? y : side == 'B' ? h - 1 - y : side == 'L' ? x : w - 1 - x;
  };
  const char* const rowAndColumn = sides[std::size_t(orientation)];
  return {from(rowAndColumn[1]), from(rowAndColumn[0])};
}

/// Returns the largest difference from the values that `expected(x, y, c)` gives; 1000 if the file
/// has another size or is refused.
template <class Expected>
double worst(const char* file, int w, int h, const Expected& expected) {
  std::vector<float> pixels;
  try {
    ImageFile image{std::filesystem::path(file)};
    if (int(image.width()) != w || int(image.height()) != h) return 1000;
    pixels = pixelsOf(image);
  } catch (const InputError&) {
    return 1000;
  }
  double difference = 0;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      for (int c = 0; c < 3; ++c)
        difference = std::max(
            difference,
            std::abs(double(pixels[std::size_t(3 * (y * w + x) + c)]) - double(expected(x, y, c))));
  return difference;
}

std::string notesOf(const char* file) {
  std::string all;
  for (const std::string& note : ImageFile(std::filesystem::path(file)).notesOfOne())
    all += (all.empty() ? "" : "|") + note;
  return all;
}

std::string errorOf(const char* file) {
  try {
    ImageFile image{std::filesystem::path(file)};
    (void)pixelsOf(image);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

QByteArray bigEndian(std::uint32_t number, int bytes = 4) {
  QByteArray text;
  for (int k = bytes - 1; k >= 0; --k) text += char(number >> unsigned(8 * k));
  return text;
}

/// EXIF with nothing but an orientation.
QByteArray exifOf(int orientation) {
  return QByteArray("MM\0*\0\0\0\10\0\1", 10) + bigEndian(0x112, 2) + bigEndian(3, 2) +
         bigEndian(1) + bigEndian(std::uint32_t(orientation), 2) + bigEndian(0, 2) + bigEndian(0);
}

/// A chunk of PNG, with its checksum (ISO 3309).
QByteArray pngChunk(const QByteArray& name, const QByteArray& content) {
  std::uint32_t crc = 0xffffffffU;
  for (const char byte : name + content) {
    crc ^= std::uint8_t(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ (crc & 1U ? 0xedb88320U : 0U);
  }
  return bigEndian(std::uint32_t(content.size())) + name + content + bigEndian(~crc);
}

/// Puts a chunk behind the head of a PNG, or before its end.
void addChunk(const char* file, const QByteArray& chunk, bool isAtEnd) {
  QByteArray png = contentOf(file);
  png.insert(isAtEnd ? png.size() - 12 : 33, chunk);
  writeFile(file, png);
}

void writePlain(const char* file, int w = width, int h = height) {
  writeImageFile(QString(file), w, h, [](int x, int y, int c) { return wantedValue(0, x, y, c); },
                 {});
}

}  // namespace

class TestPictureFacts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir::setCurrent(m_folder->path()));
  }

  void orientations_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<int>("orientation");
    QTest::addColumn<int>("tile");
    for (const char* file : {"a.tif", "a.jpg", "a.png", "late.png", "a.webp"})
      for (int orientation = 1; orientation <= 8; ++orientation)
        QTest::addRow("%s %d", file, orientation) << QByteArray(file) << orientation << 0;
    QTest::newRow("tiles") << QByteArray("a.tif") << 6 << 16;
  }
  /// Every row and column of the upright picture is another one.
  void orientations() {
    QFETCH(const QByteArray, file);
    QFETCH(const int, orientation);
    QFETCH(const int, tile);
    const bool isTurned = orientation > 4;
    const int w = isTurned ? height : width, h = isTurned ? width : height;
    if (file.endsWith("png"))  // OpenImageIO may write a chunk eXIf of its own
      writeImageFile(QString(file), width, height,
                     [](int x, int y, int c) { return wantedValue(0, x, y, c); });
    else
      writePages(QString(file),
                 {{.width = width,
                   .height = height,
                   .orientation = file.endsWith("tif") || file.endsWith("jpg") ? orientation : 1,
                   .tile = tile}},
                 wantedValue);
    if (file.endsWith("png")) addChunk(file, pngChunk("eXIf", exifOf(orientation)), file[0] == 'l');
    if (file.endsWith("webp")) wrapWebp(file, exifOf(orientation));
    const std::vector<unsigned char> stored = valuesOf<unsigned char>(file);  // WebP is lossy
    const auto expected = [&](int x, int y, int c) {
      const auto [column, row] = storedAt(orientation, x, y, w, h);
      return int(stored[std::size_t(3 * (row * width + column) + c)]);
    };
    if (file.endsWith("jpg")) {  // Qt turns JPEGs too
      QImageReader reader{QString(file)};
      reader.setAutoTransform(true);
      const QImage upright = reader.read();
      const auto ofQt = [&](int x, int y, int c) {
        const QRgb rgb = upright.pixel(x, y);
        return c == 0 ? qRed(rgb) : c == 1 ? qGreen(rgb) : qBlue(rgb);
      };
      QVERIFY(worst(file, w, h, ofQt) <= 3);
    } else {
      QVERIFY(worst(file, w, h, expected) <= 1e-3);
    }
    QCOMPARE(notesOf(file), std::string());
  }

  void windows_data() {
    QTest::addColumn<QList<int>>("data");
    QTest::addColumn<QList<int>>("display");
    const auto add = [](const char* name, const QList<int>& data, const QList<int>& display) {
      QTest::newRow(name) << data << display;
    };
    add("cropped", {4, 3, 10, 8}, {0, 0, 30, 20});
    add("overscan", {-5, -4, 40, 30}, {0, 0, 30, 20});
    add("both", {-5, 6, 20, 30}, {0, 0, 30, 20});
    add("negative origin", {-27, -13, 6, 5}, {-30, -15, 20, 10});
    add("elsewhere", {100, 100, 6, 5}, {0, 0, 30, 20});
    add("as it is, not at 0", {7, 8, 30, 20}, {7, 8, 30, 20});
  }
  /// What is not stored is black; rows and tiles.
  void windows() {
    QFETCH(const QList<int>, data);
    QFETCH(const QList<int>, display);
    for (const int tile : {0, 4}) {
      writePages("a.exr",
                 {{.width = data[2],
                   .height = data[3],
                   .x = data[0],
                   .y = data[1],
                   .display = {display.begin(), display.end()},
                   .tile = tile,
                   .type = PictureType::Float}},
                 wantedValue);
      const auto expected = [&](int x, int y, int c) {
        const int column = x + display[0] - data[0], row = y + display[1] - data[1];
        const bool isStored = column >= 0 && column < data[2] && row >= 0 && row < data[3];
        return isStored ? storedCode(0, column, row, c) : 0;
      };
      QVERIFY(worst("a.exr", display[2], display[3], expected) < 1e-3);
      QCOMPARE(notesOf("a.exr").empty(), data[0] != 100);
    }
  }

  /// A few kB that mean gigabytes.
  void hugeWindows() {
    writePages(
        "a.exr",
        {{.width = 2, .height = 2, .display = {0, 0, 2000000, 2000000}, .type = PictureType::Half}},
        wantedValue);
    QCOMPARE(errorOf("a.exr"),
             std::string("a.exr: is damaged: its display window is 2000000×2000000 px"));
  }

  void layers_data() {
    using Parts = QList<QByteArrayList>;  // of each its name, then its channels
    QTest::addColumn<Parts>("parts");
    QTest::addColumn<int>("part");
    QTest::addColumn<QList<int>>("channels");  // empty: refused
    QTest::addColumn<QByteArray>("line");
    const auto add = [](const char* name, const Parts& parts, int part, const QList<int>& channels,
                        const QByteArray& line) {
      QTest::newRow(name) << parts << part << channels << line;
    };
    add("plain", {{"", "R", "G", "B"}}, 0, {0, 1, 2}, "");
    add("with alpha", {{"", "R", "G", "B", "A"}}, 0, {0, 1, 2}, "");
    add("depth beside", {{"", "R", "G", "B", "Z"}}, 0, {0, 1, 2}, "the channel Z beside");
    add("lower case", {{"", "r", "g", "b"}}, 0, {0, 1, 2}, "");
    add("grey", {{"", "Y"}}, 0, {0, 0, 0}, "");
    add("grey and depth", {{"", "Y", "Z"}}, 0, {0, 0, 0}, "");
    add("coordinates", {{"", "X", "Y", "Z"}}, 0, {0, 1, 2}, "");
    add("Blender",
        {{"", "ViewLayer.AO.R", "ViewLayer.AO.G", "ViewLayer.AO.B", "ViewLayer.Combined.R",
          "ViewLayer.Combined.G", "ViewLayer.Combined.B", "ViewLayer.Depth.Z"}},
        0, {3, 4, 5}, "ViewLayer.AO, ViewLayer.Depth beside ViewLayer.Combined");
    add("root before layers", {{"", "R", "G", "B", "spec.R", "spec.G", "spec.B"}}, 0, {0, 1, 2},
        "spec beside R, G, B");
    add("the only colours", {{"", "Depth.Z", "main.R", "main.G", "main.B"}}, 0, {1, 2, 3},
        "Depth beside main");
    add("none is the picture", {{"", "diff.R", "diff.G", "diff.B", "spec.R", "spec.G", "spec.B"}},
        0, {}, "keep the picture's alone of diff, spec");
    add("no colours", {{"", "Depth.Z", "Mist.Z"}}, 0, {},
        "keep the picture's alone of Depth, Mist");
    add("stereo", {{"", "left.R", "left.G", "left.B", "right.R", "right.G", "right.B"}}, 0,
        {0, 1, 2}, "right beside left");
    add("stereo, right first",
        {{"", "b.right.R", "b.right.G", "b.right.B", "c.left.R", "c.left.G", "c.left.B"}}, 0,
        {3, 4, 5}, "b.right beside c.left");
    add("parts", {{"AO", "R", "G", "B"}, {"Beauty", "R", "G", "B"}}, 1, {0, 1, 2},
        "AO beside Beauty");
    add("depth first", {{"depth", "Z"}, {"rgba", "R", "G", "B", "A"}}, 1, {0, 1, 2},
        "depth beside rgba");
    add("numbered parts", {{"subimage00", "R", "G", "B"}, {"subimage01", "R", "G", "B"}}, 0,
        {0, 1, 2}, "subimage01 beside subimage00");
    add("parts of which none is the picture", {{"AO", "R", "G", "B"}, {"mist", "R", "G", "B"}}, 0,
        {}, "keep the picture's alone of AO, mist");
    add("parts that are views", {{"right", "R", "G", "B"}, {"left", "R", "G", "B"}}, 1, {0, 1, 2},
        "right beside left");
  }
  void layers() {
    QFETCH(const QList<QByteArrayList>, parts);
    QFETCH(const int, part);
    QFETCH(const QList<int>, channels);
    QFETCH(const QByteArray, line);
    std::vector<PicturePage> pages;
    for (const QByteArrayList& each : parts) {
      PicturePage page{.width = 5 + int(pages.size()),
                       .height = 4,
                       .display = {0, 0, 5, 4},  // which all parts share
                       .channels = {},
                       .name = each[0].toStdString(),
                       .type = PictureType::Half};
      for (qsizetype k = 1; k < each.size(); ++k) page.channels.push_back(each[k].toStdString());
      pages.push_back(page);
    }
    // Of a channel's name, since the reader has channels in another order than the writer.
    writePages("a.exr", pages, wantedValue);
    if (channels.isEmpty()) {
      QVERIFY2(errorOf("a.exr").ends_with(line.toStdString()), errorOf("a.exr").c_str());
      return;
    }
    const auto expected = [&](int x, int y, int c) {
      return storedCode(std::size_t(part), x, y, channels[c]);
    };
    QVERIFY(worst("a.exr", 5, 4, expected) < 0.2);  // half's precision
    const std::string notes = notesOf("a.exr");
    QVERIFY2(line.isEmpty() ? notes.empty() : notes.find(line.toStdString()) != std::string::npos,
             notes.c_str());
  }

  void pages_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("tile");
    QTest::addColumn<int>("other");  // how many pages of another size come before
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("rows");
    QTest::newRow("square") << 9 << 0 << 0 << 3 << 3;
    QTest::newRow("row") << 6 << 0 << 0 << 6 << 1;
    QTest::newRow("tiles") << 4 << 16 << 0 << 2 << 2;
    QTest::newRow("after a thumbnail") << 4 << 0 << 1 << 2 << 2;
  }
  /// Pages of a TIFF are views.
  void pages() {
    QFETCH(const int, count);
    QFETCH(const int, tile);
    QFETCH(const int, other);
    QFETCH(const int, columns);
    QFETCH(const int, rows);
    std::vector<PicturePage> pages(std::size_t(other), {.width = 7, .height = 5});
    pages.resize(std::size_t(count + other), {.width = width, .height = height, .tile = tile});
    writePages("a.tif", pages, wantedValue);
    const LightFieldParams params = lightFieldOf("a.tif");
    QCOMPARE(params.layout, Layout::views);
    const auto file = openLightField(params, {});
    QVERIFY((file->size() == LightFieldSize{width, height, columns, rows}));
    QCOMPARE(file->warnings().size(), std::size_t(other > 0));
    const auto expected = [&](const TexelIndex& at) {
      const auto page = std::size_t(other + at.v * columns + at.u);
      return Rgb{double(storedCode(page, at.i, at.j, 0)), double(storedCode(page, at.i, at.j, 1)),
                 double(storedCode(page, at.i, at.j, 2))};
    };
    QCOMPARE(firstWrong(file->read({}), expected), QString());
  }

  /// Levels of a pyramid are no views; one page is a picture.
  void singlePages() {
    writePages("a.tif", {{.width = 30, .height = 20}, {.width = 15, .height = 10}}, wantedValue);
    QCOMPARE(lightFieldOf("a.tif").layout, Layout::hogels);
    QVERIFY(notesOf("a.tif").starts_with("has 2 pages, of which one is read"));
    writePages("b.tif", {{.width = 30, .height = 20}}, wantedValue);
    QCOMPARE(notesOf("b.tif"), std::string());
    writePages("c.tif", {{.width = 30, .height = 20}, {.width = 30, .height = 20}}, wantedValue);
    QCOMPARE(notesOf("c.tif"),
             std::string(
                 "has 2 pictures, of which one is read; the file by itself, as layout \"views\", "
                 "has all"));
  }

  /// ImageJ and OME keep colours as pages of their own.
  void planes_data() {
    QTest::addColumn<QByteArray>("description");
    QTest::addColumn<bool>("areColoursFirst");
    QTest::newRow("ImageJ") << QByteArray("ImageJ=1.53\nimages=12\nchannels=3\nslices=4\n") << true;
    QTest::newRow("OME XYCZT") << QByteArray(
                                      "<OME><Pixels DimensionOrder=\"XYCZT\" SizeC=\"3\" "
                                      "SizeT=\"1\" SizeZ=\"4\"/></OME>")
                               << true;
    QTest::newRow("OME XYZCT") << QByteArray(
                                      "<OME><Pixels DimensionOrder=\"XYZCT\" SizeC=\"3\" "
                                      "SizeT=\"1\" SizeZ=\"4\"/></OME>")
                               << false;
  }
  void planes() {
    QFETCH(const QByteArray, description);
    QFETCH(const bool, areColoursFirst);
    std::vector<PicturePage> pages(12, {.width = 9, .height = 7, .channels = {"Y"}});
    pages[0].description = description.toStdString();
    writePages("a.tif", pages, wantedValue);
    const auto file = openLightField(lightFieldOf("a.tif"), {});
    QVERIFY((file->size() == LightFieldSize{9, 7, 2, 2}));
    const auto expected = [&](const TexelIndex& at) {
      const int view = 2 * at.v + at.u;
      const auto code = [&](int c) {
        const int page = areColoursFirst ? 3 * view + c : 4 * c + view;
        return double(storedCode(std::size_t(page), at.i, at.j, 0));
      };
      return Rgb{code(0), code(1), code(2)};
    };
    QCOMPARE(firstWrong(file->read({}), expected), QString());
    QCOMPARE(file->warnings(),
             (std::vector<std::string>{
                 "the file has three channels, which are taken for red, green and blue"}));
  }

  void furtherPictures() {
    writePages("a.gif", {{.width = 30, .height = 20}, {.width = 30, .height = 20}}, wantedValue);
    QVERIFY(notesOf("a.gif").starts_with("is an animation and has more pictures"));
    writePages("b.gif", {{.width = 30, .height = 20}}, wantedValue);
    QCOMPARE(notesOf("b.gif"), std::string());
    QCOMPARE(errorOf("b.gif"), std::string());
    writePlain("a.png");
    addChunk("a.png", pngChunk("acTL", bigEndian(5) + bigEndian(0)), false);
    QVERIFY(notesOf("a.png").starts_with("is an animation and has 5 pictures"));
    writePlain("a.jpg");
    const QByteArray jpeg = contentOf("a.jpg");
    const QByteArray list = QByteArray("MPF\0MM\0*\0\0\0\10\0\1", 14) + bigEndian(0xb001, 2) +
                            bigEndian(4, 2) + bigEndian(1) + bigEndian(2) + bigEndian(0);
    writeFile("a.mpo", jpeg.left(2) + "\xff\xe2" + bigEndian(std::uint32_t(list.size()) + 2, 2) +
                           list + jpeg.mid(2) + jpeg);
    QVERIFY(notesOf("a.mpo").find("has 2 pictures, of which the first is read") !=
            std::string::npos);
    writeFile("stack.tif", {});
    writePages("stack.tif",
               {{.width = 9, .height = 7, .description = "ImageJ=1.53\nimages=25\nslices=25\n"}},
               wantedValue);
    QVERIFY(
        notesOf("stack.tif").starts_with("says that it has 25 images, of which 1 can be found"));
  }

  /// Floats whose white is 255.
  void valuesAboveWhite() {
    for (const float white : {1.0F, 255.0F}) {
      writePages("a.exr", {{.width = 30, .height = 20, .type = PictureType::Float}},
                 [&](std::size_t page, int x, int y, int c) {
                   return 0.1F + white * wantedValue(page, x, y, c);
                 });
      QCOMPARE(notesOf("a.exr").empty(), white == 1);
    }
  }

  /// A folder of views tells what its first view says.
  void foldersOfViews() {
    for (const char* name : {"views/0_0.exr", "views/0_1.exr"})
      writePages(name,
                 {{.width = 10,
                   .height = 8,
                   .x = name[9] == '1' ? 3 : 5,
                   .y = 2,
                   .display = {0, 0, 30, 20},
                   .channels = {"R", "G", "B", "Z"},
                   .type = PictureType::Half}},
                 wantedValue);
    const auto file = openLightField(lightFieldOf("views"), {});
    QVERIFY((file->size() == LightFieldSize{30, 20, 2, 1}));
    QCOMPARE(file->warnings(),
             (std::vector<std::string>{"the first view, 0_0.exr, has the channel Z beside its "
                                       "colours, which are read"}));
    // Jobs tell what this finds.
    const std::vector<std::string> examined = examine(lightFieldOf("views"), {});
    QCOMPARE(std::ranges::count(examined, file->warnings()[0]), 1);
    writePages("a.exr", {{.width = 30, .height = 20, .channels = {"R", "G", "B", "Z"}}},
               wantedValue);
    PanelParams display;
    display.hogels = {3, 2};
    display.directions = {10, 10};
    QCOMPARE(examine(lightFieldOf("a.exr"), display),
             (std::vector<std::string>{
                 "the picture has the channel Z beside its colours, which are read"}));
  }

  void matlabBefore73() {
    QByteArray file =
        QByteArray("MATLAB 5.0 MAT-file").leftJustified(124) + QByteArray("\0\1IM", 4);
    const auto element = [](int type, const QByteArray& content) {
      QByteArray text;
      for (const int number : {type, int(content.size())})
        for (unsigned byte = 0; byte < 4; ++byte) text += char(number >> 8U * byte);
      return text + content.leftJustified((content.size() + 7) / 8 * 8, '\0');
    };
    const QByteArray shape("\5\0\0\0\5\0\0\0\36\0\0\0\50\0\0\0\3\0\0\0", 20);
    file += element(14, element(6, QByteArray(8, '\0')) + element(5, shape) + element(1, "LF"));
    writeFile("a.mat", file);
    QCOMPARE(errorOf("a.mat"),
             std::string("a.mat: is a MATLAB file before version 7.3 (LF "
                         "5×5×30×40×3): save it anew by save(NAME, 'LF', '-v7.3')"));
    writeFile("b.mat", file.left(200));
    QVERIFY(errorOf("b.mat").starts_with("b.mat: is a MATLAB file before version 7.3"));
  }

  /// Directories that name each other, or more entries than there are bytes.
  void hostileDirectories() {
    const QByteArray loop = QByteArray("MM\0*\0\0\0\10\0\1", 10) + bigEndian(256, 2) +
                            bigEndian(3, 2) + bigEndian(1) + bigEndian(9 << 16U) + bigEndian(8);
    const auto directories = [](const QByteArray& bytes) {
      return tiffDirectories(
                 [&](std::uint64_t at, std::span<std::byte> to) {
                   if (at >= std::uint64_t(bytes.size())) return std::size_t{0};
                   const auto count = std::min(to.size(), std::size_t(bytes.size()) - at);
                   std::memcpy(to.data(), bytes.data() + at, count);
                   return count;
                 },
                 100)
          .size();
    };
    QCOMPARE(directories(loop), std::size_t(1));
    QCOMPARE(directories(QByteArray("MM\0*\0\0\0\10\xff\xff", 10)), std::size_t(0));
    QCOMPARE(directories(QByteArray("II+\0\10\0\0\0\xff\xff\xff\xff\xff\xff\xff\xff", 16)),
             std::size_t(0));
    QCOMPARE(directories(""), std::size_t(0));
  }

 private:
  /// Gives a simple WebP an extended head and EXIF.
  static void wrapWebp(const QByteArray& file, const QByteArray& exif) {
    const QByteArray simple = contentOf(file);
    const auto littleEndian = [](std::uint32_t number, int bytes) {
      QByteArray text = bigEndian(number, bytes);
      std::ranges::reverse(text);
      return text;
    };
    const QByteArray content = "WEBPVP8X" + littleEndian(10, 4) + littleEndian(8, 4) +
                               littleEndian(width - 1, 3) + littleEndian(height - 1, 3) +
                               simple.mid(12) + "EXIF" +
                               littleEndian(std::uint32_t(exif.size()), 4) + exif;
    writeFile(file, "RIFF" + littleEndian(std::uint32_t(content.size()), 4) + content);
  }

  std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_APPLESS_MAIN(TestPictureFacts)
#include "test_picture_facts.moc"
