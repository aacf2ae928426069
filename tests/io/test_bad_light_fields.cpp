// SPDX-License-Identifier: BSD-3-Clause
// Tests the line that the program prints for pictures and folders it cannot show.
#include <QTemporaryDir>
#include <cmath>

#include "io/images/image_file.h"
#include "io/scene/view_source.h"
#include "tests/io/any_images.h"
#include "tests/io/refusal.h"

using namespace hogelscope;

namespace {

/// Of 4×3 hogels and 2×2 directions.
QByteArray hogels(const QByteArray& file) {
  return text({.display = R"({"hogels": [4, 3], "directions": [2, 2]})",
               .lightField = R"({"file": ")" + file + R"("})"});
}

QByteArray views(const QByteArray& file, const QByteArray& more = {},
                 const QByteArray& display = "{}") {
  return text({.display = display,
               .lightField = R"({"layout": "views", "file": ")" + file + "\"" + more + "}"});
}

QByteArray quilt(const QByteArray& file, const QByteArray& more = {},
                 const QByteArray& display = "{}") {
  return text({.display = display,
               .lightField = R"({"layout": "quilt", "file": ")" + file + "\"" + more + "}"});
}

QByteArray mosaic(const QByteArray& display) {
  return text({.display = display, .lightField = R"({"layout": "mosaic", "file": "ok.png"})"});
}

float noise(int x, int y, int channel) {
  return float((x * 7919 + y * 104729 + channel * 1299709) % 251) / 250.0F;
}

/// A new file of the first half of `file`.
void cut(const QString& file, const QString& half) {
  const QByteArray whole = contentOf(file);
  writeFile(half, whole.left(whole.size() / 2));
}

void damage(const QString& file, const QString& damaged) {
  QByteArray bytes = contentOf(file);
  for (qsizetype at = bytes.size() / 2; at < bytes.size() / 2 + 100; ++at) bytes[at] = '\xff';
  writeFile(damaged, bytes);
}

/// As checkProgram, but read here; the program adds the session's name where a line has none.
void checkReading() {
  QFETCH(QByteArray, document);
  QFETCH(QByteArray, line);
  writeFile("s.json", document);
  const auto load = [] { (void)loadViewSource(loadSession("s.json"), {}); };
  QCOMPARE(errorOf(load).toUtf8(), line);
}

void writeViews(const QString& folder, const QStringList& names) {
  for (const QString& name : names) writeGrey(folder + "/" + name, 8, 6);
}

}  // namespace

class TestBadLightFields : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void pictures_data();
  void pictures() { checkProgram(m_folder.path()); }
  void folders_data();
  void folders() { checkProgram(m_folder.path()); }
  void twoFilesForOneView();
  void patterns_data();
  void patterns() { checkReading(); }
  void quilts_data();
  void quilts() { checkReading(); }
  void mosaics_data();
  void mosaics() { checkReading(); }
  void rawPictures_data();
  void rawPictures() { checkReading(); }
  void everyBeginningOfAPgx();
  void attacks_data();
  void attacks();
  void exrHeadersThatAskForGigabytes_data();
  void exrHeadersThatAskForGigabytes();

 private:
  QTemporaryDir m_folder;
};

