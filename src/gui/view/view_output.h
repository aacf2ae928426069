// SPDX-License-Identifier: BSD-3-Clause
// Simulated views as files: of any size, and an animation along the states.
#pragma once

#include <QObject>
#include <QSize>
#include <optional>

#include "gui/widgets/task.h"
#include "io/scene/scene.h"

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class ReadingBar;
class SessionModel;
struct AnimationRequest;

/// One work at a time, on a thread of its own, with a bar and its stop in the status bar.
class ViewOutput : public QObject {
  Q_OBJECT

 public:
  ViewOutput(const Ui::MainWindow& ui, SessionModel* model, QObject* parent);

  /// The session's light field; none while it is read. What is under way goes on with its own.
  void setScene(const std::optional<Scene>& scene);
  /// The current state's view over the same field, as `--render` writes it: PNG of 8 bits, TIFF of
  /// 16, EXR of floats that are not rounded, by extension. done() or failed() come later.
  void saveView(const QString& file, const QSize& size);
  /// The views of all states, so many times larger than they are in the session; with a video
  /// where `ffmpeg` is not "".
  void saveAnimation(const QString& folder, double scale, const QString& ffmpeg,
                     int framesPerSecond);

 Q_SIGNALS:
  void done(const QString& line);
  void failed(const QString& line);

 private:
  void askView();
  void askAnimation();
  void start(const Task::Job& job);
  void showState();
  [[nodiscard]] QSize currentSize() const;

  const Ui::MainWindow& m_ui;
  SessionModel* m_model;
  std::optional<Scene> m_scene;
  Task* m_task;
  ReadingBar* m_bar;
};

/// The files that a session's light field is read from, which none may be written over. Of a live
/// scene its own file alone: to open it may take seconds. Throws InputError.
std::vector<std::filesystem::path> lightFieldFiles(const Session& session);

}  // namespace hogelscope
