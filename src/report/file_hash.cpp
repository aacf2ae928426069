// SPDX-License-Identifier: BSD-3-Clause
// SHA-256 of files, by Qt.
#include "report/file_hash.h"

#include <QCryptographicHash>
#include <QFile>

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::string hashOf(const fs::path& path, const Progress& progress) {
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::ReadOnly))
    throw InputError(path.string(), "cannot be read", file.errorString().toStdString());
  QCryptographicHash hash(QCryptographicHash::Sha256);
  constexpr qint64 block = qint64{1} << 20;
  while (true) {
    advance(progress, 0.0);
    const QByteArray bytes = file.read(block);
    if (bytes.isEmpty()) break;
    hash.addData(bytes);
  }
  if (file.error() != QFileDevice::NoError)
    throw InputError(path.string(), "cannot be read", file.errorString().toStdString());
  return hash.result().toHex().toStdString();
}

}  // namespace

std::string sha256(const std::vector<fs::path>& files, const Progress& progress) {
  if (files.size() == 1) return hashOf(files.front(), progress);
  std::string lines;
  for (const fs::path& file : files)
    lines += hashOf(file, progress) + "  " + file.filename().string() + "\n";
  return sha256(lines);
}

std::string sha256(const std::string& text) {
  return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256)
      .toHex()
      .toStdString();
}

}  // namespace hogelscope
