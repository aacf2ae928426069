// SPDX-License-Identifier: BSD-3-Clause
// The histograms of the pictures that are shown, one over the other.
#pragma once

#include <QWidget>
#include <vector>

#include "core/metrics/histogram.h"

namespace hogelscope {

class HistogramWidget : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramWidget(QWidget* parent = nullptr);

  /// The first filled, the second as a line.
  void setHistograms(const std::vector<Histogram>& histograms);
  [[nodiscard]] const std::vector<Histogram>& histograms() const { return m_histograms; }
  [[nodiscard]] QSize sizeHint() const override { return {256, 72}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<Histogram> m_histograms;
};

}  // namespace hogelscope