void TestBadLightFields::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  writeGrey("ok.png", 8, 6);
  writeImageFile("noise.png", 64, 48, noise);
  writeImageFile("noise.jpg", 64, 48, noise);
  cut("noise.png", "cut.png");
  cut("noise.jpg", "cut.jpg");
  damage("noise.png", "damaged.png");
  writeFile("text.png", "hello\n");
  writeFile("text.txt", "hello\n");
  writeFile("empty.png", "");
  const auto oneNan = [](int x, int y, int c) { return x == 5 && y == 2 && c == 1 ? NAN : 0.5F; };
  writeImageFile("nan.exr", 8, 6, oneNan, {PictureType::Float});
  writeImageFile("nan.tif", 8, 6, oneNan, {PictureType::Float});

  QVERIFY(QDir().mkdir("none"));
  writeViews("views", {"000_000.png", "000_001.png", "001_000.png", "001_001.png"});
  QVERIFY(QFile::link("circle", "circle"));
  writeViews("holes", {"000_000.png", "999999999999_1000000000.png"});
  writeViews("nowhere", {"000_000.png", "000_001.png", "001_000.png"});
  QVERIFY(QFile::link("none.png", "nowhere/001_001.png"));
  writeViews("sizes", {"000_000.png", "000_001.png", "001_000.png"});
  writeGrey("sizes/001_001.png", 4, 6);
  writeViews("twice", {"000_000.png", "000_001.png", "000_001.jpg"});
  writeImageFile("broken/000_000.jpg", 64, 48, noise);
  cut("noise.jpg", "broken/000_001.jpg");
  writeViews("five", {"input_Cam000.png", "input_Cam001.png", "input_Cam002.png",
                      "input_Cam003.png", "input_Cam004.png"});
  writeViews("long", {QString(60, 'a') + "_0.png"});
}

void TestBadLightFields::pictures_data() {
  refusalColumns();
  refused("missing", hogels("none.png"), "none.png: there is no such file");
  refused("in a missing folder", hogels("nowhere/ok.png"), "nowhere/ok.png: there is no such file");
  refused("a folder", hogels("views"),
          "views: is a folder, not a picture; a folder has layout \"views\"");
  refused("text, named .png", hogels("text.png"),
          "text.png: cannot be read as a picture: Not a PNG file");
  refused("text", hogels("text.txt"),
          "text.txt: cannot be read as a picture: its content is of no known format");
  refused("the session itself", hogels("s.json"),
          "s.json: cannot be read as a picture: its content is of no known format");
  refused("empty", hogels("empty.png"), "empty.png: cannot be read as a picture: Not a PNG file");
  refused("PNG cut in half",
          text({.display = R"({"hogels": [64, 48], "directions": [1, 1]})",
                .lightField = R"({"file": "cut.png"})"}),
          "cut.png: is damaged: end of stream");
  refused("PNG damaged",
          text({.display = R"({"hogels": [64, 48], "directions": [1, 1]})",
                .lightField = R"({"file": "damaged.png"})"}),
          "damaged.png: row 10: is damaged: IDAT stream error");
  refused("JPEG cut in half",
          text({.display = R"({"hogels": [64, 48], "directions": [1, 1]})",
                .lightField = R"({"file": "cut.jpg"})"}),
          "cut.jpg: is damaged: JPEG error: Premature end of JPEG file");
  refused("not hogels times directions", hogels("noise.png"),
          "noise.png: size: is 64×48 px, but 4×3 hogels of 2×2 directions need 8×6");
  refused("hogels and directions changed over",
          text({.display = R"({"hogels": [3, 4], "directions": [2, 2]})",
                .lightField = R"({"file": "ok.png"})"}),
          "ok.png: size: is 8×6 px, but 3×4 hogels of 2×2 directions need 6×8");
  refused("a device", hogels("/dev/zero"), "/dev/zero: is a device or a pipe, not a picture file");
  refused("NaN in EXR", hogels("nan.exr"), "nan.exr: pixel (5, 2): is not a number");
  refused("NaN in TIFF", hogels("nan.tif"), "nan.tif: pixel (5, 2): is not a number");
  refused("a line break in its name", hogels(R"(a\nb.png)"),
          "s.json: lightField.file: \"a\\nb.png\" has a control character");
}

