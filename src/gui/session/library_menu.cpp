// SPDX-License-Identifier: BSD-3-Clause
#include "gui/session/library_menu.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "gui/widgets/command.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "io/documents/display_library.h"
#include "io/documents/session_file.h"

namespace hogelscope {

QString sampleFile(const QString& name) {
  const QString program = QCoreApplication::applicationDirPath();
  const QString installed = program + "/../share/hogelscope/samples/" + name;
  for (const QString& file : {installed + ".hogelscope", installed + ".json",
                              program + "/../../../data/" + name + ".json"})
    if (QFileInfo::exists(file)) return QFileInfo(file).canonicalFilePath();
  return {};
}

LibraryMenu::LibraryMenu(QMenu* menu, const QString& library, QObject* parent)
    : QObject(parent), m_menu(menu) {
  std::vector<LibraryDisplay> displays;
  try {
    if (!library.isEmpty()) displays = loadDisplayLibrary(library.toStdString());
  } catch (const std::exception& error) {  // told when there is a window that listens
    QMetaObject::invokeMethod(
        this, [this, line = QString::fromUtf8(error.what())] { Q_EMIT failed(line); },
        Qt::QueuedConnection);
  }
  int digit = Qt::Key_1;
  const auto keyOf = [](int key) {
    return QKeySequence(Qt::CTRL | Qt::ALT | Qt::SHIFT | Qt::Key(key));
  };
  for (const LibraryDisplay& display : displays) {
    const QString id = QString::fromStdString(display.file);
    const QString name = QString::fromStdString(display.name);
    QString help = tr("From %1.").arg(QString::fromStdString(display.source));
    if (!display.assumed.empty())
      help += tr(" Assumed: %1.").arg(QString::fromStdString(display.assumed));
    addCommand(m_menu, {id + "Action", name, help, keyOf(digit++)}, this,
               [this, name, id] { choose(name, sampleFile("displays/" + id)); });
  }
  m_menu->addSeparator();
  addCommand(m_menu,
             {"otherDisplayAction", tr("Display of another session…"),
              tr("Shows the content on the display of a session's file"), keyOf(Qt::Key_0)},
             this, [this] {
               const QString session =
                   chooseFile(m_menu, tr("Choose the session of a display"), sessionFilter());
               if (!session.isEmpty()) choose(QFileInfo(session).completeBaseName(), session);
             });
}

void LibraryMenu::choose(const QString& name, const QString& file) {
  guarded(this, [&] { Q_EMIT chosen(name, loadSession(file.toStdString()).display); });
}

}  // namespace hogelscope
