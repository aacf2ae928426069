// SPDX-License-Identifier: BSD-3-Clause
// Drives the real window into states in which its image is not right: what stands on it then,
// that it cannot be saved, and that nothing of another session is shown.
#include <QComboBox>
#include <QDeadlineTimer>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QUndoStack>

#include "core/engine/fast_simulation.h"
#include "gui/docks/report_dock.h"
#include "gui/scene/display_scene.h"
#include "gui/scene/scene_controller.h"
#include "gui/view/image_commands.h"
#include "gui/view/image_widget.h"
#include "gui/view/view_worker.h"
#include "gui/widgets/colours.h"
#include "io/documents/session_file.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "tests/core/rendered.h"
#include "tests/gui/shown_image.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

namespace {

const QColor violet(255, 0, 255);  ///< is in no other thing that the scene draws
constexpr int enoughToSee = 100;   ///< pixels

}  // namespace

class TestNotices : public WindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup() { m_window.reset(); }
  void withoutASession();
  void openingDropsTheImage();
  void theSceneForgetsTheSessionBefore();
  void aHogelImageSaysWhatItNeeds();
  void aPathThatCannotBeReadAndItsUndo();
  void aStateThatCannotBeRendered();
  void aNoticeIsPaintedOnTheDimmedImage();
  void theCuresAreButtons();
  void allEditsSinceThePictureAreUndone();
  void aReportGoesOn();
  void aBlackPictureSaysWhatHelps();
  void aDarkPictureIsStretched();
  void thePictureSaysWhatItIs();
  void theUnitIsComparedWithItsDesign();

 private:
  QRect cures() const {
    auto* undo = view()->findChild<QPushButton*>("undoActionCure");
    return undo ? undo->parentWidget()->geometry() : QRect();
  }
  ImageWidget* view() const { return child<ImageWidget>("pictureView"); }
  ImageCommands* commands() const { return m_window->findChild<ImageCommands*>(); }
  QAction* action(const char* name) const { return child<QAction>(name); }
  DisplayScene& scene() const { return m_window->findChild<SceneController*>()->scene(); }
  QImage drawn() const { return m_window->findChild<VtkWidget*>()->image(); }
  bool isRight() const {
    return view()->notice().isEmpty() && action("savePictureAction")->isEnabled() &&
           action("copyPictureAction")->isEnabled();
  }
  /// Nothing can be taken for the right image.
  bool isWrong(const QString& why) const {
    return view()->notice().contains(why) && !action("savePictureAction")->isEnabled() &&
           !action("copyPictureAction")->isEnabled() && !commands()->saveImage("saved.png") &&
           !QFileInfo::exists("saved.png");
  }
  Image expected() const {
    return rendered(loadViewSource(m_model->session(), {}).job(m_model->current()));
  }
  /// After each step of the events that come until the light field was found not to be readable,
  /// and a little longer.
  template <class Condition>
  bool staysTrue(Condition condition) const {
    const QDeadlineTimer deadline(patience);
    const auto isOver = [&] {
      return view()->notice().contains("cannot be read") || deadline.hasExpired();
    };
    for (int turn = 0; turn < 50 || !isOver(); ++turn) {
      if (!condition()) return false;
      QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    }
    return true;
  }
  void openSmall() {
    QVERIFY(files(*m_window).open("s.json"));
    QTRY_VERIFY_WITH_TIMEOUT(isRight(), patience);
  }
  /// The same states before a light field that is not there.
  void openMissing() {
    writeFile("missing.json", contentOf("s.json").replace("a.png", "missing.png"));
    QVERIFY(files(*m_window).open("missing.json"));
  }
  /// Under a pointer that has just come to the middle of the right half.
  QString readOut() const {
    const QPointF place(0.75 * view()->width(), 0.5 * view()->height());
    QMouseEvent event(QEvent::MouseMove, place, view()->mapToGlobal(place), Qt::NoButton,
                      Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(view(), &event);
    return view()->readOut();
  }
  void typeFile(const QString& file) {
    auto* line = editor<QLineEdit>("lightFieldArea", "file");
    line->setText(file);
    QTest::keyClick(line, Qt::Key_Return);
  }
};

void TestNotices::init() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  writeSmallSession();
  showWindow({1000, 700});
}

void TestNotices::withoutASession() {
  const QString hint("No view yet: open a session (Ctrl+O)");
  QVERIFY(isWrong(hint));
  QVERIFY(!files(*m_window).open("none.json"));
  QVERIFY(isWrong(hint));
  openSmall();
  openMissing();
  QTRY_VERIFY_WITH_TIMEOUT(isWrong("missing.png"), patience);
  QVERIFY(!view()->notice().contains("No view yet"));
}

