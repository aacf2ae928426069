// SPDX-License-Identifier: BSD-3-Clause
// The bar below the view of a light field in time: play, step, scrub, loop.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "core/light_field/frames.h"
#include "gui/view/picture_rate.h"

class QAction;
class QLabel;
class QMenu;
class QSlider;

namespace hogelscope {

/// Is shown only where there are frames. While it plays, the clock says which frame is due: a slow
/// view leaves frames out and is never late. A frame is asked for once the last one is shown.
class FrameBar : public QWidget {
  Q_OBJECT

 public:
  /// Adds its commands to `menu`.
  FrameBar(QMenu* menu, QWidget* parent);

  /// Shows the bar for these frames, at the first one; `rate` is 0 if it is not known. For the
  /// frames that it shows already, it asks again for the one at which it is.
  void setFrames(const FrameNumbers& frames, double rate);
  /// Hides the bar.
  void clear();
  /// Goes to the frame that is shown at a time, in seconds.
  void showTime(double time);
  /// Goes to a frame.
  void showFrame(int frame);
  /// Tells that the frame that was asked for last is on the screen.
  void pictureShown();
  /// Asks for the frame that is shown.
  void askAgain();
  /// Stops playing.
  void stop();
  [[nodiscard]] bool isPlaying() const { return m_timer.isActive(); }
  [[nodiscard]] int frame() const { return m_frame; }

 Q_SIGNALS:
  void frameAsked(int frame);
  void played(bool isPlaying);

 private:
  void addCommands(QMenu* menu);
  void play(bool isOn);
  void tick();
  void ask(int frame);
  void step(int frames);
  [[nodiscard]] QString textOf(int frame) const;
  static QString rateOf(int perSecond, int leftOut);
  void showText();

  FrameNumbers m_frames;
  double m_rate = 0;
  bool m_isRateKnown = false;
  int m_frame = 0;
  QAction* m_play = nullptr;
  QAction* m_loop = nullptr;
  std::vector<QAction*> m_steps;
  QSlider* m_slider;
  QLabel* m_text;
  QTimer m_timer;
  QElapsedTimer m_clock;     ///< since playing began
  double m_begin = 0;        ///< the time of the frame with which it began, seconds
  bool m_isAwaited = false;  ///< the frame that was asked for is not shown yet
  int m_leftOut = 0;         ///< since playing began
  PictureRate m_shown;
  int m_perSecond = 0;
};

}  // namespace hogelscope
