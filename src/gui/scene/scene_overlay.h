// SPDX-License-Identifier: BSD-3-Clause
// Paints the two-dimensional parts over the 3-D scene's picture: axes, arrows of the handles, the
// viewing zone's outlines, scale bar, legend, the PSNR's bar and a measured line. They are painted
// with the window's fonts, and VTK need not draw the scene again for them.
#pragma once

#include <QColor>
#include <QPainter>
#include <QPolygonF>
#include <QString>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "gui/scene/scene_handles.h"
#include "gui/widgets/colours.h"

namespace hogelscope {

struct SceneOverlay {
  std::array<Vec3, 3> axes;       ///< of the world, as right, up and towards the eye
  std::vector<AxisArrow> arrows;  ///< in the painter's pixels, as are the others
  std::vector<std::pair<QPointF, QColor>> balls;
  double pixelSize = 0;                       ///< metres at the panel; 0: no scale bar
  QPolygonF wholeZone, someZone;              ///< outlines, solid and dashed; empty: none
  bool isSheet = false;                       ///< they are of a lens sheet's cones
  std::vector<QPolygonF> sharpDepths;         ///< outlines of planes, dotted
  std::optional<std::array<double, 2>> psnr;  ///< dB, the least and the largest
  QString label;                              ///< below `labelPlace`
  QPointF labelPlace;
  std::vector<QPointF> measured;  ///< up to two points
  QString distance;               ///< between them

  /// Paints on a picture of `size`; `behind` is its background.
  void paint(QPainter& painter, const QSizeF& size, const Tokens& colours,
             const QColor& behind) const;
};

}  // namespace hogelscope
