// SPDX-License-Identifier: BSD-3-Clause
// Output of the session's light field to files, in the layouts of --export, and as a page.
#pragma once

#include "gui/widgets/task_widgets.h"
#include "io/scene/light_field_export.h"

class QAction;
class QMenu;
class QStatusBar;

namespace hogelscope {

class SessionModel;

class LightFieldOutput : public FileOutput {
  Q_OBJECT

 public:
  /// Dialogs are shown over `window`.
  LightFieldOutput(QMenu* menu, QStatusBar* statusBar, SessionModel* model, QWidget* window);

  /// Sets the size of the session's light field, as it was read; none while it is read.
  void setSize(const std::optional<LightFieldSize>& size);
  /// Sets the frame that is shown of a light field in time, which is the one that is written.
  void setFrame(std::optional<int> frame) { m_frame = frame; }
  /// Writes the light field as exportAs() does, to a file, or for views to a folder; with
  /// `isForTwin` corrected for the session's unit. done() or failed() follows later.
  void save(ExportLayout layout, const QString& output, bool isForTwin = false);

 private:
  void ask();
  void share();
  void showState();

  SessionModel* m_model;
  QWidget* m_window;
  QAction* m_export;
  QAction* m_share;
  std::optional<LightFieldSize> m_size;
  std::optional<int> m_frame;
};

}  // namespace hogelscope
