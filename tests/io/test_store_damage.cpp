// SPDX-License-Identifier: BSD-3-Clause
// Tests that a damaged, incomplete or strange store is refused with its name and the place, and
// that packing goes on after whatever stopped it.
#include <QTemporaryDir>
#include <QTest>
#include <cstring>
#include <limits>

#include "core/base/error.h"
#include "io/scene/view_source.h"
#include "io/store/light_field_store.h"
#include "io/store/store_writer.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"
#include "tests/io/texels.h"

using namespace hogelscope;

namespace {

constexpr std::size_t plenty = std::size_t{1} << 30;
constexpr LightFieldSize size{20, 40, 17, 18};

PanelParams display() {
  PanelParams params;
  params.hogels = {size.nx, size.ny};
  params.directions = {size.du, size.dv};
  return params;
}

LightFieldParams source() {
  LightFieldParams params;
  params.file = "a.png";
  return params;
}

void packTo(const std::string& output, const Progress& progress = {}) {
  const auto file = openLightField(source(), display());
  pack(*file, planPack(source(), *file, {}, plenty), output, 2, progress);
}

/// Stops packing after `rows` calls of its progress.
void packUntil(const std::string& output, int rows) {
  int calls = 0;
  try {
    packTo(output, [&](double) { return ++calls < rows; });
  } catch (const Cancelled&) {
  }
}

/// Of all pages of the file, whole or not.
int pagesOf(const char* file) {
  const RandomAccessFile opened(file);
  int pages = 0;
  for (TiffLink link = firstLink(opened); link.next != 0; ++pages)
    link = readPage(opened, link.next).link;
  return pages;
}

}  // namespace

class TestStoreDamage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void flippedBitsAreFound();
  void everyTruncationIsRefused();
  void strangeFiles_data();
  void strangeFiles();
  void aCircleOfPagesIsRefused();
  void strangeDescriptions_data();
  void strangeDescriptions();
  void hugeDescriptions();
  void deepDescriptions();
  void anyFlippedByteIsSurvived();
  void stoppedPackGoesOn_data();
  void stoppedPackGoesOn();
  void anotherSourceBeginsAnew();
  void unfinishedOneIsNoStore();
  void otherFilesAreKept();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
  QByteArray m_bytes;  ///< of a whole store
};

void TestStoreDamage::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeImageFile("a.png", int(size.width()), int(size.height()), [](int x, int y, int c) {
    return float((x * 7 + y * 13 + x * y / 3 + 50 * c) % 256) / 255;
  });
  packTo("store.tif");
  m_bytes = contentOf("store.tif");
}

void TestStoreDamage::flippedBitsAreFound() {
  const RandomAccessFile file("store.tif");
  const TiffPage page = readPage(file, firstLink(file).next).page;
  std::uint64_t at = 0;
  std::memcpy(&at, m_bytes.constData() + page.offsetsAt + 8, sizeof(at));
  for (const int further : {0, 5, 100, 1000, 4000}) {
    QByteArray damaged = m_bytes;
    damaged[qsizetype(at) + further] = char(damaged[qsizetype(at) + further] ^ 4);
    writeFile("damaged.tif", damaged);
    LightFieldStore store("damaged.tif");  // the index is whole
    const QString error = errorOf([&] { (void)store.read({}); });
    QVERIFY2(error.startsWith("damaged.tif: page 0, tile (1, 0): is damaged: "), qPrintable(error));
  }
}

void TestStoreDamage::everyTruncationIsRefused() {
  for (qsizetype bytes = 0; bytes < m_bytes.size(); bytes += 1 + bytes / 37) {
    writeFile("short.tif", m_bytes.left(bytes));
    const QString error = errorOf([] { LightFieldStore store("short.tif"); });
    QVERIFY2(error.startsWith("short.tif: "), qPrintable(QString::number(bytes) + error));
  }
}

