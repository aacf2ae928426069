// SPDX-License-Identifier: BSD-3-Clause
// Shows an image, or compares two of the same size, with zoom, pan, tone, error maps, mask, pixel
// read-out and marks.
#pragma once

#include <QPainterPath>
#include <QRegion>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "core/metrics/error_map.h"
#include "gui/widgets/colours.h"
#include "picture/image_placement.h"

class QTimer;

namespace hogelscope {

class Task;

/// Returns the colours of a mask's patterns.
inline HatchColours hatchColours() {
  return {tokens().series[3], tokens().series[0], tokens().series[1]};
}

class ImageWidget : public QWidget {
  Q_OBJECT

 public:
  /// difference: the map of the error; wipeAndError: both pictures left of it.
  enum class Mode { single, sideBySide, wipe, blink, difference, wipeAndError };

  explicit ImageWidget(QWidget* parent = nullptr);

  /// Sets the images. A second one of another size is ignored; without one there is no comparison.
  void setImages(const QImage& image, const QImage& other = {});
  /// Sets the masks of both images, in their size: black = not seen, hatched by the index in an
  /// indexed mask, a RayEnd. A null mask hides nothing.
  void setMask(const QImage& seen, const QImage& otherSeen = {});
  /// Sets the titles, shown while both images are shown.
  void setTitles(const QString& title, const QString& otherTitle);
  /// Shows a notice in place of an image or on it. The image is then outdated: it is dimmed, and
  /// its pixels cannot be read out or picked. Empty: the image is up to date. A notice with `cures`
  /// is that of an error: it has a frame, and a button for each of them that is enabled, named as
  /// the action with "Cure" appended.
  void setNotice(const QString& notice, const QList<QAction*>& cures = {});
  /// Shows a text, with buttons as a notice has them, on an image that is up to date; empty: none.
  /// A notice takes its place.
  void setRemark(const QString& remark, const QList<QAction*>& cures = {});
  /// Sets the mode of the comparison. Mode::blink alternates twice a second.
  void setMode(Mode mode);
  /// Sets the error map of the modes that show it.
  void setErrorMap(ErrorKind kind, bool hasFalseColour);
  void showMask(bool isShown);
  /// Sets a text in the upper right corner of the image; empty: none.
  void setTag(const QString& tag);
  /// Sets the gain of what is shown: the images, 1/16 … 128, or their error, 1 … 128.
  void setGain(double gain) { setTone({gain, gamma()}); }
  /// Sets the gamma of what is shown, 0.2 … 5.
  void setGamma(double gamma);
  /// Sets what is painted over the first image, in its size; null: nothing.
  void setTint(const QImage& tint);
  /// Outlines pixels.
  void markPixels(const QRegion& pixels);
  /// Selects a rectangle of pixels; null: none.
  void setRegion(const QRect& region);
  /// Sets the share of the width, 0 … 1, that shows the first image.
  void setWipe(double share);
  void setViewport(const Viewport& viewport);
  /// Sets the gain that shows the lightest pixel of the first image white, as far as it can.
  void stretch();
  /// Fits the whole image.
  void fit();
  /// Shows one image pixel per screen pixel.
  void oneToOne();

  [[nodiscard]] const QImage& image() const { return m_images[0].image; }
  [[nodiscard]] const QString& notice() const { return m_notice; }
  [[nodiscard]] const QString& remark() const { return m_remark; }
  [[nodiscard]] const QString& tag() const { return m_tag; }
  /// Returns the largest code value of the first image, or one of at least `enough` if it has one.
  [[nodiscard]] int lightest(int enough = 255) const;
  [[nodiscard]] const QImage& otherImage() const { return m_images[1].image; }
  [[nodiscard]] const QImage& seen() const { return m_images[0].seen; }
  [[nodiscard]] const QImage& otherSeen() const { return m_images[1].seen; }
  [[nodiscard]] QStringList titles() const { return {m_images[0].title, m_images[1].title}; }
  [[nodiscard]] const QImage& tint() const { return m_tint.image(); }
  [[nodiscard]] const QRect& region() const { return m_region; }
  [[nodiscard]] const QRegion& markedPixels() const { return m_marked; }
  [[nodiscard]] const Viewport& viewport() const { return m_viewport; }
  [[nodiscard]] double wipe() const { return m_wipe; }
  [[nodiscard]] double gain() const { return shownTone().gain; }
  [[nodiscard]] double gamma() const { return shownTone().gamma; }
  /// Whether two images are compared.
  [[nodiscard]] bool hasTwo() const { return !otherImage().isNull(); }
  /// Returns gain and gamma of what is shown in words; "" for an image as it is.
  [[nodiscard]] QString toneText() const;
  /// Returns the whole image in the current mode, pixel for pixel, without mask and grid.
  [[nodiscard]] QImage shownImage() const;
  /// Returns position, code values and zoom under the pointer; "" if there is no pixel.
  [[nodiscard]] QString readOut() const;

