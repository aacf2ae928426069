// SPDX-License-Identifier: BSD-3-Clause
#include "gui/files/file_drop.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>
#include <QWidget>

namespace hogelscope {

namespace {

QStringList filesOf(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) files.append(url.toLocalFile());
  return files;
}

}  // namespace

FileDrop::FileDrop(QWidget* window) : QObject(window) {
  window->setAcceptDrops(true);
  window->installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* /*watched*/, QEvent* event) {
  if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop) return false;
  auto* drop = static_cast<QDropEvent*>(event);
  const QStringList files = filesOf(*drop->mimeData());
  if (files.isEmpty()) return false;
  drop->acceptProposedAction();
  if (event->type() == QEvent::Drop) Q_EMIT dropped(files);
  return true;
}

}  // namespace hogelscope
