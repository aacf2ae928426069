// SPDX-License-Identifier: BSD-3-Clause
// The values of a report's row, computed from a few of them.
#pragma once

#include <array>
#include <vector>

#include "core/metrics/metric.h"
#include "core/metrics/squared_error.h"

/// Returns the standard metrics of a view whose pixels are all seen.
inline std::vector<double> metricValues(double mse, double ssim,
                                        const std::array<double, 3>& mseYuv) {
  using hogelscope::psnr;
  const auto& [y, cb, cr] = mseYuv;
  std::vector<double> values{psnr(mse), psnr(mse), mse, mse, ssim, 1};
  for (int region = 0; region < 2; ++region)
    values.insert(values.end(),
                  {y, cb, cr, psnr(y), psnr(cb), psnr(cr), hogelscope::psnrYuv(mseYuv)});
  values.insert(values.end(), {ssim, 8, mse});
  return values;
}

inline std::vector<double> metricValues(double mse) {
  return metricValues(mse, 0.5, {mse, mse, mse});
}
