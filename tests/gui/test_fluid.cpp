// SPDX-License-Identifier: BSD-3-Clause
// Uses the real window while an image is rendered that takes far longer than each use: 300 states
// before a display of 512×512 hogels. The window's thread waits for no image, hears everything,
// and does nothing twice.
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListView>
#include <algorithm>

#include "gui/scene/display_scene.h"
#include "gui/scene/scene_controller.h"
#include "gui/view/image_widget.h"
#include "gui/view/view_worker.h"
#include "io/documents/session_file.h"
#include "tests/gui/pattern_file.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

namespace {

constexpr int stateCount = 300;
constexpr int uses = 15;

/// Counts what it delivers to the window; not what only time brings.
class CountingApplication : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    if (event->type() != QEvent::Timer) ++count;
    const auto* widget = qobject_cast<QWidget*>(receiver);
    if (watched != nullptr && widget != nullptr && watched->isAncestorOf(widget)) {
      if (event->type() == QEvent::LayoutRequest) ++layouts;
      if (event->type() == QEvent::Paint && widget->inherits("QAbstractSpinBox")) ++fields;
    }
    return QApplication::notify(receiver, event);
  }

  int count = 0;
  const QWidget* watched = nullptr;
  int layouts = 0;  ///< of what is watched
  int fields = 0;   ///< of numbers, painted in it
};

/// A full image of a state takes seconds, and is never asked for.
void writeSession() {
  Session session;
  session.display.hogels = {512, 512};
  session.display.directions = {2, 2};
  session.sampling.samplesPerPixel = 8;
  session.lightField.file = "large.png";
  writePattern("spheres", session.display, session.lightField.file);
  for (int k = 0; k < stateCount; ++k) {
    CameraState state;
    state.camera.name = "s" + std::to_string(1000 + k);
    state.camera.eye = {0.002 * k - 0.3, 0.001 * (k % 20), 0.7};
    state.camera.res = {1200, 1000};
    state.psf.windowSize = 3;
    session.cameras.push_back(state);
  }
  saveSession("s.json", session);
}

}  // namespace

class TestFluid : public WindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void cleanup();
  void stepsOfAField();
  void states();
  void turning();
  void manyEditsAtOnce();
  void anEditChangesWhatItSays();

 private:
  VtkWidget* sceneWidget() const { return child<VtkWidget>("sceneWidget"); }
  Vec3 sceneEye() const { return m_window->findChild<SceneController*>()->scene().eye().eye; }
  QDoubleSpinBox* sigma() const { return editor<QDoubleSpinBox>("psfArea", "sigma"); }
  /// Does it, and lets the window handle what has come meanwhile.
  template <class Action>
  void use(Action action) {
    auto& application = static_cast<CountingApplication&>(*qApp);
    application.count = 0;
    for (int k = 0; k < uses; ++k) {
      action(k);
      QCoreApplication::processEvents();
    }
    m_events = application.count;
    QCOMPARE(m_rows, 0);
  }

  std::vector<RenderedView> m_views;
  int m_paints = 0;  ///< of the scene
  int m_events = 0;  ///< in the last use()
  int m_rows = 0;    ///< that lists of states got: they are filled once
};

void TestFluid::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  writeSession();
  showWindow({1280, 800});
  auto* worker = m_window->findChild<ViewWorker*>();
  connect(worker, &ViewWorker::rendered, this,
          [this](const RenderedView& view) { m_views.push_back(view); });
  const vtkNew<vtkCallbackCommand> painted;
  painted->SetClientData(&m_paints);
  painted->SetCallback(
      [](vtkObject*, unsigned long, void* paints, void*) { ++*static_cast<int*>(paints); });
  sceneWidget()->renderWindow()->AddObserver(vtkCommand::EndEvent, painted);
  QSignalSpy loaded(worker, &ViewWorker::loaded);
  QVERIFY(files(*m_window).open("s.json"));
  QTRY_COMPARE_WITH_TIMEOUT(loaded.count(), 1, patience);
  for (const QAbstractItemModel* list :
       {child<QComboBox>("stateBox")->model(), child<QListView>("stateList")->model()})
    connect(list, &QAbstractItemModel::rowsInserted, this, [this] { ++m_rows; });
}

