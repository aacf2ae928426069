// SPDX-License-Identifier: BSD-3-Clause
// Finds commands and fields by a few letters in the real window, and does or edits them.
#include <QAction>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QSettings>
#include <QToolButton>

#include "gui/keys/command_palette.h"
#include "gui/keys/field_guards.h"
#include "gui/view/image_widget.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

class TestCommandPalette : public WindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    start();
  }
  void cleanup() { m_window.reset(); }

  void fieldsAreEdited() {
    child<QAbstractButton>("displayHeader")->setChecked(false);
    child<QDockWidget>("propertiesDock")->hide();
    ask("direc");
    QCOMPARE(entries().front(), QString("Display · Directions"));
    QVERIFY(list()->item(0)->data(Qt::UserRole + 2).toString().startsWith("4"));
    press(Qt::Key_Return);
    auto* field = editor<QSpinBox>("displayArea", "directions.0");
    QTRY_VERIFY_WITH_TIMEOUT(field->hasFocus(), patience);
    QVERIFY(!palette()->isVisible() && !field->visibleRegion().isEmpty());
    QVERIFY(field->findChild<QLineEdit*>()->hasSelectedText());
    ask("hoge");
    QCOMPARE(entries().front(), QString("Display · Hogels"));
  }

  void commandsAreDone() {
    auto* view = child<ImageWidget>("pictureView");
    view->setFocus();
    ask("sc fr");
    QCOMPARE(entries().front(), QString("Front"));
    QCOMPARE(list()->item(0)->data(Qt::UserRole + 1).toString(), QString("Scene"));
    QCOMPARE(list()->item(0)->data(Qt::UserRole + 2).toString(), QString("F5"));
    ask("adds");
    QVERIFY(!entries().contains("New"));
    ask("st new");
    QCOMPARE(entries().front(), QString("New"));
    press(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(m_model->session().cameras.size(), std::size_t(4), patience);
    QVERIFY(view->hasFocus());
    ask("");
    QCOMPARE(entries().front(), QString("New"));  // used last
  }

  /// The commands of a disabled menu are disabled, and no workspace leaves the home page.
  void nothingIsEditedOnTheHomePage() {
    m_window.reset();
    showWindow();
    ask("st new");
    press(Qt::Key_Return);
    QTest::qWait(50);
    QVERIFY(m_model->session().cameras.empty());
    key(Qt::Key_Escape);
    for (const char* name : {"layoutViewAction", "layoutReportAction", "resetLayoutAction"}) {
      QVERIFY2(child<QAction>(name) != nullptr, name);
      child<QAction>(name)->trigger();
    }
    QVERIFY(child<QWidget>("homePage")->isVisible());
    QVERIFY(!child<QDockWidget>("propertiesDock")->isVisible());
  }

  /// Escape does not remove picks of the scene, Page Down does not choose the next state.
  void keysAreThePalettes() {
    auto* view = child<ImageWidget>("pictureView");
    view->setFocus();
    ask("");
    const int all = list()->count();
    QVERIFY(all > 200);
    press(Qt::Key_Down);
    press(Qt::Key_Down);
    QCOMPARE(list()->currentRow(), 2);
    press(Qt::Key_PageDown);
    QCOMPARE(list()->currentRow(), 11);
    QCOMPARE(m_model->currentIndex(), std::size_t(0));
    press(Qt::Key_Escape);
    QVERIFY(!palette()->isVisible() && view->hasFocus());
  }

  void whatIsDisabledIsLastAndNotDone() {
    QVERIFY(!child<QAction>("undoAction")->isEnabled());
    ask("un");
    QVERIFY(entries().contains("Undo"));
    for (int row = 0, gone = 0; row < list()->count(); ++row) {
      const bool isDisabled = list()->item(row)->flags() == Qt::NoItemFlags;
      QVERIFY(isDisabled || gone == 0);
      gone += int(isDisabled);
    }
    ask("undo");
    QCOMPARE(entries(), QStringList("Undo"));
    press(Qt::Key_Return);
    QVERIFY(palette()->isVisible());
  }

  void whatFitsNothingIsSaid() {
    ask("xyzzy");
    QCOMPARE(entries(), QStringList("Nothing fits “xyzzy”"));
    press(Qt::Key_Return);
    QVERIFY(palette()->isVisible());
    ask("leakage sigma");  // its section is called PSF in documents
    QVERIFY(entries().join("|").contains("Sigma"));
  }

  void theButtonOpensIt() {
    const std::unique_ptr<QToolButton> button(
        CommandPalette::makeButton(child<QAction>("commandPaletteAction")));
    QVERIFY2(button->text().endsWith("Ctrl+P"), qPrintable(button->text()));
    button->click();
    QVERIFY(palette()->isVisible());
  }

  /// A section's key goes to the field of it that had the focus last; from there it closes it.
  void aSectionRemembersItsField() {
    const auto press = [this] {
      key(Qt::Key_1, Qt::ControlModifier | Qt::ShiftModifier);  // the camera's
    };
    const auto isIn = [this](const char* name) {
      return editor<QWidget>("cameraArea", name)->hasFocus();
    };
    press();  // it is open already
    QTRY_VERIFY_WITH_TIMEOUT(isIn("name"), patience);
    press();  // the keyboard is in it
    QVERIFY(!child<QWidget>("cameraArea")->isVisible());
    press();
    QTRY_VERIFY_WITH_TIMEOUT(isIn("name"), patience);
    editor<QDoubleSpinBox>("cameraArea", "eye.1")->setFocus();
    child<ImageWidget>("pictureView")->setFocus();
    press();
    QTRY_VERIFY_WITH_TIMEOUT(isIn("eye.1"), patience);
  }

 private:
  CommandPalette* palette() const { return m_window->findChild<CommandPalette*>(); }
  QListWidget* list() const { return child<QListWidget>("paletteList"); }
  QStringList entries() const {
    QStringList titles;
    for (int row = 0; row < list()->count(); ++row) titles << list()->item(row)->text();
    return titles;
  }
  /// Opens the palette, unless it is, and types words.
  void ask(const QString& words) {
    if (!palette()->isVisible()) key(Qt::Key_P, Qt::ControlModifier);
    QVERIFY(palette()->isVisible());
    QVERIFY(child<QLineEdit>("paletteSearch")->hasFocus());
    child<QLineEdit>("paletteSearch")->clear();
    QTest::keyClicks(child<QLineEdit>("paletteSearch"), words);
  }
  void press(Qt::Key which) { QTest::keyClick(child<QLineEdit>("paletteSearch"), which); }
};

int main(int argc, char** argv) {
  return runWindowTest<TestCommandPalette>(argc, argv);
}
#include "test_command_palette.moc"
