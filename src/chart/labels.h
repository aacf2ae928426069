// SPDX-License-Identifier: BSD-3-Clause
// Finds places for the labels of a chart's points, such that none covers another thing.
#pragma once

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <optional>
#include <vector>

namespace hogelscope {

/// A box that wants to stand beside a point. All lengths in points.
struct LabelRequest {
  QPointF point;
  double radius = 0;  ///< of the point's marker
  QSizeF size;
  double gap = 2.5;   ///< at least so far from the marker
  double weight = 1;  ///< how much a good place matters to it, against the others
};

struct LabelSurroundings {
  std::vector<QRectF> areas;      ///< a label lies wholly in one of them
  std::vector<QRectF> obstacles;  ///< markers and captions: no label may touch them
  std::vector<QLineF> lines;      ///< to be left free where that is possible
};

struct LabelPlace {
  QRectF box;
  std::optional<QLineF> leader;  ///< from the marker to a label that does not stand right beside it
};

/// One place for each request; none where there is no room. The first ones choose first.
std::vector<std::optional<LabelPlace>> placeLabels(const std::vector<LabelRequest>& requests,
                                                   const LabelSurroundings& surroundings);

}  // namespace hogelscope
