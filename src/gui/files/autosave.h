// SPDX-License-Identifier: BSD-3-Clause
// Keeps the edited session on disk, a few seconds behind the edits, and gives it back after a
// crash.
#pragma once

#include <QTimer>

#include "gui/files/autosave_entry.h"

class QWidget;

namespace hogelscope {

class SessionModel;

class Autosave : public QObject {
  Q_OBJECT

 public:
  Autosave(SessionModel* model, QObject* parent);

  /// Asks about every session that a crash left behind, until one is recovered. One that cannot
  /// be read is told by failed() and kept.
  void offerRecovery(QWidget* window);
  /// Saved, or not wanted: nothing is left. Without this call the last state stays on disk.
  void forget();

 Q_SIGNALS:
  void failed(const QString& line);

 private:
  void write();
  QString writeEntry();
  void writeSoon();
  bool recover(AutosaveEntry& entry);

  SessionModel* m_model;
  AutosaveEntry m_entry;
  QTimer m_timer;
  QString m_failure;  ///< the last one, said once
};

}  // namespace hogelscope
