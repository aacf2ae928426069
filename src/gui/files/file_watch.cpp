// SPDX-License-Identifier: BSD-3-Clause
#include "gui/files/file_watch.h"

#include <QDir>

#include "io/files/content_hash.h"

namespace hogelscope {

namespace {

/// Changes with a file, or with those in a folder; "" if it is missing.
std::string identityOf(const QString& path) {
  std::string text = fileIdentity(path.toStdString());
  for (const QFileInfo& each : QDir(path).entryInfoList(QDir::Files))
    text += fileIdentity(each.filePath().toStdString());
  return text;
}

}  // namespace

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
  m_timer.setSingleShot(true);
  m_timer.setInterval(std::chrono::milliseconds(500));
  connect(&m_timer, &QTimer::timeout, this, &FileWatch::look);
  for (const auto change :
       {&QFileSystemWatcher::fileChanged, &QFileSystemWatcher::directoryChanged})
    connect(&m_watcher, change, this, [this] { m_timer.start(); });
}

void FileWatch::watch(const QStringList& paths) {
  for (const QString& old : m_known.keys())
    if (!paths.contains(old)) m_known.remove(old), m_watcher.removePath(old);
  for (const QString& path : paths)
    if (!m_known.contains(path)) know(path);
}

void FileWatch::know(const QString& path) {
  m_known[path] = identityOf(path);
  m_watcher.addPath(path);
}

/// A file that was replaced is no longer watched; it is reported after another half second, in
/// which it is.
void FileWatch::look() {
  for (const QString& path : m_known.keys()) {
    const bool wasWatched = !m_watcher.addPath(path);
    const std::string now = identityOf(path);
    if (now == m_known.value(path, now)) continue;
    if (now.empty() || !wasWatched) {
      m_timer.start();
    } else {
      m_known[path] = now;
      Q_EMIT changed(path);
    }
  }
}

}  // namespace hogelscope
