// SPDX-License-Identifier: BSD-3-Clause
// The second light field, which the session's own is compared with: reads it on a thread of its
// own, so that the view stays live meanwhile, and frees it.
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <optional>
#include <thread>

#include "core/session.h"
#include "io/light_field_file.h"

namespace hogelscope {

class Comparison : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  /// Stops what is under way.
  ~Comparison() override;

  /// Reads a light field (withLightField) for the session's states; an older reading stops, and
  /// until it is there nothing changes. Throws InputError.
  void start(const Session& session, const QString& file);
  void stop();

  /// None while nothing is compared.
  [[nodiscard]] const std::optional<Scene>& other() const { return m_other; }
  /// Its file's name.
  [[nodiscard]] const QString& name() const { return m_name; }
  [[nodiscard]] bool isReading() const { return m_isReading; }

 Q_SIGNALS:
  void changed();  ///< another one, or none
  /// It could not be read; what was compared still is.
  void failed(const QString& line);

 private:
  void stopReading();
  void read(const Session& session, const QString& name);
  void finish(const std::function<void()>& result);

  std::optional<Scene> m_other;
  QString m_name;
  bool m_isReading = false;
  int m_reading = 0;  ///< the number of the latest reading
  std::atomic<bool> m_stops = false;
  std::thread m_thread;
};

}  // namespace hogelscope
