// SPDX-License-Identifier: BSD-3-Clause
// Tests exports: every layout reads back as the same light field, whatever its type.
#include "io/scene/light_field_export.h"

#include <QTemporaryDir>
#include <QTest>

#include "io/files/system_limits.h"
#include "io/scene/view_source.h"
#include "io/store/store_writer.h"
#include "tests/core/random.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

PanelParams displayOf(int du, int dv) {
  PanelParams display;
  display.hogels = {5, 4};
  display.directions = {du, dv};
  return display;
}

bool equal(const LightField& a, const LightField& b) {
  if (!(a.size() == b.size())) return false;
  const auto [nx, ny, du, dv] = a.size();
  for (int j = 0; j < ny; ++j)
    for (int v = 0; v < dv; ++v)
      for (int i = 0; i < nx; ++i)
        for (int u = 0; u < du; ++u)
          if (!(a.texel({i, j, u, v}) == b.texel({i, j, u, v}))) return false;
  return true;
}

}  // namespace

class TestLightFieldExport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { m_folder = std::make_unique<QTemporaryDir>(); }
  void readsBack_data();
  void readsBack();
  void quilts_data();
  void quilts();
  void quiltsThatCannotBe();
  void typesThatDoNotFit();
  void viewsAlone();
  void stops();

 private:
  [[nodiscard]] std::string path(const char* name) const {
    return m_folder->filePath(name).toStdString();
  }
  /// An image of hogels of noise.
  std::unique_ptr<LightFieldFile> noise(const PanelParams& display, PictureType type) {
    Random random(1);
    const QString file = m_folder->filePath(type == PictureType::Float ? "n.exr" : "n.png");
    writeImageFile(file, display.hogels[0] * display.directions[0],
                   display.hogels[1] * display.directions[1],
                   [&](int, int, int) { return float(random.uniform(0, 1)); }, {.type = type});
    LightFieldParams params;
    params.file = file.toStdString();
    return openLightField(params, display);
  }
  static std::unique_ptr<LightFieldFile> reopened(const std::string& file, Layout layout,
                                                  const PanelParams& display) {
    LightFieldParams params;
    params.file = file;
    params.layout = layout;
    return openLightField(params, display);
  }

  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestLightFieldExport::readsBack_data() {
  QTest::addColumn<int>("type");
  QTest::newRow("8 bits") << int(PictureType::UInt8);
  QTest::newRow("16 bits") << int(PictureType::UInt16);
  QTest::newRow("floats") << int(PictureType::Float);
}

void TestLightFieldExport::readsBack() {
  QFETCH(const int, type);
  const PanelParams display = displayOf(12, 3);
  const auto file = noise(display, PictureType(type));
  const LightField whole = file->read({});
  const bool isReal = type == int(PictureType::Float);

  const std::string hogels = path(isReal ? "h.exr" : "h.png");
  exportHogels(*file, hogels, {});
  QVERIFY(equal(reopened(hogels, Layout::hogels, display)->read({}), whole));
  QVERIFY(reopened(hogels, Layout::hogels, display)->type() == file->type());

  exportViews(*file, path("views"), {});
  const auto views = reopened(path("views"), Layout::views, display);
  QVERIFY(equal(views->read({}), whole));
  QVERIFY(views->type() == file->type());

  const std::string mosaic = path(isReal ? "m.exr" : "m.png");
  exportMosaic(*file, mosaic, {});
  QVERIFY(equal(reopened(mosaic, Layout::mosaic, display)->read({}), whole));
  QVERIFY(reopened(mosaic, Layout::mosaic, display)->type() == file->type());

  // From views to hogels, and over a store, whose rows do not come in order.
  exportHogels(*views, path(isReal ? "again.exr" : "again.png"), {});
  QVERIFY(
      equal(reopened(path(isReal ? "again.exr" : "again.png"), Layout::hogels, display)->read({}),
            whole));
  LightFieldParams params;
  params.file = path("views");
  params.layout = Layout::views;
  pack(*views, planPack(params, *views, display, allowedMemory()), path("p.tif"), 1, {});
  const auto store = reopened(path("p.tif"), Layout::pack, display);
  exportHogels(*store, path(isReal ? "s.exr" : "s.png"), {});
  QVERIFY(
      equal(reopened(path(isReal ? "s.exr" : "s.png"), Layout::hogels, display)->read({}), whole));
}

