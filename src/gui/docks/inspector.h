// SPDX-License-Identifier: BSD-3-Clause
// The inspector: the trace and values of a pixel of the image, or of a hogel.
#pragma once

#include <QPointer>
#include <QWidget>
#include <memory>
#include <optional>

#include "core/optics/pixel_inspection.h"

namespace Ui {
class Inspector;
}

namespace hogelscope {

class ImageWidget;
class SceneController;
struct PickedView;

class Inspector : public QWidget {
  Q_OBJECT

 public:
  explicit Inspector(QWidget* parent = nullptr);
  ~Inspector() override;

  /// Follows the pointer over `picture`; shows what is picked in `scene` otherwise.
  void follow(SceneController* scene, ImageWidget* picture);
  /// Adds a text about the focus of a pixel, shown while that pixel is.
  void showFocus(const QPoint& pixel, const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void point(const QPoint& pixel);
  void refresh();
  void showPixel(const PickedView& view, const QPoint& shown);
  void showHogel(const RenderJob& job, const QPoint& hogel);
  void showNothing(const QString& hint);
  void showNeighbours(const QPoint& pixel);
  void showPictureOf(const RenderJob& job, const QPoint& hogel);
  void showDirection(const RenderJob& job, const Hit& place);
  [[nodiscard]] QString valuesAt(const QPoint& pixel) const;

  std::unique_ptr<Ui::Inspector> m_ui;
  QPointer<SceneController> m_scene;
  QPointer<ImageWidget> m_picture;
  std::optional<QPoint> m_pointed;
  QPoint m_focused{-1, -1};  ///< the pixel that m_focusText is about
  QString m_focusText;
};

}  // namespace hogelscope
