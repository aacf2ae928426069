// SPDX-License-Identifier: BSD-3-Clause
// The plots of a report.
#pragma once

#include <string>
#include <vector>

#include "core/metrics/panel_error_figures.h"
#include "core/metrics/summary.h"
#include "core/metrics/view_error.h"
#include "core/panel/display.h"
#include "page/figure.h"

namespace hogelscope {

/// The error of a test over the hogels and over the directions, each as a complete PNG file and as
/// CSV.
struct ReportPanel {
  std::string test;
  std::string hogels;
  std::string directions;
  PanelErrorFigures figures;
  /// The error of the light field's own views, and the difference of its ranks to the perceived
  /// one; empty unless both light fields are completely in memory.
  std::string views{};
  std::string ranks{};
  double viewScale = 0;  ///< MSE at the end of the colour scale of `views`
  ViewAgreement agreement{};
  std::string hogelCells{};      ///< "hogel_x,hogel_y,mse,pixels"
  std::string directionCells{};  ///< "direction_u,direction_v,mse,pixels"
  std::string viewCells{};       ///< "direction_u,direction_v,mse,rank_difference"
};

/// Returns a plot of each row's PSNR over the eye's horizontal angle, atan2(x, z) in the display
/// frame, or over the number of its state, from 1, or of a light field in time over its frame; one
/// series for each test. Rows are in ReportOrder; those with a problem have no point.
Plot psnrPlot(const std::vector<ReportRow>& rows, const DisplayParams& display, bool isOverAngle);

/// Returns the figures NAME_above and NAME_front, with the eyes in the display frame at equal
/// scale, coloured by PSNR (hollow for identical views, a cross without a comparison), and the PSNR
/// over the angle, NAME_angle, or, where all eyes have one, over the states, NAME_states. Figures
/// whose points would coincide are left out. `test` counts from 0; NAME is its plotNameOf().
std::vector<Figure> cameraFigures(const std::vector<ReportRow>& rows, std::size_t test,
                                  const DisplayParams& display);

/// Returns for each headline mean a figure frames_MEAN of its figure over the frames of a light
/// field in time: the mean over the states at each frame, one curve for each test; empty for a
/// still.
std::vector<Figure> frameFigures(const std::vector<ReportRow>& rows, const MetricSet& metrics);

/// Returns rate–distortion figures: each headline quality over bits per directional pixel, one
/// curve for each group, with the 95 % intervals of the means; weighted means where states have
/// weights. Empty without groups.
std::vector<Figure> rateFigures(const std::vector<TestSummary>& summaries, const MetricSet& metrics,
                                const std::vector<RateGroup>& groups);

/// Returns the figures NAME_hogels, NAME_directions, and NAME_views and NAME_ranks if the panel has
/// them.
std::vector<Figure> panelFigures(const ReportPanel& panel, std::size_t test,
                                 const PanelParams& display);

}  // namespace hogelscope
