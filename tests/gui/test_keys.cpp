// SPDX-License-Identifier: BSD-3-Clause
// Presses keys in the real window: they move the camera wherever the focus is, but not in fields.
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QUndoStack>

#include "core/optics/camera.h"
#include "gui/keys/key_map.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

class TestKeys : public WindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() { start(); }
  void cleanup() { m_window.reset(); }
  void eachMotionHasItsKey_data();
  void eachMotionHasItsKey();
  void whereverTheFocusIs();
  void notInFields();
  void afterReturn_data();
  void afterReturn();
  void aStrangePoseIsTold();
  void leakageSteps();
  void lensOffAndOn();
  void leakageOffAndOn();
  void statesByPage();
  void nothingIsOpen();

 private:
  Vec3 eye() const { return m_model->current().camera.eye; }
};

void TestKeys::eachMotionHasItsKey_data() {
  QTest::addColumn<int>("which");
  QTest::addColumn<int>("motion");
  QTest::addColumn<int>("sign");
  const auto row = [](const char* name, Qt::Key which, Motion motion, int sign) {
    QTest::newRow(name) << int(which) << int(motion) << sign;
  };
  row("Walk forward", Qt::Key_W, Motion::walk, 1);
  row("Walk backward", Qt::Key_S, Motion::walk, -1);
  row("Strafe left", Qt::Key_A, Motion::strafe, -1);
  row("Strafe right", Qt::Key_D, Motion::strafe, 1);
  row("Rise", Qt::Key_E, Motion::rise, 1);
  row("Sink", Qt::Key_Q, Motion::rise, -1);
  row("Turn left", Qt::Key_J, Motion::turn, -1);
  row("Turn right", Qt::Key_L, Motion::turn, 1);
  row("Tilt up", Qt::Key_I, Motion::tilt, 1);
  row("Tilt down", Qt::Key_K, Motion::tilt, -1);
  row("Roll left", Qt::Key_U, Motion::roll, -1);
  row("Roll right", Qt::Key_O, Motion::roll, 1);
  row("Orbit left", Qt::Key_F, Motion::orbitAcross, -1);
  row("Orbit right", Qt::Key_H, Motion::orbitAcross, 1);
  row("Orbit up", Qt::Key_T, Motion::orbitUp, 1);
  row("Orbit down", Qt::Key_G, Motion::orbitUp, -1);
}

void TestKeys::eachMotionHasItsKey() {
  QFETCH(int, which);
  QFETCH(int, motion);
  QFETCH(int, sign);
  const auto step = sign * stepOf(Motion(motion));
  CameraParams expected = m_model->current().camera;
  for (int k = 0; k < 3; ++k) {
    expected = moved(expected, Motion(motion), step);
    key(Qt::Key(which));
  }
  QVERIFY(m_model->current().camera == expected);
  QCOMPARE(m_model->undoStack()->count(), 1);
  QCOMPARE(m_model->undoStack()->undoText(), QString(QTest::currentDataTag()));
  key(Qt::Key(which), Qt::ShiftModifier);
  QVERIFY(m_model->current().camera == moved(expected, Motion(motion), 5 * step));
}

/// Over scene, image and docks, in a list and on a button.
void TestKeys::whereverTheFocusIs() {
  m_window->findChild<QDockWidget*>("reportDock")->show();
  m_window->findChild<QDockWidget*>("tradeoffDock")->show();
  m_window->findChild<QDockWidget*>("tradeoffDock")->raise();
  openSection("distortion");
  double z = 0.7;
  for (const char* name : {"sceneWidget", "pictureView", "cameraArea", "propertiesDock",
                           "measureButton", "hogels.link", "tradeoffChart"}) {
    auto* widget = child<QWidget>(name);
    QVERIFY2(widget != nullptr, name);
    widget->setFocus();
    QTest::keyClick(widget, Qt::Key_W);
    z -= 0.01;
    QVERIFY2(std::abs(eye().z - z) < 1e-12, name);
  }
  auto* floating = child<QDockWidget>("psfDock");
  floating->setFloating(true);
  floating->show();
  activate(floating);
  auto* kernel = child<QWidget>("kernelView");
  kernel->setFocus();
  QTest::keyClick(kernel, Qt::Key_W);
  z -= 0.01;
  QVERIFY(std::abs(eye().z - z) < 1e-12);
  activate(m_window.get());
  child<QDockWidget>("reportDock")->raise();
  auto* table = child<QWidget>("reportTable");
  table->setFocus();
  QTest::keyClick(table, Qt::Key_W);
  QVERIFY(std::abs(eye().z - (z - 0.01)) < 1e-12);
  // after a click on the box of states too
  QTest::mouseClick(child<QComboBox>("stateBox"), Qt::LeftButton);
  QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
  QVERIFY(!child<QComboBox>("stateBox")->hasFocus());
}