 Q_SIGNALS:
  void imagesChanged();
  void toneChanged();  ///< gain or gamma of what is shown, or what is shown
  /// A click without dragging.
  void pixelPicked(int x, int y);
  /// The same with Ctrl held.
  void focusAsked(int x, int y);
  /// Emitted during drawing too.
  void regionChanged(const QRect& region);
  /// The pixel under the pointer; (-1, -1): none.
  void pointed(const QPoint& pixel);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;  ///< fits the image
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Shown {
    QImage image;
    ZoomableImage toned;
    QImage seen;
    ZoomableImage hatch;
    std::array<bool, 3> reasons{};  ///< the RayEnd that the hatch has
    QString title;
  };
  enum class Drag { none, press, pan, wipe, region };

  void addCommands();
  template <class Action>
  void addCommand(const char* name, const QString& text, const QString& help,
                  const QList<QKeySequence>& keys, std::optional<Mode> mode, Action does);
  void showActions();
  void pan(int x, int y);
  void resetTone();
  void flip();
  void takeTurn();
  void removeRegion();

  [[nodiscard]] Mode shownMode() const;
  [[nodiscard]] bool hasTwoPanes() const;
  [[nodiscard]] bool hasWipe() const;
  [[nodiscard]] bool hasError() const;
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
  void paintBoth(QPainter& painter, const QRect& pane) const;
  void paintDifference(QPainter& painter, const QRect& pane) const;
  void paintOtherPointer(QPainter& painter) const;
  void paintMarks(QPainter& painter, const QRect& clip, const Placement& at) const;
  void paintTexts(QPainter& painter) const;
  void paintLegend(QPainter& painter, int right) const;
  [[nodiscard]] QString heading() const;
  [[nodiscard]] QString errorHeading() const;
  [[nodiscard]] QImage wipedImage() const;
  void paintNotice(QPainter& painter) const;
  [[nodiscard]] QRect noticeArea() const;
  void setCures(const QList<QAction*>& cures);
  void placeCures();
  void paintValues(QPainter& painter, const QRect& clip, const Placement& at,
                   std::optional<std::size_t> which) const;

  std::array<Shown, 2> m_images;
  ZoomableImage m_tint;
  ZoomableImage m_difference;  ///< while an error is shown only, as is the next
  std::shared_ptr<const ErrorMap> m_map;
  Task* m_mapping;          ///< computes the difference of large images
  int m_wanted = 0;         ///< the number of the requested difference
  bool m_isMapOld = false;  ///< m_difference is outdated or null
  ErrorMap::Params m_error;
  Tone m_tone;  ///< of the images
  Viewport m_viewport;
  Mode m_mode = Mode::sideBySide;
  bool m_showsMask = false;
  double m_wipe = 0.5;
  QTimer* m_turns;         ///< while the images blink
  std::size_t m_turn = 0;  ///< the image shown while blinking
  QRegion m_marked;
  QPainterPath m_marks;  ///< the outline of the marked pixels
  QRect m_region;
  QString m_notice;
  QString m_remark;
  QString m_tag;
  QWidget* m_cures;                  ///< the buttons of notice or remark; hidden if there are none
  std::optional<QPointF> m_pointer;  ///< widget coordinates, as is the next
  QPointF m_pressed;
  Viewport m_draggedFrom;
  Drag m_drag = Drag::none;
  int m_wheel = 0;  ///< the rest of the wheel's last notch, eighths of a degree
};

}  // namespace hogelscope
