// SPDX-License-Identifier: BSD-3-Clause
// The second light field, which the session's own is compared with.
#include "gui/comparison.h"

#include <QFileInfo>
#include <utility>

#include "core/error.h"
#include "io/session_file.h"

namespace hogelscope {

Comparison::Comparison(QObject* parent) : QObject(parent) {
  connect(this, &Comparison::readScene, this, &Comparison::take, Qt::QueuedConnection);
  connect(
      this, &Comparison::readPart, this,
      [this](int number, double done) {
        if (number == m_reading) Q_EMIT reading(done);
      },
      Qt::QueuedConnection);
  connect(this, &Comparison::couldNotRead, this, &Comparison::giveUp, Qt::QueuedConnection);
}

Comparison::~Comparison() {
  stopReading();
}

void Comparison::start(const Session& session, const QString& file) {
  const Session other = withLightField(session, file.toStdString());
  stopReading();
  m_isReading = true;
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
  int percent = -1;
  const auto progress = [&](double done) {
    if (std::exchange(percent, int(100 * done)) != int(100 * done)) Q_EMIT readPart(number, done);
    return !m_stops;
  };
  try {
    Q_EMIT readScene(number, loadScene(session, progress), name);
  } catch (const Cancelled&) {
    // nobody waits for it
  } catch (const std::exception& error) {
    Q_EMIT couldNotRead(number, QString::fromUtf8(error.what()));
  }
}

void Comparison::take(int number, const Scene& scene, const QString& name) {
  if (number != m_reading) return;
  m_isReading = false;
  m_hasOwnDisplay = m_readsOwnDisplay;
  m_other = scene;
  m_name = name;
  Q_EMIT changed();
}

void Comparison::giveUp(int number, const QString& line) {
  if (number != m_reading) return;
  m_isReading = false;
  Q_EMIT failed(line);
}

}  // namespace hogelscope