/// Also where the last image of the session before is still on its way.
void TestNotices::openingDropsTheImage() {
  openSmall();
  for (const bool hasEdit : {false, true}) {
    if (hasEdit) {
      openSmall();
      editor<QDoubleSpinBox>("cameraArea", "eye.0")->setValue(0.05);
      QTest::qSleep(500);  // it is made, but nobody has heard of it
    }
    openMissing();
    QVERIFY2(isWrong("Reading missing.png"), qPrintable(view()->notice()));
    QVERIFY(staysTrue([this] { return view()->image().isNull(); }));
    QVERIFY(isWrong("missing.png: there is no such file"));
    QVERIFY(view()->shownImage().isNull());
    QVERIFY(!view()->grab().toImage().isNull());
  }
  openSmall();  // and the right one comes back
  QVERIFY(equals(view()->image(), expected()));
}

/// Its image on the panel, and its views on the frusta.
void TestNotices::theSceneForgetsTheSessionBefore() {
  writeImageFile("a.png", 64, 64, [](int, int, int channel) { return channel == 1 ? 0.0F : 1.0F; });
  openSmall();
  key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
  QTRY_VERIFY_WITH_TIMEOUT(scene().panel().gridLines() == 0, patience);
  QTRY_VERIFY_WITH_TIMEOUT(count(drawn(), violet) > enoughToSee, patience);
  openMissing();
  QVERIFY(staysTrue(
      [this] { return scene().panel().gridLines() > 0 && count(drawn(), violet) < enoughToSee; }));
  QVERIFY(isWrong("cannot be read"));
}

void TestNotices::aHogelImageSaysWhatItNeeds() {
  openSmall();
  m_model->openNew(sessionAround("a.png"));  // whose borders are as any others
  QTRY_VERIFY_WITH_TIMEOUT(isWrong("give display.hogels and display.directions"), patience);
  for (const char* name : {"hogels.0", "hogels.1"})
    editor<QSpinBox>("displayArea", name)->setValue(16);
  for (const char* name : {"directions.0", "directions.1"})
    editor<QSpinBox>("displayArea", name)->setValue(4);
  QTRY_VERIFY_WITH_TIMEOUT(isRight(), patience);
  QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), expected()), patience);  // a coarse one first
}

void TestNotices::aPathThatCannotBeReadAndItsUndo() {
  openSmall();
  const QImage before = view()->image().copy();
  typeFile("elsewhere.png");
  QVERIFY(isWrong("Reading elsewhere.png"));
  QTRY_VERIFY_WITH_TIMEOUT(isWrong("elsewhere.png: there is no such file"), patience);
  editor<QDoubleSpinBox>("cameraArea", "eye.0")->setValue(0.05);  // nothing to render it from
  m_model->setCurrentIndex(1);
  QTest::qWait(100);
  QVERIFY(isWrong("elsewhere.png: there is no such file"));
  m_model->setCurrentIndex(0);
  m_model->undoStack()->undo();
  m_model->undoStack()->undo();
  QTRY_VERIFY_WITH_TIMEOUT(isRight(), patience);
  QCOMPARE(view()->image(), before);
  typeFile("elsewhere.png");
  typeFile("a.png");  // the newer one wins, whatever the older one ends with
  QTRY_VERIFY_WITH_TIMEOUT(isRight(), patience);
  QTest::qWait(100);
  QVERIFY(isRight());
}

/// With the states' views in the scene, which cannot be rendered either; and while two light fields
/// are compared.
void TestNotices::aStateThatCannotBeRendered() {
  openSmall();
  editor<QSpinBox>("cameraArea", "res.0")->setValue(400);  // the scene's is smaller
  key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
  QTRY_COMPARE_WITH_TIMEOUT(view()->image().width(), 400, patience);
  auto* depth = editor<QDoubleSpinBox>("cameraArea", "eye.2");
  for (const bool hasOther : {false, true}) {
    if (hasOther) {
      writeImageFile("b.png", 64, 64, [](int x, int y, int) { return float((x ^ y) % 64) / 64; });
      QVERIFY(commands()->compareWith("b.png"));
      QTRY_VERIFY_WITH_TIMEOUT(!view()->otherImage().isNull() && isRight(), patience);
    }
    const QImage before = view()->shownImage();
    depth->setValue(0);  // the eye is the look-at point
    QTRY_VERIFY_WITH_TIMEOUT(isWrong("lookat: is the eye itself"), patience);
    QCOMPARE(view()->notice().contains("stop comparing"), hasOther);
    QCOMPARE(readOut(), QString());
    child<QComboBox>("stateBox")->setCurrentIndex(1);
    QTRY_VERIFY_WITH_TIMEOUT(isRight(), patience);
    child<QComboBox>("stateBox")->setCurrentIndex(0);
    QTRY_VERIFY_WITH_TIMEOUT(isWrong("lookat: is the eye itself"), patience);
    m_model->undoStack()->undo();
    QTRY_VERIFY_WITH_TIMEOUT(isRight(), patience);
    QCOMPARE(view()->shownImage(), before);
    QVERIFY(!readOut().isEmpty());
  }
}

