// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/state_dock.h"

#include <QAbstractListModel>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/colour_map.h"
#include "core/base/row_filter.h"
#include "core/optics/scene_eyes.h"
#include "gui/scene/scene_controller.h"
#include "gui/session/session_model.h"
#include "gui/session/state_commands.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/filtered_rows.h"
#include "io/documents/session_file.h"
#include "ui_state_dock.h"

namespace hogelscope {

namespace {

enum StateRole {
  detailRole = Qt::UserRole,
  pictureRole,
  currentRole,
  psnrRole,
  shareRole,
  staleRole
};

/// Returns a row's second line: where the eye is, lens and leakage.
QString detailOf(const DisplayParams& display, const CameraState& state) {
  const EyePlace eye = eyePlaceOf(display, state.camera.eye);
  QString text = StateDock::tr("%1 m · %2°")
                     .arg(eye.distance, 0, 'f', 2)
                     .arg(QString::number(std::lround(eye.across)).replace('-', QChar(0x2212)));
  if (!state.distortion.isPinhole()) text += StateDock::tr(" · lens");
  if (state.psf.windowSize > 1) text += StateDock::tr(" · σ %1").arg(state.psf.sigma, 0, 'f', 2);
  return text;
}

/// Returns a row's picture from one of the scene, whose rows are from below.
QImage toPicture(vtkImageData& image) {
  const int* size = image.GetDimensions();
  const QImage from(static_cast<const uchar*>(image.GetScalarPointer()), size[0], size[1],
                    3 * size[0], QImage::Format_RGB888);
  return from.mirrored().scaled(112, 80, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

}  // namespace

/// A row for each state. Its text is the state's name; a dragged row moves the state.
class StateRows : public QAbstractListModel {
 public:
  StateRows(SessionModel* model, StateCommands* commands, QObject* parent)
      : QAbstractListModel(parent), m_model(model), m_commands(commands) {}

  QHash<QString, QImage> pictures;  ///< by the states' names, so that they follow a moved state
  std::vector<double> psnr;         ///< dB, of each state; empty: none
  std::vector<bool> isStale;        ///< of psnr

  /// Returns PSNR, sigma, whether there is a lens, distance and angle; NaN: there is none.
  [[nodiscard]] std::array<double, 5> numbersOf(std::size_t row) const {
    const CameraState& state = m_model->session().cameras[row];
    const EyePlace eye = eyePlaceOf(m_model->session().display, state.camera.eye);
    return {row < psnr.size() ? psnr[row] : NAN, state.psf.windowSize > 1 ? state.psf.sigma : NAN,
            state.distortion.isPinhole() ? 0.0 : 1.0, eye.distance, eye.across};
  }

  /// Follows any change. Rows that remain stay, because one may be open in its editor.
  void refresh() {
    const int count = int(m_model->session().cameras.size());
    if (count < m_count) beginRemoveRows({}, count, m_count - 1);
    if (count > m_count) beginInsertRows({}, m_count, count - 1);
    const int before = std::exchange(m_count, count);
    if (count < before) endRemoveRows();
    if (count > before) endInsertRows();
    if (count > 0) Q_EMIT dataChanged(index(0), index(count - 1));
  }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : m_count;
  }

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override {
    const auto row = std::size_t(index.row());
    if (!index.isValid() || row >= m_model->session().cameras.size()) return {};
    const CameraState& state = m_model->session().cameras[row];
    const QString name = QString::fromStdString(state.camera.name);
    if (role == Qt::DisplayRole || role == Qt::EditRole) return name;
    if (role == detailRole) return detailOf(m_model->session().display, state);
    if (role == pictureRole) return pictures.value(name);
    if (role == currentRole) return row == m_model->currentIndex();
    if (role == psnrRole && row < psnr.size()) return psnr[row];
    if (role == shareRole && row < psnr.size()) return shareOf(psnr[row]);
    const bool isOld = row < psnr.size() && row < isStale.size() && isStale[row];
    if (role == staleRole) return isOld;
    if (role == Qt::ToolTipRole && isOld)
      return StateDock::tr(
                 "%1 dB was measured before this state or the display was edited: make "
                 "the report again")
          .arg(psnr[row], 0, 'f', 1);
    return {};
  }

  bool setData(const QModelIndex& index, const QVariant& value, int role) override {
    return role == Qt::EditRole && m_commands->rename(std::size_t(index.row()), value.toString());
  }

  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override {
    if (!index.isValid()) return Qt::ItemIsDropEnabled;  // between rows
    return Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsEditable | Qt::ItemIsDragEnabled;
  }

  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }

