// SPDX-License-Identifier: BSD-3-Clause
// What the report's plots are made of.
#include "report/page/plot.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "report/page/html.h"

namespace hogelscope {

std::string coordinate(double value) {
  return rounded(value, 2);
}

std::string svgText(double x, double y, std::string_view anchor, const std::string& text) {
  return "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" text-anchor=\"" +
         std::string(anchor) + "\">" + escaped(text) + "</text>";
}

std::string svgLine(double x1, double y1, double x2, double y2, std::string_view style) {
  return "<line x1=\"" + coordinate(x1) + "\" y1=\"" + coordinate(y1) + "\" x2=\"" +
         coordinate(x2) + "\" y2=\"" + coordinate(y2) + "\" class=\"" + std::string(style) + "\"/>";
}

std::string plotFrame(const Axis& across, const Axis& up, const std::string& titleAcross,
                      const std::string& titleUp) {
  const double left = std::min(across.from, across.to);
  const double right = std::max(across.from, across.to);
  const double top = std::min(up.from, up.to);
  const double bottom = std::max(up.from, up.to);
  std::string text;
  for (const Tick& tick : linearTicks(across, std::max(2, int((right - left) / 50)))) {
    const double x = across.at(tick.value);
    text += svgLine(x, top, x, bottom, "grid") + svgText(x, bottom + 17, "middle", tick.text);
  }
  for (const Tick& tick : linearTicks(up, std::max(2, int((bottom - top) / 30)))) {
    const double y = up.at(tick.value);
    text += svgLine(left, y, right, y, "grid") + svgText(left - 6, y + 4, "end", tick.text);
  }
  text += "<rect x=\"" + coordinate(left) + "\" y=\"" + coordinate(top) + "\" width=\"" +
          coordinate(right - left) + "\" height=\"" + coordinate(bottom - top) +
          "\" class=\"frame\"/>";
  text += svgText((left + right) / 2, bottom + 36, "middle", titleAcross);
  return text + "<g transform=\"translate(13 " + coordinate((top + bottom) / 2) +
         ") rotate(-90)\">" + svgText(0, 0, "middle", titleUp) + "</g>\n";
}

std::vector<PlotPoint> pointsOf(const std::vector<ReportRow>& rows, const std::string& test,
                                const DisplayParams& display) {
  const RigidTransform displayFromWorld = Display(display).displayFromWorld();
  std::vector<PlotPoint> points;
  for (const ReportRow& row : rows) {
    if (row.test != test) continue;
    PlotPoint point{&row, displayFromWorld.point(row.eye), row.values[psnrSeenColumn]};
    if (!row.problem.empty() || std::isnan(point.psnr))
      point.kind = PlotKind::none;
    else if (std::isinf(point.psnr))
      point.kind = PlotKind::identical;
    points.push_back(point);
  }
  std::stable_sort(points.begin(), points.end(), [](const PlotPoint& a, const PlotPoint& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    return a.kind == PlotKind::compared && a.psnr > b.psnr;
  });
  return points;
}

std::string titleOf(const PlotPoint& point) {
  const ReportRow& row = *point.row;
  std::string text = row.state + ": ";
  if (point.kind == PlotKind::none) {
    text += row.problem.empty() ? "nothing to compare" : row.problem;
  } else {
    text += point.kind == PlotKind::identical ? "identical" : rounded(point.psnr, 2) + " dB";
    const double ssim = row.values[ssimSeenColumn];
    if (!std::isnan(ssim)) text += ", SSIM " + rounded(ssim, 4);
  }
  return "<title>" + escaped(text) + "; eye " + rounded(point.eye.x, 3) + ", " +
         rounded(point.eye.y, 3) + ", " + rounded(point.eye.z, 3) + " m</title>";
}

double radiusFor(std::size_t points) {
  if (points <= 40) return 6;
  return points <= 300 ? 4 : 2.5;
}

}  // namespace hogelscope
