// SPDX-License-Identifier: BSD-3-Clause
// Tests what captures say of their cameras: the display that stands for them, and that a camera at
// the place of a view sees that view's file.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "io/documents/session_file.h"
#include "io/opening/capture_geometry.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "tests/core/random.h"
#include "tests/core/rendered.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

namespace {

constexpr int columns = 3;
constexpr int rows = 3;
constexpr int width = 24;
constexpr int height = 18;

/// Cameras 50 mm apart, in focus at 2 m, that see 0.7 m of it.
const QByteArray hci =
    "[intrinsics]\nfocal_length_mm = 100.0\nimage_resolution_x_px = 24\nsensor_size_mm = 35.0\n"
    "# a comment\n[extrinsics]\nbaseline_mm = 50.0\nfocus_distance_m = 2\n";

/// The value of a channel of view (u, v) at a pixel.
int codeAt(int view, int x, int y, int c) {
  return (view * 61 + x * 17 + y * 29 + c * 83 + x * y * 7) % 256;
}

QString pathOf(int view) {
  return QString("hci/input_Cam%1.png").arg(view, 3, 10, QChar('0'));
}

}  // namespace

class TestCaptureGeometry : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void displayOfHci();
  void aCameraSeesItsFile();
  void namesOfTheRenderer();
  void mistakes_data();
  void mistakes();
  void withoutIt();
  void shop();

 private:
  QTemporaryDir m_folder;
};

void TestCaptureGeometry::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  QVERIFY(QDir().mkpath("hci"));
  for (int view = 0; view < columns * rows; ++view)
    writeImageFile(pathOf(view), width, height,
                   [&](int x, int y, int c) { return float(codeAt(view, x, y, c)) / 255; });
  writeFile("hci/parameters.cfg", hci);
}

void TestCaptureGeometry::displayOfHci() {
  const Session session = sessionAround("hci");
  QVERIFY(std::abs(session.display.size[0] - 0.7) < 1e-12);
  QVERIFY(std::abs(session.display.size[1] - 0.7 * 18 / 24) < 1e-12);
  QCOMPARE(session.lightField.viewingDistance, 2.0);
  QCOMPARE(session.lightField.shear, (std::array<double, 2>{0, 0}));
  const double fov = 2 * std::atan(3 * 0.05 / (2 * 2)) * 180 / 3.14159265358979323846;
  QVERIFY(std::abs(session.display.fov[0] - fov) < 1e-6);
  QVERIFY(std::abs(session.display.fov[1] - fov) < 1e-6);
  // --set has the last word.
  QCOMPARE(sessionAround("hci", {"display.size=[1,1]"}).display.size[0], 1.0);
}

void TestCaptureGeometry::aCameraSeesItsFile() {
  const Session session = sessionAround("hci");
  const ViewSource scene = loadViewSource(session, {});
  for (int view = 0; view < columns * rows; ++view) {
    const double x = 0.05 * (view % columns - 1);
    const double y = -0.05 * (view / columns - 1);  // the first row is the top one
    CameraState state;
    state.camera.eye = {x, y, 2};
    state.camera.lookat = {x, y, 0};
    state.camera.res = {width, height};
    state.intrinsics.fx = state.intrinsics.fy = width * 2 / 0.7;
    state.intrinsics.cx = (width - 1) / 2.0 + width * x / 0.7;
    state.intrinsics.cy = (height - 1) / 2.0 - width * y / 0.7;
    const Image image = rendered(scene.job(state));
    for (int k = 0; k < width * height; ++k) {
      QCOMPARE(int(image.seen[std::size_t(k)]), 255);
      for (int c = 0; c < 3; ++c)
        QCOMPARE(int(image.rgb[std::size_t(3 * k + c)]), codeAt(view, k % width, k / width, c));
    }
  }
}

/// The views are parallel; the shear makes them coincide on the plane in focus.
void TestCaptureGeometry::namesOfTheRenderer() {
  QVERIFY(QDir().mkpath("lfr"));
  writeFile("lfr/config.cfg",
            "# property initial min max\nfocus-distance 8 3 50\nf-stop 0.4 0.1 2\n");
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column)
      writeImageFile(QString("lfr/Cam_0%1_0%2_%3_%4_30_36.png")
                         .arg(row)
                         .arg(column)
                         .arg(100 + 60 * row)
                         .arg(200 - 50 * column),
                     64, 32, [](int x, int y, int) { return float((x * y) % 7) / 7; });
  const Session session = sessionAround("lfr");
  const double panel = 36.0 / 30 * 8;
  QVERIFY(std::abs(session.display.size[0] - panel) < 1e-6);
  QVERIFY(std::abs(session.display.size[1] - panel / 2) < 1e-6);
  QCOMPARE(session.lightField.viewingDistance, 8.0);
  QVERIFY(std::abs(session.lightField.shear[0] - 0.05 / panel * 64) < 1e-6);
  QVERIFY2(std::abs(session.lightField.shear[1] - 0.06 / panel * 64) < 1e-6,
           qPrintable(QString::number(session.lightField.shear[1])));
}

void TestCaptureGeometry::mistakes_data() {
  QTest::addColumn<QByteArray>("value");
  QTest::newRow("word") << QByteArray("near");
  QTest::newRow("unit") << QByteArray("2m");
  QTest::newRow("zero") << QByteArray("0");
  QTest::newRow("negative") << QByteArray("-2");
  QTest::newRow("NaN") << QByteArray("nan");
  QTest::newRow("infinite") << QByteArray("1e999");
}

void TestCaptureGeometry::mistakes() {
  QFETCH(QByteArray, value);
  writeFile("hci/parameters.cfg",
            QByteArray(hci).replace("focus_distance_m = 2", "focus_distance_m = " + value));
  const QString error = errorOf([] { (void)sessionAround("hci"); });
  writeFile("hci/parameters.cfg", hci);
  QVERIFY2(error.startsWith("hci/parameters.cfg: focus_distance_m: is \"" + value + "\""),
           qPrintable(error));
}

void TestCaptureGeometry::withoutIt() {
  writeFile("hci/parameters.cfg", "[meta]\nscene = boxes\n");
  const Session session = sessionAround("hci");
  writeFile("hci/parameters.cfg", hci);
  QCOMPARE(session.lightField.viewingDistance, notGiven);
  QCOMPARE(session.display.size[0], 0.5);
}

/// A real capture: cameras 61.54 mm apart, 36 mm sensors, 30 mm lenses, in focus at 8.12 m.
void TestCaptureGeometry::shop() {
  const QString folder = HOGELSCOPE_SOURCE_DIR "/../shared/data/shop_13x13";
  if (!QDir(folder).exists()) QSKIP("the data of others is not here");
  const Session session = sessionAround(folder.toStdString());
  QVERIFY(std::abs(session.display.size[0] - 9.744) < 1e-6);
  QVERIFY(std::abs(session.lightField.shear[0] - 6.06) < 0.01);
  QVERIFY(std::abs(session.lightField.shear[1] - 6.06) < 0.01);
  QCOMPARE(session.lightField.viewingDistance, 8.12);
}

QTEST_GUILESS_MAIN(TestCaptureGeometry)
#include "test_capture_geometry.moc"
