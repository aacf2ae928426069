// SPDX-License-Identifier: BSD-3-Clause
// The dialog of animations along paths of the camera.
#pragma once

#include "core/cameras/camera_path.h"
#include "gui/widgets/dialogs.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace hogelscope {

/// Asks for the path, the size and the files. Cannot be accepted while it says what is wrong.
class AnimationDialog : public SizeDialog {
  Q_OBJECT

 public:
  /// `ffmpeg` is the program's path; "": not installed.
  AnimationDialog(const Session& session, std::size_t current, const QSize& proposed,
                  const QString& ffmpeg, QWidget* parent);

  [[nodiscard]] CameraPath path() const;
  [[nodiscard]] QString folder() const;
  [[nodiscard]] bool hasVideo() const;
  [[nodiscard]] int framesPerSecond() const;

 private:
  void showPath();
  void showProblem();

  Session m_session;
  std::size_t m_current;
  QComboBox* m_path;
  QSpinBox* m_count;
  QCheckBox* m_video;
  QSpinBox* m_rate;
  QLineEdit* m_folder;
  QLabel* m_problem;
};

}  // namespace hogelscope
