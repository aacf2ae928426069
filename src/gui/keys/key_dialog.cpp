// SPDX-License-Identifier: BSD-3-Clause
#include "gui/keys/key_dialog.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <array>

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

namespace {

QString textOfKeys(const QList<QKeySequence>& keys) {
  return QKeySequence::listToString(keys, QKeySequence::NativeText);
}

QString nameOf(const KeyMap::Command& command) {
  return command.section.isEmpty() ? command.title : command.section + ": " + command.title;
}

/// Creates a button that Return does not press, because Return belongs to the table.
QPushButton* dialogButton(const char* name, const QString& text, const QString& help) {
  auto* made = new QPushButton(text);
  made->setObjectName(name);
  made->setToolTip(help);
  made->setAutoDefault(false);
  return made;
}

}  // namespace

KeyDialog::KeyDialog(KeyMap* map, QWidget* parent)
    : QDialog(parent),
      m_map(map),
      m_search(new QLineEdit),
      m_table(new QTableWidget),
      m_label(new QLabel),
      m_field(new KeyField),
      m_resetButton(
          dialogButton("resetKeyButton", tr("Reset &this"), tr("Back to its default key"))),
      m_note(new QLabel) {
  setObjectName("keyWindow");
  setWindowTitle(tr("Keys"));
  resize(1200, 640);
  makeTable();
  layOut();
  connect(m_search, &QLineEdit::textChanged, this, &KeyDialog::search);
  connect(m_search, &QLineEdit::returnPressed, m_field, [this] { m_field->setFocus(); });
  connect(m_table, &QTableWidget::currentCellChanged, this, &KeyDialog::showChosen);
  connect(m_table, &QTableWidget::cellActivated, m_field, [this] { m_field->setFocus(); });
  connect(m_field, &KeyField::keyPressed, this, [this](const QKeySequence& key) {
    m_map->setKey(std::size_t(m_table->currentRow()), key);
  });
  connect(m_resetButton, &QPushButton::clicked, this,
          [this] { m_map->reset(std::size_t(m_table->currentRow())); });
  connect(m_map, &KeyMap::changed, this, &KeyDialog::refresh);
  m_table->setCurrentCell(0, commandColumn);
  refresh();
  setWidths();
}

void KeyDialog::makeTable() {
  m_table->setObjectName("keyTable");
  m_table->setAccessibleName(tr("Commands and keys"));
  m_table->setRowCount(int(m_map->commands().size()));
  m_table->setColumnCount(columnCount);
  m_table->setHorizontalHeaderLabels(
      {tr("Command"), tr("What it does"), tr("Key"), tr("Default"), tr("Conflict")});
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setSelectionMode(QAbstractItemView::SingleSelection);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setTabKeyNavigation(false);
  m_table->setWordWrap(false);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  for (int row = 0; row < m_table->rowCount(); ++row)
    for (int column = 0; column < columnCount; ++column)
      m_table->setItem(row, column, new QTableWidgetItem);
}

void KeyDialog::layOut() {
  m_search->setObjectName("keySearch");
  m_search->setPlaceholderText(tr("Search commands and keys"));
  m_search->setToolTip(tr("Shows the rows that have these words; a key too, such as Ctrl+D"));
  m_search->setClearButtonEnabled(true);
  m_field->setObjectName("keyField");
  m_field->setPlaceholderText(tr("No key: press one here"));
  m_field->setToolTip(tr("Press the key that the command should have; Backspace takes it away"));
  m_note->setObjectName("keyNote");
  m_note->setWordWrap(true);
  auto* resetAll =
      dialogButton("resetAllKeysButton", tr("Reset &all"), tr("All default keys again"));
  auto* closeButton =
      dialogButton("closeKeysButton", tr("&Close"), tr("Changes are saved already"));
  connect(resetAll, &QPushButton::clicked, m_map, &KeyMap::resetAll);
  connect(closeButton, &QPushButton::clicked, this, &QDialog::close);
  auto* below = new QHBoxLayout;
  below->addWidget(m_label, 1);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{m_field, m_resetButton, resetAll, closeButton})
    below->addWidget(widget);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_search);
  layout->addWidget(m_table, 1);
  layout->addLayout(below);
  layout->addWidget(m_note);
}

/// Sets the column widths once, so that they do not change with rows or keys.
void KeyDialog::setWidths() {
  m_table->resizeColumnToContents(commandColumn);
  const int keyWidth = fontMetrics().horizontalAdvance("Ctrl+Alt+Shift+PgDown ");
  for (const int column : {keyColumn, defaultColumn}) m_table->setColumnWidth(column, keyWidth);
  m_table->setColumnWidth(conflictColumn, 2 * keyWidth);
  m_table->horizontalHeader()->setSectionResizeMode(helpColumn, QHeaderView::Stretch);
}

/// Shows the rows that contain all words, in any column.
void KeyDialog::search(const QString& words) {
  const QStringList wanted = words.split(' ', Qt::SkipEmptyParts);
  for (int row = 0; row < m_table->rowCount(); ++row) {
    QString all;
    for (int column = 0; column < columnCount; ++column)
      all += m_table->item(row, column)->text() + "\n";
    m_table->setRowHidden(row, !std::ranges::all_of(wanted, [&](const QString& word) {
                            return all.contains(word, Qt::CaseInsensitive);
                          }));
  }
  for (int row = 0; row < m_table->rowCount(); ++row)
    if (!m_table->isRowHidden(row)) return m_table->setCurrentCell(row, commandColumn);
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
  for (int column = 0; column < columnCount; ++column) {
    QTableWidgetItem* item = m_table->item(row, column);
    item->setText(texts[column]);
    item->setToolTip(texts[column]);
    item->setBackground(conflict.isEmpty() ? QBrush() : QColor(200, 60, 40, 70));
  }
  QFont font = m_table->font();
  font.setBold(command.keys != command.defaults);
  m_table->item(row, keyColumn)->setFont(font);
}

void KeyDialog::refresh() {
  for (int row = 0; row < m_table->rowCount(); ++row) showRow(row);
  showChosen();
}

void KeyDialog::showChosen() {
  const int row = m_table->currentRow();
  if (row < 0) return;
  const KeyMap::Command& command = m_map->commands()[std::size_t(row)];
  m_label->setText(nameOf(command));
  m_field->setText(textOfKeys(command.keys));
  m_resetButton->setEnabled(command.keys != command.defaults);
  const QString conflict = conflictText(row);
  m_note->setText(conflict.isEmpty()
                      ? tr("Choose a command, press Return, then press its new key.")
                      : tr("⚠ %1 is also the key of %2: it does nothing until one of them "
                           "has another.")
                            .arg(textOfKeys(command.keys), conflict));
}

}  // namespace hogelscope
