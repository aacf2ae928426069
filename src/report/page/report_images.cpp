// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/report_images.h"

#include <cmath>

#include "core/base/text.h"
#include "page/html.h"
#include "report/page/report_plots.h"

namespace hogelscope {

namespace {

std::string captioned(const std::string& png, const std::string& caption) {
  return "<figure>" + imageTag(png, caption) + "<figcaption>" + escaped(caption) +
         "</figcaption></figure>\n";
}

std::string viewFigure(const ReportView& view, const ReportRow& row) {
  const double db = row.values[psnrSeenColumn];
  std::string caption = view.which + " view: " + row.state + ", " + row.test + ": PSNR " +
                        rounded(db, 2) + (db < 1e6 ? " dB" : "") + ", SSIM " +
                        rounded(row.values[ssimSeenColumn], 4);
  if (caption[0] >= 'a' && caption[0] <= 'z') caption[0] = char(caption[0] - 'a' + 'A');
  if (view.scale > 1)
    caption += ", 1/" + std::to_string(view.scale) + " of the size of the files in views";
  const std::string difference =
      view.gain == 1 ? "absolute difference"
                     : "absolute difference, " + std::to_string(view.gain) + " times as bright";
  return "<figure><h3>" + escaped(caption) + "</h3><div class=\"row views\">\n" +
         captioned(view.reference, "reference") + captioned(view.test, "test") +
         captioned(view.difference, difference) + "</div></figure>\n";
}

/// The texts at the ends of an image's sides.
struct Ends {
  std::string top;
  std::string bottom;
  std::string left;
  std::string right;
};

/// The ends of the colour scale and its unit; no scale if both are 0.
struct Scale {
  double low = 0;
  double high = 0;
  std::string unit = "MSE";
};

std::string errorFigure(const std::string& png, const std::string& title, const Ends& ends,
                        const Scale& scale) {
  std::string text = "<figure><figcaption>" + title + "</figcaption>" +
                     "<div class=\"row\"><div class=\"cells\"><div class=\"side\"><span>" +
                     ends.top + "</span><span>" + ends.bottom + "</span></div>" +
                     imageTag(png, title) + "<div class=\"foot\"><span>" + ends.left +
                     "</span><span>" + ends.right + "</span></div></div>";
  if (scale.high > scale.low) text += colourBar(scale.low, scale.high, scale.unit);
  return text + "</div></figure>\n";
}

Ends angles(const std::array<double, 2>& fov) {
  const auto half = [](double whole) { return numberText(std::round(50 * whole) / 100); };
  const std::string across = half(fov[0]);
  const std::string up = half(fov[1]);
  return {up + "° up", up + "° down", across + "° left", across + "° right"};
}

std::string viewErrorFigures(const ReportPanel& panel, const DisplayParams& display) {
  return "<p>" + escaped(agreementText(panel.agreement)) + "</p><div class=\"row\">\n" +
         errorFigure(panel.views, "of the light field's own views, one for each direction",
                     angles(display.fov), {0, panel.viewScale}) +
         errorFigure(panel.ranks, "rank of the perceived error less rank of the view's own",
                     angles(display.fov), {-1, 1, "share of ranks"}) +
         "</div>\n";
}

}  // namespace

std::string viewFigures(const std::vector<ReportView>& views, const std::vector<ReportRow>& rows) {
  std::string text;
  for (const ReportView& view : views) text += viewFigure(view, rows.at(view.row));
  return text;
}

std::string panelFigures(const std::vector<ReportPanel>& panels, const DisplayParams& display) {
  std::string all;
  for (const ReportPanel& panel : panels) {
    all += "<figure><h3>" + escaped(panel.test) + "</h3>\n<p>" +
           escaped(panelErrorText(panel.figures)) + "</p><div class=\"row\">\n" +
           errorFigure(panel.hogels, "over the hogels, as the panel faces the viewer",
                       {"top", "bottom", "left", "right"}, {0, panel.figures.hogelScale}) +
           errorFigure(panel.directions, "over the directions in which light leaves",
                       angles(display.fov), {0, panel.figures.directionScale}) +
           "</div>\n";
    if (!panel.views.empty()) all += viewErrorFigures(panel, display);
    all += "</figure>\n";
  }
  return all;
}

}  // namespace hogelscope
