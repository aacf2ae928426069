// SPDX-License-Identifier: BSD-3-Clause
// Shows an image, or compares two of the same size: zoom, pan, tone, error maps, mask, pixel
// read-out, and what is marked in it.
#pragma once

#include <QPainterPath>
#include <QRegion>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "core/metrics/error_map.h"
#include "gui/view/zoomable_image.h"

class QAction;
class QTimer;

namespace hogelscope {

class Task;

class ImageWidget : public QWidget {
  Q_OBJECT

 public:
  enum class Mode { single, sideBySide, wipe, blink, difference };

  explicit ImageWidget(QWidget* parent = nullptr);

  /// A second one of another size is not shown; without one there is nothing to compare.
  void setImages(const QImage& image, const QImage& other = {});
  /// 0 = not seen, for each image; of its size. A null one marks nothing.
  void setMask(const QImage& seen, const QImage& otherSeen = {});
  /// What the images are, shown where both are.
  void setTitles(const QString& title, const QString& otherTitle);
  /// Stands in the place of an image, or on it: then it is not what it should be, is dimmed, and
  /// no pixel of it is read out or picked. Empty: the image is right.
  void setNotice(const QString& notice);
  /// How two images are compared. Blinking, they take turns, twice a second.
  void setMode(Mode mode);
  /// What Mode::difference shows.
  void setErrorMap(ErrorKind kind, bool hasFalseColour);
  void showMask(bool isShown);
  /// Of what is shown: the pictures, 1/16 … 128, or their error, 1 … 128.
  void setGain(double gain);
  /// Likewise, 0.2 … 5.
  void setGamma(double gamma);
  /// Pixels with a line around them.
  void markPixels(const QRegion& pixels);
  /// A rectangle of pixels; null: none.
  void setRegion(const QRect& region);
  /// Share of the width, 0 … 1, left of the line: there the first image is shown.
  void setWipe(double share);
  void setViewport(const Viewport& viewport);
  /// From now on both show the same part at the same zoom: first the other's.
  void linkTo(ImageWidget& other);
  /// The whole image.
  void fit();
  /// One pixel of the image on one of the screen.
  void oneToOne();

  [[nodiscard]] const QImage& image() const { return m_images[0].image; }
  [[nodiscard]] const QString& notice() const { return m_notice; }
  [[nodiscard]] const QImage& otherImage() const { return m_images[1].image; }
  [[nodiscard]] const QImage& seen() const { return m_images[0].seen; }
  [[nodiscard]] const QImage& otherSeen() const { return m_images[1].seen; }
  [[nodiscard]] const QRect& region() const { return m_region; }
  [[nodiscard]] const QRegion& markedPixels() const { return m_marked; }
  [[nodiscard]] const Viewport& viewport() const { return m_viewport; }
  [[nodiscard]] double wipe() const { return m_wipe; }
  [[nodiscard]] double gain() const { return shownTone().gain; }
  [[nodiscard]] double gamma() const { return shownTone().gamma; }
  /// The whole image as the mode shows it, pixel for pixel, without mask and grid.
  [[nodiscard]] QImage shownImage() const;
  /// Place, code values and zoom under the pointer; "" where no pixel is.
  [[nodiscard]] QString readOut() const;

 Q_SIGNALS:
  void imagesChanged();
  /// A click that was no drag.
  void pixelPicked(int x, int y);
  /// While it is drawn, too.
  void regionChanged(const QRect& region);
  /// The pixel under the pointer; (-1, -1): there is none.
  void pointed(const QPoint& pixel);
  void viewportChanged(const hogelscope::Viewport& viewport);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;  ///< fits
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  struct Shown {
    QImage image;
    ZoomableImage toned;
    QImage seen;
    ZoomableImage hatch;
    QString title;
  };
  enum class Drag { none, press, pan, wipe, region };

  void addCommands();
  void addCommand(const char* name, const QString& text, const QString& help,
                  const QList<QKeySequence>& keys, std::optional<Mode> mode,
                  void (ImageWidget::*does)());
  void showActions();
  void zoomIn();
  void zoomOut();
  void pan(int x, int y);
  void panLeft();
  void panRight();
  void panUp();
  void panDown();
  void wipeLeft();
  void wipeRight();
  void moreGain();
  void lessGain();
  void moreGamma();
  void lessGamma();
  void resetTone();
  void flip();
  void takeTurn();
  void removeRegion();

  [[nodiscard]] Mode shownMode() const;
  [[nodiscard]] const Tone& shownTone() const;
  void setTone(const Tone& tone);
  [[nodiscard]] QRect deviceRect() const;
  [[nodiscard]] QPointF inDevice(const QPointF& position) const;
  [[nodiscard]] QRect paneAt(const QPointF& device) const;
  [[nodiscard]] Placement placement(const QRect& pane) const;
  [[nodiscard]] std::optional<QPoint> pixelAt(const QPointF& position) const;
  [[nodiscard]] int wipeColumn() const;
  [[nodiscard]] bool isOnLine(const QPointF& position) const;
  [[nodiscard]] QRect regionTo(const QPointF& position) const;
  void zoomBy(int steps, const QPointF& device);
  void updateTones();
  void updateDifference();
  void startMap();
  void takeMap(int number, const QImage& map);
  void updateHatch();

  void paintImages(QPainter& painter) const;
  void paintOne(QPainter& painter, const QRect& pane, const QRect& clip, std::size_t which) const;
  void paintDifference(QPainter& painter, const QRect& pane) const;
  void paintOtherPointer(QPainter& painter) const;
  void paintMarks(QPainter& painter, const QRect& clip, const Placement& at) const;
  void paintTexts(QPainter& painter) const;
  [[nodiscard]] QString heading() const;
  void paintNotice(QPainter& painter) const;

  std::array<Shown, 2> m_images;
  ZoomableImage m_difference;  ///< only in its mode, as the next
  std::shared_ptr<const ErrorMap> m_map;
  Task* m_mapping;          ///< works out the difference of large images
  int m_wanted = 0;         ///< number of the difference that is wanted
  bool m_isMapOld = false;  ///< m_difference is an older one, or null
  ErrorMap::Params m_error;
  Tone m_tone;  ///< of the pictures
  Viewport m_viewport;
  Mode m_mode = Mode::sideBySide;
  bool m_showsMask = false;
  double m_wipe = 0.5;
  QTimer* m_turns;         ///< while the images blink
  std::size_t m_turn = 0;  ///< the image that is shown then
  QRegion m_marked;
  QPainterPath m_marks;  ///< their outline
  QRect m_region;
  QString m_notice;
  std::optional<QPointF> m_pointer;  ///< widget coordinates, as the next
  QPointF m_pressed;
  Viewport m_draggedFrom;
  Drag m_drag = Drag::none;
  int m_wheel = 0;  ///< what is left of the wheel's last notch, eighths of a degree
};

}  // namespace hogelscope
