// SPDX-License-Identifier: BSD-3-Clause
// Shows an image, or compares two of the same size: zoom, pan, mask and pixel read-out.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "gui/view/zoomable_image.h"

class QAction;

namespace hogelscope {

class ImageWidget : public QWidget {
  Q_OBJECT

 public:
  enum class Mode { single, sideBySide, wipe, difference };

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
  /// How two images are compared.
  void setMode(Mode mode);
  void showMask(bool isShown);
  /// Factor of the difference, 1 … 128.
  void setGain(int gain);
  /// Share of the width, 0 … 1, left of the line: there the first image is shown.
  void setWipe(double share);
  void setViewport(const Viewport& viewport);
  /// From now on both show the same part at the same zoom: first the other's.
  void linkTo(ImageWidget& other);
  /// The whole image.
  void fit();
  /// One pixel of the image on one of the screen.
  void oneToOne();

  [[nodiscard]] const QImage& image() const { return m_images[0].image.image(); }
  [[nodiscard]] const QString& notice() const { return m_notice; }
  [[nodiscard]] const QImage& otherImage() const { return m_images[1].image.image(); }
  [[nodiscard]] const Viewport& viewport() const { return m_viewport; }
  [[nodiscard]] double wipe() const { return m_wipe; }
  [[nodiscard]] int gain() const { return m_gain; }
  /// The whole image as the mode shows it, pixel for pixel, without mask and grid.
  [[nodiscard]] QImage shownImage() const;
  /// Place, code values and zoom under the pointer; "" where no pixel is.
  [[nodiscard]] QString readOut() const;

 Q_SIGNALS:
  /// A click that was no drag.
  void pixelPicked(int x, int y);
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
    ZoomableImage image;
    QImage seen;
    ZoomableImage hatch;
    QString title;
  };
  enum class Drag { none, press, pan, wipe };

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

  [[nodiscard]] Mode shownMode() const;
  [[nodiscard]] QRect deviceRect() const;
  [[nodiscard]] QPointF inDevice(const QPointF& position) const;
  [[nodiscard]] QRect paneAt(const QPointF& device) const;
  [[nodiscard]] Placement placement(const QRect& pane) const;
  [[nodiscard]] std::optional<QPoint> pixelAt(const QPointF& position) const;
  [[nodiscard]] int wipeColumn() const;
  [[nodiscard]] bool isOnLine(const QPointF& position) const;
  void zoomBy(int steps, const QPointF& device);
  void updateDifference();
  void updateHatch();

  void paintImages(QPainter& painter) const;
  void paintOne(QPainter& painter, const QRect& pane, const QRect& clip, std::size_t which) const;
  void paintDifference(QPainter& painter, const QRect& pane) const;
  void paintOtherPointer(QPainter& painter) const;
  void paintTexts(QPainter& painter) const;
  void paintNotice(QPainter& painter) const;

  std::array<Shown, 2> m_images;
  ZoomableImage m_difference;  ///< only in its mode
  Viewport m_viewport;
  Mode m_mode = Mode::sideBySide;
  bool m_showsMask = false;
  int m_gain = 8;
  double m_wipe = 0.5;
  QString m_notice;
  std::optional<QPointF> m_pointer;  ///< widget coordinates, as the next
  QPointF m_pressed;
  Viewport m_draggedFrom;
  Drag m_drag = Drag::none;
  int m_wheel = 0;  ///< what is left of the wheel's last notch, eighths of a degree
};

}  // namespace hogelscope
