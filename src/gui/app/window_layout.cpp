// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/window_layout.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMouseEvent>
#include <QScreen>
#include <QSettings>
#include <QWindow>
#include <algorithm>
#include <array>
#include <utility>

#include "gui/docks/properties.h"
#include "gui/keys/field_guards.h"
#include "gui/widgets/command.h"
#include "gui/widgets/section.h"

namespace hogelscope {

namespace {

/// The version of saved layouts. Layouts of another version are ignored.
constexpr int version = 2;

bool isSeen(const QWidget* part) {
  return !part->visibleRegion().isEmpty();
}

/// Returns a length that is `small` in a window 1280 px wide and `large` in one of 2560.
int atWidth(int width, int small, int large) {
  return std::clamp(small + (large - small) * (width - 1280) / 1280, small, large);
}

}  // namespace

QRect fitted(QRect frame, const QRect& screen) {
  frame.setSize(frame.size().boundedTo(screen.size()));
  frame.moveLeft(std::clamp(frame.left(), screen.left(), screen.right() + 1 - frame.width()));
  frame.moveTop(std::clamp(frame.top(), screen.top(), screen.bottom() + 1 - frame.height()));
  return frame;
}

WindowLayout::WindowLayout(QMainWindow* window, QMenu* menu, const Parts& parts,
                           const std::array<QWidget*, 2>& views)
    : QObject(window),
      m_window(window),
      m_parts(parts),
      m_views(views),
      m_group(new QActionGroup(this)) {
  placeDocks();
  addCommands(menu);
  addDockCommands(menu);
  m_window->installEventFilter(this);
  for (QWidget* view : m_views) view->installEventFilter(this);
  for (QDockWidget* dock : docks()) dock->hide();  // until there is a session
  m_parts.view->hide();
}

void WindowLayout::placeDocks() {
  m_window->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  m_window->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  m_window->splitDockWidget(m_parts.scene, m_parts.states, Qt::Vertical);
  // They have no title: the scene has no room to lose, and the list of states has a heading.
  for (QDockWidget* dock : {m_parts.scene, m_parts.states}) dock->setTitleBarWidget(new QWidget);
}

void WindowLayout::addCommands(QMenu* menu) {
  m_onlyView = addCommand(
      menu,
      {"onlyViewAction", tr("Only the &simulated view"),
       tr("Hides all but the simulated view, or shows it again; a double click does so too"),
       Qt::Key_F11},
      this, [this] { showOnly(m_onlyView, true); });
  m_onlyScene =
      addCommand(menu,
                 {"onlySceneAction", tr("Only the 3-D s&cene"),
                  tr("Hides all but the 3-D scene, or shows it again; a double click does so too"),
                  Qt::SHIFT | Qt::Key_F11},
                 this, [this] { showOnly(m_onlyScene, false); });
  for (QAction* action : {m_onlyView, m_onlyScene}) action->setCheckable(true);
  addWorkspaces(menu->addMenu(tr("&Workspace")));
}

void WindowLayout::addWorkspaces(QMenu* menu) {
  const auto add = [&](const char* name, const QString& title, const QString& help, int digit,
                       const QList<QDockWidget*>& docks, bool hasView = true) {
    const QKeyCombination key = Qt::CTRL | Qt::ALT | Qt::Key(Qt::Key_0 + digit);
    const std::size_t index = m_workspaces.size();
    QAction* action = addCommand(menu, {name, title, help, key}, this,
                                 [this, index] { arrange(m_workspaces[index]); });
    action->setCheckable(true);
    m_group->addAction(action);
    m_workspaces.push_back({action, docks, hasView});
  };
  add("layoutViewAction", tr("&View"), tr("Scene, states, simulated view, properties"), 1,
      {m_parts.scene, m_parts.states, m_parts.properties});
  add("layoutCompareAction", tr("&Compare"), tr("The simulated view, large, and the states"), 2,
      {m_parts.states});
  add("layoutDesignAction", tr("&Measure"),
      tr("What the display shows, and whether the content fits, beside the simulated view"), 3,
      {m_parts.measure});
  add("layoutMeasureAction", tr("&Speed"),
      tr("Time and error of the methods beside the simulated view"), 4, {m_parts.tradeoff});
  add("layoutReportAction", tr("&Report"), tr("The report's tables and plots alone"), 5,
      {m_parts.report}, false);
  menu->addSeparator();
  addCommand(menu,
             {"resetLayoutAction", tr("R&eset layout"),
              tr("Puts docks and tool bar back where they were at first"),
              Qt::CTRL | Qt::SHIFT | Qt::Key_R},
             this, &WindowLayout::reset);
}

/// Adds the docks' own commands. Qt's would close a dock that another one covers.
void WindowLayout::addDockCommands(QMenu* menu) {
  menu->addSeparator();
  for (QDockWidget* dock : docks()) {
    QAction* action = dock->toggleViewAction();
    menu->addAction(action);
    disconnect(action, &QAction::triggered, dock, nullptr);
    connect(action, &QAction::triggered, this, [this, dock] { toggle(dock); });
  }
}

QList<QAction*> WindowLayout::workspaces() const {
  return m_group->actions();
}

QList<QDockWidget*> WindowLayout::docks() const {
  return m_window->findChildren<QDockWidget*>();
}

/// Whether the keyboard is in a part of the window; also for one that has nothing to focus.
bool WindowLayout::hasFocusIn(const QWidget* part) const {
  const QWidget* focused = m_window->focusWidget();
  const auto fields = part->findChildren<QWidget*>();
  const bool canHave = std::ranges::any_of(fields, [](const QWidget* field) {
    return field->isEnabled() && (field->focusPolicy() & Qt::TabFocus) != 0;
  });
  return !canHave || (focused != nullptr && part->isAncestorOf(focused));
}

/// Raises a dock that is hidden or behind another one; closes a visible one that has the focus, and
/// gives it to one that does not.
void WindowLayout::toggle(QDockWidget* dock) {
  if (isHome()) return dock->toggleViewAction()->setChecked(false);
  Section* section = m_parts.sections->sectionOf(dock);
  if (section != nullptr && !section->isOut()) return toggle(section);
  if (isSeen(dock) && (dock->isFloating() || hasFocusIn(dock))) {
    dock->close();
  } else {
    dock->show();
    dock->raise();
    focusLastField(dock->widget());
  }
  dock->toggleViewAction()->setChecked(!dock->isHidden());
}

void WindowLayout::toggle(Section* section) {
  const bool shows = !isSeen(section->content()) || !hasFocusIn(section->content());
  if (shows) {
    m_parts.properties->show();
    m_parts.properties->raise();
    m_parts.sections->reveal(section);
    focusLastField(section->content());
  } else {
    section->setOpen(false);
  }
  section->dock()->toggleViewAction()->setChecked(shows);
}

void WindowLayout::arrange(const Workspace& workspace) {
  if (isHome()) return;
  showAll();
  for (QDockWidget* dock : {m_parts.measure, m_parts.tradeoff})
    if (workspace.docks.contains(dock))
      m_window->addDockWidget(Qt::LeftDockWidgetArea, dock);
    else
      m_window->tabifyDockWidget(m_parts.report, dock);
  for (QDockWidget* dock : docks()) dock->setVisible(workspace.docks.contains(dock));
  m_window->centralWidget()->setVisible(workspace.hasView);
  workspace.action->setChecked(true);
  resize(workspace);
}

void WindowLayout::resize(const Workspace& workspace) {
  const int width = m_window->width();
  const int height = m_window->height();
  const bool hasScene = workspace.docks.contains(m_parts.scene);
  // The scene is above the states: even hidden it would give them its width.
  m_window->resizeDocks({hasScene ? m_parts.scene : m_parts.states, m_parts.properties,
                         m_parts.measure, m_parts.tradeoff},
                        {hasScene ? atWidth(width, 320, 640) : 230, atWidth(width, 312, 340),
                         2 * width / 3, 3 * width / 5},
                        Qt::Horizontal);
  m_window->resizeDocks({m_parts.scene, m_parts.states}, {height * 11 / 20, height * 9 / 20},
                        Qt::Vertical);
}

/// Whether the home page is shown, which has no docks.
bool WindowLayout::isHome() const {
  return !m_parts.home->isHidden();
}

void WindowLayout::leaveHome() {
  if (!isHome()) return;
  m_parts.home->hide();
  m_parts.view->show();
  if (m_before.isEmpty()) return arrange(m_workspaces.front());
  m_window->restoreState(std::exchange(m_before, {}), version);
  const QString last = QSettings().value("window/workspace").toString();
  for (const Workspace& workspace : m_workspaces) {
    if (workspace.action->objectName() != last) continue;
    workspace.action->setChecked(true);
    m_window->centralWidget()->setVisible(workspace.hasView);
  }
}

/// Shows one view alone. A second call restores the docks.
void WindowLayout::showOnly(QAction* action, bool isView) {
  const bool begins = action->isChecked();
  if (isHome()) return action->setChecked(false);
  const bool isFirst = m_before.isEmpty();
  const QByteArray docksNow = isFirst ? m_window->saveState(version) : m_before;
  const bool hasView = isFirst ? !m_window->centralWidget()->isHidden() : m_hadView;
  showAll();
  if (!begins) return;
  m_before = docksNow;
  m_hadView = hasView;
  action->setChecked(true);
  for (QDockWidget* dock : docks()) dock->setVisible(!isView && dock == m_parts.scene);
  m_window->centralWidget()->setVisible(isView);
}

void WindowLayout::showView() {
  m_window->centralWidget()->show();
}

/// Ends the mode of one view alone.
void WindowLayout::showAll() {
  for (QAction* action : {m_onlyView, m_onlyScene}) action->setChecked(false);
  if (m_before.isEmpty()) return;
  m_window->centralWidget()->setVisible(m_hadView);
  m_window->restoreState(std::exchange(m_before, {}), version);
}

/// Maps a double click on a view to the command of its key.
bool WindowLayout::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_window) {  // receives events that none of its parts accepts
    fitOnceFramed();
    return false;
  }
  if (event->type() != QEvent::MouseButtonDblClick ||
      static_cast<const QMouseEvent*>(event)->button() != Qt::LeftButton)
    return false;
  (watched == m_views[0] ? m_onlyView : m_onlyScene)->trigger();
  return true;
}

