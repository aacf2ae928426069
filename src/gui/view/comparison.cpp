// SPDX-License-Identifier: BSD-3-Clause
// The second light field, which the session's own is compared with.
#include "gui/view/comparison.h"

#include <QFileInfo>

#include "core/base/error.h"
#include "gui/widgets/queued_answer.h"
#include "io/documents/session_file.h"

namespace hogelscope {

Comparison::Comparison(QObject* parent) : QObject(parent) {}

Comparison::~Comparison() {
  stopReading();
}

void Comparison::start(const Session& session, const QString& file) {
  const Session other = withLightField(session, file.toStdString());
  stopReading();
  m_isReading = true;
  m_readShare = 0;
  m_readsOwnDisplay = isSessionFile(file.toStdString());
  m_thread = std::thread([this, number = m_reading, other, name = QFileInfo(file).fileName()] {
    read(number, other, name);
  });
}

void Comparison::stop() {
  stopReading();
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

void Comparison::stopReading() {
  m_stops = true;
  if (m_thread.joinable()) m_thread.join();
  m_stops = false;
  m_isReading = false;
  ++m_reading;  // what it has sent already no longer counts
}

/// On the thread.
void Comparison::read(int number, const Session& session, const QString& name) {
  const auto progress = [this](double done) {
    m_readShare = done;
    return !m_stops;
  };
  try {
    const Scene scene = loadScene(session, progress);
    m_readShare = 1;
    queueAnswer(this, m_reading, number, [this, scene, name] { take(scene, name); });
  } catch (const Cancelled&) {
    // nobody waits for it
  } catch (const std::exception& error) {
    const QString line = QString::fromUtf8(error.what());
    queueAnswer(this, m_reading, number, [this, line] { giveUp(line); });
  }
}

void Comparison::take(const Scene& scene, const QString& name) {
  m_isReading = false;
  m_hasOwnDisplay = m_readsOwnDisplay;
  m_other = scene;
  m_name = name;
  Q_EMIT changed();
}

void Comparison::giveUp(const QString& line) {
  m_isReading = false;
  Q_EMIT failed(line);
}

}  // namespace hogelscope