void TestLightFieldExport::quilts_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<int>("columns");
  QTest::newRow("by its name") << "q_qs4x3a0.8.png" << 4;
  QTest::newRow("about square") << "q.png" << 3;
}

void TestLightFieldExport::quilts() {
  QFETCH(const QString, name);
  QFETCH(const int, columns);
  const PanelParams display = displayOf(12, 1);
  const auto file = noise(display, PictureType::UInt8);
  const std::string quilt = path(qPrintable(name));
  QCOMPARE(quiltTilesFor(file->size(), quilt)[0], columns);
  exportQuilt(*file, quilt, {});
  LightFieldParams params;
  params.file = quilt;
  params.layout = Layout::quilt;
  params.quiltColumns = columns;
  params.quiltRows = 12 / columns;
  QVERIFY(equal(openLightField(params, display)->read({}), file->read({})));
}

void TestLightFieldExport::quiltsThatCannotBe() {
  const auto rows = noise(displayOf(4, 3), PictureType::UInt8);
  QVERIFY(errorOf([&] {
            (void)quiltTilesFor(rows->size(), path("q.png"));
          }).contains("display.directions: has 3 rows"));
  const auto one = noise(displayOf(12, 1), PictureType::UInt8);
  QVERIFY(errorOf([&] {
            (void)quiltTilesFor(one->size(), path("q_qs5x2a1.png"));
          }).contains("q_qs5x2a1.png: the name: says 10 views; there are 12 directions"));
}

/// No values are rounded in silence, and no file is left.
void TestLightFieldExport::typesThatDoNotFit() {
  const auto real = noise(displayOf(4, 3), PictureType::Float);
  QVERIFY(
      errorOf([&] { exportHogels(*real, path("h.png"), {}); }).contains("does not hold floats"));
  const auto deep = noise(displayOf(4, 3), PictureType::UInt16);
  QVERIFY(
      errorOf([&] { exportHogels(*deep, path("h.jpg"), {}); }).contains("does not hold 16 bits"));
  QVERIFY(errorOf([&] { exportHogels(*deep, path("h.xyz"), {}); }).contains("h.xyz"));
  QCOMPARE(namesIn(m_folder->path()), (QStringList{"n.exr", "n.png"}));
}

/// Other images in the folder would be taken for views.
void TestLightFieldExport::viewsAlone() {
  const auto file = noise(displayOf(4, 3), PictureType::UInt8);
  writeFile(m_folder->filePath("v/003_000.png"), "x");
  QVERIFY(errorOf([&] { exportViews(*file, path("v"), {}); }).contains("choose an empty folder"));
  QCOMPARE(namesIn(m_folder->filePath("v")), QStringList("003_000.png"));
  exportViews(*file, path("w"), {});
  exportViews(*file, path("w"), {});  // its own are replaced
  QCOMPARE(namesIn(m_folder->filePath("w")).size(), 12);
}

void TestLightFieldExport::stops() {
  const auto file = noise(displayOf(12, 1), PictureType::UInt8);
  const Progress stop = [](double) { return false; };
  QVERIFY_THROWS_EXCEPTION(Cancelled, exportHogels(*file, path("h.png"), stop));
  QVERIFY_THROWS_EXCEPTION(Cancelled, exportQuilt(*file, path("q.png"), stop));
  QVERIFY_THROWS_EXCEPTION(Cancelled, exportMosaic(*file, path("m.png"), stop));
  QVERIFY_THROWS_EXCEPTION(Cancelled, exportViews(*file, path("v"), stop));
  QVERIFY(!QFile::exists(m_folder->filePath("h.png")) &&
          !QFile::exists(m_folder->filePath("q.png")) &&
          !QFile::exists(m_folder->filePath("m.png")));
}

QTEST_APPLESS_MAIN(TestLightFieldExport)
#include "test_light_field_export.moc"
