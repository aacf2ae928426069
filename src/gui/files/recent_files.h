// SPDX-License-Identifier: BSD-3-Clause
// The submenu of sessions that were opened or saved last; kept in the settings.
#pragma once

#include <QObject>

class QMenu;

namespace hogelscope {

class RecentFiles : public QObject {
  Q_OBJECT

 public:
  /// Fills `menu` whenever it is about to be shown; files that are missing are grey.
  RecentFiles(QMenu* menu, QObject* parent);

  /// The latest first.
  static QStringList files();
  /// To the head of the list, which holds ten.
  void add(const QString& file);

 Q_SIGNALS:
  void chosen(const QString& file);

 private:
  void fill();

  QMenu* m_menu;
};

}  // namespace hogelscope
