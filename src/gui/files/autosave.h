// SPDX-License-Identifier: BSD-3-Clause
// Automatic saving of the edited session, a few seconds after edits, and its recovery after a
// crash.
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "core/optics/session.h"

class QWidget;

namespace hogelscope {

class SessionModel;

/// A copy of an edited session on disk, in case the program ends before it is saved. It is locked
/// by the program that edits it; an entry without a living owner was left by a crash.
class AutosaveEntry {
 public:
  /// Takes `base`, a path without extension; creates no file yet.
  explicit AutosaveEntry(const QString& base);

  /// Locks the entry. Returns false if another program or entry owns it.
  bool lock() { return m_lock.isLocked() || m_lock.tryLock(0); }
  /// Writes the session. `document` is the session's file and may be empty. Throws InputError.
  void write(const Session& session, const QString& document);
  /// Deletes the files and releases the lock.
  void remove();

  /// Returns the path of an ordinary session document.
  [[nodiscard]] QString sessionFile() const { return m_base + ".json"; }
  [[nodiscard]] QString document() const;
  [[nodiscard]] QDateTime time() const;

 private:
  [[nodiscard]] QString documentFile() const { return m_base + ".document"; }

  QString m_base;
  QLockFile m_lock;
};

/// Returns the folder of the copies, in AppDataLocation.
QString autosaveFolder();

/// Returns the entries of programs that no longer run, locked, newest first.
std::vector<std::unique_ptr<AutosaveEntry>> abandonedEntries();

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
