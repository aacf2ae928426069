// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/state_list_widget.h"

#include <QDrag>
#include <QDropEvent>
#include <QMimeData>
#include <algorithm>

namespace hogelscope {

StateListWidget::StateListWidget(QWidget* parent) : QListWidget(parent) {
  setObjectName("stateList");
  setSelectionMode(ExtendedSelection);
  setEditTriggers(DoubleClicked);
  setUniformItemSizes(true);
  setDragDropMode(InternalMove);
  setDragDropOverwriteMode(false);
}

QSize StateListWidget::sizeHint() const {
  constexpr int rows = 6;
  const int row = count() > 0 ? sizeHintForRow(0) : fontMetrics().height() + 4;
  return {QListWidget::sizeHint().width(), rows * row + 2 * frameWidth()};
}

/// Returns the row before which a drop inserts: the upper half of a row is above it, the lower half
/// below; below the last row is the end.
int StateListWidget::rowBelow(const QDropEvent& event) const {
  const QPoint at = event.position().toPoint();
  const QModelIndex index = indexAt(at);
  if (!index.isValid()) return count();
  return at.y() < visualRect(index).center().y() ? index.row() : index.row() + 1;
}

/// Starts a drag without Qt's removal of the rows.
void StateListWidget::startDrag(Qt::DropActions) {
  auto* drag = new QDrag(this);
  drag->setMimeData(model()->mimeData(selectedIndexes()));
  drag->setPixmap(viewport()->grab(visualRect(currentIndex())));
  drag->exec(Qt::MoveAction);
}

/// Emits the move; the session moves its states and the list follows.
void StateListWidget::dropEvent(QDropEvent* event) {
  std::vector<std::size_t> rows;
  for (const QModelIndex& index : selectionModel()->selectedRows())
    rows.push_back(std::size_t(index.row()));
  std::ranges::sort(rows);
  event->acceptProposedAction();
  setState(NoState);
  viewport()->update();
  Q_EMIT rowsDropped(rows, std::size_t(rowBelow(*event)));
}

}  // namespace hogelscope
