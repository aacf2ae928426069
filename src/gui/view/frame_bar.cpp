// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/frame_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "gui/widgets/command.h"

namespace hogelscope {

namespace {
constexpr double usualRate = 25;  // where the light field does not say it
}

FrameBar::FrameBar(QMenu* menu, QWidget* parent)
    : QWidget(parent), m_slider(new QSlider(Qt::Horizontal)), m_text(new QLabel) {
  setObjectName("frameBar");
  m_timer.setInterval(8);  // milliseconds
  m_timer.setTimerType(Qt::PreciseTimer);
  connect(&m_timer, &QTimer::timeout, this, &FrameBar::tick);
  addCommands(menu);
  m_slider->setObjectName("frameSlider");
  m_slider->setToolTip(tr("The frame that is shown; drag it, or use the arrow keys"));
  m_slider->setFocusPolicy(Qt::TabFocus);
  connect(m_slider, &QSlider::valueChanged, this, [this](int index) {
    stop();
    ask(m_frames.number(std::size_t(index)));
  });
  m_text->setObjectName("frameText");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 2, 8, 2);
  const auto addButton = [&](QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setFocusPolicy(Qt::TabFocus);
    layout->addWidget(button);
  };
  addButton(m_steps[0]);
  addButton(m_play);
  addButton(m_steps[1]);
  addButton(m_loop);
  layout->addWidget(m_slider, 1);
  layout->addWidget(m_text);
  clear();
}

void FrameBar::addCommands(QMenu* menu) {
  menu->addSeparator();
  m_play = addSwitch(
      menu,
      {"playFramesAction", tr("Play &frames"), tr("Plays the light field in time; again: stops"),
       Qt::CTRL | Qt::ALT | Qt::Key_Space, tr("Play")},
      false, this, &FrameBar::play);
  m_steps = {addCommand(menu,
                        {"frameBackAction", tr("Frame before"), tr("Shows the frame before"),
                         Qt::Key_Comma, "‹"},
                        this, [this] { step(-1); }),
             addCommand(menu,
                        {"frameNextAction", tr("Next frame"), tr("Shows the next frame"),
                         Qt::Key_Period, "›"},
                        this, [this] { step(1); })};
  m_loop = addSwitch(menu,
                     {"loopFramesAction", tr("Play in a loop"),
                      tr("After the last frame it plays on from the first one"),
                      Qt::CTRL | Qt::ALT | Qt::Key_Comma, tr("Loop")},
                     true, this, [](bool) {});
}

void FrameBar::setFrames(const FrameNumbers& frames, double rate) {
  const double used = rate > 0 ? rate : usualRate;
  if (isVisibleTo(parentWidget()) && frames == m_frames && used == m_rate) return ask(m_frame);
  stop();
  m_frames = frames;
  m_isRateKnown = rate > 0;
  m_rate = used;
  m_frame = frames.first;
  m_isAwaited = false;
  m_leftOut = m_perSecond = 0;
  const QSignalBlocker quiet(m_slider);
  m_slider->setRange(0, int(frames.count()) - 1);
  m_slider->setValue(0);
  for (QAction* action : {m_play, m_loop, m_steps[0], m_steps[1]}) action->setEnabled(true);
  showText();
  show();
}

void FrameBar::clear() {
  stop();
  for (QAction* action : {m_play, m_loop, m_steps[0], m_steps[1]}) action->setEnabled(false);
  hide();
}

void FrameBar::showTime(double time) {
  if (isVisibleTo(parentWidget())) showFrame(m_frames.shownAt(time, m_rate));
}

void FrameBar::showFrame(int frame) {
  if (!isVisibleTo(parentWidget()) || !m_frames.has(frame) || frame == m_frame) return;
  stop();
  ask(frame);
}

void FrameBar::askAgain() {
  if (isVisibleTo(parentWidget())) ask(m_frame);
}

void FrameBar::stop() {
  m_play->setChecked(false);
}

void FrameBar::play(bool isOn) {
  if (isOn) {
    const int begin = m_frame == m_frames.last ? m_frames.first : m_frame;
    m_begin = double(begin - m_frames.first) / m_rate;
    m_leftOut = 0;
    m_clock.start();
    m_timer.start();
  } else {
    m_timer.stop();
  }
  showText();
  Q_EMIT played(isOn);
}

/// Asks for the frame that is due.
void FrameBar::tick() {
  constexpr qint64 patience = 2000;  // milliseconds; a frame that cannot be read is left out
  if (m_isAwaited && m_clock.elapsed() < patience) return;
  const double duration = double(m_frames.last - m_frames.first + m_frames.step) / m_rate;
  double time = m_begin + double(m_clock.elapsed()) / 1000;
  if (time >= duration && !m_loop->isChecked()) {
    stop();
    return ask(m_frames.last);
  }
  time = std::fmod(time, duration);
  const int due = m_frames.shownAt(time, m_rate);
  if (due == m_frame) return;
  const int passed = (due - m_frame) / m_frames.step;
  if (passed > 1) m_leftOut += passed - 1;
  ask(due);
}

void FrameBar::step(int frames) {
  stop();
  const int frame = std::clamp(m_frame + frames * m_frames.step, m_frames.first, m_frames.last);
  if (frame != m_frame) ask(frame);
}

void FrameBar::ask(int frame) {
  m_frame = frame;
  m_isAwaited = true;
  {
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue((frame - m_frames.first) / m_frames.step);
  }
  showText();
  Q_EMIT frameAsked(frame);
}

void FrameBar::pictureShown() {
  if (!std::exchange(m_isAwaited, false)) return;
  m_perSecond = m_shown.shown();
  if (isPlaying()) showText();
}

QString FrameBar::textOf(int frame) const {
  const double time = double(frame - m_frames.first) / m_rate;
  return tr("frame %1 of %2 … %3   %4 s")
      .arg(frame)
      .arg(m_frames.first)
      .arg(m_frames.last)
      .arg(QString::fromStdString(rounded(time, 2)));
}

QString FrameBar::rateOf(int perSecond, int leftOut) {
  return tr("   %1 pictures/s, %2 left out").arg(perSecond).arg(leftOut);
}

/// The text keeps its width while it plays, so that the slider does not move.
void FrameBar::showText() {
  QString text = textOf(m_frame);
  QString widest = textOf(m_frames.last);
  if (isPlaying()) {
    text += rateOf(m_perSecond, m_leftOut);
    widest += rateOf(100, 1000);
  } else if (!m_isRateKnown) {
    text += tr("   25 frames/s assumed");
  }
  m_text->setMinimumWidth(m_text->fontMetrics().horizontalAdvance(widest));
  m_text->setText(text);
  m_text->setToolTip(m_isRateKnown ? tr("%1 frames/s").arg(m_rate)
                                   : tr("The light field does not say its frame rate; "
                                        "lightField.fps does"));
}

}  // namespace hogelscope
