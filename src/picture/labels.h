// SPDX-License-Identifier: BSD-3-Clause
// Texts and a colour scale that stand on an image.
#pragma once

#include <QColor>
#include <QPainter>
#include <QString>

#include "core/metrics/error_map.h"

namespace hogelscope {

/// The colours of a label; its ground is translucent.
struct LabelColours {
  QColor ground, text;
};

/// Paints the ground of a text.
void paintGround(QPainter& painter, const QRect& box, const QColor& colour);
/// Paints a text on a ground in the given corner of `area`, after a square of colour `mark` with
/// sides of `side` if that is valid.
void paintText(QPainter& painter, const QRect& area, Qt::Alignment corner, const QString& text,
               const LabelColours& colours, const QColor& mark = {}, int side = 0);
/// Paints a colour scale at the right of `area`, with round numbers and their unit. Returns its
/// left end.
int paintScale(QPainter& painter, const QRect& area, const ErrorMap& map, const QString& unit,
               const LabelColours& colours);

}  // namespace hogelscope
