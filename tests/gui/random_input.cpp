// SPDX-License-Identifier: BSD-3-Clause
// No test: clicks, drags, keys and texts at random in the real window and its dialogs, for a
// sanitizer to watch. Run it as an ordinary user in a folder of its own, since dialogs of files can
// replace what they are told to. The same seed gives the same input, but not the same times.
// random_input SECONDS SEED FILE…
#include <QApplication>
#include <QElapsedTimer>
#include <QStandardPaths>
#include <QTimer>
#include <QtTest>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <random>

#include "gui/app/main_window.h"
#include "gui/app/translations.h"
#include "tests/gui/window_files.h"

using namespace hogelscope;

namespace {

/// The window never closes: its close events are ignored.
class StaysOpen : public QObject {
 public:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::Close || qobject_cast<MainWindow*>(watched) == nullptr)
      return false;
    event->ignore();
    return true;
  }
};

class RandomInput {
 public:
  RandomInput(MainWindow& window, QStringList names, unsigned seed)
      : m_window(window), m_files(std::move(names)), m_random(seed) {}

  int count = 0;

  void act() {
    QWidget* top = topWidget();
    QWidget* widget = anyOf(*top);
    ++count;
    switch (below(9)) {
      case 0:
      case 1:
        return QTest::mouseClick(widget, below(8) == 0 ? Qt::RightButton : Qt::LeftButton,
                                 modifiers(), placeIn(*widget));
      case 2:
        return QTest::mouseDClick(widget, Qt::LeftButton, {}, placeIn(*widget));
      case 3:
        return drag(widget);
      case 4:
        return type(top);
      case 5:
        return wheel(widget);
      case 6:
        if (below(40) == 0 && top == &m_window)
          return (void)files(m_window).open(m_files[qsizetype(below(unsigned(m_files.size())))]);
        return resize();
      default:
        return key(top);
    }
  }

 private:
  unsigned below(unsigned end) { return unsigned(m_random() % end); }
  QWidget* topWidget() const {
    if (QWidget* popup = QApplication::activePopupWidget()) return popup;
    if (QWidget* modal = QApplication::activeModalWidget()) return modal;
    QWidget* active = QApplication::activeWindow();
    return active != nullptr ? active : &m_window;
  }
  QWidget* anyOf(QWidget& top) {
    QList<QWidget*> seen{&top};
    for (QWidget* widget : top.findChildren<QWidget*>())
      if (widget->isVisible() && widget->isEnabled() && !widget->visibleRegion().isEmpty())
        seen << widget;
    return seen[qsizetype(below(unsigned(seen.size())))];
  }
  QPoint placeIn(const QWidget& widget) {
    return {int(below(unsigned(std::max(1, widget.width())))),
            int(below(unsigned(std::max(1, widget.height()))))};
  }
  Qt::KeyboardModifiers modifiers() {
    Qt::KeyboardModifiers chosen;
    for (const Qt::KeyboardModifier one : {Qt::ControlModifier, Qt::ShiftModifier, Qt::AltModifier})
      if (below(4) == 0) chosen |= one;
    return chosen;
  }
  void drag(QWidget* widget) {
    const QPointer<QWidget> on = widget;
    QTest::mousePress(widget, Qt::LeftButton, modifiers(), placeIn(*widget));
    for (unsigned k = below(6); k > 0 && on != nullptr; --k) QTest::mouseMove(on, placeIn(*on));
    if (on != nullptr) QTest::mouseRelease(on, Qt::LeftButton, {}, placeIn(*on));
  }
  void key(QWidget* top) {
    static const std::vector<int> others{
        Qt::Key_Tab,    Qt::Key_Escape, Qt::Key_Return,   Qt::Key_Space,
        Qt::Key_Left,   Qt::Key_Right,  Qt::Key_Up,       Qt::Key_Down,
        Qt::Key_Delete, Qt::Key_Home,   Qt::Key_End,      Qt::Key_Plus,
        Qt::Key_Minus,  Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Backspace};
    const unsigned which = below(62 + unsigned(others.size()));
    const int code = which < 26   ? Qt::Key_A + int(which)
                     : which < 36 ? Qt::Key_0 + int(which) - 26
                     : which < 62 ? Qt::Key_F1 + int(which - 36) % 12
                                  : others[which - 62];
    press(top, code, modifiers());
  }
  void type(QWidget* top) {
    static const QStringList texts{"0", "-1", "1e9", "nan", "0.05", "100000", "a b", "16"};
    for (const QChar letter : texts[qsizetype(below(unsigned(texts.size())))])
      press(top, QTest::asciiToKey(letter.toLatin1()), {});
    if (below(2) == 0) press(top, Qt::Key_Return, {});
  }
  /// By the window, since a key may delete the widget that has the focus.
  static void press(const QPointer<QWidget>& top, int code, Qt::KeyboardModifiers held) {
    if (top != nullptr && top->windowHandle() != nullptr)
      QTest::keyClick(top->windowHandle(), Qt::Key(code), held);
  }
  void wheel(QWidget* widget) {
    const QPointF at = placeIn(*widget);
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, below(2) == 0 ? 120 : -120}, {},
                      modifiers(), Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
  }
  void resize() { m_window.resize(500 + int(below(1200)), 400 + int(below(700))); }

  MainWindow& m_window;
  QStringList m_files;
  std::mt19937 m_random;
};

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  installTranslations();
  const QStringList arguments = application.arguments();
  if (arguments.size() < 4) {
    std::fputs("usage: random_input SECONDS SEED FILE…\n", stderr);
    return 2;
  }
  StaysOpen staysOpen;
  application.installEventFilter(&staysOpen);
  QApplication::setQuitOnLastWindowClosed(false);
  MainWindow window;
  window.start({arguments[3]});
  QTest::qWait(1000);
  RandomInput input(window, arguments.mid(3), arguments[2].toUInt());
  QElapsedTimer time;
  time.start();
  // A dialog's own loop runs inside an action, so each action first asks for the next one.
  std::function<void()> next = [&] {
    if (time.elapsed() > 1000 * arguments[1].toLongLong()) {
      std::printf("%d actions\n", input.count);
      std::fflush(stdout);
      std::_Exit(0);  // dialogs may be open
    }
    QTimer::singleShot(20, &window, next);
    input.act();
  };
  QTimer::singleShot(0, &window, next);
  return QApplication::exec();
}
