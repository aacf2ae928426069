// SPDX-License-Identifier: BSD-3-Clause
// Tests what hostile files cannot do: libraries that crash, hang or take all memory end a process
// of their own; a file's content says what it is; a list of files is no video.
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <opencv2/videoio.hpp>
#include <thread>

#include "io/files/isolated.h"
#include "io/images/image_file.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

const QString ended =
    "a: is damaged: the library that reads it crashed, hung, or wanted too much memory";

/// Answers `request`, or does as it says.
std::string answer(const std::string& request) {
  if (request == "crash") std::abort();
  if (request == "divide") (void)::raise(SIGFPE);
  if (request == "hang")
    for (volatile bool isHanging = true; isHanging;) {
    }
  if (request == "grow") {
    std::vector<std::string> all;
    for (;;) all.emplace_back(std::size_t{1} << 26U, 'x');
  }
  if (request == "refuse") throw InputError("is wrong", "mend it");
  if (request == "name") throw InputError("a", "is wrong", "mend it");
  return request + "!";
}

QString errorAfter(Isolated& process, const char* request) {
  return errorOf([&] { (void)process.ask(request); });
}

/// The picture's values, or why there are none.
QString read(const char* file) {
  return errorOf([file] {
    ImageFile image((std::filesystem::path(file)));
    image.read(image.type(), [](std::size_t, std::size_t, const StoredRows&) {}, {});
  });
}

/// The fields of a DDS of 8×8 pixels, as Microsoft documents them.
QByteArray dds(std::uint32_t formatFlags, const char* fourCc) {
  std::array<std::uint32_t, 31> header{124, 0x1007, 8, 8, 64, 0, 1};
  header[18] = 32;  // bytes of the pixel format
  header[19] = formatFlags;
  std::memcpy(&header[20], fourCc, 4);
  header[22] = 0xff;
  header[23] = 0xff00;
  header[24] = 0xff0000;
  header[26] = 0x1000;
  return "DDS " + QByteArray(reinterpret_cast<const char*>(header.data()), sizeof header) +
         QByteArray(110, 'U');
}

}  // namespace

class TestIsolated : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(m_folder.path())); }
  void answersAndEnds();
  void hostilePictures_data();
  void hostilePictures();
  void contentSaysWhatItIs();
  void listsOfFiles_data();
  void listsOfFiles();
  void manyThreads();

 private:
  QTemporaryDir m_folder;
};

/// After each end the next request finds a new process.
void TestIsolated::answersAndEnds() {
  Isolated process("a", [] { return answer; });
  QCOMPARE(process.ask("one"), std::string("one!"));
  QCOMPARE(errorAfter(process, "crash"), ended);
  QCOMPARE(errorAfter(process, "divide"), ended);
  QCOMPARE(process.ask("two"), std::string("two!"));
  QCOMPARE(errorAfter(process, "hang"), ended);
  QCOMPARE(errorAfter(process, "refuse"), QString("a: is wrong: mend it"));
  QCOMPARE(errorAfter(process, "name"), QString("a: is wrong: mend it"));
  // A sanitizer's allocator has its own way of running out of memory: it ends the process.
  const QString grown = errorAfter(process, "grow");
  QVERIFY2(grown == "a: not enough memory" || grown == ended, qPrintable(grown));
  QCOMPARE(process.ask(std::string(1 << 20, 'x')).size(), std::size_t((1 << 20) + 1));
}

void TestIsolated::hostilePictures_data() {
  QTest::addColumn<QByteArray>("content");
  // With these OpenImageIO 2.4 divides by zero, writes beyond an array, and asks for 3.5 GB.
  QTest::newRow("premultiplied DXT2") << dds(4, "DXT2");
  QByteArray psd("8BPS\0\1\0\0\0\0\0\0\0\3\0\0\0\x08\0\0\0\x08\0\x08\0\3", 26);
  QTest::newRow("a PSD's long colour table") << psd + "\xcc" + QByteArray(95, '\2');
  QTest::newRow("a DDS's header") << dds(4, "DXT5").left(128);
  QTest::newRow("noise") << QByteArray("RIFF\xff\xff\xff\x7fWEBPVP8 ") + QByteArray(900, '\x9d');
}

