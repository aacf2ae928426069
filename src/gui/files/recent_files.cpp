// SPDX-License-Identifier: BSD-3-Clause
#include "gui/files/recent_files.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QMenu>
#include <QSaveFile>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>

namespace hogelscope {

namespace {

constexpr std::size_t mostFiles = 12;
constexpr const char* recentKey = "recent";

QDir pictureFolder() {
  return {QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/recent"};
}

QString pictureOf(const QString& file) {
  const QByteArray name = QCryptographicHash::hash(file.toUtf8(), QCryptographicHash::Sha1).toHex();
  return pictureFolder().filePath(name + ".png");
}

/// Returns all files, also missing ones, which may be on a disk that is not connected.
std::vector<RecentFile> readList() {
  std::vector<RecentFile> files;
  for (const QVariant& entry : QSettings().value(recentKey).toList()) {
    const QVariantList values = entry.toList();
    const QString file = values.value(0).toString();
    files.push_back(
        {file, values.value(1).toString(), values.value(2).toDateTime(), pictureOf(file)});
  }
  return files;
}

void writeList(const std::vector<RecentFile>& files) {
  QVariantList list;
  for (const RecentFile& recent : files)
    list << QVariant(QVariantList{recent.file, recent.what, recent.when});
  QSettings().setValue(recentKey, list);
}

/// Removes the pictures of files that are no longer in the list.
void trimPictures(const std::vector<RecentFile>& files) {
  for (const QFileInfo& picture : pictureFolder().entryInfoList({"*.png"}, QDir::Files))
    if (std::ranges::find(files, picture.filePath(), &RecentFile::thumbnail) == files.end())
      QFile::remove(picture.filePath());
}

}  // namespace

RecentFiles::RecentFiles(QMenu* menu, QObject* parent) : QObject(parent), m_menu(menu) {
  m_menu->setToolTipsVisible(true);
  connect(m_menu, &QMenu::aboutToShow, this, &RecentFiles::fill);
}

std::vector<RecentFile> RecentFiles::list() {
  std::vector<RecentFile> files = readList();
  std::erase_if(files, [](const RecentFile& recent) { return !QFileInfo::exists(recent.file); });
  return files;
}

void RecentFiles::add(const QString& file, const QString& what) {
  const QString path = QFileInfo(file).absoluteFilePath();
  std::vector<RecentFile> files = readList();
  std::erase_if(files, [&](const RecentFile& recent) { return recent.file == path; });
  files.insert(files.begin(), {path, what, QDateTime::currentDateTime(), pictureOf(path)});
  files.resize(std::min(files.size(), mostFiles));
  writeList(files);
  trimPictures(files);
}

void RecentFiles::setThumbnail(const QString& file, const QImage& view) {
  const std::vector<RecentFile> files = readList();
  const QString path = QFileInfo(file).absoluteFilePath();
  const auto recent = std::ranges::find(files, path, &RecentFile::file);
  if (recent == files.end() || view.isNull() || !pictureFolder().mkpath(".")) return;
  QSaveFile picture(recent->thumbnail);  // a missing picture is no error worth a message
  if (!picture.open(QIODevice::WriteOnly)) return;
  view.scaled(112, 80, Qt::KeepAspectRatio, Qt::SmoothTransformation).save(&picture, "PNG");
  picture.commit();
}

void RecentFiles::fill() {
  m_menu->clear();
  for (const RecentFile& recent : list()) {
    const auto number = int(m_menu->actions().size()) + 1;
    const QString name = QFileInfo(recent.file).fileName().replace("&", "&&");
    const QString form = number < 10 ? tr("&%1  %2") : tr("%1  %2");
    QAction* action = m_menu->addAction(form.arg(number).arg(name), this,
                                        [this, file = recent.file] { Q_EMIT chosen(file); });
    action->setToolTip(recent.what.isEmpty() ? recent.file : recent.what + '\n' + recent.file);
  }
  if (m_menu->isEmpty()) m_menu->addAction(tr("None yet"))->setEnabled(false);
}

}  // namespace hogelscope
