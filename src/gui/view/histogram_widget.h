// SPDX-License-Identifier: BSD-3-Clause
// Histograms of the images shown, drawn over each other.
#pragma once

#include <QWidget>
#include <vector>

#include "core/metrics/histogram.h"

namespace hogelscope {

class HistogramWidget : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramWidget(QWidget* parent = nullptr);

  /// Sets the histograms; the first is filled, the second is a line.
  void setHistograms(const std::vector<Histogram>& histograms);
  [[nodiscard]] const std::vector<Histogram>& histograms() const { return m_histograms; }
  [[nodiscard]] QSize sizeHint() const override { return {256, 72}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<Histogram> m_histograms;
};

}  // namespace hogelscope
