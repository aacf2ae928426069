// SPDX-License-Identifier: BSD-3-Clause
// What a person has to do for nine tasks, in the real window: clicks, keys and typed names. The
// steps are the shortest way that the menus and docks show; a change that needs more fails.
#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include "gui/docks/report_dock.h"
#include "gui/view/image_widget.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

class TestTasks : public WindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void theFirstPictureOfAForeignHogelImage();
  void aReportOfTwoJpegs();
  void theWorstViewAndWhy();
  void whyIsThisPixelBlack();
  void aDisplayForTheRoomByKeysAlone();
  void theRoomOnADisplayOfTheLibrary();
  void aTolerance();
  void anExport();
  void anotherMetric();

 private:
  /// Opens the live sample from the home page.
  void openRoom() {
    showWindow({1280, 800});
    child<QAbstractButton>("roomSample")->click();
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  }
  /// Presses Return in the modal dialogs that come next.
  void acceptDialogs(int count) {
    QTimer::singleShot(50, this, [this, count] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || !dialog->isVisible()) return acceptDialogs(count);
      if (count > 1) acceptDialogs(count - 1);
      ++m_steps;
      QTest::keyClick(dialog, Qt::Key_Return);
    });
  }
  void press(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) {
    key(which, modifiers);
    ++m_steps;
  }
  void click(const char* name) {
    auto* button = child<QAbstractButton>(name);
    QVERIFY(button != nullptr && button->isEnabled() && !button->visibleRegion().isEmpty());
    QTest::mouseClick(button, Qt::LeftButton);
    ++m_steps;
  }
  /// Types names of files into the dialog that the next step opens, and Return.
  void typeNames(const QString& names) {
    QTimer::singleShot(0, this, [this, names] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return typeNames(names);
      auto* line = dialog->findChild<QLineEdit*>("fileNameEdit");
      line->setText(names);
      QTest::keyClick(line, Qt::Key_Return);
      m_steps += 2;
    });
  }
  /// Double-clicks a file of the current folder in the list of the dialog that the next step opens.
  void pickFile(const QString& name) {
    QTimer::singleShot(50, this, [this, name] {
      const auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return pickFile(name);
      QAbstractItemView* view = dialog->findChild<QListView*>("listView");
      if (!view->isVisible()) view = dialog->findChild<QTreeView*>("treeView");
      const QModelIndexList found =
          view->model()->match(view->model()->index(0, 0, view->rootIndex()), Qt::DisplayRole, name,
                               1, Qt::MatchExactly);
      if (found.isEmpty()) return pickFile(name);  // its folder is still being read
      view->scrollTo(found[0]);
      const QPoint at = view->visualRect(found[0]).center();
      QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, at);
      QTest::mouseDClick(view->viewport(), Qt::LeftButton, {}, at);
      ++m_steps;
    });
  }
  [[nodiscard]] bool hasPicture() const {
    const auto* view = child<ImageWidget>("pictureView");
    return !view->image().isNull() && view->notice().isEmpty() && view->isVisible();
  }

  int m_steps = 0;
};

void TestTasks::init() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  QSettings().clear();
  m_steps = 0;
}

/// From the home page: one key, and a double click on the file. The size of its hogels is nobody's
/// to say.
void TestTasks::theFirstPictureOfAForeignHogelImage() {
  writeTwoWalls("theirs.png", 40, 30, 24, 18);
  showWindow({1280, 800});
  QSettings().setValue("lastFolder", m_folder.path());
  pickFile("theirs.png");
  press(Qt::Key_O, Qt::ControlModifier | Qt::AltModifier);
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  QVERIFY((m_model->session().display.hogels == std::array{40, 30}));
  QCOMPARE(m_steps, 2);
}

/// The layout, Add, their names, Return, Make report.
void TestTasks::aReportOfTwoJpegs() {
  for (const char* name : {"q90.jpg", "q50.jpg"})
    writeImageFile(name, 64, 64, [name](int x, int y, int c) {
      return float((x * 5 + y * 3 + c * 40 + (name[1] == '5' ? 9 * (x % 3) : 0)) % 200 + 20) / 255;
    });
  start();
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  press(Qt::Key_5, Qt::ControlModifier | Qt::AltModifier);
  typeNames(
      QString("\"%1\" \"%2\"").arg(m_folder.filePath("q90.jpg"), m_folder.filePath("q50.jpg")));
  click("addTestButton");
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().contains("mean of the finite"),
                           patience);
  QCOMPARE(child<QTableView>("reportTable")->model()->rowCount(), 3);
  QCOMPARE(m_steps, 5);
}

/// The layout, Worst, and a click on a pixel: what differs is in the row, the pixel's code values
/// and its way through the display are in the line under the scene.
void TestTasks::theWorstViewAndWhy() {
  for (const char* name : {"q90.jpg", "q50.jpg"})
    writeImageFile(name, 64, 64, [name](int x, int y, int c) {
      return float((x * 5 + y * 3 + c * 40 + (name[1] == '5' ? 9 * (x % 3) : 0)) % 200 + 20) / 255;
    });
  start();
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  auto* dock = child<ReportDock>("reportPanel");
  dock->addTest(m_folder.filePath("q50.jpg"));
  QDir(m_folder.filePath("s-report")).removeRecursively();  // or it would ask to replace it
  child<QPushButton>("makeReportButton")->click();
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().contains("mean of the finite"),
                           patience);
  child<QAction>("stopComparingAction")->trigger();
  m_steps = 0;
  press(Qt::Key_5, Qt::ControlModifier | Qt::AltModifier);
  click("worstStateButton");
  const auto* table = child<QTableView>("reportTable");
  QCOMPARE(table->currentIndex().row(), 0);  // worst first
  QCOMPARE(child<QComboBox>("stateBox")->currentText(), table->currentIndex().data().toString());
  auto* view = child<ImageWidget>("pictureView");
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture() && !view->otherImage().isNull(), patience);
  QTest::mouseClick(view, Qt::LeftButton, {}, QPoint(view->width() / 4, view->height() / 2));
  ++m_steps;
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("sceneReadout")->text().contains("sees the display"),
                           patience);
  QCOMPARE(m_steps, 3);
}

