// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/view_points.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace hogelscope {

std::vector<ViewPoint> pointsOf(const std::vector<ReportRow>& rows, const std::string& test,
                                const DisplayParams& display) {
  const RigidTransform displayFromWorld =
      transformFromPose(display.position, display.orientation).inverse();
  std::vector<ViewPoint> points;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const ReportRow& row = rows[k];
    if (row.test != test) continue;
    ViewPoint point{k, displayFromWorld.point(row.eye),
                    row.problem.empty() ? row.values[psnrSeenColumn] : NAN};
    if (std::isnan(point.psnr))
      point.kind = PlotKind::none;
    else if (std::isinf(point.psnr))
      point.kind = PlotKind::identical;
    points.push_back(point);
  }
  std::stable_sort(points.begin(), points.end(), [](const ViewPoint& a, const ViewPoint& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    return a.kind == PlotKind::compared && a.psnr > b.psnr;
  });
  return points;
}

std::string titleOf(const ViewPoint& point, const ReportRow& row) {
  std::string text = row.state + ": ";
  if (point.kind == PlotKind::none) {
    text += row.problem.empty() ? "nothing to compare" : row.problem;
  } else {
    text += point.kind == PlotKind::identical ? "identical" : rounded(point.psnr, 2) + " dB";
    const double ssim = row.values[ssimSeenColumn];
    if (!std::isnan(ssim)) text += ", SSIM " + rounded(ssim, 4);
  }
  return text + "; eye " + rounded(point.eye.x, 3) + ", " + rounded(point.eye.y, 3) + ", " +
         rounded(point.eye.z, 3) + " m";
}

double radiusFor(std::size_t points) {
  if (points <= 40) return 6;
  return points <= 300 ? 4 : 2.5;
}

}  // namespace hogelscope
