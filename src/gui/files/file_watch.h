// SPDX-License-Identifier: BSD-3-Clause
// Watches files that other programs may change.
#pragma once

#include <QFileSystemWatcher>
#include <QMap>
#include <QTimer>
#include <string>

namespace hogelscope {

/// Reports a file when it has stayed the same for half a second after a change, so neither while it
/// is written nor while it is missing. A folder changes when one of its files is added, removed or
/// replaced.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(QObject* parent);

  /// Watches these paths in place of others; new ones are known as they are now.
  void watch(const QStringList& paths);
  /// Takes a path as it is now for known, because this program has written it.
  void know(const QString& path);

 Q_SIGNALS:
  void changed(const QString& path);

 private:
  void look();

  QFileSystemWatcher m_watcher;
  QTimer m_timer;  ///< runs after each change, and while a file is missing
  QMap<QString, std::string> m_known;
};

}  // namespace hogelscope
