// SPDX-License-Identifier: BSD-3-Clause
// The submenu of recently opened or saved sessions; saved in the settings.
#pragma once

#include <QObject>

class QMenu;

namespace hogelscope {

class RecentFiles : public QObject {
  Q_OBJECT

 public:
  /// Fills `menu` whenever it is about to be shown; missing files are disabled.
  RecentFiles(QMenu* menu, QObject* parent);

  /// Returns the files, latest first.
  static QStringList files();
  /// Puts a file at the head of the list, which holds ten.
  void add(const QString& file);

 Q_SIGNALS:
  void chosen(const QString& file);

 private:
  void fill();

  QMenu* m_menu;
};

}  // namespace hogelscope
