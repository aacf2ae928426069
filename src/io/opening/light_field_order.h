// SPDX-License-Identifier: BSD-3-Clause
// The order and shear of a light field's views, from its pictures and the positions in its file
// names; what a session says against them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "capture/lenslets/lenslet_search.h"
#include "capture/order/view_order.h"
#include "core/panel/display.h"

namespace hogelscope {

struct LightFieldOrder {
  /// The light field's parameters with the order and shear that were found, as far as its layout
  /// can say them; the given ones where nothing was found.
  LightFieldParams found;
  /// Of the files: for views as `rows` and `columns` of a session say it, else as hogels,
  /// directions and tiles lie in the file.
  RowOrder rows = RowOrder::topDown;
  ColumnOrder columns = ColumnOrder::leftRight;
  Sureness sureness = Sureness::unknown;
  std::string reason;                 ///< what the order was found by, or why it was not
  std::vector<std::string> warnings;  ///< what no parameter of the layout can mend, and the like
  ViewOrder measured;
  bool isExchanged = false;  ///< what was measured has columns for the rows of `found`
  /// Of a quilt: its tiles show vertical parallax, as a mosaic's do.
  bool isLikeMosaic = false;
};

/// Looks at some of the views. Throws InputError as openLightField() does, or Cancelled.
LightFieldOrder findLightFieldOrder(const LightFieldParams& params, const DisplayParams& display,
                                    const Progress& progress = {});

/// Returns the overrides that turn order and shear of `used` into those that were found:
/// "lightField.rows=bottom-up" and the like; none where they are the same.
std::vector<std::string> mendingOf(const LightFieldParams& used, const LightFieldOrder& order);

/// Returns a line for the user if `used` contradicts what was found, with what mends it; else "".
std::string contradictionOf(const LightFieldParams& used, const LightFieldOrder& order);

/// Returns all lines for the user: the warnings, and contradictionOf() if there is one.
std::vector<std::string> warningsOf(const LightFieldParams& used, const LightFieldOrder& order);

/// Returns the parameters that were found with the order that `used` has, and the shear that puts
/// the middle depth on the panel in that order.
LightFieldParams withOrderOf(const LightFieldParams& used, const LightFieldOrder& order);

/// What is assumed of a light field, and how sure that is.
struct AssumedOrder {
  LightFieldParams used;
  LightFieldSize size;
  RowOrder rows = RowOrder::topDown;
  ColumnOrder columns = ColumnOrder::leftRight;
  Sureness sureness = Sureness::unknown;
  std::vector<std::string> warnings;
  std::optional<FoundLenslets> lenslets;  ///< of the layout of that name
  bool isChosen = false;                  ///< by the user, whatever the pictures say
};

/// Says what `used` assumes. What contradicts the content is unknown, with a warning that mends it.
AssumedOrder assumedOrder(const LightFieldParams& used, const LightFieldSize& size,
                          const LightFieldOrder& order);

/// {"layout", "hogels", "directions", "rows", "columns", "shear", "confidence", "warnings"}
std::string orderDocument(const AssumedOrder& assumed);

RowOrder reversed(RowOrder order);
ColumnOrder reversed(ColumnOrder order);
/// "top-down", "left-right", "sure" and the like.
const char* nameOf(RowOrder order);
const char* nameOf(ColumnOrder order);
const char* nameOf(Sureness sureness);

}  // namespace hogelscope
