// SPDX-License-Identifier: BSD-3-Clause
// The inspector: the trace and values of a pixel of the image, or of a hogel.
#pragma once

#include <QPointer>
#include <QWidget>
#include <optional>

#include "core/optics/pixel_inspection.h"

class QLabel;

namespace hogelscope {

class ImageWidget;
class KernelWidget;
class SceneController;

class Inspector : public QWidget {
  Q_OBJECT

 public:
  explicit Inspector(QWidget* parent = nullptr);

  /// Follows the pointer over `picture`; shows what is picked in `scene` otherwise.
  void follow(SceneController* scene, ImageWidget* picture);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void point(const QPoint& pixel);
  void refresh();
  void showPixel(const RenderJob& job, const QPoint& pixel);
  void showHogel(const RenderJob& job, const QPoint& hogel);
  void showNothing(const QString& hint);
  void showNeighbours(const QPoint& pixel);
  void showPictureOf(const RenderJob& job, const QPoint& hogel);
  void showDirection(const RenderJob& job, const Hit& place);
  [[nodiscard]] QString valuesAt(const QPoint& pixel) const;

  QPointer<SceneController> m_scene;
  QPointer<ImageWidget> m_picture;
  std::optional<QPoint> m_pointed;
  QLabel* m_swatch;
  QLabel* m_verdict;
  ImageWidget* m_neighbours;
  QLabel* m_values;
  QLabel* m_hogelTitle;
  ImageWidget* m_hogel;
  KernelWidget* m_weights;
};

}  // namespace hogelscope
