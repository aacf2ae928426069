// SPDX-License-Identifier: BSD-3-Clause
#include "gui/files/autosave_entry.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"

namespace hogelscope {

AutosaveEntry::AutosaveEntry(const QString& base) : m_base(base), m_lock(base + ".lock") {
  m_lock.setStaleLockTime(0);  // only the owner's death counts, not the lock's age
}

void AutosaveEntry::write(const Session& session, const QString& document) {
  const QString path = document.isEmpty() ? QString() : QFileInfo(document).absoluteFilePath();
  writeTextFile(documentFile().toStdString(), path.toStdString());
  saveSession(sessionFile().toStdString(), session);
}

void AutosaveEntry::remove() {
  QFile::remove(sessionFile());
  QFile::remove(documentFile());
  m_lock.unlock();
}

QString AutosaveEntry::document() const {
  QFile file(documentFile());
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QDateTime AutosaveEntry::time() const {
  return QFileInfo(sessionFile()).lastModified();
}

QString autosaveFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/autosave";
}

std::vector<std::unique_ptr<AutosaveEntry>> abandonedEntries() {
  std::vector<std::unique_ptr<AutosaveEntry>> entries;
  const QDir folder(autosaveFolder());
  for (const QFileInfo& file : folder.entryInfoList({"*.json"}, QDir::Files, QDir::Time)) {
    auto entry = std::make_unique<AutosaveEntry>(folder.filePath(file.completeBaseName()));
    // Its owner may have removed the file since the folder was read.
    if (entry->lock() && QFileInfo::exists(entry->sessionFile()))
      entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace hogelscope
