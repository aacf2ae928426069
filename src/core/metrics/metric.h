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

/// One figure of a comparison.
struct MetricColumn {
  /// The tables that show it, each with those of the ones before.
  enum class Where { files, page, window };

  std::string name;        ///< in CSV files: "psnr_seen"
  std::string title{};     ///< in tables: "PSNR seen"
  std::string unit{};      ///< in tables: "dB"
  std::string help{};      ///< a tooltip
  int decimals = 2;        ///< in tables
  double tableFactor = 1;  ///< what tables multiply values by: 100 for percent
  Where where = Where::files;
};

/// Returns a value as tables show it; "identical" if infinite, a dash if NaN.
std::string tableText(const MetricColumn& column, double value);

/// A mean over views. Values that are not finite do not count in it.
struct MetricMean {
  std::string name;        ///< in CSV files: "psnr_of_mean_mse"
  std::string title;       ///< in tables
  std::size_t column = 0;  ///< of the metric's columns
  int decimals = 2;
  double (*ofMean)(double mean) = nullptr;  ///< what is shown of the mean; null: the mean itself
  bool isQuality = false;                   ///< whether BD-rates use it
  std::string unit{};                       ///< "dB"
  bool isSeen = false;  ///< over the pixels seen in both, not over the whole frame
};

/// The value of each column, of images of one size.
using CompareImages = std::function<std::vector<double>(
    const Image& reference, const Image& test, const ParallelRows& parallelRows,
    const Progress& progress, const Viewing& viewing)>;

struct Metric {
  std::vector<MetricColumn> columns;
  std::vector<MetricMean> means;
  CompareImages compare;
  bool readsUnrounded = false;  ///< of the images; takes their rounded ones where they are missing
};

/// The columns of the standard metrics, which begin every MetricSet. Without "seen" they are over
/// the whole frame. The headlines of a report are over what is seen: black surroundings, which
/// every codec gets right, raise the others.
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

/// The means of the standard metrics, which begin every MetricSet.
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
/// YCbCr, the bits compared), then others.
class MetricSet {
 public:
  explicit MetricSet(std::vector<Metric> others = {});

  [[nodiscard]] const std::vector<MetricColumn>& columns() const { return m_columns; }
  /// Their `column` is an index of columns().
  [[nodiscard]] const std::vector<MetricMean>& means() const { return m_means; }

  /// Whether one of them reads unrounded values.
  [[nodiscard]] bool readUnrounded() const;
  /// Returns the value of each column; NaN where there is nothing to compare. They are the same to
  /// the last bit for any number of threads, and on every machine with IEEE arithmetic. Throws
  /// std::invalid_argument where the sizes differ, Cancelled.
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