void TestNotices::aNoticeIsPaintedOnTheDimmedImage() {
  openSmall();
  view()->setFixedSize(300, 400);
  const QImage before = view()->grab().toImage();
  typeFile("/a/path/that/is/too/long/for/one/line/of/the/view/at/its/least/width/none.png");
  QTRY_VERIFY_WITH_TIMEOUT(isWrong("none.png: there is no such file"), patience);
  const QImage after = view()->grab().toImage();
  QCOMPARE(after.size(), before.size());
  const int ground = qGray(tokens().canvas.rgb());
  const auto isText = [](QRgb pixel) {
    return std::abs(qGray(pixel) - qGray(tokens().text.rgb())) < 40;
  };
  int white = 0;
  int dimmed = 0;
  for (int y = 0; y < after.height(); ++y)
    for (int x = 0; x < after.width(); ++x) {
      const bool isWhite = isText(after.pixel(x, y)) && !cures().contains(x, y);
      white += isWhite ? 1 : 0;
      const int rest = std::abs(qGray(after.pixel(x, y)) - ground);
      dimmed += rest < std::abs(qGray(before.pixel(x, y)) - ground) / 2 + 2 ? 1 : 0;
      QVERIFY2(!isWhite || (x > 3 && x < after.width() - 4), "the text is cut off");
    }
  QVERIFY2(white > enoughToSee, qPrintable(QString::number(white)));
  QVERIFY2(dimmed > after.width() * after.height() / 2, qPrintable(QString::number(dimmed)));
}

void TestNotices::theCuresAreButtons() {
  openSmall();
  QVERIFY(!child<QPushButton>("undoActionCure"));
  typeFile("none.png");
  QTRY_VERIFY_WITH_TIMEOUT(isWrong("none.png: there is no such file"), patience);
  auto* undo = child<QPushButton>("undoActionCure");
  QVERIFY(undo);
  QTRY_VERIFY_WITH_TIMEOUT(undo->isVisible(), patience);
  QVERIFY(view()->rect().contains(cures()));
  QVERIFY(child<QPushButton>("openActionCure"));
  QVERIFY(!child<QPushButton>("stopComparingActionCure")->isVisible());  // nothing is compared
  const QColor frame = view()->grab().toImage().pixelColor(0, 0);
  QCOMPARE(frame, tokens().error);
  QTest::mouseClick(undo, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(isRight(), patience);
  QVERIFY(!child<QPushButton>("undoActionCure"));
  QVERIFY(view()->grab().toImage().pixelColor(0, 0) != tokens().error);
}

/// After a wrong edit and others the last one is not what has to be undone.
void TestNotices::allEditsSinceThePictureAreUndone() {
  openSmall();
  const Session before = m_model->session();
  Session content = before;
  content.display.directions = {5, 5};
  m_model->setContent(content);
  content.sampling.tolerance = 1;
  m_model->setContent(content);
  QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("undoToPictureActionCure"), patience);
  QVERIFY(isWrong(""));
  auto* undo = child<QPushButton>("undoToPictureActionCure");
  QTRY_VERIFY_WITH_TIMEOUT(undo->isVisible(), patience);
  QTest::mouseClick(undo, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(isRight(), patience);
  QVERIFY(m_model->session() == before);
  content.display.directions = {5, 5};
  m_model->setContent(content);  // one edit: the usual button is enough
  QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("undoActionCure"), patience);
  QVERIFY(!child<QPushButton>("undoToPictureActionCure"));
}