void TestBadLightFields::folders_data() {
  refusalColumns();
  refused("missing", views("elsewhere"), "elsewhere: there is no such folder");
  const QByteArray longName(300, 'x');
  refused("a name that no file has", views(longName),
          longName + ": cannot be read: File name too long");
  refused("a pattern that no file has", views(longName + "%d"),
          "s.json: lightField.file: is longer than a file's name can be");
  refused("a circle of links", views("circle"),
          "circle: cannot be read: Too many levels of symbolic links");
  refused("a picture", views("ok.png"), "ok.png: is a file; layout \"views\" reads a folder");
  refused("empty", views("none"),
          "none: views: no names agree in all but their numbers: the folder has no files that "
          "could be views; give lightField.pattern, such as RRR_CCC");
  refused("no series", views("long"),
          "long: views: no names agree in all but their numbers: " + QByteArray(60, 'a') +
              "_0.png is there; give lightField.pattern, such as RRR_CCC");
  refused("half of the views are missing", views("holes"),
          "holes: views: only 2 of 4 views are there, such as 000_000.png: if the others are "
          "missing give display.directions, such as [2,2], or if they are read the wrong way give "
          "lightField.pattern");
  refused("a link that leads nowhere", views("nowhere"),
          "nowhere/001_001.png: there is no such file");
  refused("views of different size", views("sizes"),
          "sizes/001_001.png: size: is 4×6 px, but the first view is 8×6; lightField.exclude "
          "leaves out what is no view");
  refused("a broken view", views("broken"),
          "broken/000_001.jpg: is damaged: JPEG error: Premature end of JPEG file");
  refused("five numbered views, nine expected", views("five", "", R"({"directions": [3, 3]})"),
          "five: views: 5 views do not make a grid of 3×3; mend display.directions");
  refused("other hogels", views("views", "", R"({"hogels": [6, 8]})"),
          "s.json: display.hogels: is 6×8, but the light field's file has 8×6");
  refused("other directions", views("views", "", R"({"directions": [4, 1]})"),
          "s.json: display.directions: is 4×1, but the light field's file has 2×2");
}

/// Which of them comes first is the file system's choice.
void TestBadLightFields::twoFilesForOneView() {
  writeFile("s.json", views("twice", R"(, "pattern": "RRR_CCC")"));
  const Outcome outcome =
      run({"--render", "--session", "s.json", "--output", "out"}, m_folder.path());
  QCOMPARE(outcome.status, 2);
  const QByteArray one = "000_001.png";
  const QByteArray other = "000_001.jpg";
  const auto line = [](const QByteArray& a, const QByteArray& b) {
    return "hogelscope: twice: views: " + a + " and " + b + " are the same view\n";
  };
  QVERIFY2(outcome.err == line(one, other) || outcome.err == line(other, one), outcome.err);
}

void TestBadLightFields::patterns_data() {
  refusalColumns();
  refused("fits no name", views("views", R"(, "pattern": "view_RR_CC")"),
          "views: views: \"view_RR_CC\" matches no file: 000_000.png and 3 more files are there; "
          "correct lightField.pattern");
  refused("a number after the last dot", views("views", R"(, "pattern": "render.RRR.CCC")"),
          "views: views: \"render.RRR.CCC\" matches no file: 000_000.png and 3 more files are "
          "there; what follows the last dot is the extension: write render.RRR.CCC.png");
  refused("another extension", views("views", R"(, "pattern": "RRR_CCC.jpg")"),
          "views: views: \"RRR_CCC.jpg\" matches no file: 000_000.png and 3 more files are there; "
          "correct lightField.pattern");
  refused("without numbers", views("views", R"(, "pattern": "view")"),
          "lightField.pattern: \"view\" names neither one row (RR) and one column (CC) nor one "
          "running number (NNN) nor coordinates (x, y)");
  refused("only rows", views("views", R"(, "pattern": "RRR_*")"),
          "lightField.pattern: \"RRR_*\" names neither one row (RR) and one column (CC) nor one "
          "running number (NNN) nor coordinates (x, y)");
  refused("rows, columns and a number", views("views", R"(, "pattern": "RR_CC_NN")"),
          "lightField.pattern: \"RR_CC_NN\" names neither one row (RR) and one column (CC) nor one "
          "running number (NNN) nor coordinates (x, y)");
  refused("a line break", views("views", R"(, "pattern": "a\nb")"),
          "s.json: lightField.pattern: \"a\\nb\" has a control character");
  refused(
      "% that fits no name", views("views/%03d_%03d.tif"),
      "views: views: \"%03d_%03d.tif\" matches no file: 000_000.png and 3 more files are there; "
      "correct lightField.pattern");
  refused("%s", views("views/%s.png"),
          "lightField.file: \"%s.png\": only %d and %02d stand for numbers");
  // TODO wording: lightField.file
  refused("% three times", views("views/%d_%d%d.png"),
          "lightField.pattern: \"%d_%d%d.png\" names neither one row (RR) and one column (CC) nor "
          "one running number (NNN) nor coordinates (x, y)");
  refused("% in a missing folder", views("elsewhere/%d_%d.png"),
          "elsewhere: there is no such folder");
  refused("% in a folder's name", views("%d/a.png"), "%d/a.png: there is no such folder");
}