void TestStoreDamage::strangeFiles_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<QString>("line");
  QTest::newRow("nothing") << QByteArray() << "s.tif: is not a Hogelscope store";
  QTest::newRow("text") << QByteArray("hello") << "s.tif: is not a Hogelscope store";
  QTest::newRow("header only") << QByteArray("II\x2b\0\x08\0\0\0\0\0\0\0\0\0\0\0", 16)
                               << "s.tif: is not a Hogelscope store";
  QTest::newRow("a far page") << QByteArray("II\x2b\0\x08\0\0\0\xff\xff\xff\xff\xff\xff\xff\x7f",
                                            16)
                              << "s.tif: is damaged: it ends too early";
}

void TestStoreDamage::strangeFiles() {
  QFETCH(QByteArray, content);
  QFETCH(QString, line);
  writeFile("s.tif", content);
  QCOMPARE(errorOf([] { LightFieldStore store("s.tif"); }), line);
  QVERIFY(!LightFieldStore::isStore("s.tif"));
}

/// Neither a reader nor a pack that goes on follows it for ever.
void TestStoreDamage::aCircleOfPagesIsRefused() {
  writeFile("s.tif", m_bytes);
  QByteArray changed = m_bytes;
  {
    const RandomAccessFile file("s.tif");
    const std::uint64_t first = firstLink(file).next;
    const TiffLink link = readPage(file, first).link;
    std::memcpy(changed.data() + link.nextAt, &first, sizeof(first));
  }
  writeFile("s.tif", changed);
  const QString error = errorOf([] { LightFieldStore store("s.tif"); });
  QCOMPARE(error, "s.tif: is damaged: a page of it is not a store's");
  writeFile("again.tif.part", changed);  // nor does a run go on with it, or delete it
  QCOMPARE(errorOf([] { packTo("again.tif"); }),
           "again.tif.part: cannot be written: it is there, and is not an unfinished store: move "
           "it away");
  QVERIFY(contentOf("again.tif.part") == changed);
}

void TestStoreDamage::strangeDescriptions_data() {
  QTest::addColumn<QByteArray>("from");
  QTest::addColumn<QByteArray>("to");
  QTest::newRow("another program's")
      << QByteArray("hogelscope-store") << QByteArray("hogelscope-other");
  QTest::newRow("a later version") << QByteArray("store\":1") << QByteArray("store\":2");
  QTest::newRow("no JSON") << QByteArray("\"size\":") << QByteArray("\"size\" ");
  QTest::newRow("a missing key") << QByteArray("\"size\"") << QByteArray("\"sise\"");
  QTest::newRow("another size") << QByteArray("[20,40,") << QByteArray("[20,90,");
  QTest::newRow("no cells") << QByteArray("[20,40,") << QByteArray("[00,40,");
  QTest::newRow("negative") << QByteArray("[20,40,") << QByteArray("[-1,40,");
  QTest::newRow("another block") << QByteArray("[8,8,8,8]") << QByteArray("[8,7,8,8]");
  QTest::newRow("a block of none") << QByteArray("[8,8,8,8]") << QByteArray("[8,0,8,8]");
  QTest::newRow("another type") << QByteArray("uint8") << QByteArray("float");
  QTest::newRow("an unknown type") << QByteArray("uint8") << QByteArray("uint9");
}

void TestStoreDamage::strangeDescriptions() {
  QFETCH(QByteArray, from);
  QFETCH(QByteArray, to);
  QCOMPARE(m_bytes.count(from), 1);
  QByteArray changed = m_bytes;
  writeFile("s.tif", changed.replace(from, to));
  const QString error = errorOf([] { LightFieldStore store("s.tif"); });
  QVERIFY2(error.startsWith("s.tif: "), qPrintable(error));
}

/// Numbers that fit no file that we could make here.
void TestStoreDamage::hugeDescriptions() {
  StoreHeader header;
  header.size = {5000, 5000, 10, 10};
  header.block = {8, 8, 8, 8};
  header.overview = header.size;
  const auto parsed = [&] { (void)parseStoreHeader(textOf(header)); };
  QCOMPARE(errorOf(parsed), QString("is damaged: its description's overview: is too large"));
  header.overview = {5000, 8, 10, 10};
  QCOMPARE(errorOf(parsed), QString());
  constexpr int huge = std::numeric_limits<int>::max();
  header.block = {64, 8, huge, 8};
  QCOMPARE(errorOf(parsed), QString("is damaged: its description's block: is out of range"));
}