void WindowLayout::place(const QByteArray& geometry) {
  if (!geometry.isEmpty()) m_window->restoreGeometry(geometry);
  fitScreen();
}

/// Fits the window with its frame into the screen, at any screen scale.
void WindowLayout::fitScreen() {
  if (m_window->isMaximized() || m_window->isFullScreen()) return;
  const QWindow* handle = m_window->windowHandle();  // none before the window is shown
  const QMargins frame = handle == nullptr ? QMargins() : handle->frameMargins();
  const QRect placed = m_window->geometry().marginsAdded(frame);
  const QRect wanted = fitted(placed, m_window->screen()->availableGeometry());
  if (wanted != placed) m_window->setGeometry(wanted.marginsRemoved(frame));
}

/// Fits the window once it has a frame. The frame comes later than the window, without an event.
void WindowLayout::fitOnceFramed() {
  const QWindow* handle = m_window->windowHandle();
  if (m_isFramed || handle == nullptr || handle->frameMargins().isNull()) return;
  m_isFramed = true;
  QMetaObject::invokeMethod(this, &WindowLayout::fitScreen, Qt::QueuedConnection);
}

void WindowLayout::save() const {
  QSettings settings;
  settings.setValue("window/version", version);
  settings.setValue("window/geometry", m_window->saveGeometry());
  if (const QAction* workspace = m_group->checkedAction())
    settings.setValue("window/workspace", workspace->objectName());
  if (!m_before.isEmpty() || !isHome())
    settings.setValue("window/docks", m_before.isEmpty() ? m_window->saveState(version) : m_before);
}

/// The docks follow once the home page is left.
void WindowLayout::restore() {
  const QSettings settings;
  QByteArray geometry;
  if (settings.value("window/version").toInt() == version) {
    geometry = settings.value("window/geometry").toByteArray();
    m_before = settings.value("window/docks").toByteArray();
  }
  place(geometry);
  // A second placement, because docks enlarge the window during their first layout.
  const auto again = [this, geometry] {
    if (!m_window->isMaximized() && !m_window->isFullScreen()) place(geometry);
  };
  QMetaObject::invokeMethod(this, again, Qt::QueuedConnection);
}

void WindowLayout::reset() {
  if (isHome()) return;
  m_window->addDockWidget(Qt::LeftDockWidgetArea, m_parts.scene);
  m_window->addDockWidget(Qt::LeftDockWidgetArea, m_parts.states);
  m_window->addDockWidget(Qt::RightDockWidgetArea, m_parts.properties);
  m_window->addDockWidget(Qt::BottomDockWidgetArea, m_parts.report);
  for (QDockWidget* dock : docks()) dock->setFloating(false);
  arrange(m_workspaces.front());
}

}  // namespace hogelscope
