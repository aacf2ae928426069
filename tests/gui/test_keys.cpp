// SPDX-License-Identifier: BSD-3-Clause
// Presses keys in the real window: they move the camera wherever the focus is, but not in fields;
// the window of keys gives commands other keys.
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QStatusBar>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QUndoStack>
#include <QtTest>
#include <set>

#include "core/camera_motion.h"
#include "gui/key_field.h"
#include "gui/key_map.h"
#include "gui/key_window.h"
#include "gui/main_window.h"
#include "gui/picture_view.h"
#include "gui/session_model.h"
#include "gui/vtk_widget.h"
#include "io/key_map_file.h"
#include "tests/gui/small_session.h"

using namespace hogelscope;

class TestKeys : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup() { m_window.reset(); }
  void eachMotionHasItsKey_data();
  void eachMotionHasItsKey();
  void whereverTheFocusIs();
  void notInFields();
  void aStrangePoseIsTold();
  void leakageSteps();
  void lensOffAndOn();
  void leakageOffAndOn();
  void statesByPage();
  void nothingIsOpen();
  void everythingHasAKeyOfItsOwn();
  void theManualListsAllKeys();
  void anotherKeyAtOnce();
  void conflicts();
  void searching();
  void takenAway();
  void keptForNextTime();
  void picturesToo();
  void aBadFileIsOneLine();
  void signsAndModifiers();

 private:
  template <class T>
  T* child(const char* name) const {
    return m_window->findChild<T*>(name);
  }
  template <class T>
  T* editor(const char* area, const char* name) const {
    return child<QScrollArea>(area)->widget()->findChild<T*>(name);
  }
  void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) const {
    QTest::keyClick(m_window.get(), which, modifiers);
  }
  Vec3 eye() const { return m_model->current().camera.eye; }
  QString message() const { return m_window->statusBar()->currentMessage(); }
  static QString keysFile() {
    return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/keys.json";
  }
  void start();
  void openKeys();
  int rowOf(const char* action) const;
  QString cell(const char* action, int column) const;
  void choose(const char* action) const;
  void press(const char* action, Qt::Key which, Qt::KeyboardModifiers modifiers = {}) const;

  QTemporaryDir m_folder;
  std::unique_ptr<MainWindow> m_window;
  SessionModel* m_model = nullptr;
  KeyMap* m_map = nullptr;
};

void TestKeys::init() {
  QFile::remove(keysFile());
  start();
}

void TestKeys::start() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  writeSmallSession();
  m_window = std::make_unique<MainWindow>();
  m_window->show();
  QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
  QApplication::setActiveWindow(m_window.get());  // there is no window manager that would
  m_model = m_window->findChild<SessionModel*>();
  m_map = m_window->findChild<KeyMap*>();
  QVERIFY(m_window->openSession("s.json"));
}

void TestKeys::openKeys() {
  key(Qt::Key_K, Qt::ControlModifier);
  QTRY_VERIFY(m_window->findChild<KeyWindow*>() != nullptr);
  QTRY_VERIFY(m_window->findChild<KeyWindow*>()->isVisible());
}

int TestKeys::rowOf(const char* action) const {
  const auto& commands = m_map->commands();
  const auto found = std::ranges::find(commands, QString(action), &KeyMap::Command::name);
  if (found == commands.end()) qFatal("no command %s", action);
  return int(found - commands.begin());
}

QString TestKeys::cell(const char* action, int column) const {
  return child<QTableWidget>("keyTable")->item(rowOf(action), column)->text();
}

/// As a user does: a click on the row, Return.
void TestKeys::choose(const char* action) const {
  auto* table = child<QTableWidget>("keyTable");
  QApplication::setActiveWindow(m_window->findChild<KeyWindow*>());
  QTableWidgetItem* item = table->item(rowOf(action), 0);
  table->scrollToItem(item);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualItemRect(item).center());
  QTest::keyClick(table, Qt::Key_Return);
}

