// SPDX-License-Identifier: BSD-3-Clause
// Tests the pictures of a twin's maps: channels by their names, what is written is read, and the
// line for each mistake.
#include "io/twin/twin_maps.h"

#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "io/images/channel_file.h"
#include "io/images/image_writer.h"
#include "tests/core/random_twin.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"
#include "tests/io/twin_files.h"

using namespace hogelscope;

namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

using Planes = std::vector<std::pair<std::string, std::vector<float>>>;

/// Writes channels of 2×1 px.
void writePair(const char* file, const Planes& planes) {
  writePlanes(file, 2, 1, planes);
}

/// Overwrites bytes behind the first occurrence of `after`.
void damage(const QString& file, const QByteArray& after, int at, const QByteArray& bytes) {
  QByteArray content = contentOf(file);
  const qsizetype place = content.indexOf(after);
  if (place < 0) qFatal("nothing to damage");
  content.replace(place + after.size() + at, bytes.size(), bytes);
  writeFile(file, content);
}

}  // namespace

class TestTwinMaps : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(m_folder.path())); }
  void nothing();
  void roundTrip();
  void writesCoarseMaps();
  void cannotWrite();
  void channelsByName();
  void storedOtherwise_data();
  void storedOtherwise();
  void ofAnotherProcess();
  void heights();
  void badChannels_data();
  void badChannels();
  void badFiles_data();
  void badFiles();
  void cancelling();

 private:
  QTemporaryDir m_folder;
};

void TestTwinMaps::nothing() {
  QCOMPARE(filled(readTwinMaps({}, designOf())), std::string(15, '0'));
}

/// The same bits, of all channels and of each alone.
void TestTwinMaps::roundTrip() {
  const PanelParams design = designOf({7, 5});
  Random random(1);
  TwinMaps maps;
  for (TwinPlane* plane : {&maps.shiftX, &maps.shiftY, &maps.tiltX, &maps.tiltY, &maps.gap})
    *plane = randomPlane(random, 7, 5, -1e-3, 1e-3);
  for (TwinPlane& plane : maps.gain) plane = randomPlane(random, 7, 5, 0, 2);
  writeHogelMaps("hogels.exr", maps);
  const TwinMaps back = read("hogels.exr", design);
  QCOMPARE(filled(back), std::string("111111110000000"));
  for (std::size_t k = 0; k < 8; ++k) {
    const TwinPlane& plane = *allPlanes(maps)[k];
    QVERIFY(isPlane(*allPlanes(back)[k], 7, 5, plane.values));
    TwinMaps one;
    *allPlanes(one)[k] = plane;
    writeHogelMaps("hogels_one.exr", one);
    const TwinMaps alone = read("hogels_one.exr", design);
    QCOMPARE(filled(alone), filled(one));
    QVERIFY(isPlane(*allPlanes(alone)[k], 7, 5, plane.values));
  }
}

/// Planes of several sizes become one twin's, with the values that its hogels have.
void TestTwinMaps::writesCoarseMaps() {
  Random random(2);
  TwinMaps maps;
  maps.gap = randomPlane(random, 7, 5, -0.1, 0.1);
  maps.tiltX = randomPlane(random, 2, 3, -0.1, 0.1);
  maps.gain[1] = randomPlane(random, 1, 1, 0.5, 0.9);
  writeHogelMaps("hogels.exr", maps);
  const TwinMaps back = read("hogels.exr", designOf({7, 5}));
  QCOMPARE(filled(back), std::string("001010100000000"));
  QVERIFY(isPlane(back.gap, 7, 5, maps.gap.values));
  QVERIFY(isPlane(back.gain[1], 7, 5, std::vector<float>(35, maps.gain[1].values[0])));
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 7; ++i)
      QCOMPARE(back.tiltX.atCell(i, j, 7, 5), maps.tiltX.atCell(i, j, 7, 5));
}

void TestTwinMaps::cannotWrite() {
  TwinMaps maps;
  maps.gap = {1, 1, {0.5F}};
  QCOMPARE(errorOf([&] { writeHogelMaps("hogels.tif", maps); }),
           "hogels.tif: cannot be written: channels have names in EXR alone; give it the extension "
           ".exr");
  QVERIFY(!QFile::exists("hogels.tif"));
  compareLine(errorOf([&] { writeHogelMaps("nowhere/hogels.exr", maps); }).toUtf8(),
              "nowhere/hogels.exr: cannot be written: …");
  QVERIFY_EXCEPTION_THROWN(writeHogelMaps("hogels.exr", {}), std::logic_error);
}

