// SPDX-License-Identifier: BSD-3-Clause
// Where the window and its docks are.
#include "gui/app/window_layout.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QScreen>
#include <QSettings>
#include <QSplitter>

namespace hogelscope {

namespace {

/// Another one, and layouts that were saved before no longer count.
constexpr int version = 1;

/// One that is hidden, or behind another one, comes to the front; one that can be seen is closed.
void toggle(QDockWidget* dock) {
  if (dock->visibleRegion().isEmpty()) {
    dock->show();
    dock->raise();
  } else {
    dock->close();
  }
  dock->toggleViewAction()->setChecked(!dock->isHidden());
}

}  // namespace

WindowLayout::WindowLayout(QMainWindow* window, QSplitter* splitter)
    : QObject(window),
      m_window(window),
      m_splitter(splitter),
      m_docks(window->saveState(version)),
      m_split(splitter->saveState()) {
  for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
    QAction* action = dock->toggleViewAction();
    disconnect(action, &QAction::triggered, dock, nullptr);  // Qt's would close a dock behind
    connect(action, &QAction::triggered, this, [dock] { toggle(dock); });
  }
}

void WindowLayout::save() const {
  QSettings settings;
  settings.setValue("window/version", version);
  settings.setValue("window/geometry", m_window->saveGeometry());
  settings.setValue("window/docks", m_window->saveState(version));
  settings.setValue("window/splitter", m_splitter->saveState());
}

void WindowLayout::restore() {
  const QSettings settings;
  if (settings.value("window/version").toInt() != version) {
    // Once it is shown: docks let a window grow while they are laid out for the first time.
    const auto fit = [this] {
      m_window->resize(m_window->size().boundedTo(m_window->screen()->availableSize()));
    };
    fit();
    QMetaObject::invokeMethod(m_window, fit, Qt::QueuedConnection);
    return;
  }
  m_window->restoreGeometry(settings.value("window/geometry").toByteArray());
  m_window->restoreState(settings.value("window/docks").toByteArray(), version);
  m_splitter->restoreState(settings.value("window/splitter").toByteArray());
}

void WindowLayout::reset() {
  m_window->restoreState(m_docks, version);
  m_splitter->restoreState(m_split);
}

}  // namespace hogelscope
