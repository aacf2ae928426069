// SPDX-License-Identifier: BSD-3-Clause
// The order of a light field's views for programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "capture/lenslets/lenslet_search.h"
#include "io/opening/light_field_order.h"

namespace hogelscope {

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

}  // namespace hogelscope
