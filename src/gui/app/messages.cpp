// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/messages.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QStatusBar>
#include <QStatusTipEvent>
#include <QTime>
#include <QToolButton>

#include "gui/widgets/colours.h"

namespace hogelscope {

namespace {

constexpr int mostErrors = 200;

/// A list that is six lines high by default.
class ErrorList : public QPlainTextEdit {
 public:
  [[nodiscard]] QSize sizeHint() const override { return {480, 6 * fontMetrics().lineSpacing()}; }
  [[nodiscard]] QSize minimumSizeHint() const override {
    return {120, 3 * fontMetrics().lineSpacing()};
  }
};

}  // namespace

Messages::Messages(QMainWindow* window)
    : QObject(window),
      m_window(window),
      m_dock(new QDockWidget(tr("Errors"), window)),
      m_list(new ErrorList),
      m_button(new QToolButton) {
  m_dock->setObjectName("errorsDock");
  m_list->setObjectName("errors");
  m_list->setReadOnly(true);
  m_list->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  m_list->setMaximumBlockCount(mostErrors);
  m_list->setToolTip(
      tr("The last %1 errors, the newest below; Ctrl+C copies what is selected").arg(mostErrors));
  m_dock->setWidget(m_list);
  window->addDockWidget(Qt::BottomDockWidgetArea, m_dock, Qt::Vertical);  // below the other docks
  m_dock->hide();
  QAction* toggle = m_dock->toggleViewAction();
  toggle->setShortcut(Qt::Key_F4);
  m_button->setObjectName("errorsButton");
  m_button->setAutoRaise(true);
  m_button->setToolTip(tr("Shows or hides the list of errors (F4)"));
  connect(m_button, &QToolButton::clicked, toggle, &QAction::trigger);
  window->statusBar()->addPermanentWidget(m_button);
  m_button->hide();
  window->installEventFilter(this);
  qApp->installEventFilter(this);
}

void Messages::showMessage(const QString& line) {
  m_line = line;
  show();
}

void Messages::showError(const QString& line) {
  m_error = line;
  m_line.clear();  // such as "Reading …"
  const QString time = QTime::currentTime().toString("HH:mm:ss");
  m_list->appendPlainText(tr("%1  %2").arg(time, line));
  m_button->setText(tr("⚠ %n errors", "", ++m_count));
  m_button->show();
  show();
}

void Messages::dismiss() {
  if (m_error.isEmpty()) return;
  m_error.clear();
  show();
}

/// Resets the error count; the list stays.
void Messages::settle() {
  dismiss();
  m_count = 0;
  m_button->hide();
}

void Messages::show() {
  QPalette palette;
  if (!m_error.isEmpty()) palette.setColor(QPalette::WindowText, tokens().error);
  m_window->statusBar()->setPalette(palette);
  m_window->statusBar()->showMessage(m_error.isEmpty() ? m_line : tr("Error: %1").arg(m_error));
}

/// Detects user actions at the native window, before they can cause a new error.
bool Messages::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (watched->isWindowType() && (type == QEvent::ShortcutOverride || type == QEvent::KeyPress ||
                                  type == QEvent::MouseButtonPress))
    dismiss();
  // Keeps the line, which Qt would clear whenever the pointer moves over a menu.
  if (watched != m_window || type != QEvent::StatusTip ||
      !static_cast<QStatusTipEvent*>(event)->tip().isEmpty())
    return false;
  show();
  return true;
}

}  // namespace hogelscope