/// The inspector's key, and a click on the pixel: it says why, in words.
void TestTasks::whyIsThisPixelBlack() {
  start();
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  m_model->edit("far away", [](Session& session) {  // the panel is small in the picture
    for (CameraState& state : session.cameras) state.camera.eye.z = 3;
  });
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  auto* view = child<ImageWidget>("pictureView");
  QTest::mouseClick(view, Qt::LeftButton, {}, view->rect().center() + QPoint(0, 100));
  ++m_steps;
  QTRY_VERIFY_WITH_TIMEOUT(
      child<QLabel>("inspectorVerdict")->text().startsWith("Black, outside the panel"), patience);
  QCOMPARE(m_steps, 2);
}

/// From the home page: the sample, then hogels, directions and field of view across through the
/// palette. All keys count, also letters and digits.
void TestTasks::aDisplayForTheRoomByKeysAlone() {
  showWindow({1280, 800});
  const auto* sample = child<QWidget>("roomSample");
  QVERIFY(sample != nullptr);
  // Where the focus is at first is the home page's to say.
  for (int k = 0; k < 6 && !sample->hasFocus(); ++k) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
    ++m_steps;
  }
  QVERIFY(sample->hasFocus());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  ++m_steps;
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  const auto type = [this](const QString& keys) {
    for (const QChar key : keys) {
      QTest::keyClick(QApplication::focusWidget(), key.toLatin1());
      ++m_steps;
    }
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    ++m_steps;
    QTest::qWait(50);  // the field gets the focus once it is laid out
  };
  for (const auto& [word, value] :
       {std::pair("ho", "64"), std::pair("dir", "24"), std::pair("fie", "50")}) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_P, Qt::ControlModifier);
    ++m_steps;
    type(word);
    type(value);
  }
  const DisplayParams& display = m_model->session().display;
  QCOMPARE(display.hogels[0], 64);
  QCOMPARE(display.directions[0], 24);
  QCOMPARE(display.fov[0], 50.0);
  QVERIFY2(m_steps <= 25, qPrintable(QString::number(m_steps)));
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
}

/// The key, and the picture is a wipe between the displays.
void TestTasks::theRoomOnADisplayOfTheLibrary() {
  openRoom();
  press(Qt::Key_1, Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier);
  const auto* view = child<ImageWidget>("pictureView");
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture() && view->hasTwo(), patience);
  QCOMPARE(view->titles(), QStringList({"The paper's display", "Display before"}));
  QVERIFY((m_model->session().display.hogels == std::array{512, 512}));
  QVERIFY(m_steps <= 2);
}

/// The workspace, the parameter, Sweep, the limit.
void TestTasks::aTolerance() {
  start();
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  press(Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
  child<QComboBox>("sweepParameter")->setCurrentText("Lens array · Rotation");
  ++m_steps;
  child<QScrollArea>("measureControls")->ensureWidgetVisible(child<QWidget>("sweepButton"));
  click("sweepButton");
  auto* limit = child<QDoubleSpinBox>("sweepLimit");
  QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("sweepButton")->text() == "S&weep", patience);
  limit->setValue(30);
  ++m_steps;
  const QString answer = child<QLabel>("sweepAnswer")->text();
  QVERIFY2(answer.startsWith("PSNR to the design ≥ 30"), qPrintable(answer));
  QCOMPARE(m_steps, 4);
}

/// The key, Return for hogels, Return for the name that is proposed.
void TestTasks::anExport() {
  QSettings().setValue("lastFolder", m_folder.path());
  start();
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  QFile::remove("hogels.png");
  QSettings().setValue("lastFolder", m_folder.path());
  acceptDialogs(2);
  press(Qt::Key_L, Qt::ControlModifier | Qt::AltModifier);
  QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists("hogels.png"), patience);
  QTRY_VERIFY_WITH_TIMEOUT(message().contains("Saved"), patience);
  QCOMPARE(m_steps, 3);
}

/// In the report's workspace: the menu and a metric.
void TestTasks::anotherMetric() {
  start();
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  child<QAction>("layoutReportAction")->trigger();
  QMenu* menu = child<QToolButton>("metricsButton")->menu();
  QVERIFY(!child<QWidget>("metricsButton")->visibleRegion().isEmpty());
  Q_EMIT menu->aboutToShow();
  ++m_steps;
  QVERIFY(!menu->actions().isEmpty() && menu->actions().front()->isEnabled());
  menu->actions().front()->trigger();
  ++m_steps;
  QCOMPARE(m_model->session().metrics.size(), std::size_t(1));
  QCOMPARE(m_steps, 2);
}

int main(int argc, char** argv) {
  return runWindowTest<TestTasks>(argc, argv);
}
#include "test_tasks.moc"
