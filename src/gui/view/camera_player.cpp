// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/camera_player.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <cmath>
#include <numbers>
#include <utility>

#include "gui/session/session_model.h"
#include "gui/widgets/command.h"
#include "gui/widgets/guarded.h"

namespace hogelscope {

CameraPlayer::CameraPlayer(QMenu* menu, SessionModel* model, QObject* parent)
    : QObject(parent), m_model(model) {
  m_timer.setInterval(16);  // milliseconds; fewer pictures where rendering takes longer
  connect(&m_timer, &QTimer::timeout, this, &CameraPlayer::step);
  menu->addSeparator();
  const auto add = [this, menu](const QString& name, const QString& text, const QString& what,
                                const QKeyCombination& key, PathKind kind) {
    addCommand(menu, {name, text, what + tr("; again, or Escape: stops"), key}, this,
               [this, kind] { play(kind); });
  };
  add("playAction", tr("Pla&y"), tr("Shows the way through all states, without changing them"),
      Qt::SHIFT | Qt::Key_Space, PathKind::between);
  add("playOrbitAction", tr("Play orbit"),
      tr("Takes the eye around the look-at, through the display's angle"),
      Qt::ALT | Qt::SHIFT | Qt::Key_O, PathKind::orbit);
  add("playTurntableAction", tr("Play turntable"),
      tr("Takes the camera around the display, through the display's angle"),
      Qt::ALT | Qt::SHIFT | Qt::Key_T, PathKind::turntable);
  for (const auto change :
       {&SessionModel::opened, &SessionModel::edited, &SessionModel::statesChanged,
        &SessionModel::contentChanged, &SessionModel::currentChanged})
    connect(m_model, change, this, &CameraPlayer::stop);
}

CameraState CameraPlayer::shown() const {
  return m_shown.value_or(m_model->current());
}

void CameraPlayer::play(PathKind kind) {
  const bool isAgain = m_shown && m_kind == kind;
  stop();
  if (isAgain) return;
  const auto check = [&] { requireOneSize(m_model->session().cameras); };
  if (kind == PathKind::between && !guarded(this, check)) return;
  m_kind = kind;
  m_shown = m_model->current();
  m_time.start();
  m_timer.start();
  qApp->installEventFilter(this);
}

/// A turn goes to the right from the current state, to the left past it, and back.
void CameraPlayer::step() {
  constexpr double pace = 2000;  // milliseconds from state to state, or of a quarter of a turn
  const Session& session = m_model->session();
  const double position = double(m_time.elapsed()) / pace;
  const bool isTurn = m_kind != PathKind::between;
  if (position >= (isTurn ? 4 : double(session.cameras.size()) - 1)) return stop();
  const double degrees = std::sin(position * std::numbers::pi / 2) * session.display.fov[0] / 2;
  const auto move = [&] {
    if (isTurn)
      m_shown->camera = turned(m_kind, m_model->current().camera, session.display, degrees);
    else
      m_shown = stateAt(session.cameras, position);
  };
  if (!guarded(this, move)) return stop();
  Q_EMIT moved();
}

/// Goes back to the current state.
void CameraPlayer::stop() {
  if (!std::exchange(m_shown, std::nullopt)) return;
  m_timer.stop();
  qApp->removeEventFilter(this);
  Q_EMIT moved();
}

/// Takes Escape before it is another command's.
bool CameraPlayer::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (!isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
    return QObject::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::KeyPress) stop();
  return true;
}

}  // namespace hogelscope