/// Each channel goes to its own plane, row 0 is the first, and what is missing stays empty.
void TestTwinMaps::channelsByName() {
  const std::vector<std::string> hogels{"shift.x", "shift.y", "tilt.x", "tilt.y",
                                        "gap",     "gain.R",  "gain.G", "gain.B"};
  for (std::size_t k = 0; k < hogels.size(); ++k) {
    writePlanes("hogels.exr", 2, 3, {{hogels[k], {0, 1, 2, 3, 4, 5}}});
    const TwinMaps maps = read("hogels.exr");
    std::string expected(15, '0');
    expected[k] = '1';
    QCOMPARE(filled(maps), expected);
    QVERIFY(isPlane(*allPlanes(maps)[k], 2, 3, {0, 1, 2, 3, 4, 5}));
  }
  const std::vector<float> more{1, 2, 3, 4, 5, 6};
  writePlanes("directions.exr", 3, 2,
              {{"sigma", more},
               {"gain.B", {0, 0, 0, 0, 0, 1}},
               {"move.v", {-1, 0, 0, 0, 0, 0}},
               {"gain.R", {2, 0, 0, 0, 0, 0}},
               {"move.u", {0, 0, -3, 0, 0, 0}},
               {"gain.G", {0, 7, 0, 0, 0, 0}}});
  const TwinMaps maps = read("directions.exr");
  QCOMPARE(filled(maps), std::string("000000001111110"));
  QVERIFY(isPlane(maps.sigma, 3, 2, more));
  QVERIFY(isPlane(maps.moveU, 3, 2, {0, 0, -3, 0, 0, 0}));
  QVERIFY(isPlane(maps.moveV, 3, 2, {-1, 0, 0, 0, 0, 0}));
  QVERIFY(isPlane(maps.directionGain[0], 3, 2, {2, 0, 0, 0, 0, 0}));
  QVERIFY(isPlane(maps.directionGain[1], 3, 2, {0, 7, 0, 0, 0, 0}));
  QVERIFY(isPlane(maps.directionGain[2], 3, 2, {0, 0, 0, 0, 0, 1}));
}

void TestTwinMaps::storedOtherwise_data() {
  QTest::addColumn<int>("type");
  QTest::addColumn<int>("tile");
  QTest::newRow("half") << int(PictureType::Half) << 0;
  QTest::newRow("tiles of float") << int(PictureType::Float) << 16;
  QTest::newRow("tiles of half") << int(PictureType::Half) << 32;
}

/// Larger than a band of rows.
void TestTwinMaps::storedOtherwise() {
  QFETCH(int, type);
  QFETCH(int, tile);
  const auto value = [](int x, int y, int c) { return float((x + 3 * y) % 512 + 512 * c); };
  writeImageFile("hogels.exr", 1100, 1001, value,
                 {PictureType(type), 3, tile, {"shift.x", "gain.B", "gap"}});
  const TwinMaps maps = read("hogels.exr", designOf({1100, 1001}));
  QCOMPARE(filled(maps), std::string("100010010000000"));
  const std::array planes{&maps.shiftX, &maps.gain[2], &maps.gap};
  int wrong = 0;
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < 1001; ++y)
      for (int x = 0; x < 1100; ++x)
        wrong +=
            planes[std::size_t(c)]->values[std::size_t(1100 * y + x)] == value(x, y, c) ? 0 : 1;
  QCOMPARE(wrong, 0);
}

/// A format that this process does not read itself has its channels too, in several bands.
void TestTwinMaps::ofAnotherProcess() {
  const auto value = [](int x, int y, int c) { return float((x + 3 * y) % 8 + 1 + 8 * c) / 4; };
  writeImageFile("colours.hdr", 2000, 601, value, {PictureType::Float});
  ChannelFile file("colours.hdr");
  QCOMPARE(file.names(), (std::vector<std::string>{"R", "G", "B"}));
  QCOMPARE(file.width(), std::size_t(2000));
  for (int c = 0; c < 3; ++c) {
    const std::vector<float> values = file.read(std::size_t(c));
    QCOMPARE(values.size(), std::size_t(2000 * 601));
    int wrong = 0;
    for (int y = 0; y < 601; ++y)
      for (int x = 0; x < 2000; ++x)
        wrong += values[std::size_t(2000 * y + x)] == value(x, y, c) ? 0 : 1;
    QCOMPARE(wrong, 0);
  }
}

void TestTwinMaps::heights() {
  const std::vector<float> metres{0, -0.001F, 0.25F, 3, -4, 5};
  writePlanes("height.exr", 3, 2, {{"height", metres}, {"R", {9, 9, 9, 9, 9, 9}}});
  QVERIFY(isPlane(read("height.exr").height, 3, 2, metres));
  writePlanes("height.exr", 3, 2, {{"Z", metres}});
  QVERIFY(isPlane(read("height.exr").height, 3, 2, metres));
  QCOMPARE(filled(read("height.exr")), std::string("000000000000001"));
  for (const char* file : {"height.fits", "height.tif"}) {
    writeImageFile(file, 3, 2, [&](int x, int y, int) { return metres[std::size_t(3 * y + x)]; },
                   {PictureType::Float, 1});
    QVERIFY2(isPlane(read(file).height, 3, 2, metres), file);
  }
  writePlanes("height.exr", 16384, 1, {{"height", std::vector<float>(16384, 1)}});
  QCOMPARE(read("height.exr").height.width, 16384);
}

