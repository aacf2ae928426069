// SPDX-License-Identifier: BSD-3-Clause
// Dropping of files and folders onto the window.
#pragma once

#include <QObject>
#include <QStringList>

class QWidget;

namespace hogelscope {

class FileDrop : public QObject {
  Q_OBJECT

 public:
  explicit FileDrop(QWidget* window);

 Q_SIGNALS:
  /// Emitted during the drop. Connect it as queued, or a dialog would block the other program.
  void dropped(const QStringList& files);

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hogelscope
