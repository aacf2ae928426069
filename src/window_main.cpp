// SPDX-License-Identifier: BSD-3-Clause
// The program hogelscope-window, which hogelscope becomes without a job.
#include <QApplication>
#include <QIcon>
#include <cstdlib>

#include "cli/jobs.h"
#include "cli/program.h"
#include "core/base/error.h"
#include "core/base/version.h"
#include "gui/app/main_window.h"
#include "gui/app/translations.h"

namespace {

/// Opens the window and `files` in it (FileCommands::openFiles). Returns the exit status.
int runWindow(int argc, char** argv, const std::vector<std::string>& files) {
  // Without this check Qt would end the process with a longer message.
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr)
    throw hogelscope::InputError("window", "there is no display server (DISPLAY is not set)",
                                 "batch mode needs none, see --help");
  const QApplication application(argc, argv);
  QApplication::setApplicationName("Hogelscope");
  QApplication::setWindowIcon(QIcon(":/desktop/io.github.hogelscope.Hogelscope.svg"));
  QApplication::setApplicationVersion(hogelscope::programVersion());
  QApplication::setOrganizationName("Hogelscope");
  hogelscope::installTranslations();
  hogelscope::MainWindow window;
  QStringList names;
  for (const std::string& file : files) names.append(QString::fromStdString(file));
  window.start(names);
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  return hogelscope::runProgram(argc, argv, [argc, argv](const hogelscope::CommandLine& line) {
    if (line.job != nullptr)
      throw hogelscope::InputError("--" + std::string(line.job->name), "",
                                   "is a job of hogelscope, not of its window");
    hogelscope::usePluginFolders(line);
    return runWindow(argc, argv, line.files);
  });
}
