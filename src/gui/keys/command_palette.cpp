// SPDX-License-Identifier: BSD-3-Clause
#include "gui/keys/command_palette.h"

#include <QAction>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QPainter>
#include <QScrollArea>
#include <QSettings>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <tuple>

#include "core/base/word_fit.h"
#include "gui/keys/key_map.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/parameter_form.h"
#include "gui/widgets/section.h"
#include "ui_command_palette.h"

namespace hogelscope {

namespace {

/// Whether a command can be used: its menus, if any, are enabled too.
bool isUsable(const QAction& action) {
  return action.isEnabled() && std::ranges::all_of(action.associatedObjects(), [](QObject* object) {
           const auto* menu = qobject_cast<QMenu*>(object);
           return menu == nullptr || menu->isEnabled();
         });
}

constexpr const char* usedKey = "paletteRecent";
constexpr int mostRows = 10;

enum EntryRole { entryRole = Qt::UserRole, pathRole, rightRole };

/// Paints an entry: title, path, and at the right the key in a frame. A field has no path, since it
/// stands in its title, and a value instead of a key.
class EntryDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
    return {scaled(200), scaled(28)};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const Tokens& t = tokens();
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const QColor faint = isSelected ? t.text2 : t.text3;
    const QString path = index.data(pathRole).toString();
    painter->save();
    if (isSelected) painter->fillRect(option.rect, t.selection);
    QRect place = option.rect.adjusted(scaled(12), 0, -scaled(12), 0);
    const QString right = index.data(rightRole).toString();
    const bool isKey = !path.isEmpty() && !right.isEmpty();
    if (isKey) place.adjust(0, 0, -scaled(5), 0);
    const QRect key = writeLine(*painter, place.adjusted(place.width() / 2, 0, 0, 0),
                                Qt::AlignVCenter | Qt::AlignRight, right,
                                textFont(isKey ? TextSize::caption : TextSize::base), faint);
    painter->setPen(t.strongLine);
    if (isKey) painter->drawRoundedRect(key.adjusted(-scaled(5), -1, scaled(5), 1), 3, 3);
    place.setRight(key.left() - scaled(12));
    const QRect title = writeLine(*painter, place, Qt::AlignVCenter, index.data().toString(),
                                  textFont(TextSize::base),
                                  option.state.testFlag(QStyle::State_Enabled) ? t.text : faint);
    place.setLeft(title.right() + scaled(8));
    writeLine(*painter, place, Qt::AlignVCenter, path, textFont(TextSize::caption), faint);
    painter->restore();
  }
};

/// Returns how well a word fits an entry, itself or by another word for the same thing.
int fitOf(const std::string& word, const std::string& title, const std::string& path) {
  using Words = std::pair<std::string_view, std::string_view>;
  static constexpr std::array others{
      Words{"generate", "make"},     Words{"metric", "report"},      Words{"psnr", "report"},
      Words{"flip", "report"},       Words{"codec", "report"},       Words{"leakage", "psf"},
      Words{"psf", "leakage"},       Words{"blur", "leakage"},       Words{"crosstalk", "leakage"},
      Words{"fisheye", "model"},     Words{"distortion", "lens"},    Words{"calibration", "import"},
      Words{"unit", "twin"},         Words{"tolerance", "twin"},     Words{"error", "difference"},
      Words{"export", "save"},       Words{"screenshot", "picture"}, Words{"aperture", "pupil"},
      Words{"depth", "measure"},     Words{"ipd", "stereo"},         Words{"theme", "dark"},
      Words{"font", "text"},         Words{"speed", "method"},       Words{"views", "directions"},
      Words{"resolution", "res"},    Words{"video", "animation"},    Words{"shortcut", "keys"},
      Words{"trajectory", "camera"}, Words{"quit", "close"}};
  int fit = wordFit(word, title, path);
  for (const auto& [asked, other] : others)  // from the third letter on
    if (word.size() > 2 && asked.starts_with(word))
      fit = std::max(fit, wordFit(other, title, path) / 2);
  return fit;
}