void TestBadLightFields::quilts_data() {
  refusalColumns();
  refused("more views than pixels", quilt("ok.png", R"(, "columns": 9, "rows": 3)"),
          "ok.png: size: is 8×6 px, which does not divide into 9×3 views; mend lightField.columns "
          "and rows");
  refused("neither columns nor suffix", quilt("ok.png"),
          "ok.png: lightField.columns: and rows are not given, and the file's name has no "
          "_qs{columns}x{rows}a{aspect}");
  refused("columns without rows", quilt("ok.png", R"(, "columns": 2)"),
          "ok.png: lightField.columns: and rows are not given, and the file's name has no "
          "_qs{columns}x{rows}a{aspect}");
  refused("a folder", quilt("views", R"(, "columns": 2, "rows": 2)"),
          "views: is a folder, not a picture; a folder has layout \"views\"");
  refused("other directions",
          quilt("ok.png", R"(, "columns": 2, "rows": 3)", R"({"directions": [2, 3]})"),
          "display.directions: is 2×3, but the light field's file has 6×1");
}

void TestBadLightFields::mosaics_data() {
  refusalColumns();
  refused("does not divide", mosaic(R"({"directions": [4, 4]})"),
          "ok.png: size: is 8×6 px, which does not divide into 4×4 views; mend display.directions");
  refused("no directions", mosaic("{}"),
          "ok.png: display.directions: is not given: how many views the picture has across and "
          "down, such as [15,15]");
  refused("other hogels", mosaic(R"({"directions": [4, 3], "hogels": [3, 2]})"),
          "display.hogels: is 3×2, but the light field's file has 2×2");
}

