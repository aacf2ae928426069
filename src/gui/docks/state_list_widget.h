// SPDX-License-Identifier: BSD-3-Clause
// The list of camera states; dragged rows tell where they are to go and do not move by themselves.
#pragma once

#include <QListWidget>
#include <vector>

namespace hogelscope {

class StateListWidget : public QListWidget {
  Q_OBJECT

 public:
  explicit StateListWidget(QWidget* parent = nullptr);

  /// Six rows.
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  /// In ascending order; `before` is a row as they are now, or their number for the end.
  void rowsDropped(const std::vector<std::size_t>& rows, std::size_t before);

 protected:
  void startDrag(Qt::DropActions actions) override;
  void dropEvent(QDropEvent* event) override;

 private:
  [[nodiscard]] int rowBelow(const QDropEvent& event) const;
};

}  // namespace hogelscope
