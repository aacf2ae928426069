// SPDX-License-Identifier: BSD-3-Clause
// The sessions and light fields that were opened or saved last, with a small picture of each; their
// submenu. Kept in the settings, the pictures in the user's folder of caches.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <vector>

class QImage;
class QMenu;

namespace hogelscope {

struct RecentFile {
  QString file;       ///< the absolute path of a session, an image, a folder of views or a mesh
  QString what;       ///< in words, such as "Session · 12 states"; may be empty
  QDateTime when;     ///< opened or saved last
  QString thumbnail;  ///< an image file of at most 112 × 80 px; missing until it has been rendered
};

class RecentFiles : public QObject {
  Q_OBJECT

 public:
  /// Fills `menu` whenever it is about to be shown.
  RecentFiles(QMenu* menu, QObject* parent);

  /// Returns the files that exist, latest first.
  static std::vector<RecentFile> list();
  /// Puts a file at the head of the list, which holds twelve.
  static void add(const QString& file, const QString& what);
  /// Keeps a small copy of a view of a file in the list; ignores other files.
  static void setThumbnail(const QString& file, const QImage& view);

 Q_SIGNALS:
  void chosen(const QString& file);

 private:
  void fill();

  QMenu* m_menu;
};

}  // namespace hogelscope
