// SPDX-License-Identifier: BSD-3-Clause
// The metrics of a report. Rows, CSV files, means, BD-rates, the journal and all tables follow from
// the columns and the means that a metric declares here.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/optics/image.h"
#include "core/optics/viewing.h"

namespace hogelscope {

/// A value of a comparison.
struct MetricColumn {
  /// The tables with this column. Each one also has the columns of those before it.
  enum class Where { files, page, window };

  std::string name;        ///< in CSV files: "psnr_seen"
  std::string title{};     ///< in tables, such as "PSNR seen"
  std::string unit{};      ///< in tables, such as "dB"
  std::string help{};      ///< tooltip
  int decimals = 2;        ///< in tables
  double tableFactor = 1;  ///< the factor of values in tables, such as 100 for percent
  Where where = Where::files;
};

/// Formats a value for tables; "identical" if infinite, a dash if NaN.
std::string tableText(const MetricColumn& column, double value);

/// A mean over views, without values that are not finite.
struct MetricMean {
  std::string name;        ///< in CSV files: "psnr_of_mean_mse"
  std::string title;       ///< in tables
  std::size_t column = 0;  ///< an index of the metric's columns
  int decimals = 2;
  double (*ofMean)(double mean) = nullptr;  ///< conversion of the mean; null: the mean itself
  bool isQuality = false;                   ///< whether BD-rates use it
  std::string unit{};                       ///< such as "dB"
  bool isSeen = false;   ///< over the pixels seen in both images, not the whole frame
  bool mayFall = false;  ///< whether it may be an error: BD-rates take one that falls with the rate
};

/// Returns the value of each column for images of one size.
using CompareImages = std::function<std::vector<double>(
    const Image& reference, const Image& test, const ParallelRows& parallelRows,
    const Progress& progress, const Viewing& viewing)>;

struct Metric {
  std::vector<MetricColumn> columns;
  std::vector<MetricMean> means;
  CompareImages compare;
  bool readsUnrounded = false;  ///< of the images; falls back to rounded ones
};

/// Indices of the standard metrics' columns, which come first in every MetricSet. Those without
/// "seen" are over the whole frame. A report's headlines use the seen pixels, because black
/// surroundings, which every codec reproduces exactly, raise the others.
enum MetricIndex : std::size_t {
  psnrSeenColumn,
  psnrColumn,
  mseSeenColumn,
  mseColumn,
  ssimColumn,
  seenColumn,
  mseYColumn,
  mseCbColumn,
  mseCrColumn,
  psnrYColumn,
  psnrCbColumn,
  psnrCrColumn,
  psnrYuvColumn,
  mseYSeenColumn,
  mseCbSeenColumn,
  mseCrSeenColumn,
  psnrYSeenColumn,
  psnrCbSeenColumn,
  psnrCrSeenColumn,
  psnrYuvSeenColumn,
  ssimSeenColumn,
  bitsColumn,
  mseOfBitsColumn
};

/// Indices of the standard metrics' means, which come first in every MetricSet.
enum MeanIndex : std::size_t {
  meanPsnr,
  psnrOfMeanMse,
  meanSsim,
  meanPsnrY,
  meanPsnrYuv,
  meanPsnrSeen,
  psnrOfMeanMseSeen,
  meanSsimSeen,
  meanPsnrYSeen,
  meanPsnrYuvSeen
};

/// The standard metrics (MSE and PSNR of RGB, SSIM, the share of seen pixels, MSE and PSNR of
/// YCbCr, the bits compared), followed by others.
class MetricSet {
 public:
  explicit MetricSet(std::vector<Metric> others = {});

  [[nodiscard]] const std::vector<MetricColumn>& columns() const { return m_columns; }
  /// Returns the means; their `column` is an index of columns().
  [[nodiscard]] const std::vector<MetricMean>& means() const { return m_means; }

  /// Whether a mean is among the headlines: over the seen pixels, unless it is of a metric that has
  /// the whole frame alone.
  [[nodiscard]] bool isHeadline(std::size_t mean) const;

  /// Whether any of the metrics reads unrounded values.
  [[nodiscard]] bool readUnrounded() const;
  /// Returns the value of each column; NaN if there is nothing to compare. The values are
  /// bit-identical for any number of threads and on every machine with IEEE arithmetic. Throws
  /// std::invalid_argument if the sizes differ, and Cancelled.
  [[nodiscard]] std::vector<double> compare(const Image& reference, const Image& test,
                                            const ParallelRows& parallelRows = serialRows,
                                            const Progress& progress = {},
                                            const Viewing& viewing = {}) const;
  /// Returns the values of a view that cannot be compared: NaN, and no pixel seen.
  [[nodiscard]] std::vector<double> noValues() const;

 private:
  std::vector<Metric> m_metrics;
  std::vector<MetricColumn> m_columns;
  std::vector<MetricMean> m_means;
};

}  // namespace hogelscope
