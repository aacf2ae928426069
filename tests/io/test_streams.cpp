// SPDX-License-Identifier: BSD-3-Clause
// Tests that light fields of all layouts are told row of hogels by row of hogels, whatever memory
// there is for it.
#include <QTemporaryDir>

#include "io/scene/view_source.h"
#include "io/store/light_field_store.h"
#include "io/store/store_writer.h"
#include "tests/io/any_images.h"
#include "tests/io/light_fields.h"

using namespace hogelscope;

namespace {

constexpr LightFieldSize size{10, 21, 11, 9};

void writeHogels() {
  writeImageFile("a.png", int(size.width()), int(size.height()), hogelImage(size));
}

void writeStore() {
  writeHogels();
  const auto file = openLightField(paramsOf("a.png"), displayOf(size));
  pack(*file, planPack(paramsOf("a.png"), *file, {}, allowedMemory()), "store.tif", 2, {});
}

void writeViews() {
  for (int v = 0; v < size.dv; ++v)
    for (int u = 0; u < size.du; ++u)
      writeImageFile(QString("views/%1_%2.png").arg(v, 3, 10, QChar('0')).arg(u, 3, 10, QChar('0')),
                     size.nx, size.ny, [&](int x, int y, int c) {
                       return valueAt({x, y, u, v}, c);
                     });
}

/// Each reader has its own way back to the top.
void writeQuilts() {
  const auto write = [](const char* file, PictureType type) {
    writeImageFile(file, size.nx * size.du, size.ny * size.dv,
                   [](int x, int y, int c) {
                     return valueAt({x % size.nx, y % size.ny, x / size.nx, y / size.ny}, c);
                   },
                   {type});
  };
  write("a_qs11x9a1.png", PictureType::UInt8);
  write("b_qs11x9a1.png", PictureType::UInt16);
  write("c_qs11x9a1.jpg", PictureType::UInt8);
  write("d_qs11x9a1.tif", PictureType::UInt16);
  write("e_qs11x9a1.exr", PictureType::Float);
}

}  // namespace

class TestStreams : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void cleanup() { allowMemory(0); }
  void anyMemory_data();
  void anyMemory();
  void viewsAreReadOnceForEachBand();

 private:
  QTemporaryDir m_folder;
};

void TestStreams::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  writeStore();
  writeViews();
  writeQuilts();
}

void TestStreams::anyMemory_data() {
  QTest::addColumn<LightFieldParams>("params");
  QTest::addColumn<std::size_t>("memory");
  LightFieldParams sheared = paramsOf("views", Layout::views);
  sheared.shear = {1.2, -0.7};
  LightFieldParams turned = paramsOf("views", Layout::views, true);
  turned.rows = RowOrder::bottomUp;
  LightFieldParams mosaic = paramsOf("a_qs11x9a1.png", Layout::mosaic, true);
  mosaic.shear = {1.2, -0.7};
  const std::vector<std::pair<const char*, LightFieldParams>> all{
      {"hogels", paramsOf("a.png")},
      {"hogels, incoming", paramsOf("a.png", Layout::hogels, true)},
      {"store", paramsOf("store.tif", Layout::pack)},
      {"store, incoming", paramsOf("store.tif", Layout::pack, true)},
      {"views", paramsOf("views", Layout::views)},
      {"views, sheared", sheared},
      {"views, incoming, bottom up", turned},
      {"quilt, PNG", paramsOf("a_qs11x9a1.png", Layout::quilt)},
      {"quilt, PNG of 16 bits", paramsOf("b_qs11x9a1.png", Layout::quilt)},
      {"quilt, JPEG", paramsOf("c_qs11x9a1.jpg", Layout::quilt)},
      {"quilt, TIFF", paramsOf("d_qs11x9a1.tif", Layout::quilt)},
      {"quilt, EXR", paramsOf("e_qs11x9a1.exr", Layout::quilt)},
      {"mosaic, sheared, incoming", mosaic}};
  const std::size_t hogelRow = 4 * size.width() * std::size_t(size.dv);
  for (const auto& [name, params] : all)
    for (const std::size_t rows : {1U, 3U, 8U, 20U, 100U})
      QTest::addRow("%s, %d rows", name, int(rows)) << params << 2 * rows * hogelRow;
  QTest::newRow("views, too little for a row") << all[4].second << std::size_t{1};
  QTest::newRow("store, too little for a row") << all[2].second << std::size_t{1};
}

void TestStreams::anyMemory() {
  QFETCH(LightFieldParams, params);
  QFETCH(std::size_t, memory);
  const auto file =
      openLightField(params, params.layout == Layout::quilt ? PanelParams{} : displayOf(size));
  const LightField whole = file->read({});
  allowMemory(memory);
  QCOMPARE(firstDifference(streamed(*file), whole), QString());
}

/// Returns how many bytes this process has read.
qint64 bytesRead() {
  QFile file("/proc/self/io");
  if (!file.open(QIODevice::ReadOnly)) return 0;
  return file.readAll().split('\n').front().split(' ').last().toLongLong();
}

/// 21 rows in bands of 8: three times all views. The share done never falls.
void TestStreams::viewsAreReadOnceForEachBand() {
  const auto file = openLightField(paramsOf("views", Layout::views), {});
  qint64 bytes = 0;
  for (const auto& view : file->files()) bytes += qint64(std::filesystem::file_size(view));
  allowMemory(std::size_t{2} * 8 * 4 * size.width() * std::size_t(size.dv));
  double last = 0;
  const qint64 before = bytesRead();
  file->stream([](int, int, const StoredRows&) {},
               [&](double done) {
                 const bool isOn = done >= last;
                 last = done;
                 return isOn;
               });
  const qint64 read = bytesRead() - before;
  QVERIFY(last > 0.9);
  QVERIFY2(read >= 3 * bytes && read < 10 * bytes,
           qPrintable(QString("%1 of %2").arg(read).arg(bytes)));
}

QTEST_APPLESS_MAIN(TestStreams)
#include "test_streams.moc"
