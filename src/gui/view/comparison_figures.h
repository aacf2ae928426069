// SPDX-License-Identifier: BSD-3-Clause
// Metrics of the images shown, computed on their own thread.
// They are MetricSet's, as a report's are; one pair of images at a time, then the newest.
#pragma once

#include <QImage>
#include <QObject>
#include <optional>
#include <vector>

#include "core/metrics/histogram.h"
#include "gui/widgets/task.h"

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

/// Formats the metrics in one line, with the names of the report's table.
QString textOf(const ComparisonFigures& figures);

class ComparisonMeter : public QObject {
  Q_OBJECT

 public:
  explicit ComparisonMeter(QObject* parent);

  /// Starts a measurement. The newest request wins, but a running one is finished, so that metrics
  /// keep updating while images change.
  void measure(const ShownPictures& pictures);
  /// Stops measuring and clears the metrics.
  void forget();

 Q_SIGNALS:
  void measured(const hogelscope::ComparisonFigures& figures);

 private:
  void start();
  void finish(const ComparisonFigures& figures);

  std::optional<ShownPictures> m_next;
  Task m_task;
};

}  // namespace hogelscope
