// SPDX-License-Identifier: BSD-3-Clause
// Automatic saving of the edited session, a few seconds after edits, and its recovery after a
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

  /// Asks about each session left by a crash until one is recovered. Unreadable ones are reported
  /// through failed() and kept.
  void offerRecovery(QWidget* window);
  /// Removes the copy after the session was saved or discarded. Without this call it stays on disk.
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
  QString m_failure;  ///< the last error, reported once
};

}  // namespace hogelscope
