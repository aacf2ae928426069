// SPDX-License-Identifier: BSD-3-Clause
#include "picture/comparison_figures.h"

#include <utility>

#include "core/base/parallel.h"
#include "core/metrics/metric.h"
#include "picture/conversions.h"

namespace hogelscope {

ComparisonFigures figuresOf(const ShownPictures& shown, const Progress& progress) {
  ComparisonFigures figures;
  figures.region = shown.region;
  const auto pairOf = [&](const QRect& part) {
    return std::pair(toImage(shown.image, shown.seen, part),
                     toImage(shown.other, shown.otherSeen, part));
  };
  const bool hasOther = !shown.other.isNull();
  const auto [own, other] = pairOf(shown.region.isNull() ? shown.image.rect() : shown.region);
  figures.histograms.push_back(lumaHistogram(own));
  if (!hasOther) return figures;
  figures.histograms.push_back(lumaHistogram(other));
  const auto compare = [&](const Image& a, const Image& b) {
    return MetricSet().compare(a, b, parallelRows, progress);
  };
  if (shown.region.isNull()) {
    figures.whole = compare(own, other);
    return figures;
  }
  figures.inRegion = compare(own, other);
  const auto [wholeOwn, wholeOther] = pairOf(shown.image.rect());
  figures.whole = compare(wholeOwn, wholeOther);
  return figures;
}

}  // namespace hogelscope