void TestKeys::press(const char* action, Qt::Key which, Qt::KeyboardModifiers modifiers) const {
  choose(action);
  auto* field = child<KeyField>("keyField");
  QVERIFY(field->hasFocus());
  QTest::keyClick(field, which, modifiers);
  QApplication::setActiveWindow(m_window.get());
}

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

/// Over scene, picture and docks, in a list and on a button.
void TestKeys::whereverTheFocusIs() {
  m_window->findChild<QDockWidget*>("reportDock")->show();
  m_window->findChild<QDockWidget*>("tradeoffDock")->show();
  m_window->findChild<QDockWidget*>("tradeoffDock")->raise();
  double z = 0.7;
  for (const char* name : {"sceneWidget", "pictureView", "cameraArea", "psfDock", "measureButton",
                           "k1.slider", "tradeoffChart"}) {
    auto* widget = child<QWidget>(name);
    QVERIFY2(widget != nullptr, name);
    widget->setFocus();
    QTest::keyClick(widget, Qt::Key_W);
    z -= 0.01;
    QVERIFY2(std::abs(eye().z - z) < 1e-12, name);
  }
  auto* floating = child<QDockWidget>("psfDock");
  floating->setFloating(true);
  QApplication::setActiveWindow(floating);
  auto* slider = child<QWidget>("sigma.slider");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_W);
  z -= 0.01;
  QVERIFY(std::abs(eye().z - z) < 1e-12);
  QApplication::setActiveWindow(m_window.get());
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
  QVERIFY(m_window->openSession("s.json"));
  QVERIFY(now() == lens);
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
  QVERIFY(QTest::qWaitForWindowExposed(&empty));
  QApplication::setActiveWindow(&empty);
  for (const KeyMap::Command& command : empty.findChild<KeyMap*>()->commands())
    if (command.section.startsWith("Camera") || command.section == "Edit")
      if (command.name != "keysAction") command.actions[0]->trigger();
  for (const Qt::Key which : {Qt::Key_W, Qt::Key_B, Qt::Key_P, Qt::Key_X, Qt::Key_PageDown})
    QTest::keyClick(&empty, which);
  QVERIFY(!empty.isWindowModified());
}

void TestKeys::everythingHasAKeyOfItsOwn() {
  QVERIFY(m_map->commands().size() > 60);
  for (std::size_t k = 0; k < m_map->commands().size(); ++k) {
    const KeyMap::Command& command = m_map->commands()[k];
    QVERIFY2(!command.defaults.isEmpty(), qPrintable(command.name));
    QVERIFY2(!command.section.isEmpty() && !command.title.isEmpty(), qPrintable(command.name));
    QVERIFY2(m_map->conflictsOf(k).empty(), qPrintable(command.name));
  }
}

/// keys.md holds a row for each command, and no other; what it should be lies beside this program.
void TestKeys::theManualListsAllKeys() {
  QByteArray table = "| menu | command | key |\n|---|---|---|\n";
  for (const KeyMap::Command& command : m_map->commands())
    table += QString("| %1 | %2 | %3 |\n")
                 .arg(command.section, command.title,
                      QKeySequence::listToString(command.defaults, QKeySequence::PortableText)
                          .replace("; ", " or "))
                 .toUtf8();
  const QString made = QCoreApplication::applicationDirPath() + "/keys.md";
  const QByteArray manual = contentOf(HOGELSCOPE_SOURCE_DIR "/resources/manual/keys.md");
  writeFile(made, manual.left(manual.indexOf("| menu |")) + table);
  QVERIFY2(contentOf(made) == manual, qPrintable("the manual should be as " + made));
}