void TestTwinMaps::badChannels_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QByteArray>("name");
  QTest::addColumn<float>("value");
  QTest::addColumn<QByteArray>("line");
  const QByteArray pixel = ", pixel (1, 2): ";
  const QByteArray hogels = "shift.x, shift.y, tilt.x, tilt.y, gap, gain.R, gain.G, gain.B";
  for (const char* name : {"shift.x", "shift.y", "tilt.x", "tilt.y", "gap", "gain.R"}) {
    const QByteArray begin = "hogels.exr: channel \"" + QByteArray(name) + "\"" + pixel;
    QTest::newRow(name) << "hogels.exr" << QByteArray(name) << notANumber
                        << begin + "is not a number";
    QTest::newRow(name) << "hogels.exr" << QByteArray(name) << -infinite << begin + "is infinite";
  }
  for (const char* name : {"gain.R", "gain.G", "gain.B"})
    for (const QString file : {"hogels.exr", "directions.exr"})
      QTest::newRow(name) << file << QByteArray(name) << -0.5F
                          << file.toUtf8() + ": channel \"" + name + "\"" + pixel +
                                 "is -0.5, below 0";
  QTest::newRow("no width") << "directions.exr" << QByteArray("sigma") << 0.0F
                            << "directions.exr: channel \"sigma\"" + pixel + "is 0, not above 0";
  QTest::newRow("negative width") << "directions.exr" << QByteArray("sigma") << -2.0F
                                  << "directions.exr: channel \"sigma\"" + pixel +
                                         "is -2, not above 0";
  QTest::newRow("move") << "directions.exr" << QByteArray("move.v") << infinite
                        << "directions.exr: channel \"move.v\"" + pixel + "is infinite";
  QTest::newRow("height") << "height.exr" << QByteArray("height") << notANumber
                          << "height.exr: channel \"height\"" + pixel + "is not a number";
  QTest::newRow("unknown") << "hogels.exr" << QByteArray("shift.z") << 0.0F
                           << "hogels.exr: channel \"shift.z\": is not one of " + hogels;
  QTest::newRow("capitals") << "hogels.exr" << QByteArray("Gap") << 0.0F
                            << "hogels.exr: channel \"Gap\": is not one of " + hogels;
  QTest::newRow("of directions") << "hogels.exr" << QByteArray("sigma") << 1.0F
                                 << "hogels.exr: channel \"sigma\": is not one of " + hogels;
  QTest::newRow("of hogels") << "directions.exr" << QByteArray("gap") << 1.0F
                             << QByteArray(
                                    "directions.exr: channel \"gap\": is not one of move.u, "
                                    "move.v, sigma, gain.R, gain.G, gain.B");
}

void TestTwinMaps::badChannels() {
  QFETCH(QString, file);
  QFETCH(QByteArray, name);
  QFETCH(float, value);
  QFETCH(QByteArray, line);
  writePlanes(file.toStdString(), 2, 3, {{name.toStdString(), {1, 1, 1, 1, 1, value}}});
  QCOMPARE(errorWith(file.toStdString()), line);
}

