// SPDX-License-Identifier: BSD-3-Clause
// The figures of the pictures that are shown, worked out on a thread of its own.
#pragma once

#include <QImage>
#include <QObject>
#include <optional>
#include <vector>

#include "core/metrics/histogram.h"
#include "gui/widgets/task.h"

namespace hogelscope {

/// What is shown. Null images are not there; a null mask sees everything, a null region is none.
struct ShownPictures {
  QImage image;
  QImage seen;
  QImage other;
  QImage otherSeen;
  QRect region;
};

struct ComparisonFigures {
  QRect region;
  std::vector<double> whole;  ///< the report's metrics (MetricSet); empty without another picture
  std::vector<double> inRegion;       ///< likewise, and without a region
  std::vector<Histogram> histograms;  ///< of each picture, of the region where there is one
};

/// In one line, with the words of the report's table.
QString textOf(const ComparisonFigures& figures);

class ComparisonMeter : public QObject {
  Q_OBJECT

 public:
  explicit ComparisonMeter(QObject* parent);

  /// The newest wins, but what is under way is finished, so that figures keep coming while
  /// pictures do.
  void measure(const ShownPictures& pictures);
  /// There is nothing to measure.
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
