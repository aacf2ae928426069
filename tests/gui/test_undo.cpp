// SPDX-License-Identifier: BSD-3-Clause
// Takes every kind of edit back in the real window, and does it again.
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QUndoStack>

#include "gui/session/state_commands.h"
#include "io/documents/session_file.h"
#include "tests/gui/scrub.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

class TestUndo : public WindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup() { m_window.reset(); }
  void aDragIsOneStep();
  void valuesOfTwoFieldsAreTwoSteps();
  void stepsOfTwoStatesAreTwo();
  void eachStatesCommandComesBack_data();
  void eachStatesCommandComesBack();
  void aCameraSetComesBack();
  void afterSavingUndoIsAnEdit();
  void aFailedActionLeavesNoStep();
  void nothingChangedIsNoStep();
  void anotherSessionHasNoSteps();
  void fieldsUndoTypingFirst();

 private:
  void trigger(const char* name) const { child<QAction>(name)->trigger(); }
  void undo() const { key(Qt::Key_Z, Qt::ControlModifier); }
  void redo() const { key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }
  int steps() const { return m_model->undoStack()->count(); }
  QString undoText() const { return child<QAction>("undoAction")->text().remove('&'); }
};

void TestUndo::init() {
  start();
  QVERIFY(!child<QAction>("undoAction")->isEnabled());
  QVERIFY(!child<QAction>("redoAction")->isEnabled());
}

void TestUndo::aDragIsOneStep() {
  const Session before = m_model->session();
  auto* field = editor<QDoubleSpinBox>("psfArea", "sigma");
  scrub(field, 20);
  QCOMPARE(m_model->current().psf.sigma, 0.8);  // of 0 … 3 in 200 pixels
  QCOMPARE(steps(), 1);
  scrub(field, 20);  // another drag is another step, however soon it follows
  QCOMPARE(m_model->current().psf.sigma, 1.1);
  QCOMPARE(steps(), 2);
  undo();
  QCOMPARE(undoText(), QString("Undo Change sigma"));
  QVERIFY(m_window->isWindowModified());
  undo();
  QVERIFY(m_model->session() == before);
  QCOMPARE(editor<QDoubleSpinBox>("psfArea", "sigma")->value(), 0.5);
  QVERIFY(!m_window->isWindowModified());
  QVERIFY(!child<QAction>("undoAction")->isEnabled());
  QCOMPARE(child<QAction>("redoAction")->text().remove('&'), QString("Redo Change sigma"));
  redo();
  QCOMPARE(field->value(), 0.8);
}

void TestUndo::valuesOfTwoFieldsAreTwoSteps() {
  editor<QDoubleSpinBox>("psfArea", "sigma")->setValue(2);
  editor<QDoubleSpinBox>("cameraArea", "eye.0")->setValue(0.25);
  editor<QSpinBox>("psfArea", "windowSize")->setValue(5);
  QCOMPARE(steps(), 3);
  undo();
  QCOMPARE(m_model->current().psf.windowSize, 3);
  QCOMPARE(undoText(), QString("Undo Change eye"));
  undo();
  QCOMPARE(m_model->current().camera.eye.x, 0.0);
  QCOMPARE(m_model->current().psf.sigma, 2.0);
}

/// And undo goes to the state that it changes.
void TestUndo::stepsOfTwoStatesAreTwo() {
  key(Qt::Key_W);
  key(Qt::Key_PageDown);
  key(Qt::Key_W);
  QCOMPARE(steps(), 2);
  key(Qt::Key_PageDown);
  QCOMPARE(m_model->currentIndex(), std::size_t(2));
  undo();
  QCOMPARE(m_model->currentIndex(), std::size_t(1));
  QCOMPARE(m_model->session().cameras[1].camera.eye.z, 0.7);
  undo();
  QCOMPARE(m_model->currentIndex(), std::size_t(0));
  QCOMPARE(m_model->session().cameras[0].camera.eye.z, 0.7);
}

using Act = std::function<void(MainWindow&)>;
Q_DECLARE_METATYPE(Act)

void TestUndo::eachStatesCommandComesBack_data() {
  QTest::addColumn<Act>("act");
  QTest::addColumn<QStringList>("names");
  QTest::addColumn<QString>("step");
  const auto triggers = [](const char* name) -> Act {
    return [name](MainWindow& window) { window.findChild<QAction*>(name)->trigger(); };
  };
  const auto row = [](const char* name, const Act& act, const char* names, const char* step) {
    QTest::newRow(name) << act << QString(names).split('|') << QString("Undo ") + step;
  };
  row("duplicate", triggers("duplicateAction"), "a|b|b 2|c", "Duplicate state");
  row("delete", triggers("removeAction"), "a|c", "Delete state");
  row("up", triggers("moveUpAction"), "b|a|c", "Move state");
  row("down", triggers("moveDownAction"), "a|c|b", "Move state");
  row(
      "load",
      [](MainWindow& window) { window.findChild<StateCommands*>()->mergeStatesOf("s.json"); },
      "a|b|c|a 2|b 2|c 2", "Load states");
  row(
      "rename", [](MainWindow& window) { window.findChild<StateCommands*>()->rename(1, "new"); },
      "a|new|c", "Rename state");
}

