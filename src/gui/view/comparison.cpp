// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/comparison.h"

#include <QFileInfo>

#include "io/documents/session_file.h"
#include "io/opening/session_around.h"

namespace hogelscope {

Comparison::Comparison(QObject* parent) : QObject(parent) {
  connect(&m_task, &Task::failed, this, [this](const QString& line) {
    m_file.clear();
    Q_EMIT failed(line);
  });
}

void Comparison::start(const Session& session, const QString& file) {
  const Session other = withLightField(session, file.toStdString());
  const bool hasOwnDisplay = isSessionFile(file.toStdString());
  m_file = file;
  m_task.start([=, this](const Progress& progress) {
    return [=, this, source = loadViewSource(other, progress)] {
      m_other = source;
      m_isIdeal = false;
      m_name = QFileInfo(file).fileName();
      m_hasOwnDisplay = hasOwnDisplay;
      Q_EMIT changed();
    };
  });
}

void Comparison::startIdeal() {
  m_task.abandon();
  m_file.clear();
  m_other.reset();
  m_isIdeal = true;
  m_name = tr("ideal view");
  Q_EMIT changed();
}

void Comparison::stop() {
  m_task.abandon();
  m_file.clear();
  m_isIdeal = false;
  m_other.reset();
  m_name.clear();
  Q_EMIT changed();
}

std::optional<ViewSource> Comparison::other(const Session& session) const {
  if (m_isIdeal) {
    std::optional<ViewSource> ideal = m_own;
    if (!session.lightField.isLive()) ideal.reset();
    if (ideal) ideal->isIdeal = true;
    return ideal;
  }
  std::optional<ViewSource> source = m_other;
  if (!source) return source;
  source->sampling = session.sampling;
  if (m_hasOwnDisplay) return source;
  source->display = displayOf(session);
  source->display.hogels = m_other->display.hogels;
  source->display.directions = m_other->display.directions;
  return source;
}

}  // namespace hogelscope