/// Shows the field and moves the focus into it.
void goTo(QWidget* editor) {
  for (QWidget* each = editor; each != nullptr; each = each->parentWidget()) {
    if (auto* section = qobject_cast<Section*>(each)) section->setOpen(true);
    if (auto* dock = qobject_cast<QDockWidget*>(each)) {
      dock->show();
      dock->raise();
    }
  }
  const auto focus = [editor] {
    for (QWidget* each = editor; each != nullptr; each = each->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(each)) area->ensureWidgetVisible(editor);
    editor->activateWindow();
    editor->setFocus(Qt::TabFocusReason);
    if (editor->metaObject()->indexOfMethod("selectAll()") >= 0)  // of line edits and spin boxes
      QMetaObject::invokeMethod(editor, "selectAll");
  };
  QMetaObject::invokeMethod(editor, focus, Qt::QueuedConnection);  // once it is laid out
}

}  // namespace

CommandPalette::CommandPalette(KeyMap* map, QMainWindow* window)
    : QFrame(window), m_map(map), m_window(window), m_ui(std::make_unique<Ui::CommandPalette>()) {
  hide();
  m_ui->setupUi(this);
  m_ui->paletteSearch->addAction(icon("find"), QLineEdit::LeadingPosition);
  m_ui->paletteSearch->installEventFilter(this);
  m_ui->paletteList->setItemDelegate(new EntryDelegate(m_ui->paletteList));
  connect(m_ui->paletteSearch, &QLineEdit::textChanged, this, &CommandPalette::search);
  connect(m_ui->paletteList, &QListWidget::itemClicked, this, &CommandPalette::choose);
}

CommandPalette::~CommandPalette() = default;

QToolButton* CommandPalette::makeButton(QAction* action) {
  auto* button = new QToolButton;
  button->setObjectName("commandPaletteButton");
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setIcon(icon("find"));
  button->setToolTip(action->toolTip());
  const auto showKey = [button, action] {
    button->setText(
        tr("Commands and fields   %1").arg(action->shortcut().toString(QKeySequence::NativeText)));
  };
  connect(action, &QAction::changed, button, showKey);
  connect(button, &QToolButton::clicked, action, &QAction::trigger);
  showKey();
  return button;
}

void CommandPalette::toggle() {
  if (isVisible()) return leave();
  m_before = m_window->focusWidget();
  collect();
  m_ui->paletteSearch->clear();
  search({});
  show();
  raise();
  m_window->activateWindow();
  m_ui->paletteSearch->setFocus(Qt::ShortcutFocusReason);
}

/// Reads the commands and the fields as they are now.
void CommandPalette::collect() {
  m_entries.clear();
  for (const ParameterForm* form : m_window->findChildren<ParameterForm*>())
    for (const ParameterForm::Row& row : form->rows())
      if (row.editor->isEnabled())
        m_entries.push_back(
            {row.group + '.' + row.label, row.label, row.group, row.text, {}, row.editor});
  for (const KeyMap::Command& command : m_map->commands()) {
    const auto usable = std::ranges::find_if(command.actions, [](const QPointer<QAction>& action) {
      return action != nullptr && isUsable(*action);
    });
    m_entries.push_back({command.name,
                         command.title,
                         command.section,
                         command.keys.value(0).toString(QKeySequence::NativeText),
                         usable == command.actions.end() ? nullptr : *usable,
                         {}});
  }
}

