// SPDX-License-Identifier: BSD-3-Clause
// Metrics of plugins.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/metric.h"

namespace hogelscope {

/// Returns the standard metrics and those of the plugins with these names (Session::metrics). Each
/// plugin has one column, with its name and "_" for "-", and one mean. Throws InputError.
MetricSet metricsOf(const std::vector<std::string>& names, std::vector<Metric> more = {});

}  // namespace hogelscope