/// PGX, raw YUV, and JPEG XL, which nothing here reads.
void TestBadLightFields::rawPictures_data() {
  refusalColumns();
  const auto pgx = [](const char* name, const char* file, const QByteArray& content,
                      const QByteArray& line) {
    writeFile(file, content);
    refused(name, hogels(file), file + line);
  };
  const QByteArray line = ": is damaged: a PGX begins with a line such as PG ML +10 WIDTH HEIGHT";
  pgx("text named .pgx", "text.pgx", "hello\n", line);
  pgx("empty PGX", "empty.pgx", "", line);
  pgx("PGX of another order of bytes", "order.pgx", "PG MM +8 8 6\n" + QByteArray(48, 'a'), line);
  pgx("PGX without an end", "endless.pgx", "PG ML +8 8 " + QByteArray(5000, '6'), line);
  pgx("PGX with a negative width", "negative.pgx", "PG ML +8 -8 6\n" + QByteArray(48, 'a'), line);
  pgx("PGX of 17 bits", "deep.pgx", "PG ML +17 8 6\n" + QByteArray(192, 'a'),
      ": has 17 bits a sample: 1 to 16 can be read");
  pgx("PGX without pixels", "none.pgx", "PG ML +8 0 6\n", ": is not a picture with pixels");
  pgx("PGX that asks for 2 EB", "large.pgx", "PG ML +10 999999999 999999999\nab",
      ": is damaged: its 32 bytes cannot be 999999999×999999999 px of 10 bits");
  pgx("PGX with a sample of 11 bits", "range.pgx",
      "PG ML +10 8 6\n" + QByteArray(18, 0) + "\4" + QByteArray(77, 0),
      ": sample (1, 1): has more than 10 bits");
  pgx("PGX with too small a sample", "sign.pgx", "PG ML -4 8 6\n" + QByteArray(48, '\x80'),
      ": sample (0, 0): has more than 4 bits");
  writeFile("rgb/0/a.pgx", "PG ML +8 8 6\n" + QByteArray(48, 'a'));
  writeFile("rgb/1/a.pgx", "PG ML +8 8 6\n" + QByteArray(48, 'a'));
  writeFile("rgb/2/a.pgx", "PG ML +7 8 6\n" + QByteArray(48, 'a'));
  refused(
      "components of other bits", hogels("rgb/0/a.pgx"),
      QDir::currentPath().toUtf8() +
          "/rgb/2/a.pgx: size: is 8×6 px of 7 bits, but the component in folder 0 has 8×6 px of "
          "8 bits");

  const auto yuv = [](const QByteArray& more) {
    return text({.display = R"({"hogels": [4, 3], "directions": [2, 2]})",
                 .lightField = R"({"file": "a.yuv")" + more + "}"});
  };
  writeFile("a.yuv", QByteArray(72, 'a'));
  refused(
      "YUV without a size", yuv(""),
      "a.yuv: lightField.yuvSize: is not given, and raw YUV does not say its size; for a folder "
      "of views give lightField.pattern too, such as RRR_CCC.yuv");
  refused("YUV of another sampling", yuv(R"(, "yuvSize": [8, 6], "yuvSampling": "4:4:4")"),
          "a.yuv: size: is 72 bytes, but one picture of 8×6 px, 4:4:4, 8 bits has 144; mend "
          "lightField.yuvSize, yuvSampling or yuvBits");
  refused("YUV of a million px squared", yuv(R"(, "yuvSize": [1000000, 1000000], "yuvBits": 10)"),
          "a.yuv: size: is 72 bytes, but one picture of 1000000×1000000 px, 4:2:0, 10 bits has "
          "3000000000000; mend lightField.yuvSize, yuvSampling or yuvBits");
  refused("YUV of 9 bits", yuv(R"(, "yuvBits": 9)"),
          "s.json: lightField.yuvBits: 9 is not one of 8, 10, … 16");
  writeFile("wide.yuv", QByteArray(144, 'a'));
  refused("YUV that is not 10 bits",
          hogels(R"(wide.yuv", "yuvSize": [8, 6], "yuvBits": 10, "yuvMatrix": "bt601)"),
          "wide.yuv: sample (0, 0): has more than 10 bits");
  refused("YUV's size of a PNG", hogels(R"(ok.png", "yuvSize": "x)"),
          "s.json: lightField.yuvSize: is not known here; known are file, layout, incoming, "
          "viewingDistance, fps, frames");

  const QByteArray jpegXl = "is JPEG XL, which OpenImageIO " +
                            QByteArray::fromStdString(openImageIoVersion()) +
                            " does not read; convert it, such as by djxl NAME.jxl NAME.png";
  writeFile("bare.jxl", "\xff\x0a\x10\x90");
  refused("JPEG XL", hogels("bare.jxl"), "bare.jxl: " + jpegXl);
  writeFile("boxed.jxl", QByteArray("\0\0\0\x0cJXL \r\n\x87\n\0\0\0\x14", 16));
  refused("JPEG XL in boxes", hogels("boxed.jxl"), "boxed.jxl: " + jpegXl);
}

