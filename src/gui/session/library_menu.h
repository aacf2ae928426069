// SPDX-License-Identifier: BSD-3-Clause
// The menu "See this content on": a library of displays, and those of other sessions.
#pragma once

#include <QObject>

#include "core/panel/display.h"

class QMenu;
class QString;

namespace hogelscope {

/// Returns the file of an installed sample, or of the one in the source tree, such as "room" or
/// "displays/paper"; "" if there is none.
QString sampleFile(const QString& name);

class LibraryMenu : public QObject {
  Q_OBJECT

 public:
  /// Adds a command for each display of a library.json; only the last command if it is "" or
  /// damaged, which failed() tells.
  LibraryMenu(QMenu* menu, const QString& library, QObject* parent);

 Q_SIGNALS:
  void chosen(const QString& name, const hogelscope::DisplayParams& display);
  void failed(const QString& line);

 private:
  void choose(const QString& name, const QString& file);

  QMenu* m_menu;
};

}  // namespace hogelscope
