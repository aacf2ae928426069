// SPDX-License-Identifier: BSD-3-Clause
// Drives the list of states in the real window: chosen, renamed, dragged, deleted, dropped.
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QToolButton>

#include "gui/docks/state_dock.h"
#include "gui/session/state_commands.h"
#include "tests/gui/docks_test.h"

using namespace hogelscope;

class TestStateDock : public DocksTest {
  Q_OBJECT

 private:
  void clickRow(int row, Qt::KeyboardModifiers modifiers = {}) {
    const QRect box = list()->visualRect(at(row));
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, modifiers, box.center());
  }
  void press(const char* action) {
    for (auto* button : child<QWidget>("statesDock")->findChildren<QToolButton*>())
      if (button->defaultAction() && button->defaultAction()->objectName() == action)
        return QTest::mouseClick(button, Qt::LeftButton);
    QFAIL("no such button");
  }
  /// Drops the selected rows before or behind a row, as the list does where the pointer is in the
  /// upper or the lower half of it. The window system's own drag needs a real pointer.
  void dropRows(int to, double share) {
    QAbstractItemModel* model = list()->model();
    const std::unique_ptr<QMimeData> rows(
        model->mimeData(list()->selectionModel()->selectedRows()));
    model->dropMimeData(rows.get(), Qt::MoveAction, share < 0.5 ? to : to + 1, 0, {});
  }
  void drop(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    auto* dock = m_window->findChild<StateDock*>();
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(dock, &enter);
    if (!enter.isAccepted()) return;
    QDropEvent dropped({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(dock, &dropped);
  }

 private Q_SLOTS:
  void init() { showWindow(); }
  void cleanup() { m_window.reset(); }

  void statesAreListedAndChosen() {
    openSmall();
    QCOMPARE(count(), 6);
    clickRow(3);
    QCOMPARE(m_model->currentIndex(), std::size_t(3));
    QTest::keyClick(list(), Qt::Key_Down);
    QCOMPARE(m_model->currentIndex(), std::size_t(4));
    child<QComboBox>("stateBox")->setCurrentIndex(1);
    QCOMPARE(currentRow(), 1);
    press("addStateAction");
    QCOMPARE(names().back(), QString("View"));
    QCOMPARE(currentRow(), 6);
    press("moveUpAction");
    QCOMPARE(names()[5], QString("View"));
    press("duplicateAction");
    QCOMPARE(names()[6], QString("View 2"));
    m_model->undoStack()->undo();
    QCOMPARE(count(), 7);
  }

  void statesAreRenamedInPlace() {
    openSmall();
    child<QDockWidget>("statesDock")->hide();
    const auto type = [this](const QString& name) {
      child<QAction>("renameAction")->trigger();
      QTRY_VERIFY_WITH_TIMEOUT(list()->isVisible() && list()->findChild<QLineEdit*>() != nullptr,
                               patience);
      auto* line = list()->findChild<QLineEdit*>();
      line->setText(name);
      QTest::keyClick(line, Qt::Key_Return);
      QTRY_VERIFY_WITH_TIMEOUT(list()->findChild<QLineEdit*>() == nullptr, patience);
    };
    type("wide");
    QCOMPARE(names().front(), QString("wide"));
    QCOMPARE(m_model->current().camera.name, std::string("wide"));
    QCOMPARE(child<QComboBox>("stateBox")->itemText(0), QString("wide"));
    type("Fig 2");
    QVERIFY2(message().contains("another state's already"), qPrintable(message()));
    QCOMPARE(names().front(), QString("wide"));
    type("a/b");
    QVERIFY(message().startsWith("Error"));
    QCOMPARE(names().front(), QString("wide"));
  }

  void statesAreDragged() {
    openSmall();
    clickRow(2);
    dropRows(0, 0.2);
    QTRY_COMPARE_WITH_TIMEOUT(
        names(), QStringList({"Fig 3", "Fig 1", "Fig 2", "Fig 4", "Fig 5", "Fig 6"}), patience);
    QCOMPARE(m_model->currentIndex(), std::size_t(0));  // still Fig 3
    QCOMPARE(currentRow(), 0);
    QCOMPARE(m_model->undoStack()->count(), 1);
    QVERIFY(m_model->undoStack()->undoText().startsWith("Move "));
    m_model->undoStack()->undo();
    QCOMPARE(names().front(), QString("Fig 1"));
    QCOMPARE(m_model->current().camera.name, std::string("Fig 3"));
    // Several; the current one is none of them.
    clickRow(0);
    clickRow(1, Qt::ControlModifier);
    QTest::qWait(1100);  // else it is one edit with the next
    dropRows(4, 0.8);
    QTRY_COMPARE_WITH_TIMEOUT(
        names(), QStringList({"Fig 3", "Fig 4", "Fig 5", "Fig 1", "Fig 2", "Fig 6"}), patience);
    QCOMPARE(m_model->current().camera.name, std::string("Fig 2"));
    QCOMPARE(count(), 6);
    // To where it is: nothing happens.
    const int steps = m_model->undoStack()->count();
    clickRow(3);
    dropRows(3, 0.9);
    QCOMPARE(m_model->undoStack()->count(), steps);
    QCOMPARE(names()[3], QString("Fig 1"));
  }

  void severalStatesAreDeletedAndSaved() {
    openSmall();
    clickRow(1);
    clickRow(3, Qt::ControlModifier);
    clickRow(5, Qt::ControlModifier);
    auto* commands = m_window->findChild<StateCommands*>();
    const QString file = m_folder.filePath("some.json");
    QVERIFY(commands->saveStatesAs(file));
    const Session saved = loadSession(file.toStdString());
    QCOMPARE(saved.cameras.size(), std::size_t(3));
    QVERIFY(saved.cameras[1] == m_model->session().cameras[3]);
    QVERIFY(saved.display == m_model->session().display);
    QVERIFY(commands->appendStatesTo(file));
    QCOMPARE(loadSession(file.toStdString()).cameras.size(), std::size_t(6));
    press("removeAction");
    QCOMPARE(names(), QStringList({"Fig 1", "Fig 3", "Fig 5"}));
    QCOMPARE(list()->selectionModel()->selectedRows().size(), 1);
    m_model->undoStack()->undo();
    QCOMPARE(count(), 6);
    list()->selectAll();
    press("removeAction");
    QCOMPARE(count(), 6);
    QVERIFY(message().contains("a session needs one"));
  }

  /// One undo takes all back; names stay different, and the form shows the current state.
  void severalStatesAreEdited() {
    openSmall();
    const Session before = m_model->session();
    clickRow(1);
    clickRow(4, Qt::ControlModifier);
    clickRow(3, Qt::ControlModifier);
    editor<QDoubleSpinBox>("cameraArea", "eye.1")->setValue(0.125);
    for (std::size_t k = 0; k < before.cameras.size(); ++k) {
      CameraState expected = before.cameras[k];
      if (k == 1 || k == 3 || k == 4) expected.camera.eye.y = 0.125;
      QVERIFY2(m_model->session().cameras[k] == expected, qPrintable(QString::number(k)));
    }
    QCOMPARE(list()->selectionModel()->selectedRows().size(), 3);
    QCOMPARE(m_model->undoStack()->undoText(), QString("Change eye of 3 states"));
    QCOMPARE(m_model->undoStack()->count(), 1);
    m_model->undoStack()->undo();
    QVERIFY(m_model->session() == before);

    clickRow(1);
    clickRow(4, Qt::ControlModifier);
    auto* name = editor<QLineEdit>("cameraArea", "name");
    name->setText("mine");
    QTest::keyClick(name, Qt::Key_Return);
    QCOMPARE(names(), QStringList({"Fig 1", "Fig 2", "Fig 3", "Fig 4", "mine", "Fig 6"}));
    m_model->undoStack()->undo();

    clickRow(1);
    clickRow(4, Qt::ControlModifier);
    child<QCheckBox>("calibrated")->setChecked(true);
    for (const std::size_t k : {1, 4}) {
      const CameraState& state = m_model->session().cameras[k];
      QCOMPARE(state.intrinsics.fx, Camera(before.cameras[k].camera).focalLength().x);
    }
    m_model->undoStack()->undo();
    QVERIFY(m_model->session() == before);

    clickRow(2);
    editor<QDoubleSpinBox>("cameraArea", "eye.1")->setValue(0.25);
    QVERIFY(m_model->session().cameras[1] == before.cameras[1]);
    QCOMPARE(m_model->undoStack()->undoText(), QString("Change eye"));
  }

  /// A picture comes for each row in sight, it is that of the state, and it follows edits.
  void rowsHavePicturesOfTheirStates() {
    openSmall();
    const auto picture = [this](int row) { return at(row).data(Qt::UserRole + 1).value<QImage>(); };
    for (int row = 0; row < 3; ++row) QTRY_VERIFY_WITH_TIMEOUT(!picture(row).isNull(), patience);
    const QImage first = picture(0);
    QCOMPARE(first.size(), QSize(90, 80));
    // Not exactly the view, because it is made quickly: the same light and dark places.
    const auto differs = [](const QImage& a, const QImage& b) {
      double sum = 0;
      for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
          sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
      return sum / (a.width() * a.height());
    };
    QVERIFY2(differs(first, view()) < 25, qPrintable(QString::number(differs(first, view()))));
    QVERIFY(differs(first, view().mirrored()) > 2 * differs(first, view()));
    m_model->edit("away", [](Session& session) { session.cameras[0].camera.eye.z = 3; });
    QTRY_VERIFY_WITH_TIMEOUT(picture(0) != first, patience);
    const QImage other = picture(0);
    clickRow(0);
    press("moveDownAction");
    QCOMPARE(picture(1), other);  // it goes with its state
  }

  void rowsSayWhereTheEyeIs() {
    openSmall();
    m_model->edit("aside", [](Session& session) {
      session.cameras[1].camera.eye = {-0.3, 0, 0.3};
      session.cameras[1].distortion = {};
      session.cameras[1].psf.windowSize = 1;
    });
    QCOMPARE(at(0).data(Qt::UserRole).toString(), QString("0.56 m · 0° · lens · σ 0.67"));
    QCOMPARE(at(1).data(Qt::UserRole).toString(), QString("0.42 m · −45°"));
  }

  /// Hiding the current state does not choose another one.
  void aFilterHidesStates() {
    openSmall();
    auto* filter = child<QLineEdit>("stateFilter");
    filter->setFocus();
    QTest::keyClicks(filter, "fig 3");
    QCOMPARE(names(), QStringList("Fig 3"));
    QCOMPARE(child<QLabel>("stateCount")->text(), QString("1 of 6"));
    QCOMPARE(m_model->currentIndex(), std::size_t(0));
    QCOMPARE(m_model->marked(), std::vector<std::size_t>{0});
    QTest::keyClick(filter, Qt::Key_Down);
    QVERIFY(list()->hasFocus());
    clickRow(0);
    QCOMPARE(m_model->currentIndex(), std::size_t(2));
    child<QAction>("renameAction")->trigger();
    filter->clear();
    QCOMPARE(count(), 6);
    QCOMPARE(currentRow(), 2);
    m_window->findChild<StateDock*>()->showPsnr({30, 20, std::nan(""), HUGE_VAL, 25, 40}, {});
    filter->setText("psnr < 30");
    QCOMPARE(names(), QStringList({"Fig 2", "Fig 5"}));
    QCOMPARE(at(0).data(Qt::UserRole + 3).toDouble(), 20.0);
    QCOMPARE(at(0).data(Qt::UserRole + 4).toDouble(), 0.0);
    QCOMPARE(at(1).data(Qt::UserRole + 4).toDouble(), 0.25);
    clickRow(1);
    press("removeAction");
    QCOMPARE(m_model->session().cameras.size(), std::size_t(5));
    QCOMPARE(names(), QStringList());  // the values were of other states
    filter->clear();
    QCOMPARE(names(), QStringList({"Fig 1", "Fig 2", "Fig 3", "Fig 4", "Fig 6"}));
    filter->setText("lens");
    for (const QString& name : names()) {
      const auto found = std::ranges::find_if(m_model->session().cameras, [&](const auto& state) {
        return state.camera.name == name.toStdString();
      });
      QVERIFY(found->distortion != DistortionParams{});
    }
    QCOMPARE(count(), 3);
  }

  void droppedSessionsGiveTheirStates() {
    openSmall();
    drop(sampleFile);
    QCOMPARE(count(), 12);
    QCOMPARE(names()[6], QString("Fig 1 2"));
    drop(m_folder.filePath("none.json"));
    QVERIFY(message().contains("none.json"));
    drop("/etc/hosts");
    QCOMPARE(count(), 12);
  }

  /// 300 states: what a step through them costs is not allowed to grow with the square.
  void manyStates() {
    openSmall();
    m_model->changeStates("many", [](Session& session) {
      CameraState state = session.cameras[0];
      for (int k = 0; k < 294; ++k) {
        state.camera.name = "s" + std::to_string(k);
        session.cameras.push_back(state);
      }
      return std::size_t(0);
    });
    QCOMPARE(count(), 300);
    for (int row = 0; row < 300; row += 10) {
      list()->setCurrentIndex(at(row));
      QCOMPARE(m_model->currentIndex(), std::size_t(row));
    }
    list()->selectAll();
    clickRow(currentRow(), Qt::ControlModifier);
    press("removeAction");
    QCOMPARE(count(), 1);
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestStateDock>(argc, argv);
}
#include "test_state_dock.moc"
