// SPDX-License-Identifier: BSD-3-Clause
// Metrics of plugins beside the standard ones.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/metric.h"

namespace hogelscope {

/// Returns the standard metrics and those of the plugins with these names (Session::metrics). Each
/// has one column, named as the plugin with "_" for "-", and one mean. Throws InputError.
MetricSet metricsOf(const std::vector<std::string>& names);

}  // namespace hogelscope
