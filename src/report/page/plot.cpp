// SPDX-License-Identifier: BSD-3-Clause
// What the report's plots are made of.
#include "report/page/plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/colour_map.h"
#include "core/base/text.h"
#include "report/page/html.h"

namespace hogelscope {

namespace {

/// Corners of the markers other than the circle, in radii.
constexpr std::array<std::array<double, 8>, 4> corners{{{-1, -1, 1, -1, 1, 1, -1, 1},
                                                        {0, -1.2, 1.2, 1, 0, 1, -1.2, 1},
                                                        {0, -1.4, 1.4, 0, 0, 1.4, -1.4, 0},
                                                        {0, 1.2, 1.2, -1, 0, -1, -1.2, -1}}};

}  // namespace

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
                      const std::string& titleUp, std::vector<Tick> ticksAcross) {
  const double left = std::min(across.from, across.to);
  const double right = std::max(across.from, across.to);
  const double top = std::min(up.from, up.to);
  const double bottom = std::max(up.from, up.to);
  std::string text;
  if (ticksAcross.empty()) ticksAcross = linearTicks(across, std::max(2, int((right - left) / 50)));
  for (const Tick& tick : ticksAcross) {
    const double x = across.at(tick.value);
    text += svgLine(x, top, x, bottom, "grid");
    if (!tick.text.empty()) text += svgText(x, bottom + 17, "middle", tick.text);
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

std::string seriesMark(std::size_t series, double x, double y, double radius,
                       const std::string& attributes, const std::string& content) {
  const std::size_t kind = series % (corners.size() + 1);
  const std::string more = (attributes.empty() ? "" : " " + attributes) + ">" + content;
  if (kind == 0)
    return "<circle cx=\"" + coordinate(x) + "\" cy=\"" + coordinate(y) + "\" r=\"" +
           coordinate(radius) + "\"" + more + "</circle>";
  std::string points;
  for (std::size_t k = 0; k < 8; k += 2)
    points += (k == 0 ? "" : " ") + coordinate(x + radius * corners[kind - 1][k]) + "," +
              coordinate(y + radius * corners[kind - 1][k + 1]);
  return "<polygon points=\"" + points + "\"" + more + "</polygon>";
}

std::string plotLegend(const std::vector<std::string>& names) {
  std::string text = "<ul class=\"legend\">";
  for (std::size_t k = 0; k < names.size(); ++k)
    text += std::string("<li><svg viewBox=\"-8 -8 16 16\" width=\"14\" height=\"14\" fill=\"") +
            seriesColour(k) + "\" aria-hidden=\"true\">" + seriesMark(k, 0, 0, 5, "", "") +
            "</svg> " + escaped(names[k]) + "</li>";
  return text + "</ul>\n";
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
