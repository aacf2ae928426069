// SPDX-License-Identifier: BSD-3-Clause
// Finds the order and shear of a light field's views from its images and the positions in its file
// names, and compares them with a session. What was found changes new sessions alone; a session's
// own order stays, with a warning.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "capture/lenslets/lenslet_search.h"
#include "capture/order/view_order.h"
#include "core/panel/display.h"

namespace hogelscope {

/// The order of a capture's files by the places of its cameras; nothing else is so sure.
struct CameraOrder {
  RowOrder rows = RowOrder::topDown;
  ColumnOrder columns = ColumnOrder::leftRight;
  std::string file;  ///< that says it
};

struct LightFieldOrder {
  /// The light field's parameters with the order that was found, as far as its layout has
  /// parameters for it, and its shear unless the order is unknown; the given ones if nothing was
  /// found.
  LightFieldParams found;
  /// The order of the files: for views that of a session's `rows` and `columns`, otherwise that of
  /// hogels, directions or tiles in the file.
  RowOrder rows = RowOrder::topDown;
  ColumnOrder columns = ColumnOrder::leftRight;
  Sureness sureness = Sureness::unknown;
  std::string reason;                 ///< evidence for the order, or why it was not found
  std::vector<std::string> warnings;  ///< such as errors that no parameter of the layout corrects
  ViewOrder measured;
  bool isExchanged = false;  ///< rows and columns of `measured` are exchanged in `found`
  /// The tiles of a quilt show vertical parallax, as those of a mosaic do.
  bool isLikeMosaic = false;
  bool isLikeQuilt = false;  ///< the tiles of a row follow those of another, as in a quilt
};

/// Finds the order by some of the views, or takes that of their cameras, for which the parameters
/// must read the files' grid; then the views are still examined for the shear, and for whether they
/// contradict it. Throws InputError as openLightField() does, or Cancelled.
LightFieldOrder findLightFieldOrder(const LightFieldParams& params, const DisplayParams& display,
                                    const Progress& progress = {},
                                    const std::optional<CameraOrder>& cameras = {});

/// Whether the motion between the views was measured along rows and columns as they are read, so
/// that the shear of the middle depth is known.
bool hasMiddleMotion(const ViewOrder& measured);

/// Returns the overrides that turn order and shear of `used` into those that were found, such as
/// "lightField.rows=bottom-up"; none if they are the same.
std::vector<std::string> mendingOf(const LightFieldParams& used, const LightFieldOrder& order);

/// Returns a warning with the correction if `used` contradicts what was found; otherwise "".
std::string contradictionOf(const LightFieldParams& used, const LightFieldOrder& order);

/// Returns all warnings, with contradictionOf() if there is one.
std::vector<std::string> warningsOf(const LightFieldParams& used, const LightFieldOrder& order);

/// Returns the parameters that were found, with the order of `used` and the shear that puts the
/// middle depth on the panel in that order.
LightFieldParams withOrderOf(const LightFieldParams& used, const LightFieldOrder& order);

/// The order that is assumed for a light field, and its confidence.
struct AssumedOrder {
  LightFieldParams used;
  LightFieldSize size;
  RowOrder rows = RowOrder::topDown;
  ColumnOrder columns = ColumnOrder::leftRight;
  Sureness sureness = Sureness::unknown;
  std::vector<std::string> warnings;
  std::optional<FoundLenslets> lenslets;  ///< only for the layout of that name
  bool isChosen = false;                  ///< by the user, regardless of the images
};

/// Returns the order in `used`. If it contradicts the content, it is `unknown`, with a warning that
/// contains the correction.
AssumedOrder assumedOrder(const LightFieldParams& used, const LightFieldSize& size,
                          const LightFieldOrder& order);

/// Returns a JSON object of layout, hogels, directions, rows, columns, shear, confidence, lenslets
/// if there are any, and warnings.
std::string orderDocument(const AssumedOrder& assumed);

RowOrder reversed(RowOrder order);
ColumnOrder reversed(ColumnOrder order);
/// Returns "top-down", "left-right", "raster", "bottom-left", "sure" or another name.
const char* nameOf(RowOrder order);
const char* nameOf(ColumnOrder order);
const char* nameOf(ViewScan scan);
const char* nameOf(QuiltStart start);
const char* nameOf(Sureness sureness);

}  // namespace hogelscope