void TestBadLightFields::everyBeginningOfAPgx() {
  const QByteArray whole = "PG LM -10 3 2\n" + QByteArray(12, 0);
  for (qsizetype length = 0; length < whole.size(); ++length) {
    writeFile("begin.pgx", whole.left(length));
    const QString error = errorOf([] { ImageFile(std::filesystem::path("begin.pgx")); });
    QVERIFY2(error.startsWith("begin.pgx: is damaged: "), qPrintable(error));
  }
  writeFile("begin.pgx", whole);
  QCOMPARE(errorOf([] { ImageFile(std::filesystem::path("begin.pgx")); }), QString());
}

/// What somebody might try; the line is not told, but there is one, soon.
void TestBadLightFields::attacks_data() {
  QTest::addColumn<QByteArray>("document");
  const auto pattern = [](const QByteArray& text) {
    return views("long", ", \"pattern\": \"" + text + "\"");
  };
  QTest::newRow("many stars") << pattern(QByteArray("*a").repeated(12) + "_NNN.x");
  QTest::newRow("a pattern of 300 kB") << pattern(QByteArray("ab_").repeated(100000));
  QTest::newRow("a pattern of 1 MB of one letter") << pattern(QByteArray(1000000, 'a'));
  QTest::newRow("a zero in the name") << hogels(R"(ok.png\u0000.exr)");
}

void TestBadLightFields::attacks() {
  QFETCH(QByteArray, document);
  writeFile("s.json", document);
  const QStringList arguments{"--render", "--session", "s.json", "--output", "attacks"};
  const Outcome outcome = run(arguments, m_folder.path());
  QCOMPARE(outcome.status, 2);
  QVERIFY(outcome.err.startsWith("hogelscope: "));
  QCOMPARE(outcome.err.count('\n'), 1);
  QVERIFY(outcome.err.size() < 1000);
}

void TestBadLightFields::exrHeadersThatAskForGigabytes_data() {
  QTest::addColumn<QByteArray>("attribute");
  QTest::addColumn<int>("at");  // bytes after the attribute's type
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("problem");
  const QByteArray gigabytes("\0\0\0\x60", 4);
  QTest::newRow("an attribute's size") << QByteArray("compression\0compression", 23) << 1
                                       << gigabytes << "compression needs more than the file has";
  // Behind the size: the first and the last pixel, x and y.
  QTest::newRow("the table of chunks") << QByteArray("dataWindow\0box2i", 16) << 17 << gigabytes
                                       << "dataWindow needs more than the file has";
  QTest::newRow("lines of 16 million pixels")
      << QByteArray("dataWindow\0box2i", 16) << 13 << QByteArray("\0\0\xfe\0", 4)
      << "dataWindow needs more than the file has";
  // OpenEXR reads on from the type's end, not from the size's: the next attribute is another there.
  QTest::newRow("a size that is not the type's")
      << QByteArray("channels\0chlist", 15) << 1 << QByteArray("\x36\0\0\0", 4)
      << "channels is longer or shorter than a chlist";
  QTest::newRow("a window of 15 bytes")
      << QByteArray("displayWindow\0box2i", 19) << 1 << QByteArray("\x0f\0\0\0", 4)
      << "displayWindow is longer or shorter than a box2i";
}

/// OpenEXR allocates what they ask for before it looks whether the file has it.
void TestBadLightFields::exrHeadersThatAskForGigabytes() {
  QFETCH(QByteArray, attribute);
  QFETCH(int, at);
  QFETCH(QByteArray, bytes);
  QFETCH(QString, problem);
  writeImageFile("large.exr", 8, 6, [](int, int, int) { return 0.5F; }, {PictureType::Half});
  QByteArray content = contentOf("large.exr");
  const qsizetype place = content.indexOf(attribute);
  QVERIFY(place > 0);
  content.replace(place + attribute.size() + at, bytes.size(), bytes);
  writeFile("large.exr", content);
  QCOMPARE(errorOf([] { ImageFile(std::filesystem::path("large.exr")); }),
           "large.exr: is damaged: its " + problem);
}

QTEST_GUILESS_MAIN(TestBadLightFields)
#include "test_bad_light_fields.moc"
