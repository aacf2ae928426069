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
  /// Once the drop has ended, so that a question does not hold the other program.
  void dropped(const QStringList& files);

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hogelscope
