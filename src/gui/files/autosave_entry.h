// SPDX-License-Identifier: BSD-3-Clause
// An edited session on disk, in case the program ends before it is saved; locked by the program
// that edits it, so that one without a living owner is what a crash left behind.
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <memory>
#include <vector>

#include "core/optics/session.h"

namespace hogelscope {

class AutosaveEntry {
 public:
  /// `base` is a path without extension; nothing is made yet.
  explicit AutosaveEntry(const QString& base);

  /// False where another program, or another entry, owns it.
  bool lock() { return m_lock.isLocked() || m_lock.tryLock(0); }
  /// `document` is the file that the session is of; may be empty. Throws InputError.
  void write(const Session& session, const QString& document);
  /// Also gives the lock back.
  void remove();

  /// A session document like any other.
  [[nodiscard]] QString sessionFile() const { return m_base + ".json"; }
  [[nodiscard]] QString document() const;
  [[nodiscard]] QDateTime time() const;

 private:
  [[nodiscard]] QString documentFile() const { return m_base + ".document"; }

  QString m_base;
  QLockFile m_lock;
};

/// In AppDataLocation.
QString autosaveFolder();

/// What programs left behind that run no more, locked; the newest first.
std::vector<std::unique_ptr<AutosaveEntry>> abandonedEntries();

}  // namespace hogelscope
