// SPDX-License-Identifier: BSD-3-Clause
// Times every event that the window's thread handles while the window is used: 300 states before a
// display of 512×512 hogels. Painting is counted apart, since here a processor draws the scene.
#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QScrollArea>
#include <QSlider>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

#include "core/pattern.h"
#include "gui/main_window.h"
#include "gui/picture_view.h"
#include "gui/vtk_widget.h"
#include "io/image_writer.h"
#include "io/session_file.h"

using namespace hogelscope;

namespace {

constexpr double frame = 16;  ///< milliseconds
/// The machine has other work too, and one event may meet a page that must be read again.
constexpr double slack = 12;

/// An application that times what it delivers; what an event delivers in turn belongs to it.
class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    if (!isTiming || m_depth > 0 || isPaint(*event)) return QApplication::notify(receiver, event);
    ++m_depth;
    QElapsedTimer timer;
    timer.start();
    const QEvent::Type type = event->type();
    const QString name = receiver->objectName() + " " + receiver->metaObject()->className();
    const bool result = QApplication::notify(receiver, event);
    const double milliseconds = double(timer.nsecsElapsed()) * 1e-6;
    --m_depth;
    times.push_back(milliseconds);
    if (milliseconds > worst) {
      worst = milliseconds;
      where = QString("event %1 of %2").arg(int(type)).arg(name);
    }
    return result;
  }

  bool isTiming = false;
  std::vector<double> times;
  double worst = 0;
  QString where;

 private:
  static bool isPaint(const QEvent& event) {
    return event.type() == QEvent::UpdateRequest || event.type() == QEvent::Paint ||
           event.type() == QEvent::Expose;
  }
  int m_depth = 0;
};

void writeSession(const QString& folder) {
  Session session;
  session.display.hogels = {512, 512};
  session.display.directions = {4, 4};
  session.lightField.file = (folder + "/large.png").toStdString();
  const auto pattern = makePattern("spheres", session.display, {});
  ImageRowWriter writer(session.lightField.file, 2048, 2048);
  std::vector<std::uint8_t> row(3 * 2048);
  for (int y = 0; y < 2048; ++y) {
    pattern->row(y, row.data());
    writer.write(row);
  }
  writer.finish();
  for (int k = 0; k < 300; ++k) {
    CameraState state;
    state.camera.name = "s" + std::to_string(1000 + k);
    state.camera.eye = {0.002 * k - 0.3, 0.001 * (k % 20), 0.7};
    state.psf.windowSize = 3;
    session.cameras.push_back(state);
  }
  saveSession((folder + "/s.json").toStdString(), session);
}

}  // namespace

class TestFluid : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void cleanup();
  void slider();
  void states();
  void turning();

 private:
  template <class Action>
  void use(int times, Action action) {
    auto* application = static_cast<TimedApplication*>(qApp);
    application->times.clear();
    application->worst = 0;
    application->isTiming = true;
    for (int k = 0; k < times; ++k) {
      action(k);
      QTest::qWait(10);
    }
    application->isTiming = false;
  }

  QTemporaryDir m_folder;
  std::unique_ptr<MainWindow> m_window;
};

void TestFluid::initTestCase() {
  writeSession(m_folder.path());
  m_window = std::make_unique<MainWindow>();
  m_window->resize(1280, 800);
  m_window->show();
  QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
  QVERIFY(m_window->openSession(m_folder.filePath("s.json")));
  QTRY_VERIFY_WITH_TIMEOUT(!m_window->findChild<PictureView*>("pictureView")->image().isNull(),
                           60000);
}

/// After each use: nearly all within a frame, and nothing that a user would call a freeze.
void TestFluid::cleanup() {
  auto* application = static_cast<TimedApplication*>(qApp);
  std::vector<double>& times = application->times;
  QVERIFY(times.size() > 50);
  std::sort(times.begin(), times.end());
  const double most = times[times.size() * 99 / 100];
  qInfo("%zu events, 99 %% within %.2f ms, the longest %.1f ms (%s)", times.size(), most,
        application->worst, qPrintable(application->where));
  QVERIFY2(most < frame * slack / 4, qPrintable(application->where));
  QVERIFY2(application->worst < frame * slack, qPrintable(application->where));
}

void TestFluid::slider() {
  auto* sigma =
      m_window->findChild<QScrollArea*>("psfArea")->widget()->findChild<QSlider*>("sigma.slider");
  QVERIFY(sigma);
  use(60, [&](int) { QTest::keyClick(sigma, Qt::Key_Right); });
}

void TestFluid::states() {
  auto* box = m_window->findChild<QComboBox*>("stateBox");
  use(60, [&](int) { QTest::keyClick(box, Qt::Key_Down); });
}

void TestFluid::turning() {
  auto* scene = m_window->findChild<VtkWidget*>("sceneWidget");
  const QPoint middle = scene->rect().center();
  QTest::mousePress(scene, Qt::LeftButton, {}, middle + QPoint(120, 120));
  use(60, [&](int k) { QTest::mouseMove(scene, middle + QPoint(120 - 3 * k, 120 - k)); });
  QTest::mouseRelease(scene, Qt::LeftButton, {}, middle);
}

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(VtkWidget::surfaceFormat());
  TimedApplication application(argc, argv);
  TestFluid test;
  return QTest::qExec(&test, argc, argv);
}
#include "test_fluid.moc"