void TestKeys::anotherKeyAtOnce() {
  openKeys();
  QCOMPARE(cell("walkForwardAction", 0), QString("Camera: Walk forward"));
  QCOMPARE(cell("walkForwardAction", 1), QString("Moves the camera 1 cm along its view"));
  QCOMPARE(cell("walkForwardAction", 2), QString("W"));
  press("walkForwardAction", Qt::Key_Y, Qt::ControlModifier);
  QCOMPARE(cell("walkForwardAction", 2), QString("Ctrl+Y"));
  QCOMPARE(cell("walkForwardAction", 3), QString("W"));
  key(Qt::Key_W);
  QCOMPARE(eye().z, 0.7);
  key(Qt::Key_Y, Qt::ControlModifier);
  QCOMPARE(eye().z, 0.69);
  QVERIFY(loadKeyTexts(keysFile().toStdString()) == KeyTexts({{"walkForwardAction", "Ctrl+Y"}}));
  choose("walkForwardAction");
  QTest::mouseClick(child<QPushButton>("resetKeyButton"), Qt::LeftButton);
  QVERIFY(!child<QPushButton>("resetKeyButton")->isEnabled());
  QVERIFY(loadKeyTexts(keysFile().toStdString()).empty());
  QApplication::setActiveWindow(m_window.get());
  key(Qt::Key_W);
  QCOMPARE(eye().z, 0.68);
}

/// Both are marked, neither works, and one solves it for both.
void TestKeys::conflicts() {
  openKeys();
  press("walkForwardAction", Qt::Key_D, Qt::ControlModifier);
  QCOMPARE(cell("walkForwardAction", 4), QString("⚠ also States: Duplicate"));
  QCOMPARE(cell("duplicateAction", 4), QString("⚠ also Camera: Walk forward"));
  QVERIFY(child<QLabel>("keyNote")->text().contains("Ctrl+D is also the key of States: Duplicate"));
  auto* table = child<QTableWidget>("keyTable");
  const QBrush marked = table->item(rowOf("duplicateAction"), 0)->background();
  QVERIFY(marked != table->item(rowOf("renameAction"), 0)->background());
  QTest::ignoreMessage(QtWarningMsg, QRegularExpression("QAction::event: Ambiguous shortcut.*"));
  key(Qt::Key_D, Qt::ControlModifier);
  QCOMPARE(m_model->session().cameras.size(), std::size_t(3));
  QCOMPARE(eye().z, 0.7);
  press("duplicateAction", Qt::Key_F9);
  QCOMPARE(cell("walkForwardAction", 4), QString());
  QCOMPARE(cell("duplicateAction", 4), QString());
  key(Qt::Key_D, Qt::ControlModifier);
  QCOMPARE(eye().z, 0.69);
  key(Qt::Key_F9);
  QCOMPARE(m_model->session().cameras.size(), std::size_t(4));
  QTest::mouseClick(child<QPushButton>("resetAllKeysButton"), Qt::LeftButton);
  key(Qt::Key_D, Qt::ControlModifier);
  QCOMPARE(m_model->session().cameras.size(), std::size_t(5));
}

void TestKeys::searching() {
  openKeys();
  auto* table = child<QTableWidget>("keyTable");
  auto* search = child<QLineEdit>("keySearch");
  const auto shown = [&] {
    std::set<QString> rows;
    for (int row = 0; row < table->rowCount(); ++row)
      if (!table->isRowHidden(row)) rows.insert(m_map->commands()[std::size_t(row)].name);
    return rows;
  };
  QCOMPARE(shown().size(), m_map->commands().size());
  QTest::keyClicks(search, "ctrl+d");  // Ctrl+D and Ctrl+Del
  QCOMPARE(shown(), (std::set<QString>{"duplicateAction", "removeAction"}));
  search->clear();
  QTest::keyClicks(search, "ORBIT up");
  QVERIFY(shown().contains("orbitUpAction") && shown().contains("orbitUpLargeAction"));
  QVERIFY(!shown().contains("walkForwardAction"));
  QCOMPARE(table->currentRow(), rowOf("orbitUpAction"));
  QApplication::setActiveWindow(m_window->findChild<KeyWindow*>());
  QTest::keyClick(search, Qt::Key_Return);
  QVERIFY(child<KeyField>("keyField")->hasFocus());
  m_window->findChild<KeyWindow*>()->grab().save(QCoreApplication::applicationDirPath() +
                                                 "/key_window.png");
  QTest::keyClicks(search, " no such thing");
  QVERIFY(shown().empty());
}

