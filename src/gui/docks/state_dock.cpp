// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/state_dock.h"

#include <QDrag>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QGridLayout>
#include <QMimeData>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/session/session_model.h"
#include "gui/session/state_commands.h"
#include "io/documents/session_file.h"

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

StateDock::StateDock(SessionModel* model, StateCommands* commands, QWidget* parent)
    : QWidget(parent), m_model(model), m_commands(commands), m_list(new StateListWidget) {
  setAcceptDrops(true);
  m_list->setToolTip(
      tr("The camera states; Ctrl or Shift marks several, for editing, deleting, saving and "
         "dragging"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_list, 1);
  layout->addWidget(makeButtons());
  connect(m_list, &QListWidget::currentRowChanged, this,
          [this](int row) { m_model->setCurrentIndex(std::size_t(row)); });
  connect(m_list, &QListWidget::itemSelectionChanged, this, &StateDock::emitSelection);
  connect(m_list, &QListWidget::itemChanged, this, &StateDock::rename);
  connect(m_list, &StateListWidget::rowsDropped, m_commands, &StateCommands::move);
  connect(m_model, &SessionModel::opened, this, &StateDock::fill);
  connect(m_model, &SessionModel::statesChanged, this, &StateDock::fill);
  connect(m_model, &SessionModel::edited, this, &StateDock::showCurrent);
  connect(m_model, &SessionModel::currentChanged, this, &StateDock::showCurrent);
  fill();
}

QWidget* StateDock::makeButtons() {
  constexpr int columns = 3;
  auto* buttons = new QWidget;
  auto* grid = new QGridLayout(buttons);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2);
  int count = 0;
  for (QAction* action : m_commands->actions()) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    grid->addWidget(button, count / columns, count % columns);
    ++count;
  }
  return buttons;
}

/// Updates the items in place, because one of them may be open in its editor.
void StateDock::fill() {
  {
    const QSignalBlocker quiet(m_list);
    const std::vector<CameraState>& states = m_model->session().cameras;
    while (m_list->count() > int(states.size())) delete m_list->takeItem(m_list->count() - 1);
    while (m_list->count() < int(states.size())) {
      auto* item = new QListWidgetItem(m_list);
      item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    for (int row = 0; row < m_list->count(); ++row)
      m_list->item(row)->setText(QString::fromStdString(states[std::size_t(row)].camera.name));
  }
  showCurrent();
}

void StateDock::showCurrent() {
  const int row = int(m_model->currentIndex());
  if (m_list->currentRow() != row) {
    const QSignalBlocker quiet(m_list);
    m_list->setCurrentRow(row, QItemSelectionModel::ClearAndSelect);
  }
  emitSelection();
}

void StateDock::emitSelection() {
  std::vector<std::size_t> marked;
  for (const QModelIndex& index : m_list->selectionModel()->selectedRows())
    marked.push_back(std::size_t(index.row()));
  m_model->setMarked(std::move(marked));
}

void StateDock::editName() {
  m_list->setFocus();
  m_list->editItem(m_list->currentItem());
}

/// Renames a state, or restores the old name if the new one is rejected.
void StateDock::rename(const QListWidgetItem* item) {
  if (!m_commands->rename(std::size_t(m_list->row(item)), item->text())) fill();
}

void StateDock::dragEnterEvent(QDragEnterEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (isSessionFile(url.toLocalFile().toStdString())) return event->acceptProposedAction();
}

void StateDock::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (isSessionFile(url.toLocalFile().toStdString()))
      m_commands->mergeStatesOf(url.toLocalFile());
  event->acceptProposedAction();
}

}  // namespace hogelscope