/// The test's own process lives on, whatever the library of this machine makes of it.
void TestIsolated::hostilePictures() {
  QFETCH(QByteArray, content);
  for (const char* name : {"a.dds", "a.psd", "a.webp", "a.jpg", "a"}) {
    writeFile(name, content);
    const QString error = read(name);
    QVERIFY2(error.isEmpty() || (error.startsWith(QString(name) + ": ") && !error.contains('\n')),
             qPrintable(error));
  }
}

void TestIsolated::contentSaysWhatItIs() {
  const auto value = [](int x, int y, int) { return float(x + y) / 20; };
  for (const char* ending : {"png", "jpg", "tif", "webp", "bmp", "ppm", "tga"}) {
    writeImageFile(QString("right.") + ending, 8, 6, value, {});
    for (const char* other : {"png", "jpg", "tif", "exr", "dds", "mp4", "xyz"}) {
      const QString wrong = QString("wrong.") + other;
      writeFile(wrong, contentOf(QString("right.") + ending));
      const ImageFile image(std::filesystem::path(wrong.toStdString()));
      QCOMPARE(image.width(), std::size_t(8));
      QCOMPARE(image.format(),
               ImageFile(std::filesystem::path("right." + std::string(ending))).format());
    }
  }
}

void TestIsolated::listsOfFiles_data() {
  QTest::addColumn<QByteArray>("list");
  QTest::newRow("ffconcat") << QByteArray("ffconcat version 1.0\nfile 'a.avi'\n");
  QTest::newRow("HLS") << QByteArray(
      "#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\na.avi\n"
      "#EXT-X-ENDLIST\n");
  QTest::newRow("DASH") << QByteArray(
      "<?xml version=\"1.0\"?>\n<MPD xmlns=\"urn:mpeg:dash:schema:mpd:2011\" type=\"static\">"
      "<Period><AdaptationSet><Representation><BaseURL>a.avi</BaseURL></Representation>"
      "</AdaptationSet></Period></MPD>\n");
  QTest::newRow("SDP") << QByteArray(
      "v=0\no=- 0 0 IN IP4 127.0.0.1\nc=IN IP4 127.0.0.1\n"
      "m=video 9 RTP/AVP 96\n");
}

/// FFmpeg would read what they name.
void TestIsolated::listsOfFiles() {
  QFETCH(QByteArray, list);
  {
    cv::VideoWriter video("a.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 25, {16, 16});
    for (int frame = 0; frame < 4; ++frame)
      video.write(cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(60 * frame)));
  }
  QCOMPARE(ImageFile(std::filesystem::path("a.avi")).frames(), std::size_t(4));
  for (const char* name : {"list.mp4", "list.avi", "list.m3u8", "list"}) {
    writeFile(name, list);
    QCOMPARE(read(name),
             QString(name) + ": cannot be read as a picture: its content is of no known format");
  }
}

/// A copy of the process is made while other threads are inside the same library.
void TestIsolated::manyThreads() {
  const auto value = [](int x, int y, int) { return float(x + y) / 20; };
  writeImageFile("a.jpg", 64, 48, value, {});
  writeImageFile("a.tga", 64, 48, value, {});
  std::atomic<int> failed = 0;
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < 6; ++k)
      threads.emplace_back([k, &failed] {
        for (int time = 0; time < 25; ++time)
          failed += read(k % 2 == 0 ? "a.jpg" : "a.tga").isEmpty() ? 0 : 1;
      });
  }
  QCOMPARE(failed.load(), 0);
}

QTEST_APPLESS_MAIN(TestIsolated)
#include "test_isolated.moc"
