// SPDX-License-Identifier: BSD-3-Clause
// The second light field, compared with the session's own. It is read on its own thread, so that
// the view stays responsive.
#pragma once

#include <QObject>
#include <optional>

#include "core/optics/session.h"
#include "gui/widgets/task.h"
#include "io/scene/view_source.h"

namespace hogelscope {

class Comparison : public QObject {
  Q_OBJECT

 public:
  explicit Comparison(QObject* parent = nullptr);

  /// Reads a light field (withLightField) for the session's states and stops an older reading. The
  /// current comparison stays until the new one is read. Throws InputError.
  void start(const Session& session, const QString& file);
  /// Compares with the ideal view of the session's own light field while that is live.
  void startIdeal();
  void stop();
  /// Sets the session's own light field; none while it is read.
  void setSource(const std::optional<ViewSource>& own) { m_own = own; }

  /// Returns the second light field with the session's sampling, and with the session's display
  /// unless it has its own; none without a comparison.
  [[nodiscard]] std::optional<ViewSource> other(const Session& session) const;
  /// The file's name, or a description.
  [[nodiscard]] const QString& name() const { return m_name; }
  /// The file that is compared or being read; "" if there is none.
  [[nodiscard]] const QString& file() const { return m_file; }
  [[nodiscard]] bool isReading() const { return m_task.isRunning(); }
  /// Returns the share that has been read, 0 … 1; polled by PolledBar.
  [[nodiscard]] double readShare() const { return m_task.share(); }

 Q_SIGNALS:
  void changed();  ///< another light field, or none
  /// The file could not be read; the current comparison stays.
  void failed(const QString& line);

 private:
  std::optional<ViewSource> m_own;
  std::optional<ViewSource> m_other;
  bool m_isIdeal = false;
  QString m_name;
  QString m_file;
  bool m_hasOwnDisplay = false;  ///< the display of other()
  Task m_task;
};

}  // namespace hogelscope
