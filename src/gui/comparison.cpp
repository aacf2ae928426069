// SPDX-License-Identifier: BSD-3-Clause
// The second light field, which the session's own is compared with.
#include "gui/comparison.h"

#include <QFileInfo>

#include "core/error.h"
#include "io/session_file.h"

namespace hogelscope {

Comparison::~Comparison() {
  stopReading();
}

void Comparison::start(const Session& session, const QString& file) {
  const Session other = withLightField(session, file.toStdString());
  stopReading();
  m_isReading = true;
  m_thread = std::thread([this, other, name = QFileInfo(file).fileName()] { read(other, name); });
}

void Comparison::stop() {
  stopReading();
  m_other.reset();
  m_name.clear();
  Q_EMIT changed();
}

void Comparison::stopReading() {
  m_stops = true;
  if (m_thread.joinable()) m_thread.join();
  m_stops = false;
  m_isReading = false;
  ++m_reading;  // what it has sent already no longer counts
}

/// On the thread. What it read is handed over on the object's own.
void Comparison::read(const Session& session, const QString& name) {
  try {
    const Scene scene = loadScene(session, [this](double) { return !m_stops; });
    finish([this, scene, name] {
      m_other = scene;
      m_name = name;
      Q_EMIT changed();
    });
  } catch (const Cancelled&) {
    // nobody waits for it
  } catch (const std::exception& error) {
    finish([this, line = QString::fromUtf8(error.what())] { Q_EMIT failed(line); });
  }
}

void Comparison::finish(const std::function<void()>& result) {
  QMetaObject::invokeMethod(
      this,
      [this, number = m_reading, result] {
        if (number != m_reading) return;
        m_isReading = false;
        result();
      },
      Qt::QueuedConnection);
}

}  // namespace hogelscope
