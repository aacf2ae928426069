// SPDX-License-Identifier: BSD-3-Clause
// Files and folders that are dropped onto the window.
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
  /// During the drop: to be connected as queued, or a question would hold the other program.
  void dropped(const QStringList& files);

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hogelscope