void TestKeys::notInFields() {
  const CameraState before = m_model->current();
  auto* name = editor<QLineEdit>("cameraArea", "name");
  name->setFocus();
  QTest::keyClicks(name, "wWp");
  QCOMPARE(name->text(), QString("awWp"));
  QVERIFY(m_model->current() == before);
  auto* depth = editor<QDoubleSpinBox>("cameraArea", "eye.2");
  depth->setFocus();
  QCOMPARE(m_model->current().camera.name, std::string("awWp"));  // the field was left
  for (const char letter : {'w', 'e', 'z', 'P'}) QTest::keyClick(depth, letter);
  QCOMPARE(eye().z, 0.7);
  auto* border = editor<QComboBox>("psfArea", "border");
  border->setFocus();
  QTest::keyClick(border, Qt::Key_B);  // black
  QCOMPARE(border->currentText(), QString("black"));
  QVERIFY(m_model->current().distortion == before.distortion);
  // other keys of the window are none of a field's
  QTest::keyClick(border, Qt::Key_PageDown);
  QCOMPARE(m_model->currentIndex(), std::size_t(1));
}

void TestKeys::afterReturn_data() {
  QTest::addColumn<bool>("isFloating");
  QTest::newRow("in the window") << false;
  QTest::newRow("in a floating dock") << true;
}

/// Return takes what was typed and keeps the focus; after Escape the next key is the camera's.
void TestKeys::afterReturn() {
  QFETCH(bool, isFloating);
  auto* dock = child<QDockWidget>("cameraDock");
  dock->setFloating(isFloating);
  dock->setVisible(isFloating);
  const auto type = [&](QWidget* field, const QString& text) {
    activate(dock->window());
    field->setFocus();
    QTRY_VERIFY_WITH_TIMEOUT(field->hasFocus(), patience);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(field->hasFocus());
    QTest::keyClick(field, Qt::Key_Escape);
    QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), child<QWidget>("pictureView"), patience);
  };
  type(editor<QDoubleSpinBox>("cameraArea", "eye.2"), "0.5");
  QCOMPARE(eye().z, 0.5);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_W);
  QCOMPARE(eye().z, 0.49);
  type(editor<QDoubleSpinBox>("cameraArea", "eye.2"), "0.49");  // the same value
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_S);
  QCOMPARE(eye().z, 0.5);
  type(editor<QLineEdit>("cameraArea", "name"), "other");
  QCOMPARE(m_model->current().camera.name, std::string("other"));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_D);
  QCOMPARE(eye().x, 0.01);
  const int edits = m_model->undoStack()->count();
  type(editor<QDoubleSpinBox>("cameraArea", "eye.0"), "");  // no number: as it was
  QCOMPARE(m_model->undoStack()->count(), edits);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_A);
  QVERIFY(std::abs(eye().x) < 1e-12);
}

void TestKeys::aStrangePoseIsTold() {
  editor<QDoubleSpinBox>("cameraArea", "eye.2")->setValue(0);
  const int steps = m_model->undoStack()->count();
  key(Qt::Key_W);
  QVERIFY2(message().contains("lookat"), qPrintable(message()));
  QCOMPARE(m_model->undoStack()->count(), steps);
}

