// SPDX-License-Identifier: BSD-3-Clause
// The places that a label may take, as far as the other labels leave them to it.
#pragma once

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <vector>

#include "chart/labels.h"

namespace hogelscope {

constexpr double labelMargin = 1.5;  ///< points between a label and anything else

struct LabelCandidate {
  LabelPlace place;
  double price = 0;  ///< points of distance from the marker, and what else is bad about the place
};

/// Free of everything but labels, the cheapest first: around the point, and all over the areas.
std::vector<LabelCandidate> candidatesNear(const LabelRequest& request,
                                           const LabelSurroundings& around);
std::vector<LabelCandidate> candidatesAnywhere(const LabelRequest& request,
                                               const LabelSurroundings& around);

/// Is any of the line inside the box?
bool meets(const QLineF& line, const QRectF& box);
QPointF nearestPoint(const QRectF& box, const QPointF& to);
QRectF grown(const QRectF& box, double by);

}  // namespace hogelscope
