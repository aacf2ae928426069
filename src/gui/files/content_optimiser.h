// SPDX-License-Identifier: BSD-3-Clause
// Content that makes up for the display's leakage, as --optimise writes it.
#pragma once

#include "gui/widgets/task_widgets.h"
#include "io/scene/light_field_export.h"

class QAction;
class QMenu;
class QStatusBar;

namespace hogelscope {

class SessionModel;

class ContentOptimiser : public FileOutput {
  Q_OBJECT

 public:
  /// Dialogs are shown over `window`.
  ContentOptimiser(QMenu* menu, QStatusBar* statusBar, SessionModel* model, QWidget* window);

  /// Sets whether the session's light field can be read.
  void setHasContent(bool hasContent);
  /// Asks for the target and the file, then solves.
  void ask();
  /// Writes the optimised content, its table and its page; done() and written(), or failed(),
  /// follow later.
  void save(ExportLayout layout, const QString& output);

 Q_SIGNALS:
  /// The content has been written, to be compared with the session's own.
  void written(const QString& output);

 private:
  void showState();

  SessionModel* m_model;
  QWidget* m_window;
  QAction* m_action;
  bool m_hasContent = false;
};

}  // namespace hogelscope