void TestKeys::leakageSteps() {
  const auto psf = [this] { return m_model->current().psf; };
  key(Qt::Key_X);
  key(Qt::Key_X);
  QCOMPARE(psf().sigma, 0.6);
  for (int k = 0; k < 50; ++k) key(Qt::Key_Z);
  QCOMPARE(psf().sigma, 0.05);
  key(Qt::Key_V);
  QCOMPARE(psf().windowSize, 5);
  for (int k = 0; k < 60; ++k) key(Qt::Key_V);
  QCOMPARE(psf().windowSize, 99);
  for (int k = 0; k < 60; ++k) key(Qt::Key_C);
  QCOMPARE(psf().windowSize, 1);
}

void TestKeys::lensOffAndOn() {
  const DistortionParams lens = m_model->current().distortion;
  const auto now = [this] { return m_model->current().distortion; };
  QVERIFY(lens != DistortionParams{});
  key(Qt::Key_B);
  QVERIFY(now() == DistortionParams{});
  QCOMPARE(m_model->undoStack()->undoText(), QString("Switch off lens distortion"));
  key(Qt::Key_B);
  QVERIFY(now() == lens);
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(now() == DistortionParams{});
  key(Qt::Key_B);  // after undo too
  QVERIFY(now() == lens);
  editor<QDoubleSpinBox>("distortionArea", "k1")->setValue(0.3);
  DistortionParams other = now();
  QCOMPARE(other.k1, 0.3);
  key(Qt::Key_B);
  key(Qt::Key_B);
  QVERIFY(now() == other);
  key(Qt::Key_B);
  key(Qt::Key_PageDown);  // a state without a lens does not get another one's
  key(Qt::Key_B);
  QVERIFY2(message().contains("b has no lens distortion to switch on"), qPrintable(message()));
  QVERIFY(now() == DistortionParams{});
  editor<QDoubleSpinBox>("distortionArea", "k1")->setValue(0.3);
  key(Qt::Key_B);
  QVERIFY(files(*m_window).open("s.json"));  // nor one of another session
  QVERIFY(now() == lens);
  key(Qt::Key_PageDown);
  key(Qt::Key_B);
  QVERIFY2(message().contains("b has no lens distortion to switch on"), qPrintable(message()));
}

void TestKeys::leakageOffAndOn() {
  key(Qt::Key_P);
  QCOMPARE(m_model->current().psf.windowSize, 1);
  QCOMPARE(m_model->current().psf.sigma, 0.5);
  key(Qt::Key_P);
  QCOMPARE(m_model->current().psf.windowSize, 3);
  key(Qt::Key_V);
  key(Qt::Key_P);
  key(Qt::Key_P);
  QCOMPARE(m_model->current().psf.windowSize, 5);
}

void TestKeys::statesByPage() {
  key(Qt::Key_PageUp);
  QCOMPARE(m_model->currentIndex(), std::size_t(0));
  for (int k = 0; k < 5; ++k) key(Qt::Key_PageDown);
  QCOMPARE(child<QComboBox>("stateBox")->currentText(), QString("c"));
  key(Qt::Key_PageUp);
  QCOMPARE(child<QComboBox>("stateBox")->currentText(), QString("b"));
  QCOMPARE(m_model->undoStack()->count(), 0);
}

void TestKeys::nothingIsOpen() {
  MainWindow empty;
  empty.show();
  QVERIFY(QTest::qWaitForWindowExposed(&empty, patience));
  activate(&empty);
  for (const KeyMap::Command& command : empty.findChild<KeyMap*>()->commands())
    if (command.section.startsWith("Camera") || command.section == "Edit")
      if (command.name != "keysAction") command.actions[0]->trigger();
  for (const Qt::Key which : {Qt::Key_W, Qt::Key_B, Qt::Key_P, Qt::Key_X, Qt::Key_PageDown})
    QTest::keyClick(&empty, which);
  QVERIFY(!empty.isWindowModified());
}

int main(int argc, char** argv) {
  return runWindowTest<TestKeys>(argc, argv);
}
#include "test_keys.moc"
