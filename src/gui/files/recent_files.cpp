// SPDX-License-Identifier: BSD-3-Clause
#include "gui/files/recent_files.h"

#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace hogelscope {

namespace {

constexpr int mostFiles = 10;
constexpr const char* recentKey = "recentFiles";

}  // namespace

RecentFiles::RecentFiles(QMenu* menu, QObject* parent) : QObject(parent), m_menu(menu) {
  m_menu->setToolTipsVisible(true);
  connect(m_menu, &QMenu::aboutToShow, this, &RecentFiles::fill);
}

QStringList RecentFiles::files() {
  return QSettings().value(recentKey).toStringList();
}

void RecentFiles::add(const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  QStringList list = files();
  list.removeAll(path);
  list.prepend(path);
  QSettings().setValue(recentKey, list.mid(0, mostFiles));
}

void RecentFiles::fill() {
  m_menu->clear();
  for (const QString& file : files()) {
    const auto number = int(m_menu->actions().size()) + 1;
    QString name = QFileInfo(file).fileName().replace("&", "&&");
    const QString form = number < 10 ? tr("&%1  %2") : tr("%1  %2");
    QAction* action =
        m_menu->addAction(form.arg(number).arg(name), this, [this, file] { Q_EMIT chosen(file); });
    action->setEnabled(QFileInfo::exists(file));
    action->setToolTip(action->isEnabled() ? file : tr("%1 is missing").arg(file));
  }
  if (m_menu->isEmpty()) m_menu->addAction(tr("None yet"))->setEnabled(false);
}

}  // namespace hogelscope
