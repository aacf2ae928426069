// SPDX-License-Identifier: BSD-3-Clause
// Drives the dock "Measure" of the real window: closed forms at once, the engine's figures when
// edits rest, the button that fits the content, and undo.
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QUndoStack>

#include "chart/depth_budget_chart.h"
#include "gui/docks/measure_widget.h"
#include "gui/view/image_widget.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

class TestMeasureDock : public WindowTest {
  Q_OBJECT

 private:
  QString status() const { return child<QLabel>("measureStatus")->text(); }
  QPushButton* fit() const { return child<QPushButton>("fitContentButton"); }
  QImage picture(const char* plot) const { return child<QWidget>(plot)->grab().toImage(); }
  double depth() const {
    return (*m_model->session().lightField.content.find<std::vector<double>>("position"))[2];
  }
  void editDisplay(const std::function<void(DisplayParams&)>& change) {
    Session content = m_model->session();
    change(content.display);
    m_model->setContent(content);
  }

 private Q_SLOTS:
  /// A mesh that stands far in front of the panel and behind it, on a display of few directions.
  void init() {
    writeFile(m_folder.filePath("a.obj"),
              "v -1 -1 -1 1 0 0\nv 1 -1 -1 1 0 0\nv 1 1 -1 0 1 0\nv -1 1 -1 0 1 0\n"
              "v -0.3 -0.3 1 0 0 1\nv 0.3 -0.3 1 0 0 1\nv 0 0.3 1 0 0 1\nf 1 2 3 4\nf 5 6 7\n");
    showWindow({1400, 800});
    QVERIFY(files(*m_window).open(m_folder.filePath("a.obj")));
    QTRY_VERIFY_WITH_TIMEOUT(!child<ImageWidget>("pictureView")->image().isNull(), patience);
    editDisplay([](DisplayParams& display) {
      display.hogels = {64, 64};
      display.directions = {16, 16};
    });
    QTest::keyClick(m_window.get(), Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(child<QWidget>("measureView")->isVisible());
  }
  void cleanup() { m_window.reset(); }

  void simulatesWhenEditsRest() {
    QTRY_VERIFY2_WITH_TIMEOUT(status().startsWith("Simulated; contrast differs"),
                              qPrintable(status()), patience);
    QVERIFY(status().section(' ', -1).toDouble() < 0.02);
    const QImage contrast = picture("contrastPlot");
    const QImage zone = picture("zonePlot");
    // An edit is followed at once.
    editDisplay([](DisplayParams& display) { display.fov = {30, 30}; });
    QCOMPARE(status(), QString("Closed forms"));
    QVERIFY(picture("contrastPlot") != contrast);
    QVERIFY(picture("zonePlot") != zone);
    QTRY_VERIFY_WITH_TIMEOUT(status().startsWith("Simulated"), patience);
  }

  void fitsTheContent() {
    QTRY_VERIFY_WITH_TIMEOUT(fit()->isEnabled(), patience);
    const double before = depth();
    const QString inside = fit()->text();
    QVERIFY2(fit()->toolTip().startsWith("scale "), qPrintable(fit()->toolTip()));
    QTest::mouseClick(fit(), Qt::LeftButton);
    QVERIFY(depth() != before);
    const auto percent = [](const QString& text) {
      return text.section('(', 1, 1).section(' ', 0, 0).toInt();
    };
    QTRY_VERIFY2_WITH_TIMEOUT(percent(fit()->text()) >= 95, qPrintable(fit()->text()), patience);
    QVERIFY(percent(inside) < 95);
    QTRY_COMPARE_WITH_TIMEOUT(fit()->toolTip(), QString("The content fits already"), patience);
    QVERIFY(!fit()->isEnabled());
    m_model->undoStack()->undo();
    QCOMPARE(depth(), before);
  }

  /// Nothing is worked out while the dock is hidden, and a hidden one stops.
  void restsWhileHidden() {
    child<QDockWidget>("measureDock")->hide();
    editDisplay([](DisplayParams& display) { display.fov = {40, 40}; });
    const QString before = status();
    QTest::qWait(800);
    QCOMPARE(status(), before);
    child<QDockWidget>("measureDock")->show();
    QTRY_VERIFY_WITH_TIMEOUT(status().startsWith("Simulated"), patience);
  }

  void saysWhatIsWrong() {
    CameraState behind = m_model->current();
    behind.camera.eye.z = -1;
    behind.camera.lookat.z = -2;
    m_model->setCurrent(behind);
    QTRY_VERIFY2_WITH_TIMEOUT(status().contains("its eye is not in front of the panel"),
                              qPrintable(status()), patience);
    QVERIFY(!fit()->isEnabled());
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestMeasureDock>(argc, argv);
}
#include "test_measure_dock.moc"
