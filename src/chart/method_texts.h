// SPDX-License-Identifier: BSD-3-Clause
// Texts of measured methods, as HTML in the colours of a chart. `em` is the size of text in pixels.
#pragma once

#include <QString>
#include <vector>

#include "chart/painting.h"
#include "chart/recommendations.h"
#include "study/tradeoff.h"

namespace hogelscope {

/// Returns a number of views per second such as "11".
QString rateText(const TradeoffRow& row);
/// Returns name, time, error and a better method of a measured row.
QString detailsOf(const std::vector<TradeoffRow>& rows, std::size_t row,
                  const ChartColours& colours, double em);
/// Returns the row's RMSE, with its interval if only part of the pixels were compared.
QString errorText(const TradeoffRow& row);
/// Returns the text of the button for the row that is recommended for some purposes, in one line or
/// three. `isUsed`: the live view is rendered by the method.
QString cardText(const std::vector<Purpose>& alike, const TradeoffRow& row, bool isUsed,
                 bool isLine, const ChartColours& colours, double em);

}  // namespace hogelscope
