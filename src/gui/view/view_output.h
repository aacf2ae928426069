// SPDX-License-Identifier: BSD-3-Clause
// Output of simulated views to files: images of any size, and an animation along a path.
// A view of another size is a RenderJob whose camera is `resized`, so files are those of batch
// mode.
#pragma once

#include <QSize>
#include <optional>

#include "gui/widgets/task_widgets.h"
#include "io/scene/view_source.h"

class QAction;
class QMenu;
class QStatusBar;

namespace hogelscope {

class SessionModel;
struct CameraPath;

class ViewOutput : public FileOutput {
  Q_OBJECT

 public:
  /// Dialogs are shown over `view`.
  ViewOutput(QMenu* menu, QWidget* view, QStatusBar* statusBar, SessionModel* model,
             QObject* parent);

  /// Sets the session's light field; none while it is read. A running job keeps its own.
  void setSource(const std::optional<ViewSource>& source);
  /// Saves a state's view as `--render` writes it: PNG of 8 bits, TIFF of 16, EXR of unrounded
  /// floats, by extension. done() or failed() follows later.
  void saveView(const QString& file, const CameraState& state);
  /// Saves the views along a path, scaled by `scale`, with a video unless `ffmpeg` is "". Throws
  /// InputError as statesAlong().
  void saveAnimation(const CameraPath& path, const QString& folder, double scale,
                     const QString& ffmpeg, int framesPerSecond);

 private:
  void askView();
  void askAnimation();
  void showState();
  [[nodiscard]] Session resolvedSession() const;
  [[nodiscard]] QSize currentSize() const;

  QWidget* m_view;
  SessionModel* m_model;
  std::optional<ViewSource> m_source;
  QAction* m_saveView;
  QAction* m_saveAnimation;
};

}  // namespace hogelscope