/// After each use: it did not wait for an image each time, since then all would be full ones; no
/// more were made than were asked for; and the newest one is shown.
void TestFluid::cleanup() {
  const auto full = std::count_if(m_views.begin(), m_views.end(),
                                  [](const RenderedView& view) { return view.scale == 1; });
  QVERIFY2(full <= uses / 2, qPrintable(QString::number(full)));
  QVERIFY2(m_views.size() <= 2 * uses, qPrintable(QString::number(m_views.size())));
  m_views.clear();
  sigma()->setValue(sigma()->value() + 0.01);
  QTRY_VERIFY_WITH_TIMEOUT(!m_views.empty(), patience);
  QCOMPARE(child<ImageWidget>("pictureView")->image(), m_views.back().image);
  m_views.clear();
}

/// Each step is in the field and in the session before the next one, and makes fewer events than
/// there are states.
void TestFluid::stepsOfAField() {
  const double before = sigma()->value();
  sigma()->setFocus();
  use([&](int k) {
    QTest::keyClick(sigma(), Qt::Key_Up);
    QCOMPARE(sigma()->value(), before + 0.01 * (k + 1));
    QCOMPARE(m_model->current().psf.sigma, sigma()->value());
  });
  QVERIFY2(m_events < stateCount * uses, qPrintable(QString::number(m_events)));
}

void TestFluid::states() {
  auto* box = child<QComboBox>("stateBox");
  box->setFocus();
  use([&](int k) {
    QTest::keyClick(box, Qt::Key_Down);
    QCOMPARE(m_model->currentIndex(), std::size_t(k + 1));
    QCOMPARE(editor<QDoubleSpinBox>("cameraArea", "eye.0")->value(),
             m_model->session().cameras[std::size_t(k + 1)].camera.eye.x);
  });
  QVERIFY2(m_events < stateCount * uses, qPrintable(QString::number(m_events)));
}

/// The scene follows the hand, and is painted once for each of its moves.
void TestFluid::turning() {
  const QPoint middle = sceneWidget()->rect().center();
  QTest::mousePress(sceneWidget(), Qt::LeftButton, {}, middle + QPoint(120, 120));
  QCoreApplication::processEvents();
  m_paints = 0;
  int turns = 0;
  use([&](int k) {
    const Vec3 before = sceneEye();
    const QPointF at = middle + QPoint(120 - 3 * k, 120 - k);
    QMouseEvent move(QEvent::MouseMove, at, sceneWidget()->mapToGlobal(at), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(sceneWidget(), &move);
    turns += length(sceneEye() - before) > 0 ? 1 : 0;
  });
  QTest::mouseRelease(sceneWidget(), Qt::LeftButton, {}, middle);
  QVERIFY2(turns >= uses - 1, qPrintable(QString::number(turns)));
  QVERIFY2(m_paints > 0 && m_paints <= 3 * uses, qPrintable(QString::number(m_paints)));
  QVERIFY2(m_events < stateCount * uses, qPrintable(QString::number(m_events)));
}

/// Edits that come faster than the window paints are painted together.
void TestFluid::manyEditsAtOnce() {
  QCoreApplication::processEvents();
  m_paints = 0;
  for (int k = 0; k < uses; ++k) sigma()->setValue(sigma()->value() - 0.01);
  QCOMPARE(m_paints, 0);
  QCoreApplication::processEvents();
  QCoreApplication::processEvents();
  QVERIFY2(m_paints <= 4, qPrintable(QString::number(m_paints)));
}

/// An edit of the leakage neither lays the properties out nor paints the fields of other sections.
void TestFluid::anEditChangesWhatItSays() {
  auto& application = static_cast<CountingApplication&>(*qApp);
  auto* focal = editor<QDoubleSpinBox>("cameraArea", "fov");
  QVERIFY(focal->isVisible() && !sigma()->isVisible());
  QTest::qWait(50);
  application.watched = child<QWidget>("propertiesDock");
  application.layouts = application.fields = 0;
  for (int k = 0; k < 3; ++k) {
    sigma()->setValue(sigma()->value() + 0.01);
    QTest::qWait(20);
  }
  QCOMPARE(application.layouts, 0);
  QCOMPARE(application.fields, 0);
  focal->setValue(focal->value() + 1);
  QTest::qWait(20);
  QVERIFY(application.fields >= 1);
  application.watched = nullptr;
}

int main(int argc, char** argv) {
  QStandardPaths::setTestModeEnabled(true);
  CountingApplication application(argc, argv);
  TestFluid test;
  return QTest::qExec(&test, argc, argv);
}
#include "test_fluid.moc"
