// SPDX-License-Identifier: BSD-3-Clause
#include "gui/files/autosave.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>

#include "gui/session/session_model.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
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

Autosave::Autosave(SessionModel* model, QObject* parent)
    : QObject(parent),
      m_model(model),
      m_entry(autosaveFolder() + "/" + QUuid::createUuid().toString(QUuid::WithoutBraces)) {
  m_timer.setSingleShot(true);
  m_timer.setInterval(std::chrono::seconds(3));
  connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
  for (const auto change :
       {&SessionModel::edited, &SessionModel::statesChanged, &SessionModel::contentChanged})
    connect(model, change, this, &Autosave::writeSoon);
  connect(model, &SessionModel::saved, this, &Autosave::forget);
  connect(model, &SessionModel::opened, this, [this] {
    forget();
    if (m_model->isModified()) write();  // a recovered session
  });
}

/// Starts the timer. Later edits do not delay it, because a value may be dragged for minutes.
void Autosave::writeSoon() {
  if (!m_timer.isActive()) m_timer.start();
}

/// Writes the session. If it cannot be written, because the disk is full or two values are not
/// consistent yet, it is tried again later and the previous copy stays.
void Autosave::write() {
  if (!m_model->isModified()) return forget();
  QString failure;
  try {
    check(m_model->session());
    failure = writeEntry();
  } catch (const std::exception&) {
    m_timer.start();
    return;
  }
  if (!failure.isEmpty()) m_timer.start();
  if (!failure.isEmpty() && failure != m_failure) Q_EMIT failed(failure);
  m_failure = failure;
}

/// Returns an error message, or "" on success.
QString Autosave::writeEntry() {
  try {
    makeFolder(autosaveFolder().toStdString());
    if (!m_entry.lock())
      return tr("%1 cannot be written; a crash would lose the edits").arg(m_entry.sessionFile());
    m_entry.write(m_model->session(), m_model->file());
    return {};
  } catch (const std::exception& error) {
    return tr("%1; a crash would lose the edits").arg(QString::fromUtf8(error.what()));
  }
}

void Autosave::forget() {
  m_timer.stop();
  m_entry.remove();
}

void Autosave::offerRecovery(QWidget* window) {
  for (const auto& entry : abandonedEntries()) {
    const Recovery answer = askRecovery(window, entry->document(), entry->time());
    if (answer == Recovery::discard) entry->remove();
    if (answer == Recovery::recover && recover(*entry)) return;
  }
}

/// Recovers a session. Its entry is removed only after this program has written its own.
bool Autosave::recover(AutosaveEntry& entry) {
  if (!guarded(this, [&] { m_model->recover(entry.sessionFile(), entry.document()); }))
    return false;
  if (!m_model->isModified() || QFile::exists(m_entry.sessionFile())) entry.remove();
  return true;
}

}  // namespace hogelscope
