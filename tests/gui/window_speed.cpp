// SPDX-License-Identifier: BSD-3-Clause
// No test: says when, after the process was made, the window and its first picture are there, and
// what an edit, the engine's share of it, a turn of the scene, the drag of a mesh and playing
// frames cost. window_speed FILE [WIDTHxHEIGHT]
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QTimer>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "core/engine/renderer.h"
#include "gui/app/main_window.h"
#include "gui/scene/display_scene.h"
#include "gui/scene/scene_controller.h"
#include "gui/scene/vtk_widget.h"
#include "gui/session/session_model.h"
#include "gui/view/image_widget.h"

using namespace hogelscope;

namespace {

double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Seconds since this process was made, to a hundredth, and of CPU.
void say(const char* what) {
  QFile stat("/proc/self/stat");
  (void)stat.open(QIODevice::ReadOnly);
  const double made =
      stat.readAll().split(')').last().simplified().split(' ')[19].toDouble() / 100;  // ticks
  std::printf("%-28s %5.2f s, %5.2f s of CPU\n", what, seconds(CLOCK_BOOTTIME) - made,
              seconds(CLOCK_PROCESS_CPUTIME_ID));
}

/// The median of 30 uses, each until nothing more comes, in ms.
template <class Use>
void sayCost(const char* what, Use use) {
  std::vector<double> wall;
  std::vector<double> cpu;
  for (int k = 0; k < 30; ++k) {
    const double wallBefore = seconds(CLOCK_MONOTONIC);
    const double cpuBefore = seconds(CLOCK_PROCESS_CPUTIME_ID);
    use(k);
    wall.push_back(1000 * (seconds(CLOCK_MONOTONIC) - wallBefore));
    cpu.push_back(1000 * (seconds(CLOCK_PROCESS_CPUTIME_ID) - cpuBefore));
  }
  std::sort(wall.begin(), wall.end());
  std::sort(cpu.begin(), cpu.end());
  std::printf("%-28s %5.1f ms, %5.1f ms of CPU\n", what, wall[wall.size() / 2],
              cpu[cpu.size() / 2]);
}

/// The longest time for which the window's thread does not come back to its events meanwhile.
template <class Use>
void sayLongest(const char* what, Use use) {
  double wall = 0, cpu = 0;
  double wallBefore = seconds(CLOCK_MONOTONIC), cpuBefore = seconds(CLOCK_THREAD_CPUTIME_ID);
  QTimer tick;
  QObject::connect(&tick, &QTimer::timeout, [&] {
    wall = std::max(wall, seconds(CLOCK_MONOTONIC) - wallBefore);
    cpu = std::max(cpu, seconds(CLOCK_THREAD_CPUTIME_ID) - cpuBefore);
    wallBefore = seconds(CLOCK_MONOTONIC);
    cpuBefore = seconds(CLOCK_THREAD_CPUTIME_ID);
  });
  tick.start(1);
  use();
  std::printf("%-28s %5.1f ms, %5.1f ms of CPU at most\n", what, 1000 * wall, 1000 * cpu);
}

/// How many pictures of a mesh are shown in a second while it is dragged, an edit every 10 ms.
void sayPicturesOfDrag(QDoubleSpinBox& position, const ImageWidget& view) {
  constexpr int edits = 300;
  int pictures = 0;
  const auto counting =
      QObject::connect(&view, &ImageWidget::imagesChanged, [&pictures] { ++pictures; });
  const double start = seconds(CLOCK_MONOTONIC);
  for (int k = 0; k < edits; ++k) {
    position.setValue(0.02 * std::sin(0.05 * k));
    QTest::qWait(10);
  }
  QObject::disconnect(counting);
  std::printf("%-28s %5.1f pictures/s\n", "a dragged mesh",
              pictures / (seconds(CLOCK_MONOTONIC) - start));
}

/// How many pictures are shown in a second while frames play that have been read before.
void sayPicturesOfPlay(QAction& play, const ImageWidget& view) {
  play.trigger();
  QTest::qWait(10000);  // all frames are read
  int pictures = 0;
  const auto counting =
      QObject::connect(&view, &ImageWidget::imagesChanged, [&pictures] { ++pictures; });
  const double start = seconds(CLOCK_MONOTONIC), cpu = seconds(CLOCK_PROCESS_CPUTIME_ID);
  QTest::qWait(5000);
  QObject::disconnect(counting);
  const double passed = seconds(CLOCK_MONOTONIC) - start;
  std::printf("%-28s %5.1f pictures/s, %5.1f ms of CPU each\n", "frames that play",
              pictures / passed, 1000 * (seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu) / pictures);
  play.trigger();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  say("main()");
  const QTemporaryDir home;  // without edits that an earlier run left, which the window asks about
  qputenv("HOME", home.path().toUtf8());
  QStandardPaths::setTestModeEnabled(true);
  const QApplication application(argc, argv);
  MainWindow window;
  say("window made");
  if (argc > 2) {
    const QStringList size = QString(argv[2]).split('x');
    window.resize(size.at(0).toInt(), size.at(1).toInt());
  }
  window.start({QString(argv[1])});
  say("window shown");
  const auto* view = window.findChild<ImageWidget*>("pictureView");
  if (!QTest::qWaitFor([&] { return !view->image().isNull() && view->notice().isEmpty(); }, 60000))
    return 1;
  say("picture there");
  QTest::qWait(1);
  QApplication::processEvents();
  say("picture painted");
  QTest::qWait(2000);  // the full image, the scene

  auto* sceneWidget = window.findChild<VtkWidget*>("sceneWidget");
  int scenes = 0;
  const vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&scenes);
  count->SetCallback(
      [](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
  sceneWidget->renderWindow()->AddObserver(vtkCommand::EndEvent, count);

  if (auto* play = window.findChild<QAction*>("playFramesAction"); play->isEnabled())
    sayPicturesOfPlay(*play, *view);
  auto* sigma = window.findChild<QWidget*>("psfArea")->findChild<QDoubleSpinBox*>("sigma");
  sayCost("edit of the PSF", [&](int k) {
    const qint64 before = view->image().cacheKey();
    sigma->setValue(0.5 + 0.01 * k);
    (void)QTest::qWaitFor([&] { return view->image().cacheKey() != before; }, 60000);
    QApplication::processEvents();
  });
  QTest::qWait(500);
  Renderer renderer;
  RenderJob job = *window.findChild<SceneController*>()->job();
  sayCost("its picture by the engine", [&](int k) {
    job.state.psf.sigma = 0.5 + 0.01 * k;
    (void)renderer.render(job);
  });
  DisplayScene& scene = window.findChild<SceneController*>()->scene();
  std::printf("%-28s %5.1f\n", "scenes drawn for an edit", scenes / 30.0);
  const QSize size = sceneWidget->deviceSize();
  std::printf("%-28s %5d x %d px\n", "the scene's size", size.width(), size.height());
  sayCost("turn of the scene", [&](int) {
    scene.turn(3, 0);
    sceneWidget->repaint();
    QApplication::processEvents();
  });
  sayLongest("small views of 300 states", [&] {
    auto* model = window.findChild<SessionModel*>();
    model->changeStates("300 states", [](Session& session) {
      const CameraState first = session.cameras.front();
      for (int k = int(session.cameras.size()); k < 300; ++k) {
        session.cameras.push_back(first);
        session.cameras.back().camera.name = std::to_string(k);
        session.cameras.back().camera.eye.x += 0.001 * k;
      }
      return std::size_t(0);
    });
    window.findChild<QAction*>("sceneStatePicturesAction")->trigger();
    QTest::qWait(8000);
  });
  const auto sayCommand = [&](const char* what, const char* first, const char* second) {
    sayCost(what, [&](int k) {
      window.findChild<QAction*>(k % 2 == 0 ? first : second)->trigger();
      QApplication::processEvents();
    });
  };
  sayCommand("light or dark", "lightColours", "darkColours");
  sayCommand("size of the text", "largerTextAction", "normalTextAction");
  if (const auto* mesh = window.findChild<QWidget*>("meshForm"))
    sayPicturesOfDrag(*mesh->findChild<QDoubleSpinBox*>("position.0"), *view);
  return 0;
}