void TestKeys::takenAway() {
  openKeys();
  press("walkForwardAction", Qt::Key_Backspace);
  QCOMPARE(cell("walkForwardAction", 2), QString());
  key(Qt::Key_W);
  QCOMPARE(eye().z, 0.7);
  m_window.reset();
  start();
  key(Qt::Key_W);
  QCOMPARE(eye().z, 0.7);
}

void TestKeys::keptForNextTime() {
  openKeys();
  press("reportDockAction", Qt::Key_F8);
  m_window.reset();
  start();
  key(Qt::Key_F8);
  QTRY_VERIFY(child<QDockWidget>("reportDock")->isVisible());
  openKeys();
  QCOMPARE(cell("reportDockAction", 2), QString("F8"));
  QCOMPARE(cell("reportDockAction", 3), QString("Ctrl+R"));
}

/// One key for the same command of all pictures.
void TestKeys::picturesToo() {
  QTRY_VERIFY_WITH_TIMEOUT(!child<PictureView>("pictureView")->image().isNull(), 20000);
  openKeys();
  press("zoomInAction", Qt::Key_F7);
  child<QDockWidget>("reportDock")->show();
  const QImage picture = child<PictureView>("pictureView")->image();
  for (const char* name : {"pictureView", "reportReference"}) {
    auto* view = child<PictureView>(name);
    view->setImages(picture);
    view->setFocus();
    const Viewport before = view->viewport();
    QTest::keyClick(view, Qt::Key_Plus);
    QVERIFY(view->viewport() == before);
    QTest::keyClick(view, Qt::Key_F7);
    QVERIFY2(view->viewport() != before, name);
  }
}

void TestKeys::aBadFileIsOneLine() {
  m_window.reset();
  for (const auto& [document, line] :
       {std::pair("{", "is not JSON"),
        std::pair(R"({"hogelscopeKeys": 1, "keys": {"saveAction": "Nonsense+W"}})",
                  "keys.saveAction: \"Nonsense+W\" is not a key")}) {
    writeFile(keysFile(), document);
    MainWindow window;
    const QString shown = window.statusBar()->currentMessage();
    QVERIFY2(shown.startsWith("Error: " + keysFile()) && shown.contains(line), qPrintable(shown));
    QVERIFY(!shown.contains('\n'));
    QCOMPARE(window.findChild<QAction*>("saveAction")->shortcut(), QKeySequence("Ctrl+S"));
  }
  writeFile(keysFile(), R"({"hogelscopeKeys": 1, "keys": {"newerAction": "Ctrl+J"}})");
  MainWindow window;
  QVERIFY(window.statusBar()->currentMessage().isEmpty());
}

void TestKeys::signsAndModifiers() {
  KeyField field;
  field.show();
  QSignalSpy pressed(&field, &KeyField::keyPressed);
  const auto last = [&] { return pressed.takeLast()[0].value<QKeySequence>().toString(); };
  QTest::keyClick(&field, Qt::Key_Plus, Qt::ShiftModifier);
  QCOMPARE(last(), QString("+"));
  QTest::keyClick(&field, Qt::Key_A, Qt::ShiftModifier | Qt::AltModifier);
  QCOMPARE(last(), QString("Alt+Shift+A"));
  QTest::keyClick(&field, Qt::Key_Delete, Qt::ControlModifier);
  QCOMPARE(last(), QString("Ctrl+Del"));
  QTest::keyClick(&field, Qt::Key_Delete);
  QCOMPARE(last(), QString());
  for (const Qt::Key which : {Qt::Key_Shift, Qt::Key_Control, Qt::Key_Alt, Qt::Key_Meta,
                              Qt::Key_AltGr, Qt::Key_Return, Qt::Key_Escape, Qt::Key_Tab}) {
    QKeyEvent event(QEvent::KeyPress, which, {});
    QApplication::sendEvent(&field, &event);
  }
  QVERIFY(pressed.isEmpty());
}

int main(int argc, char** argv) {
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat::setDefaultFormat(VtkWidget::surfaceFormat());
  QApplication application(argc, argv);
  TestKeys test;
  return QTest::qExec(&test, argc, argv);
}
#include "test_keys.moc"
