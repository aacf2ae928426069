// SPDX-License-Identifier: BSD-3-Clause
// No test: says when, after the process was made, the window, and its first picture, are there.
// start_time FILE
#include <QApplication>
#include <QTimer>
#include <QtTest>
#include <cstdio>
#include <ctime>

#include "gui/app/main_window.h"
#include "gui/scene/vtk_widget.h"
#include "gui/view/image_widget.h"

using namespace hogelscope;

namespace {

/// Seconds since this process was made, to a hundredth, and of CPU.
void say(const char* what) {
  QFile stat("/proc/self/stat");
  (void)stat.open(QIODevice::ReadOnly);
  const double made =
      stat.readAll().split(')').last().simplified().split(' ')[19].toDouble() / 100;  // ticks
  timespec now{}, spent{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &spent);
  std::printf("%-28s %5.2f s, %5.2f s of CPU\n", what,
              double(now.tv_sec) + 1e-9 * double(now.tv_nsec) - made,
              double(spent.tv_sec) + 1e-9 * double(spent.tv_nsec));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  say("main()");
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat::setDefaultFormat(VtkWidget::surfaceFormat());
  const QApplication application(argc, argv);
  MainWindow window;
  say("window made");
  window.start({QString(argv[1])});
  say("window shown");
  const auto* view = window.findChild<ImageWidget*>("pictureView");
  if (!QTest::qWaitFor([&] { return !view->image().isNull() && view->notice().isEmpty(); }, 60000))
    return 1;
  say("picture there");
  QTest::qWaitFor([] { return false; }, 1);
  QApplication::processEvents();
  say("picture painted");
  return 0;
}
