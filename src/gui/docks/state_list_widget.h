// SPDX-License-Identifier: BSD-3-Clause
// The list of camera states. Dragged rows emit their destination and do not move by themselves.
#pragma once

#include <QListWidget>
#include <vector>

namespace hogelscope {

class StateListWidget : public QListWidget {
  Q_OBJECT

 public:
  explicit StateListWidget(QWidget* parent = nullptr);

  /// Returns the size of six rows.
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  /// Emits the dragged rows in ascending order; `before` is a row index before the move, or the row
  /// count for the end.
  void rowsDropped(const std::vector<std::size_t>& rows, std::size_t before);

 protected:
  void startDrag(Qt::DropActions actions) override;
  void dropEvent(QDropEvent* event) override;

 private:
  [[nodiscard]] int rowBelow(const QDropEvent& event) const;
};

}  // namespace hogelscope