  /// Moves the dragged states; the rows follow the session. `row` -1 is the end.
  bool dropMimeData(const QMimeData* data, Qt::DropAction, int row, int,
                    const QModelIndex&) override {
    QDataStream stream(data->data(mimeTypes().front()));
    std::vector<std::size_t> states;
    while (!stream.atEnd()) {
      int from = 0;
      int column = 0;
      QMap<int, QVariant> texts;
      stream >> from >> column >> texts;
      states.push_back(std::size_t(from));
    }
    std::ranges::sort(states);
    return m_commands->move(states, std::size_t(row < 0 ? m_count : row));
  }

 private:
  /// Returns the place of a value between the least and the largest finite one.
  [[nodiscard]] double shareOf(double dB) const {
    std::vector<double> finite;
    std::ranges::copy_if(psnr, std::back_inserter(finite),
                         [](double x) { return std::isfinite(x); });
    if (finite.empty()) return 1;
    const auto [least, most] = std::ranges::minmax(finite);
    if (least == most) return std::isinf(dB) ? 1 : 0.5;  // while a report runs
    return std::clamp((dB - least) / (most - least), 0.0, 1.0);
  }

  SessionModel* m_model;
  StateCommands* m_commands;
  int m_count = 0;  ///< rows that the view knows of
};

namespace {

/// Paints a row: picture, name and detail, PSNR with a bar; a line marks the current state.
class StateDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const Tokens& t = tokens();
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const bool isUnderPointer = option.state.testFlag(QStyle::State_MouseOver);
    const QRect row = option.rect;
    if (isSelected || isUnderPointer) painter->fillRect(row, isSelected ? t.selection : t.hover);
    if (index.data(currentRole).toBool())
      painter->fillRect(row.left(), row.top(), scaled(3), row.height(), t.eye);
    painter->save();
    painter->setRenderHint(QPainter::SmoothPixmapTransform);
    const QRect place(row.left() + scaled(12), row.top() + scaled(4), scaled(56), scaled(40));
    const auto picture = index.data(pictureRole).value<QImage>();
    painter->fillRect(place, picture.isNull() ? t.canvas : QColor(Qt::black));
    QRect fitted({}, picture.size().scaled(place.size(), Qt::KeepAspectRatio));
    fitted.moveCenter(place.center());
    painter->drawImage(fitted, picture);
    QRect texts = row.adjusted(scaled(78), scaled(6), -scaled(12), -scaled(8));
    if (index.data(psnrRole).isValid()) {
      paintPsnr(painter, texts.adjusted(texts.width() - scaled(56), 0, 0, 0), index,
                isSelected ? t.text2 : t.text3);
      texts.adjust(0, 0, -scaled(60), 0);
    }
    writeLine(*painter, texts, Qt::AlignTop, index.data().toString(),
              textFont(TextSize::base, QFont::Medium), t.text);
    writeLine(*painter, texts, Qt::AlignBottom, index.data(detailRole).toString(),
              textFont(TextSize::caption), t.text2);
    painter->restore();
  }

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
    return {scaled(200), scaled(48)};
  }

  /// Puts the editor on the name.
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex&) const override {
    editor->setGeometry(option.rect.adjusted(scaled(70), scaled(2), -scaled(12), -scaled(22)));
  }

 private:
  static void paintPsnr(QPainter* painter, const QRect& place, const QModelIndex& index,
                        const QColor& faint) {
    const double dB = index.data(psnrRole).toDouble();
    const bool isStale = index.data(staleRole).toBool();
    const QString unit = std::isfinite(dB) ? " dB" : "";
    painter->setFont(textFont(TextSize::caption));
    painter->setPen(faint);
    painter->drawText(place, Qt::AlignRight, unit);
    const int unitWidth = painter->fontMetrics().horizontalAdvance(unit);
    painter->setFont(textFont(TextSize::base, QFont::Medium));
    painter->setPen(isStale ? faint : tokens().text);
    painter->drawText(place.adjusted(0, 0, -unitWidth, 0), Qt::AlignRight,
                      std::isfinite(dB) ? QString::number(dB, 'f', 1)
                      : std::isnan(dB)  ? "–"
                                        : "∞");
    QRect bar(place.left(), place.bottom() - scaled(8), place.width(), scaled(3));
    painter->fillRect(bar, tokens().line);
    const double share = std::isnan(dB) ? 0 : 0.2 + 0.8 * index.data(shareRole).toDouble();
    if (isStale)
      painter->fillRect(place.left() - scaled(6), place.top(), 2, place.height(), tokens().amber);
    bar.setWidth(int(share * bar.width()));  // that of the least is seen, too
    const auto [r, g, b] = falseColour(index.data(shareRole).toDouble());
    painter->fillRect(bar, isStale ? tokens().strongLine : QColor::fromRgb(r, g, b));
  }
};

}  // namespace

