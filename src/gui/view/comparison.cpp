// SPDX-License-Identifier: BSD-3-Clause
// The second light field, which the session's own is compared with.
#include "gui/view/comparison.h"

#include <QFileInfo>

#include "io/documents/session_file.h"

namespace hogelscope {

Comparison::Comparison(QObject* parent) : QObject(parent) {
  connect(&m_task, &Task::failed, this, &Comparison::failed);
}

void Comparison::start(const Session& session, const QString& file) {
  const Session other = withLightField(session, file.toStdString());
  const bool hasOwnDisplay = isSessionFile(file.toStdString());
  m_task.start([=, this](const Progress& progress) {
    return [=, this, scene = loadScene(other, progress)] {
      m_other = scene;
      m_name = QFileInfo(file).fileName();
      m_hasOwnDisplay = hasOwnDisplay;
      Q_EMIT changed();
    };
  });
}

void Comparison::stop() {
  m_task.abandon();
  m_other.reset();
  m_name.clear();
  Q_EMIT changed();
}

std::optional<Scene> Comparison::other(const Session& session) const {
  std::optional<Scene> scene = m_other;
  if (!scene) return scene;
  scene->sampling = session.sampling;
  if (m_hasOwnDisplay) return scene;
  scene->display = session.display;
  scene->display.hogels = m_other->display.hogels;
  scene->display.directions = m_other->display.directions;
  return scene;
}

}  // namespace hogelscope
