// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/report_page.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/text.h"
#include "core/metrics/statistics.h"
#include "page/html.h"
#include "report/page/report_plots.h"
#include "report/page/test_names.h"
#include "report/page/unit_plots.h"

namespace hogelscope {

namespace {

/// Returns a picture that leads to its file.
std::string captioned(const std::string& png, const std::string& file, const std::string& caption) {
  return "<figure><a href=\"" + escaped(file) + "\">" + imageTag(png, caption) +
         "</a><figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string viewFigure(const ReportView& view, const ReportRow& row) {
  const double db = row.values[psnrSeenColumn];
  std::string caption = view.which + " view: " + viewName(row) + ": PSNR " + rounded(db, 2) +
                        (db < 1e6 ? " dB" : "") + ", SSIM " +
                        rounded(row.values[ssimSeenColumn], 4);
  if (caption[0] >= 'a' && caption[0] <= 'z') caption[0] = char(caption[0] - 'a' + 'A');
  if (view.scale > 1)
    caption += ", 1/" + std::to_string(view.scale) + " of the size of the files in views";
  const std::string classes = view.scale > 1 ? "row views" : "row views whole";
  const std::string difference =
      view.gain == 1 ? "absolute difference"
                     : "absolute difference, " + std::to_string(view.gain) + " times as bright";
  return "<figure><h3>" + escaped(caption) + "</h3><div class=\"" + classes + "\">\n" +
         captioned(view.reference, view.files + "_reference.png", "reference") +
         captioned(view.test, view.files + "_test.png", "test") +
         captioned(view.difference, view.files + "_difference.png", difference) +
         "</div></figure>\n";
}

/// The tests of a page, of which its script shows one at a time: `ofTest` returns the part of a
/// test, by its number, or "".
template <class Part>
std::string oneAtATime(const ReportPage& page, Part ofTest) {
  const std::vector<std::string> tests = testsOf(page.rows);
  const std::vector<std::string> names = figureNames(tests);
  std::string parts;
  for (std::size_t test = 0; test < tests.size(); ++test) {
    const std::string part = ofTest(test);
    if (!part.empty())
      parts += "<section data-test=\"" + escaped(names[test]) + "\"><h3>" + escaped(names[test]) +
               "</h3>\n" + part + "</section>\n";
  }
  return parts.empty() ? "" : "<div class=\"tests\">" + parts + "</div>\n";
}

std::string sideBySide(const std::vector<Figure>& figures) {
  if (figures.empty()) return {};
  std::string text = "<div class=\"plots\">\n";
  for (const Figure& figure : figures) text += figureTag(figure);
  return text + "</div>\n";
}

/// Returns the pictures of the views. Throws std::out_of_range if a view names no row.
std::string viewFigures(const ReportPage& page) {
  for (const ReportView& view : page.views) (void)page.rows.at(view.row);
  const std::vector<std::string> tests = testsOf(page.rows);
  return oneAtATime(page, [&](std::size_t test) {
    std::string text;
    for (const ReportView& view : page.views)
      if (page.rows[view.row].test == tests[test]) text += viewFigure(view, page.rows[view.row]);
    return text;
  });
}

std::vector<Figure> unitsOf(const ReportPage& page) {
  return page.isAgainstDesign ? unitFigures(page.summaries, page.metrics) : std::vector<Figure>();
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

std::string overUnits(const ReportPage& page) {
  const std::vector<Figure> figures = unitsOf(page);
  if (figures.empty()) return {};
  std::string text = "<h2>Over the units</h2>\n";
  for (const std::string& sentence : unitSentences(page.summaries, page.metrics))
    text += "<p>" + escaped(sentence) + "</p>\n";
  return text +
         "<p>In the distribution each point is a unit's mean over the states, with its 95 % "
         "bootstrap interval; to its left are the units with lower means. The yield is the share "
         "of "
         "units within a limit, with Wilson's 95 % interval for units that were drawn alike. The "
         "pointer over a point shows the unit.</p>\n" +
         sideBySide(figures);
}

std::string headingOf(const ReportPage& page) {
  return page.isAgainstDesign ? "Units as built against the design of " + page.session
                              : "Perceived views of " + page.session;
}

std::string overPosition(const ReportPage& page) {
  const std::string figures = oneAtATime(page, [&](std::size_t test) {
    return sideBySide(cameraFigures(page.rows, test, page.display));
  });
  if (figures.empty()) return {};
  return "<h2>PSNR over camera position</h2>\n<p>In the display's frame, in metres: the panel's "
         "middle is at 0. Filled: coloured by PSNR; hollow: identical; cross: nothing to compare; "
         "one scale for all tests; PSNR of the pixels seen. "
         "The pointer over a point shows its name and figures.</p>\n" +
         figures;
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

std::string panelPart(const ReportPanel& panel, std::size_t test, const PanelParams& display) {
  std::string text = "<p>" + escaped(panelErrorText(panel.figures)) + "</p>\n";
  if (!panel.views.empty()) text += "<p>" + escaped(agreementText(panel.agreement)) + "</p>\n";
  return text + sideBySide(panelFigures(panel, test, display));
}

std::string errorOnPanel(const ReportPage& page) {
  return "<h2>Where the error comes from</h2>\n<p>Each pixel that both pictures see counts for the "
         "hogel and for the direction that the ray through its centre meets. Colours show the mean "
         "squared error (MSE) of all such pixels of all states, from 0 to the 99th percentile of "
         "the cells; grey: no pixel met it. Costliest is what holds most of the squared error; "
         "hogel (0, 0) is the top left one. The error of the light field's own views (sub-aperture "
         "images) is that by which codecs are usually judged; yellow in its ranks: perceived worse "
         "than its own error tells. View (0, 0) is the top left one.</p>\n" +
         orderOfTests(page) + oneAtATime(page, [&](std::size_t test) {
           return test < page.panels.size() ? panelPart(page.panels[test], test, page.display)
                                            : std::string();
         });
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

std::vector<Figure> figuresOf(const ReportPage& page) {
  std::vector<Figure> figures = rateFigures(page.summaries, page.metrics, page.groups);
  const auto add = [&](std::vector<Figure> more) {
    std::ranges::move(more, std::back_inserter(figures));
  };
  add(frameFigures(page.rows, page.metrics));
  add(unitsOf(page));
  const std::size_t tests = testsOf(page.rows).size();
  for (std::size_t test = 0; test < tests; ++test)
    add(cameraFigures(page.rows, test, page.display));
  for (std::size_t test = 0; test < page.panels.size(); ++test)
    add(panelFigures(page.panels[test], test, page.display));
  return figures;
}

std::string html(const ReportPage& page) {
  std::vector<Figure> rates = rateFigures(page.summaries, page.metrics, page.groups);
  const auto main =
      std::ranges::find(rates, "rate_" + page.metrics.means()[meanPsnrSeen].name, &Figure::name);
  if (main != rates.end()) std::rotate(rates.begin(), main, main + 1);
  std::string text = "<h1>" + escaped(headingOf(page)) + "</h1>\n";
  for (const std::string& warning : page.warnings)
    text += "<p class=\"warning\">" + escaped(warning) + "</p>\n";
  if (page.hasPage)
    text +=
        "<p><a href=\"page.html\">Look around</a> in all of the light fields, from any "
        "place.</p>\n";
  text += overUnits(page);
  if (!page.summaries.empty()) {
    text += "<h2>Results</h2>\n";
    if (!rates.empty()) text += figureTag(rates.front());
    text += meansTable(page.summaries, page.metrics);
    for (const std::string& note : page.notes) text += "<p>" + escaped(note) + ".</p>\n";
  }
  if (const std::vector<Figure> frames = frameFigures(page.rows, page.metrics); !frames.empty())
    text +=
        "<h2>Over time</h2>\n<p>Means over the states at each frame; flicker is the error of "
        "the change since the frame before. The pointer over a point shows its figures.</p>\n" +
        sideBySide(frames);
  if (rates.size() > 1)
    text +=
        "<h2>Quality over rate</h2>\n<p>Means over the states with 95 % bootstrap intervals. The "
        "pointer over a point shows its figures.</p>\n" +
        sideBySide({rates.begin() + 1, rates.end()});
  if (!page.comparisons.empty())
    text += "<h2>Bjøntegaard deltas</h2>\n" + bdTable(page.comparisons, page.metrics);
  text += overPosition(page);
  if (!page.views.empty()) text += "<h2>Worst, median and best views</h2>\n" + viewFigures(page);
  if (!page.panels.empty()) text += errorOnPanel(page);
  if (!page.summaries.empty())
    text += "<h2>Means over the whole frame</h2>\n<p>Black surroundings included.</p>\n" +
            frameTable(page.summaries, page.metrics);
  if (!page.rows.empty()) text += "<h2>All states</h2>\n" + statesTable(page.rows, page.metrics);
  if (!page.lenses.empty())
    text += "<h2>How far the lenses can be trusted</h2>\n" + lensesTable(page.lenses);
  return pageOf("Hogelscope report: " + page.session, text + definitions + whatWasTested(page));
}

}  // namespace hogelscope
