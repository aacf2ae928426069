// SPDX-License-Identifier: BSD-3-Clause
// Finds the focus at which a picked pixel is sharp, and focuses there on request.
#pragma once

#include <QObject>
#include <QPoint>
#include <functional>
#include <optional>

#include "gui/widgets/task.h"
#include "picture/stereo_view.h"

class QAction;
class QMenu;

namespace hogelscope {

class ImageWidget;
class SessionModel;

class FocusFinder : public QObject {
  Q_OBJECT

 public:
  /// Follows the pixels that are picked in `view`. `viewAt` returns the view that a pixel belongs
  /// to; none if it is outside.
  FocusFinder(QMenu* menu, ImageWidget* view, SessionModel* model,
              std::function<std::optional<PickedView>(const QPoint&)> viewAt, QObject* parent);

 Q_SIGNALS:
  /// A text about the focus of a pixel, "" if it is not known (any more).
  void found(const QPoint& pixel, const QString& text);
  void failed(const QString& line);

 private:
  void pick(int x, int y);
  void focusOn(int x, int y);
  void search(const QPoint& pixel, bool isApplied);
  bool searchCapture(const QPoint& pixel);
  void takeDepth(const QPoint& pixel, const std::optional<double>& depth);
  void take(const QPoint& pixel, const std::optional<double>& focus, bool isApplied);
  void forgetEdited();

  SessionModel* m_model;
  std::function<std::optional<PickedView>(const QPoint&)> m_viewAt;
  std::optional<QPoint> m_pixel;     ///< the one picked last
  std::optional<RenderJob> m_asked;  ///< the job of the latest search
  QAction* m_focus;
  Task* m_task;
};

}  // namespace hogelscope
