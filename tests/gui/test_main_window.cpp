// SPDX-License-Identifier: BSD-3-Clause
// Drives the real window: opens the sample session, edits fields, looks at what it shows.
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStatusBar>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

#include "core/engine/fast_simulation.h"
#include "core/engine/scaled_view.h"
#include "gui/docks/tradeoff_widget.h"
#include "gui/scene/vtk_widget.h"
#include "gui/session/state_commands.h"
#include "gui/view/image_widget.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/task.h"
#include "io/documents/session_file.h"
#include "io/scene/view_source.h"
#include "tests/core/rendered.h"
#include "tests/gui/patience.h"
#include "tests/gui/shown_image.h"
#include "tests/gui/window_files.h"

using namespace hogelscope;

namespace {

const QString sampleFile = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/tests/data/table1.json");

}  // namespace

class TestMainWindow : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<MainWindow> m_window;
  QTemporaryDir m_folder;

  const QImage& view() const { return m_window->findChild<ImageWidget*>("pictureView")->image(); }
  template <class T>
  T* editor(const char* dock, const char* name) const {
    return m_window->findChild<QWidget*>(dock)->findChild<T*>(name);
  }
  QString message() const { return m_window->statusBar()->currentMessage(); }
  void waitForSample() {
    QVERIFY(files(*m_window).open(sampleFile));
    QTRY_VERIFY_WITH_TIMEOUT(!view().isNull() && message().contains(" ms"), patience);
  }

 private Q_SLOTS:
  void init() {
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), patience));
  }
  void cleanup() { m_window.reset(); }

  void opensAndShowsTheReferenceImage() {
    waitForSample();
    const Session session = loadSession(sampleFile.toStdString());
    const ViewSource scene = loadViewSource(session, {});
    const Image expected = simulate(scene.job(session.cameras[0]));
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), expected), patience);
    QVERIFY(m_window->windowTitle().startsWith("table1.json"));
    QVERIFY(!m_window->isWindowModified());
  }

  void sceneShowsPanelGridAndFrustum() {
    waitForSample();
    m_window->findChild<QAction*>("scenePanelPictureAction")->trigger();  // off
    const QImage scene = m_window->findChild<VtkWidget*>()->image();
    QVERIFY(count(scene, QColor(61, 71, 92)) > 5000);  // panel
    QVERIFY(count(scene, tokens().text3) > 2000);      // grid
    QVERIFY(count(scene, tokens().eye) > 100);         // the current frustum
    m_window->grab().save(QCoreApplication::applicationDirPath() + "/main_window.png");
  }

  void otherStatesHaveTheirFrusta() {
    waitForSample();
    editor<QDoubleSpinBox>("cameraArea", "eye.0")->setValue(0.3);
    QTRY_VERIFY_WITH_TIMEOUT(count(m_window->findChild<VtkWidget*>()->image(), tokens().text3) > 50,
                             patience);
  }

  void anEditChangesTheImage() {
    waitForSample();
    const QImage before = view().copy();
    auto* field = editor<QSpinBox>("psfArea", "windowSize");
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Down);
    QTest::keyClick(field, Qt::Key_Down);
    QTRY_VERIFY_WITH_TIMEOUT(view() != before, patience);
    QVERIFY(m_window->isWindowModified());
    QCOMPARE(editor<QSpinBox>("psfArea", "windowSize")->value(), 1);

    Session session = loadSession(sampleFile.toStdString());
    session.cameras[0].psf.windowSize = 1;
    const ViewSource scene = loadViewSource(session, {});
    const Image expected = simulate(scene.job(session.cameras[0]));
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), expected), patience);
  }

  void importsACalibrationAndSaysWhatTheLensIsWorth() {
    waitForSample();
    auto* certificate = m_window->findChild<QLabel*>("certificateLabel");
    QTRY_VERIFY_WITH_TIMEOUT(certificate->text().contains("one-to-one everywhere"), patience);
    QFile file(m_folder.filePath("k.json"));  // of OpenCV's samples/data/intrinsics.yml
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "{\"K\": [534.8, 0, 335.7, 0, 534.8, 240.7, 0, 0, 1], \"D\": [0.2958943955272433, "
        "-1.0354662043042675, 0, 0], \"image_width\": 640, \"image_height\": 480}");
    file.close();
    QVERIFY(files(*m_window).importCalibration(file.fileName()));
    QCOMPARE(editor<QDoubleSpinBox>("cameraArea", "fx")->value(), 534.8);
    QCOMPARE(editor<QDoubleSpinBox>("distortionArea", "k3")->value(), 0.0);
    QTRY_COMPARE_WITH_TIMEOUT(view().size(), QSize(640, 480), patience);
    QTRY_VERIFY_WITH_TIMEOUT(certificate->text().contains("have no ray: the lens folds"), patience);
    QVERIFY(certificate->text().contains("one-to-one within r = 0.7304"));
    QVERIFY(!files(*m_window).importCalibration(m_folder.filePath("missing.yml")));
    QVERIFY(message().contains("missing.yml: cannot be read"));
    QCOMPARE(view().size(), QSize(640, 480));
  }

  void measuresAndUsesAMethod() {
    Session session = loadSession(sampleFile.toStdString(), {"camera.res=[80,60]"});
    session.cameras.resize(1);
    const QString file = m_folder.filePath("small.json");
    saveSession(file.toStdString(), session);
    QVERIFY(files(*m_window).open(file));
    QTRY_VERIFY_WITH_TIMEOUT(!view().isNull() && message().contains(" ms"), patience);
    auto* dock = m_window->findChild<QDockWidget*>("tradeoffDock");
    dock->toggleViewAction()->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(dock->isVisible(), patience);
    auto* measure = m_window->findChild<QPushButton*>("measureButton");
    auto* chart = m_window->findChild<TradeoffChartWidget*>();
    QSignalSpy moved(dock->findChild<QProgressBar*>(), &QProgressBar::valueChanged);
    auto* budget = dock->findChild<QSpinBox*>("budgetBox");
    QCOMPARE(budget->text(), QString("60 s"));
    budget->setValue(2);
    QTest::mouseClick(measure, Qt::LeftButton);
    QVERIFY(!budget->isEnabled());
    moved.clear();
    const auto* task = dock->findChild<Task*>();
    QVERIFY(sleepUntil([&] { return task->share() > 0.5; }));
    QCoreApplication::processEvents();
    QVERIFY2(moved.count() <= 2, qPrintable(QString::number(moved.count())));
    QTRY_VERIFY_WITH_TIMEOUT(!chart->chart().rows().empty(), patience);
    auto* table = dock->findChild<QTableWidget*>("methodTable");
    dock->setFloating(true);
    dock->resize(1000, 700);
    QTRY_VERIFY_WITH_TIMEOUT(table->isVisible(), patience);
    const auto clickHalfSize = [table] {
      const QTableWidgetItem* item = table->findItems("half size", Qt::MatchStartsWith).first();
      for (const QTableWidgetItem* other : table->findItems("half size*", Qt::MatchWildcard))
        if (!other->text().contains(',')) item = other;
      table->scrollToItem(item);
      QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                        table->visualItemRect(item).center());
    };
    clickHalfSize();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("method: half size"), patience);

    const ViewSource scene = loadViewSource(session, {});
    RenderJob small = scene.job(session.cameras[0]);
    const Image exact = simulate(small);
    small.method.scale = 2;
    const Image expected = enlarged(rendered(reduced(small)), 2, {80, 60});
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), expected), patience);
    QTest::mouseClick(m_window->findChild<QPushButton*>("ownMethodButton"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!message().contains("method"), patience);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), exact), patience);
    QVERIFY(!equals(view(), expected));

    // Another session: neither the chart nor the method is its own.
    clickHalfSize();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("method: half size"), patience);
    waitForSample();
    QVERIFY(chart->chart().rows().empty());
    QVERIFY(!m_window->findChild<QPushButton*>("ownMethodButton")->isVisible());
    QVERIFY(!message().contains("method"));
  }

  void theStatesMenuDoesWhatItSays() {
    waitForSample();
    auto* box = m_window->findChild<QComboBox*>("stateBox");
    const auto trigger = [this](const char* name) {
      m_window->findChild<QAction*>(name)->trigger();
    };
    trigger("duplicateAction");
    QCOMPARE(box->count(), 7);
    QCOMPARE(box->currentText(), QString("Fig 1 2"));
    QVERIFY(m_window->isWindowModified());
    trigger("moveUpAction");
    QCOMPARE(box->currentIndex(), 0);
    QCOMPARE(box->itemText(1), QString("Fig 1"));
    trigger("moveUpAction");
    QCOMPARE(box->currentIndex(), 0);
    trigger("moveDownAction");
    QCOMPARE(box->currentIndex(), 1);
    auto* commands = m_window->findChild<StateCommands*>();
    const QString other = m_folder.filePath("other.json");
    QVERIFY(files(*m_window).save(other));
    QVERIFY(commands->appendStatesTo(other));
    QCOMPARE(loadSession(other.toStdString()).cameras.back().camera.name, std::string("Fig 1 2 2"));
    QVERIFY(commands->mergeStatesOf(sampleFile));
    QCOMPARE(box->count(), 13);
    QCOMPARE(box->currentIndex(), 7);
    for (int left = 12; left >= 1; --left) {
      trigger("removeAction");
      QCOMPARE(box->count(), left);
    }
    trigger("removeAction");
    QCOMPARE(box->count(), 1);
    QVERIFY(message().contains("a session needs one"));
    QVERIFY(!commands->mergeStatesOf(m_folder.filePath("none.json")));
    QVERIFY(message().contains("none.json: cannot be read"));
  }

  void stopsMeasuring() {
    waitForSample();
    m_window->findChild<QDockWidget*>("tradeoffDock")->show();
    auto* measure = m_window->findChild<QPushButton*>("measureButton");
    QTest::mouseClick(measure, Qt::LeftButton);
    QVERIFY(measure->text().contains("Stop"));
    QTest::qWait(100);
    QTest::mouseClick(measure, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(measure->isEnabled() && measure->text().contains("Measure"), patience);
    QVERIFY(m_window->findChild<TradeoffChartWidget*>()->chart().rows().empty());
  }

  /// The jobs of all states are made when a measurement begins, not at each edit.
  void editsPrepareNoMeasurement() {
    waitForSample();
    auto* widget = m_window->findChild<TradeoffWidget*>();
    auto* measure = m_window->findChild<QPushButton*>("measureButton");
    const Session session = loadSession(sampleFile.toStdString());
    const std::vector<RenderJob> jobs{loadViewSource(session, {}).job(session.cameras[0])};
    int calls = 0;
    widget->setViews([&] {
      ++calls;
      return jobs;
    });
    auto* field = editor<QDoubleSpinBox>("distortionArea", "k1");
    for (int step = 1; step <= 5; ++step) field->setValue(field->value() - 0.02);
    QCOMPARE(calls, 0);
    QTest::mouseClick(measure, Qt::LeftButton);
    QCOMPARE(calls, 1);
    QTest::mouseClick(measure, Qt::LeftButton);  // stop
    QTRY_VERIFY_WITH_TIMEOUT(measure->isEnabled(), patience);
  }

  /// No machine renders all of the sample session in a second by every method.
  void measuresWithinTheBudgetOfItsField() {
    waitForSample();
    m_window->findChild<QDockWidget*>("tradeoffDock")->show();
    m_window->findChild<QSpinBox*>("budgetBox")->setValue(1);
    QTest::mouseClick(m_window->findChild<QPushButton*>("measureButton"), Qt::LeftButton);
    const auto* chart = m_window->findChild<TradeoffChartWidget*>();
    QTRY_VERIFY_WITH_TIMEOUT(!chart->chart().rows().empty(), patience);
    const auto& rows = chart->chart().rows();
    QCOMPARE(rows.size(), namedMethods().size());
    QVERIFY(std::ranges::all_of(rows, &TradeoffRow::isSampled));
    QVERIFY(m_window->findChild<QSpinBox*>("budgetBox")->isEnabled());
  }

  void theLastOfManyEditsWins() {
    waitForSample();
    auto* field = editor<QDoubleSpinBox>("distortionArea", "k1");
    const double start = field->value();
    for (int step = 1; step <= 30; ++step) field->setValue(start - 0.02 * step);
    Session session = loadSession(sampleFile.toStdString());
    session.cameras[0].distortion.k1 = editor<QDoubleSpinBox>("distortionArea", "k1")->value();
    QVERIFY(std::abs(session.cameras[0].distortion.k1) < 1e-9);
    const ViewSource scene = loadViewSource(session, {});
    const Image expected = simulate(scene.job(session.cameras[0]));
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), expected), patience);
  }

  void anotherStateIsShown() {
    waitForSample();
    const QImage before = view().copy();
    m_window->findChild<QComboBox*>("stateBox")->setCurrentIndex(4);
    QTRY_VERIFY_WITH_TIMEOUT(view() != before, patience);
    QCOMPARE(editor<QLineEdit>("cameraArea", "name")->text(), QString("Fig 5"));
    QVERIFY(!m_window->isWindowModified());
  }

  void savesWhatWasEdited() {
    waitForSample();
    editor<QDoubleSpinBox>("psfArea", "sigma")->setValue(1.25);
    const QString file = m_folder.filePath("copy.json");
    QVERIFY(files(*m_window).save(file));
    QVERIFY(!m_window->isWindowModified());
    Session expected = loadSession(sampleFile.toStdString());
    expected.cameras[0].psf.sigma = 1.25;
    Session saved = loadSession(file.toStdString());
    QCOMPARE(QFileInfo(saved.lightField.file.c_str()).canonicalFilePath(),
             QFileInfo(expected.lightField.file.c_str()).canonicalFilePath());
    saved.lightField.file = expected.lightField.file;
    QVERIFY(saved == expected);
  }

  void aBadSessionIsToldAndKeepsTheOldOne() {
    waitForSample();
    const QString file = m_folder.filePath("bad.json");
    QFile bad(file);
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write(R"({"hogelscope": 1, "cameras": []})");
    bad.close();
    QVERIFY(!files(*m_window).open(file));
    QVERIFY2(message().contains("lightField.file"), qPrintable(message()));
    QVERIFY(m_window->windowTitle().startsWith("table1.json"));
  }

  void anImpossibleCameraIsToldAndMended() {
    waitForSample();
    auto* depth = editor<QDoubleSpinBox>("cameraArea", "eye.2");
    depth->setValue(0);  // the eye is the look-at point
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("lookat"), patience);
    depth->setValue(0.7);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
  }

  void closesWhileRendering() {
    waitForSample();
    editor<QSpinBox>("cameraArea", "res.0")->setValue(4000);
    m_window.reset();  // must neither hang nor crash
  }
};

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  TestMainWindow test;
  return QTest::qExec(&test, argc, argv);
}
#include "test_main_window.moc"
