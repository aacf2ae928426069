// SPDX-License-Identifier: BSD-3-Clause
// Output of the 3-D scene to files: images of any size, and geometry for other programs.
#pragma once

#include <QSize>

#include "gui/widgets/task_widgets.h"

class QAction;
class QMenu;
class QStatusBar;

namespace hogelscope {

/// Behind a saved picture of the scene; figures on white and transparent paper have the colours of
/// the light scheme.
enum class SceneBackground { asShown, white, transparent };

class SceneController;
class SessionModel;

class SceneOutput : public FileOutput {
  Q_OBJECT

 public:
  SceneOutput(QMenu* menu, QStatusBar* statusBar, SceneController* controller, SessionModel* model,
              QObject* parent);

  /// Saves the current scene; the panel has as many pixels as the image can show. The extension
  /// gives the format; PNG and TIFF can be transparent. done() or failed() follows later.
  void savePicture(const QString& file, const QSize& size,
                   SceneBackground background = SceneBackground::asShown);
  /// Calls exportScene() in the background. done() or failed() follows later.
  void exportTo(const QString& file);

 private:
  void draw(const QString& file, const QSize& size, SceneBackground background);
  void askPicture();
  void askExport();
  void showState();

  SceneController* m_controller;
  SessionModel* m_model;
  QString m_file;  ///< the output file of the task
  QAction* m_savePicture;
  QAction* m_export;
};

}  // namespace hogelscope
