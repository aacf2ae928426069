// SPDX-License-Identifier: BSD-3-Clause
// The figures of images that are compared: the report's metrics, histograms.
#pragma once

#include <QImage>
#include <QRect>
#include <vector>

#include "core/base/progress.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

/// The images shown. Null images are absent; a null mask means that all pixels are seen; a null
/// region means none.
struct ShownPictures {
  QImage image;
  QImage seen;
  QImage other;
  QImage otherSeen;
  QRect region;
};

struct ComparisonFigures {
  QRect region;
  std::vector<double> whole;     ///< the report's metrics (MetricSet); empty without a second image
  std::vector<double> inRegion;  ///< as `whole`; empty without a region
  std::vector<Histogram> histograms;  ///< of each image, restricted to the region if there is one
};

/// Returns the figures of the images, of which there is at least one. Throws Cancelled.
ComparisonFigures figuresOf(const ShownPictures& shown, const Progress& progress);

}  // namespace hogelscope