void TestStoreDamage::deepDescriptions() {
  const std::string open(500000, '[');
  const std::string closed(500000, ']');
  const std::string description = "{\"hogelscope-store\":" + open + closed + "}";
  QCOMPARE(errorOf([&] { (void)parseStoreHeader(description); }),
           QString("is damaged: its description cannot be read"));
}

/// Wherever the byte is: the same texels, other texels or an error, but an end in good order.
void TestStoreDamage::anyFlippedByteIsSurvived() {
  const qsizetype tail = 3000;  // the last page: its index, its directory
  for (qsizetype k = 0; k < tail; k += 3) {
    QByteArray changed = m_bytes;
    const qsizetype at = k < 600 ? k : m_bytes.size() - tail + k;
    changed[at] = char(changed[at] ^ (k % 2 == 0 ? 0x80 : 0x01));
    writeFile("s.tif", changed);
    (void)errorOf([] {
      const LightFieldStore store("s.tif");
      (void)store.overview();
    });
  }
}

void TestStoreDamage::stoppedPackGoesOn_data() {
  QTest::addColumn<int>("rows");
  QTest::newRow("at once") << 1;
  QTest::newRow("in the first page") << 40;
  QTest::newRow("later") << 500;
  QTest::newRow("near the end") << 715;
}

void TestStoreDamage::stoppedPackGoesOn() {
  QFETCH(int, rows);
  packUntil("again.tif", rows);
  QVERIFY(QFileInfo::exists("again.tif.part"));
  QVERIFY(!QFileInfo::exists("again.tif"));
  // What is after the last complete page is of no use, whatever it is.
  QFile part("again.tif.part");
  QVERIFY(part.open(QIODevice::Append));
  part.write("half a page");
  part.close();
  const int pages = pagesOf("again.tif.part");
  const qint64 inode = part.size();
  packTo("again.tif");
  QCOMPARE(contentOf("again.tif"), m_bytes);
  QVERIFY(!QFileInfo::exists("again.tif.part"));
  if (rows > 400) QVERIFY2(pages > 0 && inode > 0, "nothing was kept");
}

void TestStoreDamage::anotherSourceBeginsAnew() {
  packUntil("again.tif", 600);
  QVERIFY(pagesOf("again.tif.part") > 0);
  writeImageFile("a.png", int(size.width()), int(size.height()),
                 [](int x, int y, int) { return float((x + y) % 200) / 255; });
  packTo("again.tif");
  LightFieldStore store("again.tif");
  QCOMPARE(firstWrong(store.read({}),
                      [](const TexelIndex& at) {
                        const double sum = (at.i * 17 + at.u + at.j * 18 + at.v) % 200;
                        return Rgb{sum, sum, sum};
                      }),
           QString());
}

void TestStoreDamage::unfinishedOneIsNoStore() {
  packUntil("again.tif", 600);
  const QString error = errorOf([] { LightFieldStore store("again.tif.part"); });
  QVERIFY2(error.startsWith("again.tif.part: is not complete: it has "), qPrintable(error));
}

void TestStoreDamage::otherFilesAreKept() {
  writeFile("again.tif.part", "somebody's thesis");
  QCOMPARE(errorOf([] { packTo("again.tif"); }),
           "again.tif.part: cannot be written: it is there, and was not written by hogelscope: "
           "move it away");
  QCOMPARE(contentOf("again.tif.part"), QByteArray("somebody's thesis"));
  QDir().mkdir("folder");
  QCOMPARE(errorOf([] { packTo("folder"); }),
           "folder: cannot be written: it is there, and is not a file");
}

QTEST_APPLESS_MAIN(TestStoreDamage)
#include "test_store_damage.moc"
