// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/translations.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

namespace hogelscope {

void installTranslations() {
  auto* application = QCoreApplication::instance();
  auto* plurals = new QTranslator(application);
  if (plurals->load(":/translations/hogelscope_en.qm")) application->installTranslator(plurals);
  auto* language = new QTranslator(application);
  if (language->load(QLocale(), "hogelscope", "_", QCoreApplication::applicationDirPath()))
    application->installTranslator(language);
}

}  // namespace hogelscope
