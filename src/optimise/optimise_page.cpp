// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/optimise_page.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "io/images/image_writer.h"
#include "page/figure.h"
#include "page/html.h"
#include "page/map_plot.h"

namespace hogelscope {

namespace {

constexpr std::array<const char*, judgedContents> contentNames{"before", "prefiltered", "after"};

/// Returns the root of the mean error of texels in code values.
double rmsOf(double error, const OptimiseFigures& figures) {
  return figures.weight > 0 ? 255 * std::sqrt(error / figures.weight) : 0;
}

std::string whatIs(const std::string& reference) {
  if (reference == "ideal") return "the ideal view";
  if (reference == "views") return "the state's picture";
  return "the display without leakage";
}

/// Returns the references, each once.
std::vector<std::string> referencesOf(const Judgement& judgement) {
  std::vector<std::string> references;
  for (const JudgedView& view : judgement.views)
    if (std::ranges::find(references, view.reference) == references.end())
      references.push_back(view.reference);
  return references;
}

/// The means over the states, or over the held-out eyes, against one reference.
struct Means {
  bool isHeldOut = false;
  std::string reference;
  std::array<ViewScore, judgedContents> scores;
};

std::vector<Means> meansOf(const Judgement& judgement) {
  std::vector<Means> all;
  for (const bool isHeldOut : {false, true})
    for (const std::string& reference : referencesOf(judgement)) {
      Means means{isHeldOut, reference, {}};
      for (std::size_t k = 0; k < judgedContents; ++k)
        means.scores[k] = meanOf(judgement.views, reference, isHeldOut, JudgedContent(k));
      if (!std::isnan(means.scores[afterContent].psnr)) all.push_back(means);
    }
  return all;
}

std::string psnrText(double psnr) {
  if (std::isnan(psnr)) return "–";
  return std::isinf(psnr) ? "identical" : rounded(psnr, 2);
}

std::string ssimText(double ssim) {
  return std::isnan(ssim) ? "–" : rounded(ssim, 4);
}

std::string cells(const std::array<ViewScore, judgedContents>& scores) {
  std::string text;
  for (const ViewScore& score : scores)
    text += "<td class=\"n\">" + psnrText(score.psnr) + "</td><td class=\"n\">" +
            ssimText(score.ssim) + "</td>";
  return text;
}

std::string tableHead(const std::string& first) {
  std::string text = "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>" + first +
                     "</th><th>compared with</th>";
  for (const char* const name : contentNames)
    text += std::string("<th>") + name + ", PSNR dB</th><th>" + name + ", SSIM</th>";
  return text + "</tr></thead><tbody>\n";
}

std::string meansTable(const Judgement& judgement) {
  std::string text = tableHead("mean over");
  for (const auto& [isHeldOut, reference, scores] : meansOf(judgement))
    text += std::string("<tr><td>") + (isHeldOut ? "held-out eyes" : "states") + "</td><td>" +
            whatIs(reference) + "</td>" + cells(scores) + "</tr>\n";
  return text + "</tbody></table></div>\n";
}

std::string viewsTable(const Judgement& judgement) {
  std::string text = tableHead("view");
  for (const JudgedView& view : judgement.views)
    text += "<tr><td>" + escaped(view.state) + "</td><td>" + whatIs(view.reference) + "</td>" +
            cells(view.scores) + "</tr>\n";
  return text + "</tbody></table></div>\n";
}

std::string detailsOf(const Judgement& judgement) {
  std::string text = "<figure><div class=\"row views whole\">\n";
  for (const ViewDetail& detail : judgement.details)
    text += "<figure>" +
            imageTag(encodedPng(detail.width, detail.height, detail.rgb), detail.title) +
            "<figcaption>" + detail.title + "</figcaption></figure>\n";
  return text + "</div><figcaption>" + escaped(judgement.views.front().state) +
         ": the middle of the view</figcaption></figure>\n";
}

/// Returns a map of the share of values that are at 0 or at full scale.
Figure clippingMap(const std::vector<std::uint32_t>& counts, int columns, double each,
                   const std::string& of) {
  MapPlot plot;
  plot.titleAcross = of + ", from the left";
  plot.titleUp = "from the bottom";
  plot.unit = "share";
  plot.columns = columns;
  const int rows = int(counts.size()) / columns;
  plot.across = {0, double(columns)};
  plot.up = {0, double(rows)};
  for (int row = rows - 1; row >= 0; --row)
    for (int column = 0; column < columns; ++column)
      plot.values.push_back(counts[std::size_t(row) * std::size_t(columns) + std::size_t(column)] /
                            each);
  plot.shades[1] = std::max(0.01, *std::ranges::max_element(plot.values));
  Figure figure;
  figure.name = "clipping_" + of;
  figure.title = "Clipped values over " + of;
  figure.caption =
      "The share of values that are at 0 or at full scale: there the display has no "
      "contrast left to make up for its leakage.";
  figure.draw = [plot, of](double width) {
    const PlotBox box{.width = width, .height = width > columnUnits ? 400.0 : 280.0, .top = 26};
    return svgOf(plot, box, styleFor(width), "Share of clipped values over " + of);
  };
  return figure;
}

std::string mapsOf(const OptimiseFigures& figures, const LightFieldSize& size) {
  const double hogels = double(size.nx) * size.ny, directions = double(size.du) * size.dv;
  std::string text;
  for (const Figure& figure :
       {clippingMap(figures.clippedOfHogels, size.nx, 3 * directions, "hogels"),
        clippingMap(figures.clippedOfDirections, size.du, 3 * hogels, "directions")})
    text += "<h2>" + figure.title + "</h2>\n" + figureTag(figure);
  return text;
}

std::string percent(double share) {
  return rounded(100 * share, 1) + " %";
}

double valuesOf(const LightFieldSize& size) {
  return 3 * double(size.width()) * double(size.height());
}

double meanIterations(const OptimiseFigures& figures, const LightFieldSize& size) {
  return double(figures.iterations) / (3 * double(size.nx) * size.ny);
}

std::string solverText(const OptimiseFigures& figures, const LightFieldSize& size) {
  const double values = valuesOf(size);
  return "<p>What texels look like differs from what they should look like by " +
         rounded(rmsOf(figures.before, figures), 2) + " code values before and " +
         rounded(rmsOf(figures.after, figures), 2) +
         " after (root of the mean square); with no content would it be less than " +
         rounded(rmsOf(figures.bound, figures), 2) + ", which is proven: at most " +
         rounded(openDecibels(figures), 2) + " dB are left. Hogels took " +
         rounded(meanIterations(figures, size), 1) + " iterations in the mean and " +
         std::to_string(figures.mostIterations) + " at most. " +
         percent(double(figures.black) / values) + " of the values are 0, " +
         percent(double(figures.white) / values) + " are at full scale.</p>\n";
}

std::string targetText(const OptimisedContent& content, const Session& session) {
  const OptimiseParams& params = content.what().params;
  std::string text = "<p>Each hogel shows what comes closest to ";
  switch (params.target) {
    case OptimiseTarget::light:
      text += hasPrefilter(session)
                  ? "its own light, the mean of " + std::to_string(params.samples) +
                        " rays of each directional pixel"
                  : std::string("its own light");
      break;
    case OptimiseTarget::ideal:
      text += "the ideal views of the states";
      break;
    case OptimiseTarget::views:
      text += "the pictures of the states";
  }
  if (params.target != OptimiseTarget::light)
    text += " and, with a weight of " + numberText(params.keep) +
            " in that of a seen texel, to its own light";
  text += ". The display leaks ";
  const std::vector<StatesLeakage>& leakages = content.what().leakages;
  for (std::size_t k = 0; k < leakages.size(); ++k) {
    const PsfParams& psf = leakages[k].psf;
    text += (k > 0 ? " and " : "") +
            (psf.windowSize > 1 ? "with sigma " + numberText(psf.sigma) + " in a window of " +
                                      std::to_string(psf.windowSize)
                                : std::string("nothing")) +
            (leakages.size() > 1 ? " (" + std::to_string(leakages[k].states) + " states)" : "");
  }
  text += content.what().light == LightModel::linear ? ", in linear light" : "";
  const auto [black, white] = params.lift;
  if (black > 0 || white > 0)
    text += "; black is raised by " + percent(black) + " of white and white lowered by " +
            percent(white);
  return text + ".</p>\n";
}

}  // namespace

double openDecibels(const OptimiseFigures& figures) {
  constexpr double noticed = 0.1;  // of a code value: a smaller error is none
  const auto square = [&](double error) {
    return std::pow(rmsOf(error, figures), 2) + noticed * noticed;
  };
  return 10 * std::log10(square(figures.after) / square(figures.bound));
}

std::string csv(const Optimised& result, const OptimisedContent& content) {
  Table table{{"view", "held_out", "reference"}};
  for (const char* const name : contentNames)
    for (const char* const figure : {"_psnr", "_ssim"})
      table[0].push_back(std::string(name) + figure);
  for (const char* const name : {"iterations", "open_db", "black", "white"})
    table[0].emplace_back(name);
  const auto add = [&](const std::string& view, bool isHeldOut, const std::string& reference,
                       const std::array<ViewScore, judgedContents>& scores) {
    std::vector<std::string> row{view, isHeldOut ? "1" : "0", reference};
    for (const ViewScore& score : scores) {
      row.push_back(numberCell(score.psnr));
      row.push_back(numberCell(score.ssim));
    }
    row.resize(table[0].size());
    table.push_back(std::move(row));
  };
  for (const JudgedView& view : result.judgement.views)
    add(view.state, view.isHeldOut, view.reference, view.scores);
  const OptimiseFigures& figures = result.figures;
  const LightFieldSize size = content.size();
  for (const auto& [isHeldOut, reference, scores] : meansOf(result.judgement)) {
    add("mean", isHeldOut, reference, scores);
    std::vector<std::string>& row = table.back();
    std::size_t at = row.size() - 4;
    for (const double value :
         {meanIterations(figures, size), openDecibels(figures),
          double(figures.black) / valuesOf(size), double(figures.white) / valuesOf(size)})
      row[at++] = numberText(value);
  }
  return csvText(table);
}

std::string meansText(const Optimised& result) {
  const std::vector<Means> all = meansOf(result.judgement);
  if (all.empty()) return "no eye sees the display: nothing is compared\n";
  std::string text;
  for (const auto& [isHeldOut, reference, scores] : all) {
    text += std::string(isHeldOut ? "held-out eyes" : "states") + ", against " + whatIs(reference) +
            ":";
    for (std::size_t k = 0; k < judgedContents; ++k)
      if (!std::isnan(scores[k].psnr))
        text += (k > 0 ? ", " : " ") + psnrText(scores[k].psnr) +
                (std::isinf(scores[k].psnr) ? " " : " dB ") + contentNames[k];
    text += "\n";
  }
  return text;
}

std::string optimisePage(const OptimiseRequest& request, const Optimised& result,
                         const OptimisedContent& content) {
  const Judgement& judgement = result.judgement;
  std::string body = "<h1>Content for the display of " + escaped(request.name) + "</h1>\n" +
                     targetText(content, request.session);
  for (const std::string& warning : result.warnings)
    body += "<p class=\"warning\">Attention: " + escaped(warning) + ".</p>\n";
  body +=
      detailsOf(judgement) + meansTable(judgement) + solverText(result.figures, content.size()) +
      "<p>PSNR is that of the mean squared error, over the pixels that are seen. Held-out eyes "
      "are drawn around those of the states and were not optimised for. If the content is "
      "coded, it should be optimised after its decoder: it takes more bits than the light field "
      "did.</p>\n" +
      mapsOf(result.figures, content.size()) + "<h2>All views</h2>\n" + viewsTable(judgement);
  return pageOf("Hogelscope optimises: " + request.name, body);
}

}  // namespace hogelscope