StateDock::StateDock(SessionModel* model, StateCommands* commands, SceneController* scene,
                     QWidget* parent)
    : QWidget(parent),
      m_ui(std::make_unique<Ui::StateDock>()),
      m_model(model),
      m_commands(commands),
      m_scene(scene),
      m_rows(new StateRows(model, commands, this)),
      m_shown(new FilteredRows(m_rows, [this](int row, std::size_t k) {
        return m_rows->numbersOf(std::size_t(row))[k];
      })) {
  m_ui->setupUi(this);
  m_ui->stateList->setModel(m_shown);
  m_ui->stateList->setItemDelegate(new StateDelegate(m_ui->stateList));
  m_ui->stateList->setMinimumHeight(scaled(4 * 48));
  m_ui->stateList->viewport()->installEventFilter(this);
  m_ui->stateFilter->addAction(icon("find"), QLineEdit::LeadingPosition);
  fillHeader();
  connectModel();
}

StateDock::~StateDock() = default;

/// Adds the buttons of commands. The last button has all commands, also those for which the dock is
/// too narrow.
void StateDock::fillHeader() {
  static const std::map<QString, const char*> icons{
      {"addStateAction", "new"},  {"duplicateAction", "duplicate"}, {"renameAction", "rename"},
      {"removeAction", "delete"}, {"moveUpAction", "up"},           {"moveDownAction", "down"}};
  for (QAction* action : m_commands->actions()) {
    const auto found = icons.find(action->objectName());
    if (found == icons.end()) continue;
    action->setIcon(icon(found->second));
    action->setIconVisibleInMenu(false);
    m_buttons.push_back(new QToolButton);
    m_buttons.back()->setDefaultAction(action);
    m_ui->header->insertWidget(m_ui->header->count() - 1, m_buttons.back());
  }
  m_ui->moreStatesButton->setIcon(icon("more"));
  m_ui->moreStatesButton->setMenu(m_commands->menu());
}