void TestTwinMaps::badFiles_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QByteArray>("line");
  const auto level = [](int, int, int) { return 0.5F; };
  const auto add = [](const char* row, const QString& file, const QByteArray& line) {
    QTest::newRow(row) << file << file.toUtf8() + ": " + line;
  };
  add("missing", "hogels_missing.exr", "cannot be read: No such file or directory");
  QDir().mkpath("hogels_folder.exr");
  add("a folder", "hogels_folder.exr", "is not a file");
  writePlanes("hogels_wide.exr", 5, 3, {{"gap", std::vector<float>(15)}});
  add("too wide", "hogels_wide.exr", "size: 5×3 px are more than the 4×3 hogels of the display");
  writePlanes("hogels_high.exr", 1, 4, {{"gap", std::vector<float>(4)}});
  add("too high", "hogels_high.exr", "size: 1×4 px are more than the 4×3 hogels of the display");
  writePlanes("directions_wide.exr", 9, 1, {{"sigma", std::vector<float>(9, 1)}});
  add("more than the directions", "directions_wide.exr",
      "size: 9×1 px are more than the 8×8 directions of a hogel");
  writePlanes("height_wide.exr", 1, 16385, {{"height", std::vector<float>(16385)}});
  add("a high height map", "height_wide.exr",
      "size: 1×16385 px are more than the 16384×16384 that a height map may have");
  writePair("height_none.exr", {{"k", {0, 0}}, {"l", {0, 0}}});
  add("no height", "height_none.exr", "has no channel \"height\", but several others: k, l");
  Planes many;
  for (char digit = '0'; digit < '9'; ++digit) many.push_back({{'k', digit}, {0, 0}});
  for (char digit = '0'; digit < '5'; ++digit) many.push_back({{'l', digit}, {0, 0}});
  writePair("height_many.exr", many);
  add("too many to list", "height_many.exr",
      "has no channel \"height\", but several others: k0, k1, k2, k3, k4, k5, k6, k7, k8, "
      "l0, l1, l2, …");
  writeImageFile("hogels_parts.exr", 2, 2, level, {PictureType::Float, 1, 0, {"gap"}, 3});
  add("several parts", "hogels_parts.exr", "has 3 pictures; its channels must be in one");
  writeImageFile("hogels_whole.exr", 2, 2, level, {PictureType::UInt32, 1, 0, {"gap"}});
  add("whole numbers in EXR", "hogels_whole.exr", "channel \"gap\": has whole numbers, not floats");
  writeImageFile("height.png", 2, 2, level, {PictureType::UInt8, 1});
  add("a grey PNG", "height.png", "channel \"Y\": has whole numbers, not floats");
  writeImageFile("height16.tif", 2, 2, level, {PictureType::UInt16, 1});
  add("a grey TIFF", "height16.tif", "channel \"Y\": has whole numbers, not floats");
  writeImageFile("hogels.hdr", 2, 2, level, {PictureType::Float, 3});
  add("colours", "hogels.hdr",
      "channel \"R\": is not one of shift.x, shift.y, tilt.x, tilt.y, gap, gain.R, gain.G, "
      "gain.B");
  writeFile("hogels_text.exr", "shift.x,shift.y\n1,2\n");
  add("text", "hogels_text.exr", "cannot be read as a picture: …");
  writeFile("hogels_empty.exr", "");
  add("empty", "hogels_empty.exr", "cannot be read as a picture: …");
  writePlanes("hogels_full.exr", 4, 3, {{"gap", std::vector<float>(12, 0.1F)}});
  const QByteArray whole = contentOf("hogels_full.exr");
  writeFile("hogels_cut.exr", whole.chopped(4));
  add("truncated", "hogels_cut.exr", "is damaged: …");
  writeFile("hogels_begin.exr", whole.left(60));
  add("the begin of a header", "hogels_begin.exr", "…");
  const QByteArray window("dataWindow\0box2i", 16);
  writeFile("hogels_huge.exr", whole);
  damage("hogels_huge.exr", window, 12, QByteArray("\xff\xff\xff\x7f\xff\xff\xff\x7f", 8));
  add("a huge window", "hogels_huge.exr",
      "is damaged: its dataWindow needs more than the file has");
  writeFile("hogels_long.exr", whole);
  damage("hogels_long.exr", QByteArray("channels\0chlist", 15), 1, QByteArray("\0\0\0\x60", 4));
  add("gigabytes of channels", "hogels_long.exr",
      "is damaged: its channels needs more than the file has");
  // With this OpenImageIO 2.4 writes beyond an array.
  writeFile("hogels.psd", QByteArray("8BPS\0\1\0\0\0\0\0\0\0\3\0\0\0\x08\0\0\0\x08\0\x08\0\3", 26) +
                              "\xcc" + QByteArray(95, '\2'));
  add("what crashes a library", "hogels.psd", "…");
  writeFile("directions_large.csv", QByteArray((64 << 20) + 1, '\n'));
  add("a long table", "directions_large.csv", "is larger than 64 MiB: not a document of ours");
}

void TestTwinMaps::badFiles() {
  QFETCH(QString, file);
  QFETCH(QByteArray, line);
  compareLine(errorWith(file.toStdString()), line);
}

void TestTwinMaps::cancelling() {
  writePlanes("hogels.exr", 4, 3, {{"gap", std::vector<float>(12)}});
  writePlanes("height.exr", 1, 1, {{"height", {0}}});
  TwinMapFiles files = filesOf("hogels.exr");
  files.height = "height.exr";
  int polls = 0;
  double last = -1;
  const auto count = [&](double done) {
    polls += done >= last && done <= 1 ? 1 : 1000;
    last = done;
    return true;
  };
  (void)readTwinMaps(files, designOf(), count);
  QVERIFY(polls >= 2 && polls < 1000);
  for (int stop = 0; stop < polls; ++stop) {
    int poll = 0;
    QVERIFY_EXCEPTION_THROWN(
        (void)readTwinMaps(files, designOf(), [&](double) { return poll++ < stop; }), Cancelled);
  }
}

QTEST_APPLESS_MAIN(TestTwinMaps)
#include "test_twin_maps.moc"
