// SPDX-License-Identifier: BSD-3-Clause
#include "gui/keys/key_dialog.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <algorithm>
#include <array>

#include "gui/widgets/colours.h"
#include "ui_key_dialog.h"

namespace hogelscope {

namespace {

bool isTaken(const QKeyEvent& event) {
  constexpr std::array<int, 5> kept{Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_Escape, Qt::Key_Return,
                                    Qt::Key_Enter};
  return std::ranges::find(kept, event.key()) == kept.end();
}

/// Whether the key is a modifier, such as Shift or Ctrl alone.
bool isModifier(int key) {
  return (key >= Qt::Key_Shift && key <= Qt::Key_ScrollLock) || key == Qt::Key_AltGr ||
         key == Qt::Key_Super_L || key == Qt::Key_Super_R || key == Qt::Key_unknown || key == 0;
}

/// Returns the modifiers. Shift that is needed to type a sign, such as +, is part of the sign.
Qt::KeyboardModifiers modifiersOf(const QKeyEvent& event) {
  Qt::KeyboardModifiers modifiers = event.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier |
                                                         Qt::AltModifier | Qt::MetaModifier);
  const bool isSign = event.key() < Qt::Key_Escape && event.key() != Qt::Key_Space &&
                      !QChar(event.key()).isLetterOrNumber();
  if (isSign) modifiers &= ~Qt::KeyboardModifiers(Qt::ShiftModifier);
  return modifiers;
}

QString textOfKeys(const QList<QKeySequence>& keys) {
  return QKeySequence::listToString(keys, QKeySequence::NativeText);
}

QString nameOf(const KeyMap::Command& command) {
  return command.section.isEmpty() ? command.title : command.section + ": " + command.title;
}

}  // namespace

KeyField::KeyField(QWidget* parent) : QLineEdit(parent) {
  setReadOnly(true);
  setContextMenuPolicy(Qt::NoContextMenu);
  setAttribute(Qt::WA_InputMethodEnabled, false);
}