/// It has a light field of its own; and what it says of its tests is not about the image.
void TestNotices::aReportGoesOn() {
  openSmall();
  writeImageFile("b.png", 64, 64, [](int x, int y, int) { return float((x ^ y) % 64) / 64; });
  writeImageFile("tiny.png", 4, 4, [](int, int, int) { return 0.5F; });
  auto* dock = m_window->findChild<ReportDock*>();
  auto* note = child<QLabel>("reportNote");
  action("reportDockAction")->trigger();
  dock->addTest("b.png");
  QTest::mouseClick(child<QPushButton>("makeReportButton"), Qt::LeftButton);
  typeFile("elsewhere.png");
  QTRY_VERIFY_WITH_TIMEOUT(note->text().contains("mean of the finite"), patience);
  QTRY_VERIFY_WITH_TIMEOUT(isWrong("elsewhere.png: there is no such file"), patience);
  m_model->undoStack()->undo();
  QTRY_VERIFY_WITH_TIMEOUT(isRight(), patience);
  dock->addTest("tiny.png");
  QTest::mouseClick(child<QPushButton>("makeReportButton"), Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(note->text().contains("tiny.png"), patience);
  QVERIFY(isRight());
}

/// An eye that has walked past the panel sees nothing of it; one step brings it back.
void TestNotices::aBlackPictureSaysWhatHelps() {
  openSmall();
  QVERIFY(view()->remark().isEmpty());
  editor<QDoubleSpinBox>("cameraArea", "eye.2")->setValue(-0.7);
  QTRY_VERIFY_WITH_TIMEOUT(view()->remark().contains("No pixel sees the panel"), patience);
  QVERIFY(isRight());  // it is what the state sees
  QVERIFY(view()->findChild<QPushButton*>("maskActionCure")->isVisible());
  view()->findChild<QPushButton*>("lookAtPanelActionCure")->click();
  QTRY_VERIFY_WITH_TIMEOUT(view()->remark().isEmpty(), patience);
  QVERIFY(m_model->current().camera.eye.z > 0);
  m_model->undoStack()->undo();
  QCOMPARE(m_model->current().camera.eye.z, -0.7);
}

void TestNotices::aDarkPictureIsStretched() {
  writeImageFile("a.png", 64, 64, [](int x, int, int) { return float(x % 4) / 255; });
  openSmall();
  QTRY_VERIFY_WITH_TIMEOUT(view()->remark().contains("its lightest pixel has 3 of 255"), patience);
  view()->findChild<QPushButton*>("stretchActionCure")->click();
  QCOMPARE(view()->gain(), 85.0);
  QVERIFY(view()->remark().isEmpty());
  QCOMPARE(commands()->deviations(), QStringList("× 85"));
}

/// A unit's errors, an eye of two, and a method are no longer seen only in the menus.
void TestNotices::thePictureSaysWhatItIs() {
  openSmall();
  const auto tag = [this] { return view()->tag(); };
  QVERIFY2(tag().isEmpty(), qPrintable(tag()));
  QVERIFY(commands()->deviations().isEmpty());
  Session built = m_model->session();
  built.twin.lensArray.rotation = 0.1;
  m_model->setContent(built);
  QTRY_COMPARE_WITH_TIMEOUT(tag(), QString("as built"), patience);
  action("asBuiltAction")->trigger();
  QTRY_COMPARE_WITH_TIMEOUT(tag(), QString("as designed"), patience);
  CameraState head = m_model->current();
  head.stereo.ipd = 0.06;
  m_model->setCurrent(head);
  action("leftEyeAction")->trigger();
  QTRY_COMPARE_WITH_TIMEOUT(tag(), QString("as designed · left eye"), patience);
  QVERIFY(commands()->deviations().isEmpty());
  action("anaglyphAction")->trigger();
  QTRY_COMPARE_WITH_TIMEOUT(commands()->deviations(), QStringList("both eyes"), patience);
}

void TestNotices::theUnitIsComparedWithItsDesign() {
  openSmall();
  QVERIFY(!action("compareDesignedAction")->isEnabled());
  Session built = m_model->session();
  built.twin.lensArray.rotation = 1;
  m_model->setContent(built);
  QTRY_COMPARE_WITH_TIMEOUT(view()->tag(), QString("as built"), patience);
  action("asBuiltAction")->trigger();
  action("compareDesignedAction")->trigger();
  QVERIFY(action("asBuiltAction")->isChecked());
  QTRY_VERIFY_WITH_TIMEOUT(view()->hasTwo(), patience);
  QCOMPARE(view()->titles(), QStringList({"As built", "As designed"}));
  const ViewSource source = loadViewSource(built, {});
  ViewSource design = source;
  design.twin = nullptr;
  const auto shows = [this](const QImage& image, const ViewSource& wanted) {
    return equals(image, rendered(wanted.job(m_model->current())));
  };
  QTRY_VERIFY_WITH_TIMEOUT(shows(view()->image(), source), patience);
  QVERIFY(shows(view()->otherImage(), design) && view()->image() != view()->otherImage());
  action("stopComparingAction")->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(!view()->hasTwo(), patience);
}

int main(int argc, char** argv) {
  return runWindowTest<TestNotices>(argc, argv);
}
#include "test_notices.moc"
