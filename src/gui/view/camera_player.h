// SPDX-License-Identifier: BSD-3-Clause
// Plays paths of the camera in the simulated view.
#pragma once

#include <QElapsedTimer>
#include <QMenu>
#include <QTimer>
#include <optional>

#include "core/cameras/camera_path.h"

namespace hogelscope {

class SessionModel;

/// Moves a camera of its own; the session stays as it is. The clock says where it is, so a slow
/// view shows fewer pictures and is never late. It stops at the path's end, with Escape, with its
/// command again, and when the session changes.
class CameraPlayer : public QObject {
  Q_OBJECT

 public:
  CameraPlayer(QMenu* menu, SessionModel* model, QObject* parent);

  /// Returns the state on the path; the current state while nothing is played.
  [[nodiscard]] CameraState shown() const;

 Q_SIGNALS:
  void moved();  ///< shown() has changed
  void failed(const QString& line);

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void play(PathKind kind);
  void step();
  void stop();

  SessionModel* m_model;
  QTimer m_timer;
  QElapsedTimer m_time;  ///< since the path's beginning
  PathKind m_kind = PathKind::between;
  std::optional<CameraState> m_shown;  ///< none: nothing is played
};

}  // namespace hogelscope