bool KeyField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isTaken(static_cast<QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

void KeyField::keyPressEvent(QKeyEvent* event) {
  if (!isTaken(*event)) {
    event->ignore();
    return;
  }
  if (isModifier(event->key())) return;
  const Qt::KeyboardModifiers modifiers = modifiersOf(*event);
  const bool isRemoved = modifiers == Qt::NoModifier &&
                         (event->key() == Qt::Key_Backspace || event->key() == Qt::Key_Delete);
  Q_EMIT keyPressed(isRemoved ? QKeySequence()
                              : QKeySequence(QKeyCombination(modifiers, Qt::Key(event->key()))));
}

KeyDialog::KeyDialog(KeyMap* map, QWidget* parent)
    : QDialog(parent), m_map(map), m_ui(std::make_unique<Ui::KeyDialog>()) {
  m_ui->setupUi(this);
  m_ui->keyTable->setRowCount(int(m_map->commands().size()));
  m_ui->keyTable->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  for (int row = 0; row < m_ui->keyTable->rowCount(); ++row)
    for (int column = 0; column < columnCount; ++column)
      m_ui->keyTable->setItem(row, column, new QTableWidgetItem);
  connect(m_ui->keySearch, &QLineEdit::textChanged, this, &KeyDialog::search);
  const auto focusKey = [this] { m_ui->keyField->setFocus(); };
  connect(m_ui->keySearch, &QLineEdit::returnPressed, m_ui->keyField, focusKey);
  connect(m_ui->keyTable, &QTableWidget::cellActivated, m_ui->keyField, focusKey);
  connect(m_ui->keyTable, &QTableWidget::currentCellChanged, this, &KeyDialog::showChosen);
  connect(m_ui->keyField, &KeyField::keyPressed, this,
          [this](const QKeySequence& key) { m_map->setKey(chosen(), key); });
  connect(m_ui->resetKeyButton, &QPushButton::clicked, this, [this] { m_map->reset(chosen()); });
  connect(m_ui->resetAllKeysButton, &QPushButton::clicked, m_map, &KeyMap::resetAll);
  connect(m_map, &KeyMap::changed, this, &KeyDialog::refresh);
  m_ui->keyTable->setCurrentCell(0, commandColumn);
  refresh();
  setWidths();
}

KeyDialog::~KeyDialog() = default;

std::size_t KeyDialog::chosen() const {
  return std::size_t(m_ui->keyTable->currentRow());
}

/// Sets the column widths once, so that they do not change with rows or keys.
void KeyDialog::setWidths() {
  m_ui->keyTable->resizeColumnToContents(commandColumn);
  const int keyWidth = fontMetrics().horizontalAdvance("Ctrl+Alt+Shift+PgDown ");
  for (const int column : {keyColumn, defaultColumn})
    m_ui->keyTable->setColumnWidth(column, keyWidth);
  m_ui->keyTable->setColumnWidth(conflictColumn, keyWidth);
  m_ui->keyTable->horizontalHeader()->setSectionResizeMode(helpColumn, QHeaderView::Stretch);
}

/// Shows the rows that contain all words, in any column.
void KeyDialog::search(const QString& words) {
  const QStringList wanted = words.split(' ', Qt::SkipEmptyParts);
  for (int row = 0; row < m_ui->keyTable->rowCount(); ++row) {
    QString all;
    for (int column = 0; column < columnCount; ++column)
      all += m_ui->keyTable->item(row, column)->text() + "\n";
    m_ui->keyTable->setRowHidden(row, !std::ranges::all_of(wanted, [&](const QString& word) {
                                   return all.contains(word, Qt::CaseInsensitive);
                                 }));
  }
  for (int row = 0; row < m_ui->keyTable->rowCount(); ++row)
    if (!m_ui->keyTable->isRowHidden(row))
      return m_ui->keyTable->setCurrentCell(row, commandColumn);
}

QString KeyDialog::conflictText(int row) const {
  QStringList names;
  for (const std::size_t other : m_map->conflictsOf(std::size_t(row)))
    names << nameOf(m_map->commands()[other]);
  return names.join("; ");
}

void KeyDialog::showRow(int row) {
  const KeyMap::Command& command = m_map->commands()[std::size_t(row)];
  const QString conflict = conflictText(row);
  const QStringList texts{nameOf(command), command.help, textOfKeys(command.keys),
                          textOfKeys(command.defaults),
                          conflict.isEmpty() ? QString() : tr("⚠ also %1").arg(conflict)};
  QColor marked = tokens().error;
  marked.setAlphaF(0.3F);
  for (int column = 0; column < columnCount; ++column) {
    QTableWidgetItem* item = m_ui->keyTable->item(row, column);
    item->setText(texts[column]);
    item->setToolTip(texts[column]);
    item->setBackground(conflict.isEmpty() ? QBrush() : QBrush(marked));
  }
  QFont font = m_ui->keyTable->font();
  font.setBold(command.keys != command.defaults);
  m_ui->keyTable->item(row, keyColumn)->setFont(font);
}

void KeyDialog::refresh() {
  for (int row = 0; row < m_ui->keyTable->rowCount(); ++row) showRow(row);
  showChosen();
}

void KeyDialog::showChosen() {
  const int row = m_ui->keyTable->currentRow();
  if (row < 0) return;
  const KeyMap::Command& command = m_map->commands()[std::size_t(row)];
  m_ui->commandLabel->setText(nameOf(command));
  m_ui->keyField->setText(textOfKeys(command.keys));
  m_ui->resetKeyButton->setEnabled(command.keys != command.defaults);
  const QString conflict = conflictText(row);
  m_ui->keyNote->setText(conflict.isEmpty()
                             ? tr("Choose a command, press Return, then press its new key.")
                             : tr("⚠ %1 is also the key of %2: it does nothing until one of them "
                                  "has another.")
                                   .arg(textOfKeys(command.keys), conflict));
}

}  // namespace hogelscope
