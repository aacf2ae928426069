// SPDX-License-Identifier: BSD-3-Clause
// Metrics of plugins.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/metric.h"

namespace hogelscope {

/// Returns the standard metrics, those of the plugins with these names (Session::metrics), and
/// `more`. A plugin has a column with its name, "_" for "-", and its mean; and, if it has a figure
/// of the seen pixels, those of the name with "_seen". Throws InputError, also for a column's name
/// that is there twice.
MetricSet metricsOf(const std::vector<std::string>& names, std::vector<Metric> more = {});

}  // namespace hogelscope
