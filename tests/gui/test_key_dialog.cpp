// SPDX-License-Identifier: BSD-3-Clause
// Gives commands other keys in the window of keys, as a user does, and compares the manual's table.
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <set>

#include "gui/keys/key_dialog.h"
#include "gui/keys/key_map.h"
#include "gui/view/image_widget.h"
#include "io/documents/key_map_file.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

class TestKeyDialog : public WindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup() { m_window.reset(); }
  void everythingHasAKeyOfItsOwn();
  void theManualListsAllKeys();
  void anotherKeyAtOnce();
  void conflicts();
  void searching();
  void takenAway();
  void keptForNextTime();
  void imagesToo();
  void aBadFileIsOneLine();
  void signsAndModifiers();

 private:
  Vec3 eye() const { return m_model->current().camera.eye; }
  KeyMap* map() const { return m_window->findChild<KeyMap*>(); }
  static QString keysFile() {
    return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/keys.json";
  }
  void openKeys();
  int rowOf(const char* action) const;
  QString cell(const char* action, int column) const;
  void choose(const char* action) const;
  void press(const char* action, Qt::Key which, Qt::KeyboardModifiers modifiers = {}) const;
};

void TestKeyDialog::init() {
  QFile::remove(keysFile());
  start();
}

void TestKeyDialog::openKeys() {
  key(Qt::Key_K, Qt::ControlModifier);
  QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<KeyDialog*>() != nullptr, patience);
  QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<KeyDialog*>()->isVisible(), patience);
}

int TestKeyDialog::rowOf(const char* action) const {
  const auto& commands = map()->commands();
  const auto found = std::ranges::find(commands, QString(action), &KeyMap::Command::name);
  if (found == commands.end()) qFatal("no command %s", action);
  return int(found - commands.begin());
}

QString TestKeyDialog::cell(const char* action, int column) const {
  return child<QTableWidget>("keyTable")->item(rowOf(action), column)->text();
}

/// As a user does: a click on the row, Return.
void TestKeyDialog::choose(const char* action) const {
  auto* table = child<QTableWidget>("keyTable");
  activate(m_window->findChild<KeyDialog*>());
  QTableWidgetItem* item = table->item(rowOf(action), 0);
  table->scrollToItem(item);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualItemRect(item).center());
  QTest::keyClick(table, Qt::Key_Return);
}

void TestKeyDialog::press(const char* action, Qt::Key which,
                          Qt::KeyboardModifiers modifiers) const {
  choose(action);
  auto* field = child<KeyField>("keyField");
  QVERIFY(field->hasFocus());
  QTest::keyClick(field, which, modifiers);
  activate(m_window.get());
}

void TestKeyDialog::everythingHasAKeyOfItsOwn() {
  QVERIFY(map()->commands().size() > 60);
  for (std::size_t k = 0; k < map()->commands().size(); ++k) {
    const KeyMap::Command& command = map()->commands()[k];
    QVERIFY2(!command.defaults.isEmpty(), qPrintable(command.name));
    QVERIFY2(!command.section.isEmpty() && !command.title.isEmpty(), qPrintable(command.name));
    QVERIFY2(!command.help.isEmpty(), qPrintable(command.name));
    QVERIFY2(map()->conflictsOf(k).empty(), qPrintable(command.name));
  }
}

/// keys.md holds a row for each command, and no other; what it should be lies beside this program.
void TestKeyDialog::theManualListsAllKeys() {
  QByteArray table = "| menu | command | key |\n|---|---|---|\n";
  for (const KeyMap::Command& command : map()->commands())
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

void TestKeyDialog::anotherKeyAtOnce() {
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
  activate(m_window.get());
  key(Qt::Key_W);
  QCOMPARE(eye().z, 0.68);
}

/// Both are marked, neither works, and one solves it for both.
void TestKeyDialog::conflicts() {
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
  press("duplicateAction", Qt::Key_F10);
  QCOMPARE(cell("walkForwardAction", 4), QString());
  QCOMPARE(cell("duplicateAction", 4), QString());
  key(Qt::Key_D, Qt::ControlModifier);
  QCOMPARE(eye().z, 0.69);
  key(Qt::Key_F10);
  QCOMPARE(m_model->session().cameras.size(), std::size_t(4));
  QTest::mouseClick(child<QPushButton>("resetAllKeysButton"), Qt::LeftButton);
  key(Qt::Key_D, Qt::ControlModifier);
  QCOMPARE(m_model->session().cameras.size(), std::size_t(5));
}

void TestKeyDialog::searching() {
  openKeys();
  auto* table = child<QTableWidget>("keyTable");
  auto* search = child<QLineEdit>("keySearch");
  const auto shown = [&] {
    std::set<QString> rows;
    for (int row = 0; row < table->rowCount(); ++row)
      if (!table->isRowHidden(row)) rows.insert(map()->commands()[std::size_t(row)].name);
    return rows;
  };
  QCOMPARE(shown().size(), map()->commands().size());
  QTest::keyClicks(search, "ctrl+d");  // Ctrl+D, Ctrl+Del and Ctrl+Down
  QCOMPARE(shown(), (std::set<QString>{"duplicateAction", "removeAction", "lessGammaAction"}));
  search->clear();
  QTest::keyClicks(search, "ORBIT up");
  QVERIFY(shown().contains("orbitUpAction") && shown().contains("orbitUpLargeAction"));
  QVERIFY(!shown().contains("walkForwardAction"));
  QCOMPARE(table->currentRow(), rowOf("orbitUpAction"));
  activate(m_window->findChild<KeyDialog*>());
  QTest::keyClick(search, Qt::Key_Return);
  QVERIFY(child<KeyField>("keyField")->hasFocus());
  m_window->findChild<KeyDialog*>()->grab().save(QCoreApplication::applicationDirPath() +
                                                 "/key_window.png");
  QTest::keyClicks(search, " no such thing");
  QVERIFY(shown().empty());
}

void TestKeyDialog::takenAway() {
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

void TestKeyDialog::keptForNextTime() {
  openKeys();
  press("reportDockAction", Qt::Key_F10);
  m_window.reset();
  start();
  key(Qt::Key_F10);
  QTRY_VERIFY_WITH_TIMEOUT(child<QDockWidget>("reportDock")->isVisible(), patience);
  openKeys();
  QCOMPARE(cell("reportDockAction", 2), QString("F10"));
  QCOMPARE(cell("reportDockAction", 3), QString("Ctrl+R"));
}

/// Of the picture itself.
void TestKeyDialog::imagesToo() {
  QTRY_VERIFY_WITH_TIMEOUT(!child<ImageWidget>("pictureView")->image().isNull(), patience);
  openKeys();
  press("zoomInAction", Qt::Key_F12);
  auto* view = child<ImageWidget>("pictureView");
  view->setFocus();
  const Viewport before = view->viewport();
  QTest::keyClick(view, Qt::Key_Plus);
  QVERIFY(view->viewport() == before);
  QTest::keyClick(view, Qt::Key_F12);
  QVERIFY(view->viewport() != before);
}

void TestKeyDialog::aBadFileIsOneLine() {
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

void TestKeyDialog::signsAndModifiers() {
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
  return runWindowTest<TestKeyDialog>(argc, argv);
}
#include "test_key_dialog.moc"