void TestUndo::eachStatesCommandComesBack() {
  QFETCH(Act, act);
  QFETCH(QStringList, names);
  QFETCH(QString, step);
  m_model->setCurrentIndex(1);
  const Session before = m_model->session();
  auto* box = child<QComboBox>("stateBox");
  const auto shown = [box] {
    QStringList list;
    for (int k = 0; k < box->count(); ++k) list << box->itemText(k);
    return list;
  };
  act(*m_window);
  const std::size_t current = m_model->currentIndex();
  QCOMPARE(shown(), names);
  QCOMPARE(steps(), 1);
  QCOMPARE(undoText(), step);
  activate(m_window.get());
  undo();
  QVERIFY(m_model->session() == before);
  QCOMPARE(shown(), QStringList({"a", "b", "c"}));
  QCOMPARE(m_model->currentIndex(), std::size_t(1));
  QCOMPARE(box->currentIndex(), 1);
  redo();
  QCOMPARE(shown(), names);
  QCOMPARE(m_model->currentIndex(), current);
}

void TestUndo::aCameraSetComesBack() {
  const Session before = m_model->session();
  child<QPushButton>("addSetButton")->click();
  QVERIFY(m_model->session().cameras.size() > 3);
  QCOMPARE(undoText(), QString("Undo Add camera set"));
  undo();
  QVERIFY(m_model->session() == before);
  QCOMPARE(child<QComboBox>("stateBox")->count(), 3);
}

void TestUndo::afterSavingUndoIsAnEdit() {
  trigger("duplicateAction");
  QVERIFY(m_window->isWindowModified());
  QVERIFY(files(*m_window).save("t.json"));
  QVERIFY(!m_window->isWindowModified());
  undo();
  QVERIFY(m_window->isWindowModified());
  redo();
  QVERIFY(!m_window->isWindowModified());
  QCOMPARE(loadSession("t.json").cameras.size(), std::size_t(4));
}

void TestUndo::aFailedActionLeavesNoStep() {
  for (int left = 2; left >= 1; --left) trigger("removeAction");
  QCOMPARE(steps(), 2);
  const Session before = m_model->session();
  trigger("removeAction");  // the only one
  QVERIFY(m_window->statusBar()->currentMessage().contains("a session needs one"));
  QVERIFY(!m_window->findChild<StateCommands*>()->mergeStatesOf("missing.json"));
  QCOMPARE(steps(), 2);
  QVERIFY(m_model->session() == before);
}

void TestUndo::nothingChangedIsNoStep() {
  trigger("moveUpAction");  // the first one
  auto* sigma = editor<QDoubleSpinBox>("psfArea", "sigma");
  sigma->setValue(sigma->value());
  QCOMPARE(steps(), 0);
  QVERIFY(!m_window->isWindowModified());
}

void TestUndo::anotherSessionHasNoSteps() {
  trigger("duplicateAction");
  QVERIFY(files(*m_window).open("s.json"));
  QCOMPARE(steps(), 0);
  QVERIFY(!child<QAction>("undoAction")->isEnabled());
  undo();
  QCOMPARE(m_model->session().cameras.size(), std::size_t(3));
}

/// Where nothing was typed, Ctrl+Z in a field is the session's.
void TestUndo::fieldsUndoTypingFirst() {
  auto* sigma = editor<QDoubleSpinBox>("psfArea", "sigma");
  sigma->setFocus();
  sigma->selectAll();
  QTest::keyClicks(sigma, "2");
  QTest::keyClick(sigma, Qt::Key_Return);
  QCOMPARE(m_model->current().psf.sigma, 2.0);
  QTest::keyClick(sigma, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(m_model->current().psf.sigma, 0.5);
  QCOMPARE(sigma->value(), 0.5);
  QTest::keyClick(sigma, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(m_model->current().psf.sigma, 2.0);

  auto* name = editor<QLineEdit>("cameraArea", "name");
  name->setFocus();
  QTest::keyClicks(name, "x");
  QCOMPARE(name->text(), QString("ax"));
  QTest::keyClick(name, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(name->text(), QString("a"));
  QCOMPARE(m_model->current().psf.sigma, 2.0);
}

int main(int argc, char** argv) {
  return runWindowTest<TestUndo>(argc, argv);
}
#include "test_undo.moc"
