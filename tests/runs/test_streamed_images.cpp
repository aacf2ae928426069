// SPDX-License-Identifier: BSD-3-Clause
// Images of a light field that is read from the top: the same pixels, each row read once, in the
// memory that was allowed.
#include "io/scene/view_source.h"
#include "runs/state_images.h"

#include <QTemporaryDir>
#include <QTest>

#include "io/documents/session_file.h"
#include "tests/core/rendered.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

/// Counts what is read of a real file.
class CountedFile : public LightFieldFile {
 public:
  explicit CountedFile(std::unique_ptr<LightFieldFile> file) : m_file(std::move(file)) {}

  [[nodiscard]] StoredType type() const override { return m_file->type(); }
  [[nodiscard]] LightFieldSize size() const override { return m_file->size(); }
  [[nodiscard]] std::vector<std::filesystem::path> files() const override {
    return m_file->files();
  }
  [[nodiscard]] LightField read(const Progress& progress) override {
    return m_file->read(progress);
  }
  [[nodiscard]] bool isStream() const override { return m_file->isStream(); }
  void stream(const HogelRow& row, const Progress& progress) override {
    m_file->stream(
        [&](int j, int v, const StoredRows& rgb) {
          ++rows;
          row(j, v, rgb);
        },
        progress);
  }

  int rows = 0;

 private:
  std::unique_ptr<LightFieldFile> m_file;
};

/// 20×24 hogels of 9×8.
Session sessionOf(const QByteArray& file, const QByteArray& more = {}) {
  writeFile("s.json", R"({"hogelscope": 1, "display": {"hogels": [20, 24], "directions": [9, 8],
    "size": [0.4, 0.4], "fov": [60, 60]}, "lightField": {"file": ")" +
                          file + "\"" + more + R"(}, "cameras": [
    {"name": "a", "eye": [0, 0, 0.8], "fov": 50, "res": [150, 120]},
    {"name": "b", "eye": [0.1, 0.05, 0.7], "up": [0.7, 0.7, 0], "fov": 40, "res": [60, 200],
     "psf": {"sigma": 0.7, "windowSize": 5}},
    {"name": "c", "eye": [0, 0.1, 0.6], "fov": 50, "res": [150, 120],
     "distortion": {"k1": 0.2}, "psf": {"sigma": 0.7, "windowSize": 3}},
    {"name": "looks nowhere"},
    {"name": "behind", "eye": [0, 0, -1], "res": [50, 50]}]})");
  Session session = loadSession("s.json");
  session.cameras[3].camera.lookat = session.cameras[3].camera.eye;  // files are not let do that
  return session;
}

std::vector<RenderJob> viewsOf(const Session& session, const ViewSource& scene) {
  std::vector<RenderJob> views;
  for (const CameraState& state : session.cameras) views.push_back(scene.job(state));
  return views;
}

float noise(int x, int y, int channel) {
  const auto mixed = std::uint32_t(x * 7919 + y * 104729 + channel * 1299709) * 2654435761U;
  return float((mixed ^ mixed >> 13U) % 251U) / 250.0F;
}

constexpr std::size_t plenty = std::size_t{1} << 30;

}  // namespace

class TestStreamedImages : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void sameImages_data();
  void sameImages();
  void readOnce();
  void readTwiceWhereMemoryIsShort();
  void tooLittleForOneView();
  void tooManyPictures();
  void onlyLargeStreamsPass();
  void damagedRow();
  void stops();

 private:
  QTemporaryDir m_folder;
};

void TestStreamedImages::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  for (const char* name : {"bytes.png", "bytes.tif", "bytes.jpg"})
    writeImageFile(name, 180, 192, noise, PictureKind{});
  writeImageFile("words.png", 180, 192, noise, {PictureType::UInt16});
  writeImageFile("reals.exr", 180, 192, noise, {PictureType::Float});
}

void TestStreamedImages::sameImages_data() {
  QTest::addColumn<QByteArray>("file");
  QTest::addColumn<QByteArray>("more");
  for (const char* name : {"bytes.png", "bytes.tif", "bytes.jpg", "words.png", "reals.exr"})
    QTest::newRow(name) << QByteArray(name) << QByteArray();
  QTest::newRow("incoming") << QByteArray("bytes.png") << QByteArray(", \"incoming\": true");
  QTest::newRow("incoming words") << QByteArray("words.png") << QByteArray(", \"incoming\": true");
}

