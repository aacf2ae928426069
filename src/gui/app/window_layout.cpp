// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/window_layout.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QProxyStyle>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QTabBar>
#include <QWindow>
#include <algorithm>
#include <utility>

#include "ui_main_window.h"

namespace hogelscope {

namespace {

/// The version of saved layouts. Layouts of another version are ignored.
constexpr int version = 2;

/// Raises a dock that is hidden or behind another one; closes a visible one.
void toggle(QDockWidget* dock) {
  if (dock->visibleRegion().isEmpty()) {
    dock->show();
    dock->raise();
  } else {
    dock->close();
  }
  dock->toggleViewAction()->setChecked(!dock->isHidden());
}

/// A style whose dock tabs fit into a narrow window.
class NarrowTabs : public QProxyStyle {
 public:
  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override {
    constexpr int space = 10;  // px, both sides of the text together
    return metric == PM_TabBarTabHSpace ? space : QProxyStyle::pixelMetric(metric, option, widget);
  }
};

}  // namespace

QRect fitted(QRect frame, const QRect& screen) {
  frame.setSize(frame.size().boundedTo(screen.size()));
  frame.moveLeft(std::clamp(frame.left(), screen.left(), screen.right() + 1 - frame.width()));
  frame.moveTop(std::clamp(frame.top(), screen.top(), screen.bottom() + 1 - frame.height()));
  return frame;
}

WindowLayout::WindowLayout(QMainWindow* window, const Ui::MainWindow& ui)
    : QObject(window),
      m_window(window),
      m_ui(ui),
      m_docks(window->saveState(version)),
      m_split(ui.splitter->saveState()),
      m_tabStyle(new NarrowTabs) {
  connectDocks();
  connectTasks();
  connectParts();
  connect(ui.resetLayoutAction, &QAction::triggered, this, &WindowLayout::reset);
}

void WindowLayout::narrow(QTabBar* tabs) {
  tabs->setStyle(m_tabStyle);
  tabs->setElideMode(Qt::ElideNone);
}

void WindowLayout::connectDocks() {
  m_tabStyle->setParent(this);
  for (QTabBar* tabs : m_window->findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
    narrow(tabs);
  m_window->installEventFilter(this);
  for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
    QAction* action = dock->toggleViewAction();
    disconnect(action, &QAction::triggered, dock, nullptr);  // Qt's would close a covered dock
    connect(action, &QAction::triggered, this, [dock] { toggle(dock); });
  }
}

/// Connects each task to its docks and views; the last dock is raised.
void WindowLayout::connectTasks() {
  const auto on = [this](QAction* action, const QList<QDockWidget*>& docks,
                         const QList<QWidget*>& parts) {
    connect(action, &QAction::triggered, this, [=, this] { arrange(docks, parts); });
  };
  QWidget* const scene = m_ui.sceneArea;
  QWidget* const view = m_ui.pictureArea;
  const QList<QDockWidget*> forms{m_ui.statesDock,     m_ui.lightFieldDock, m_ui.displayDock,
                                  m_ui.distortionDock, m_ui.psfDock,        m_ui.cameraDock};
  on(m_ui.layoutViewAction, forms, {scene, view});
  on(m_ui.layoutLensAction, {m_ui.cameraDock, m_ui.psfDock, m_ui.distortionDock}, {view});
  on(m_ui.layoutCompareAction, {m_ui.statesDock}, {view});
  on(m_ui.layoutReportAction, {m_ui.reportDock}, {scene, view});
  on(m_ui.layoutMeasureAction, {m_ui.statesDock, m_ui.tradeoffDock}, {view});
}

void WindowLayout::connectParts() {
  for (const auto& [action, part] :
       {std::pair(m_ui.onlyViewAction, m_ui.pictureArea),
        std::pair(m_ui.onlySceneAction, static_cast<QWidget*>(m_ui.sceneArea))})
    connect(action, &QAction::triggered, this, [this, a = action, p = part] { showOnly(a, p); });
  m_ui.pictureView->installEventFilter(this);
  m_ui.sceneWidget->installEventFilter(this);
}

void WindowLayout::arrange(const QList<QDockWidget*>& docks, const QList<QWidget*>& parts) {
  showAll();
  for (QDockWidget* dock : m_window->findChildren<QDockWidget*>())
    dock->setVisible(docks.contains(dock));
  for (QWidget* part : {m_ui.sceneArea, m_ui.pictureArea}) part->setVisible(parts.contains(part));
  docks.back()->raise();
}

/// Shows one view alone. A second call restores the docks.
void WindowLayout::showOnly(QAction* action, QWidget* part) {
  const bool begins = action->isChecked();
  const QByteArray docks = m_before.isEmpty() ? m_window->saveState(version) : m_before;
  showAll();
  if (!begins) return;
  m_before = docks;
  action->setChecked(true);
  for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) dock->hide();
  for (QWidget* other : {m_ui.sceneArea, m_ui.pictureArea}) other->setVisible(other == part);
}

void WindowLayout::showAll() {
  for (QAction* action : {m_ui.onlyViewAction, m_ui.onlySceneAction}) action->setChecked(false);
  m_ui.sceneArea->show();
  m_ui.pictureArea->show();
  if (!m_before.isEmpty()) m_window->restoreState(std::exchange(m_before, {}), version);
}

/// Maps a double click to the action of its key, and styles dock tabs when Qt creates them.
bool WindowLayout::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ChildPolished) {
    auto* tabs = qobject_cast<QTabBar*>(static_cast<const QChildEvent*>(event)->child());
    if (tabs != nullptr) narrow(tabs);
  }
  if (watched == m_window) {  // receives events that none of its parts accepts
    fitOnceFramed();
    return false;
  }
  if (event->type() != QEvent::MouseButtonDblClick ||
      static_cast<const QMouseEvent*>(event)->button() != Qt::LeftButton)
    return false;
  (watched == m_ui.pictureView ? m_ui.onlyViewAction : m_ui.onlySceneAction)->trigger();
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
  settings.setValue("window/docks", m_before.isEmpty() ? m_window->saveState(version) : m_before);
  settings.setValue("window/splitter", m_ui.splitter->saveState());
}

void WindowLayout::restore() {
  const QSettings settings;
  QByteArray geometry;
  if (settings.value("window/version").toInt() == version) {
    geometry = settings.value("window/geometry").toByteArray();
    m_window->restoreState(settings.value("window/docks").toByteArray(), version);
    m_ui.splitter->restoreState(settings.value("window/splitter").toByteArray());
  }
  place(geometry);
  // A second placement, because docks enlarge the window during their first layout.
  const auto again = [this, geometry] {
    if (!m_window->isMaximized() && !m_window->isFullScreen()) place(geometry);
  };
  QMetaObject::invokeMethod(this, again, Qt::QueuedConnection);
}

void WindowLayout::reset() {
  showAll();
  m_window->restoreState(m_docks, version);
  m_ui.splitter->restoreState(m_split);
}

}  // namespace hogelscope
