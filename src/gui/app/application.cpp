// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/application.h"

#include <QApplication>
#include <QCoreApplication>
#include <QIcon>
#include <QLocale>
#include <QTranslator>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/version.h"
#include "gui/app/main_window.h"

namespace hogelscope {

void installTranslations() {
  auto* application = QCoreApplication::instance();
  auto* plurals = new QTranslator(application);
  if (plurals->load(":/translations/hogelscope_en.qm")) application->installTranslator(plurals);
  auto* language = new QTranslator(application);
  if (language->load(QLocale(), "hogelscope", "_", QCoreApplication::applicationDirPath()))
    application->installTranslator(language);
}

int runWindow(int argc, char** argv, const std::vector<std::string>& files) {
  // Without this check Qt would end the process with a longer message.
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr)
    throw InputError("window", "there is no display server (DISPLAY is not set)",
                     "batch mode needs none, see --help");
  const QApplication application(argc, argv);
  QApplication::setApplicationName("Hogelscope");
  QApplication::setWindowIcon(QIcon(":/icons/io.github.hogelscope.Hogelscope.svg"));
  QApplication::setApplicationVersion(programVersion());
  QApplication::setOrganizationName("Hogelscope");
  installTranslations();
  MainWindow window;
  QStringList names;
  for (const std::string& file : files) names.append(QString::fromStdString(file));
  window.start(names);
  return QApplication::exec();
}

}  // namespace hogelscope