void TestStreamedImages::sameImages() {
  QFETCH(QByteArray, file);
  QFETCH(QByteArray, more);
  const Session session = sessionOf(file, more);
  const auto input = openLightField(session.lightField, session.display);
  const auto made = renderStreamed(*input, viewsOf(session, unloadedViewSource(session, *input)),
                                   plenty, serialRows, {});
  const std::vector<RenderJob> views = viewsOf(session, loadViewSource(session, {}));
  QCOMPARE(made.size(), views.size());
  for (const std::size_t k : {0U, 1U, 2U, 4U}) {
    QCOMPARE(QString::fromStdString(made[k].problem), QString());
    QVERIFY(made[k].image == rendered(views[k]));
  }
  QVERIFY(made[3].problem.find("eye") != std::string::npos);
}

void TestStreamedImages::readOnce() {
  const Session session = sessionOf("bytes.png");
  CountedFile file(openLightField(session.lightField, session.display));
  const std::vector<RenderJob> views = viewsOf(session, unloadedViewSource(session, file));
  (void)renderStreamed(file, views, plenty, serialRows, {});
  QCOMPARE(file.rows, 192);
}

void TestStreamedImages::readTwiceWhereMemoryIsShort() {
  const Session session = sessionOf("bytes.png");
  CountedFile file(openLightField(session.lightField, session.display));
  const std::vector<RenderJob> views = viewsOf(session, unloadedViewSource(session, file));
  const auto whole = renderStreamed(file, views, plenty, serialRows, {});
  file.rows = 0;
  // The lens of "c" alone takes 150·120·16 = 288 000 bytes.
  const auto made = renderStreamed(file, views, 300000, serialRows, {});
  QCOMPARE(file.rows, 2 * 192);
  for (std::size_t k = 0; k < views.size(); ++k) QVERIFY(made[k].image == whole[k].image);
}

void TestStreamedImages::tooLittleForOneView() {
  const Session session = sessionOf("bytes.png");
  CountedFile file(openLightField(session.lightField, session.display));
  const auto made = renderStreamed(file, viewsOf(session, unloadedViewSource(session, file)),
                                   100000, serialRows, {});
  QVERIFY(made[0].problem.empty());
  QCOMPARE(QString::fromStdString(made[2].problem).left(33),
           QString("memory: a view needs 290.9 kB of "));
}

/// All are in memory until the last row has come: refused before the first is read.
void TestStreamedImages::tooManyPictures() {
  const Session session = sessionOf("bytes.png");
  CountedFile file(openLightField(session.lightField, session.display));
  RenderJob large = viewsOf(session, unloadedViewSource(session, file)).front();
  large.state.camera.res = {16384, 16384};
  const double most = double(machineMemory()) / (2.0 * Image::bytesPerPixel * 16384 * 16384);
  const std::vector<RenderJob> views(std::size_t(most) + 1, large);
  const QString error = errorOf([&] { (void)renderStreamed(file, views, plenty, serialRows, {}); });
  QVERIFY2(error.startsWith(QString("cameras: their %1 pictures need ").arg(views.size())) &&
               error.endsWith(": take fewer states, or pack the light field into a store"),
           qPrintable(error));
  QCOMPARE(file.rows, 0);
}

void TestStreamedImages::onlyLargeStreamsPass() {
  const Session session = sessionOf("bytes.png");
  const auto file = openLightField(session.lightField, session.display);
  const std::size_t bytes = LightField::bytes({20, 24, 9, 8}, StoredType::uint8);
  QVERIFY(!mustStream(*file, bytes));
  QVERIFY(mustStream(*file, bytes - 1));
  writeImageFile("lf_qs4x2a1.png", 40, 20, noise);
  QVERIFY(!mustStream(*openLightField(lightFieldOf("lf_qs4x2a1.png"), {}), 1));
}

void TestStreamedImages::damagedRow() {
  const QByteArray bytes = contentOf("bytes.png");
  writeFile("cut.png", bytes.left(bytes.size() * 3 / 4));
  const Session session = sessionOf("cut.png");
  const auto file = openLightField(session.lightField, session.display);
  try {
    (void)renderStreamed(*file, viewsOf(session, unloadedViewSource(session, *file)), plenty,
                         serialRows, {});
    QFAIL("a file that is cut was read");
  } catch (const InputError& error) {
    const QString line = error.what();
    QVERIFY2(line.startsWith("cut.png: row 1") && line.contains("is damaged"), qPrintable(line));
  }
}

void TestStreamedImages::stops() {
  const Session session = sessionOf("bytes.png");
  const auto file = openLightField(session.lightField, session.display);
  const auto tillHalf = [](double done) { return done < 0.5; };
  QVERIFY_THROWS_EXCEPTION(
      Cancelled, (void)renderStreamed(*file, viewsOf(session, unloadedViewSource(session, *file)),
                                      plenty, serialRows, tillHalf));
}

QTEST_APPLESS_MAIN(TestStreamedImages)
#include "test_streamed_images.moc"