/// Lists the entries that fit all words, the best ones first, then those used last; commands that
/// are disabled are at the end.
void CommandPalette::search(const QString& text) {
  const QStringList words = text.toLower().split(' ', Qt::SkipEmptyParts);
  const QStringList used = QSettings().value(usedKey).toStringList();
  std::vector<std::tuple<bool, int, std::size_t, std::size_t>> found;  // in the list's order
  for (std::size_t k = 0; k < m_entries.size(); ++k) {
    const Entry& entry = m_entries[k];
    const std::string title = entry.title.toLower().toStdString();
    const std::string path = entry.path.toLower().toStdString();
    int sum = 0;
    const bool fits = std::ranges::all_of(words, [&](const QString& word) {
      const int fit = fitOf(word.toStdString(), title, path);
      sum += fit;
      return fit > 0;
    });
    const bool isDisabled = entry.action == nullptr && entry.editor == nullptr;
    // One that was never used is at -1, the largest unsigned number.
    if (fits) found.emplace_back(isDisabled, -sum, std::size_t(used.indexOf(entry.id)), k);
  }
  std::ranges::sort(found);
  m_ui->paletteList->clear();
  for (const auto& [isDisabled, fit, use, k] : found) {
    const Entry& entry = m_entries[k];
    const bool isField = entry.editor != nullptr;
    auto* item = new QListWidgetItem(isField ? entry.path + " · " + entry.title : entry.title,
                                     m_ui->paletteList);
    item->setData(entryRole, qulonglong(k));
    item->setData(pathRole, isField ? QString() : entry.path);
    item->setData(rightRole, entry.right);
    if (isDisabled) item->setFlags(Qt::NoItemFlags);
  }
  if (found.empty()) {
    auto* none =
        new QListWidgetItem(tr("Nothing fits “%1”").arg(text.trimmed()), m_ui->paletteList);
    none->setFlags(Qt::NoItemFlags);
  }
  m_ui->paletteList->setCurrentRow(0);
  const int width = std::clamp(m_window->width() * 2 / 5, scaled(380), scaled(560));
  const int height = std::min(m_ui->paletteList->count(), mostRows) * scaled(28) + 2;
  setGeometry((m_window->width() - width) / 2, scaled(8), width,
              m_ui->paletteSearch->sizeHint().height() + height);
}

/// Does the command, with the focus where it was, or goes to the field.
void CommandPalette::choose() {
  const QListWidgetItem* item = m_ui->paletteList->currentItem();
  if (item == nullptr || item->flags() == Qt::NoItemFlags) return;
  const Entry entry = m_entries[item->data(entryRole).toULongLong()];
  QStringList used = QSettings().value(usedKey).toStringList();
  used.removeAll(entry.id);
  used.prepend(entry.id);
  QSettings().setValue(usedKey, used.mid(0, mostRows));
  leave();
  if (entry.editor != nullptr) return goTo(entry.editor);
  QMetaObject::invokeMethod(entry.action, &QAction::trigger, Qt::QueuedConnection);
}

/// Gives the focus back and hides the palette.
void CommandPalette::leave() {
  if (m_before != nullptr) m_before->setFocus();
  hide();
}

/// Handles the search field's keys, which are not the window's while it has the focus.
bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason)
    hide();
  const bool isPress = event->type() == QEvent::KeyPress;
  if (!isPress && event->type() != QEvent::ShortcutOverride)
    return QFrame::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool isChoice = key == Qt::Key_Return || key == Qt::Key_Enter;
  const int step = key == Qt::Key_Up         ? -1
                   : key == Qt::Key_Down     ? 1
                   : key == Qt::Key_PageUp   ? 1 - mostRows
                   : key == Qt::Key_PageDown ? mostRows - 1
                                             : 0;
  if (!isChoice && step == 0 && key != Qt::Key_Escape) return QFrame::eventFilter(watched, event);
  event->accept();
  if (!isPress) return true;
  if (isChoice) choose();
  if (key == Qt::Key_Escape) leave();
  if (step != 0)
    m_ui->paletteList->setCurrentRow(
        std::clamp(m_ui->paletteList->currentRow() + step, 0, m_ui->paletteList->count() - 1));
  return true;
}

}  // namespace hogelscope
