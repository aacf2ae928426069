// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/report_page.h"

#include <cmath>

#include "core/base/text.h"
#include "core/metrics/statistics.h"
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

/// Returns the figures of the views. Throws std::out_of_range if a view names no row.
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

std::string fact(const std::string& name, const std::string& value) {
  return "<tr><th scope=\"row\">" + escaped(name) + "</th><td>" + escaped(value) + "</td></tr>\n";
}

std::string displayWords(const PanelParams& d) {
  const auto pair = [](const auto& values) {
    return numberText(values[0]) + " × " + numberText(values[1]);
  };
  return pair(d.size) + " m, " + pair(d.hogels) + " hogels of " + pair(d.directions) +
         " directions, field of view " + pair(d.fov) + "°, " +
         (d.lens == HogelLensModel::plugin
              ? "lenses of the plugin " + d.lensSource
              : std::string(hogelLensNames()[std::size_t(d.lens)]) + " hogel lenses") +
         (d.viewingDistance > 0 ? ", converging at " + numberText(d.viewingDistance) + " m" : "");
}

std::string whatWasTested(const ReportPage& page) {
  std::string text = "<h2>What was tested</h2>\n<table class=\"facts\"><tbody>\n";
  for (const ReportFact& one : page.facts) text += fact(one.name, one.value);
  return text + fact("Display", displayWords(page.display)) + "</tbody></table>\n";
}

std::string overPosition(const ReportPage& page) {
  return "<h2>PSNR over camera position</h2>\n<p>In the display's frame, in metres: the panel's "
         "middle is at 0. Filled: coloured by PSNR; hollow: identical; cross: nothing to compare; "
         "one scale for all tests; PSNR of the pixels seen. "
         "The pointer over a point shows its name and figures.</p>\n" +
         cameraMaps(page.rows, page.display) + anglePlot(page.rows, page.display);
}

/// Returns the rank correlation of the views' own quality and the perceived one over the tests.
std::string orderOfTests(const ReportPage& page) {
  std::vector<double> own;
  std::vector<double> perceived;
  for (const ReportPanel& panel : page.panels)
    for (const TestSummary& test : page.summaries)
      if (!panel.views.empty() && test.test == panel.test) {
        own.push_back(panel.agreement.meanPsnr);
        perceived.push_back(test.summary.means[meanPsnrSeen]);
      }
  if (own.size() < 3) return {};
  return "<p>Over the " + std::to_string(own.size()) +
         " tests, the rank correlation (Spearman) of the mean PSNR of the light field's own views "
         "and the mean PSNR seen is " +
         rounded(rankCorrelation(own, perceived), 2) + ".</p>\n";
}

std::string errorOnPanel(const ReportPage& page) {
  return "<h2>Where the error comes from</h2>\n<p>Each pixel that both pictures see counts for the "
         "hogel and for the direction that the ray through its centre meets. Colours show the mean "
         "squared error (MSE) of all such pixels of all states, from 0 to the 99th percentile of "
         "the cells; grey: no pixel met it. Costliest is what holds most of the squared error; "
         "hogel (0, 0) is the top left one. The second row of pictures has the error of the light "
         "field's own views (sub-aperture images), by which codecs are usually judged; yellow in "
         "the "
         "last one: perceived worse than its own error tells. View (0, 0) is the top left "
         "one.</p>\n" +
         orderOfTests(page) + panelFigures(page.panels, page.display);
}

constexpr const char* definitions =
    R"html(<h2>How to read the figures</h2>
<dl>
<dt>MSE, PSNR</dt><dd>Mean of the squared differences of RGB, in code values from 0 to 255, with the
fractions of light fields of more than 8 bits; PSNR = 10 log10(255²/MSE) in dB, which is that of the
peak of any other number of bits.</dd>
<dt>Seen, frame</dt><dd>“Seen” is over the pixels that both pictures see, and so is all that is not called
“frame”, which is over the whole picture: black surroundings, which no light field gets wrong, raise its
PSNR. “Seen %” is the share of the pixels seen.</dd>
<dt>Identical</dt><dd>MSE is 0, so that PSNR is infinite. Identical views are counted, and are in no mean
of PSNRs.</dd>
<dt>Mean PSNR, PSNR of mean MSE</dt><dd>The first is the mean of the finite PSNRs; the second is the PSNR
of the mean MSE, identical views included. They differ, and bad views weigh more in the second.</dd>
<dt>PSNR-Y, PSNR-YUV</dt><dd>PSNR of the luma of BT.709 in full range; and
(6 PSNR-Y + PSNR-Cb + PSNR-Cr)/8.</dd>
<dt>SSIM</dt><dd>Structural similarity as Wang et al. 2004 have it, on luma, with an 11×11 Gaussian window
of σ 1.5; 1 is identical. “Seen” is the mean over the windows that hold only pixels seen.</dd>
<dt>Intervals</dt><dd>95 % percentile bootstrap over the states, 10 000 resamples (fewer of more than 2000
states, at least 1000): how a mean would vary with other camera positions of the same kind, not with other scenes.</dd>
<dt>Weighted</dt><dd>The same mean with each view counted by its state's weight.</dd>
</dl>
)html";

}  // namespace

std::string html(const ReportPage& page) {
  std::string text = "<h1>Perceived views of " + escaped(page.session) + "</h1>\n" +
                     summaryTables(page.summaries, page.metrics);
  if (!page.groups.empty())
    text +=
        "<h2>Quality over rate</h2>\n<p>Means over the states with 95 % bootstrap intervals; over "
        "the pixels seen, but for metrics of plugins. The pointer over a point shows its "
        "figures.</p>\n" +
        ratePlots(page.summaries, page.metrics, page.groups);
  if (!page.comparisons.empty())
    text += "<h2>Bjøntegaard deltas</h2>\n" + bdTable(page.comparisons);
  if (!page.rows.empty()) text += overPosition(page);
  if (!page.views.empty())
    text += "<h2>Worst, median and best views</h2>\n" + viewFigures(page.views, page.rows);
  if (!page.panels.empty()) text += errorOnPanel(page);
  if (!page.rows.empty()) text += "<h2>All states</h2>\n" + statesTable(page.rows, page.metrics);
  if (!page.lenses.empty())
    text += "<h2>How far the lenses can be trusted</h2>\n" + lensesTable(page.lenses);
  return pageOf("Hogelscope report: " + page.session, text + definitions + whatWasTested(page));
}

}  // namespace hogelscope
