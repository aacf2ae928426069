// SPDX-License-Identifier: BSD-3-Clause
// The second light field, which the session's own is compared with: reads it on a thread of its
// own, so that the view stays live meanwhile, and frees it.
#pragma once

#include <QObject>
#include <optional>

#include "core/optics/session.h"
#include "gui/widgets/task.h"
#include "io/scene/scene.h"

namespace hogelscope {

class Comparison : public QObject {
  Q_OBJECT

 public:
  explicit Comparison(QObject* parent = nullptr);

  /// Reads a light field (withLightField) for the session's states; an older reading stops, and
  /// until it is there nothing changes. Throws InputError.
  void start(const Session& session, const QString& file);
  /// Compares with the ideal view of the session's own light field, as long as that is live.
  void startIdeal();
  void stop();
  /// The session's own light field; none while it is read.
  void setScene(const std::optional<Scene>& own) { m_own = own; }

  /// With the session's sampling, and its display where the other light field has none of its own.
  /// None while nothing is compared.
  [[nodiscard]] std::optional<Scene> other(const Session& session) const;
  /// Its file's name, or what it is.
  [[nodiscard]] const QString& name() const { return m_name; }
  /// The file that is compared or read for that; "" where it is none.
  [[nodiscard]] const QString& file() const { return m_file; }
  [[nodiscard]] bool isReading() const { return m_task.isRunning(); }
  /// How much has been read, 0 … 1; to be polled (PolledBar).
  [[nodiscard]] double readShare() const { return m_task.share(); }

 Q_SIGNALS:
  void changed();  ///< another one, or none
  /// It could not be read; what was compared still is.
  void failed(const QString& line);

 private:
  std::optional<Scene> m_own;
  std::optional<Scene> m_other;
  bool m_isIdeal = false;
  QString m_name;
  QString m_file;
  bool m_hasOwnDisplay = false;  ///< other()
  Task m_task;
};

}  // namespace hogelscope