void StateDock::connectModel() {
  const QItemSelectionModel* selection = m_ui->stateList->selectionModel();
  connect(selection, &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& index) {
    if (!m_isFollowing && index.isValid()) m_model->setCurrentIndex(stateAt(index));
  });
  connect(selection, &QItemSelectionModel::selectionChanged, this, [this] {
    if (!m_isFollowing) emitSelection();
  });
  connect(m_ui->stateFilter, &QLineEdit::textChanged, this, [this](const QString& text) {
    const RowFilter filter = rowFilter(text, {"PSNR", "σ", "lens", "distance", "angle"});
    follow([&] { m_shown->setFilter(filter); });
  });
  connect(m_model, &SessionModel::opened, this, [this] {
    m_rows->pictures.clear();
    m_ui->stateFilter->clear();
    showPsnr({}, {});
  });
  connect(m_model, &SessionModel::statesChanged, this, [this] { showPsnr({}, {}); });
  for (const auto signal : {&SessionModel::edited, &SessionModel::contentChanged})
    connect(m_model, signal, this, [this] { follow([this] { m_rows->refresh(); }); });
  connect(m_model, &SessionModel::currentChanged, this, &StateDock::showCurrent);
  connect(m_scene, &SceneController::stateRendered, this, [this](int row, const VtkImage& image) {
    m_rows->pictures[m_rows->index(row).data().toString()] = toPicture(*image);
    m_ui->stateList->viewport()->update();
  });
}

/// Hides the last buttons where there is no room for them.
void StateDock::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int button = m_buttons.front()->sizeHint().width();
  int left = width() - scaled(110) - button;  // title and the last button
  for (QToolButton* each : m_buttons) each->setVisible((left -= button) >= 0);
}

bool StateDock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Paint && event->type() != QEvent::Hide)
    return QWidget::eventFilter(watched, event);
  std::vector<std::size_t> states;
  QModelIndex index =
      event->type() == QEvent::Hide ? QModelIndex() : m_ui->stateList->indexAt({1, 1});
  for (; index.isValid() &&
         m_ui->stateList->visualRect(index).top() < m_ui->stateList->viewport()->height();
       index = index.siblingAtRow(index.row() + 1))
    states.push_back(stateAt(index));
  m_scene->watchStates(states);
  return false;
}

std::size_t StateDock::stateAt(const QModelIndex& index) const {
  return std::size_t(m_shown->mapToSource(index).row());
}

/// Applies a change of the rows, which chooses no other state.
template <class Change>
void StateDock::follow(Change change) {
  {
    const QScopedValueRollback following(m_isFollowing, true);
    change();
  }
  showCurrent();
}

void StateDock::showPsnr(const std::vector<double>& dB, const std::vector<bool>& isStale) {
  follow([&] {
    m_rows->psnr = dB;
    m_rows->isStale = isStale;
    m_rows->refresh();
  });
}

/// Selects the current state, unless the filter hides it.
void StateDock::showCurrent() {
  const QModelIndex index = m_shown->mapFromSource(m_rows->index(int(m_model->currentIndex())));
  if (index != m_ui->stateList->currentIndex()) {
    const QScopedValueRollback following(m_isFollowing, true);
    m_ui->stateList->selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect);
  }
  m_ui->stateList->viewport()->update();
  const int all = m_rows->rowCount();
  const int shown = m_shown->rowCount();
  m_ui->stateCount->setText(shown == all ? QString::number(all)
                                         : tr("%1 of %2").arg(shown).arg(all));
  emitSelection();
}

void StateDock::emitSelection() {
  std::vector<std::size_t> marked;
  for (const QModelIndex& index : m_ui->stateList->selectionModel()->selectedRows())
    marked.push_back(stateAt(index));
  m_model->setMarked(std::move(marked));
}

void StateDock::editName() {
  if (!m_ui->stateList->currentIndex().isValid()) m_ui->stateFilter->clear();  // it hides the state
  m_ui->stateList->setFocus();
  m_ui->stateList->edit(m_ui->stateList->currentIndex());
}

/// Goes from the filter into the list.
void StateDock::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Down || !m_ui->stateFilter->hasFocus())
    return QWidget::keyPressEvent(event);
  m_ui->stateList->setFocus();
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
