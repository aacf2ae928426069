// SPDX-License-Identifier: BSD-3-Clause
#include "measure/measure_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/text.h"
#include "core/panel/depth_budget.h"
#include "core/panel/design_numbers.h"
#include "page/html.h"
#include "page/latex_table.h"
#include "page/map_plot.h"

namespace hogelscope {

namespace {

using Figures = std::vector<const MeasuredFigure*>;

/// Returns the figures of this name with a place in a plot: `begin` starts their `where`.
Figures chosen(const std::vector<MeasuredFigure>& figures, std::string_view name,
               std::string_view begin) {
  Figures result;
  for (const MeasuredFigure& one : figures)
    if (one.of.figure == name && one.of.where.starts_with(begin)) result.push_back(&one);
  std::ranges::stable_sort(result, {}, [](const MeasuredFigure* one) { return one->of.across; });
  return result;
}

std::string pointsOf(const Figures& figures, const std::string& across, const std::string& up) {
  Table table{{across, up, "value", "closed_form"}};
  for (const MeasuredFigure* one : figures)
    table.push_back({numberText(one->of.across), numberText(one->of.up), numberCell(one->value),
                     numberCell(one->of.closedForm)});
  if (up.empty())
    for (std::vector<std::string>& row : table) row.erase(row.begin() + 1);
  return csvText(table);
}

/// A plot of values over one axis, simulated and in closed form.
struct CurveTitles {
  std::string name;
  std::string title;
  std::string caption;
  std::string across;  ///< title of the axis
  std::string up;
  std::string column;  ///< of the CSV
};

void addCurve(const Figures& figures, const CurveTitles& titles, std::vector<Figure>& plots) {
  if (figures.size() < 2) return;
  Plot plot;
  plot.titleAcross = titles.across;
  plot.titleUp = titles.up;
  plot.hasCurves = true;
  plot.leastRange = {0, 0.01};
  plot.series = {{"simulated", {}, 3}, {"closed form", {}, 1.5}};
  for (const MeasuredFigure* one : figures) {
    const auto add = [&](std::size_t series, double value) {
      if (!std::isfinite(value)) return;
      plot.series[series].points.push_back({one->of.across,
                                            value,
                                            one->of.where + ": " + numberText(fourDigits(value)),
                                            0,
                                            {value, value}});
    };
    add(0, one->value);
    add(1, one->of.closedForm);
  }
  if (plot.series[1].points.empty()) plot.series.pop_back();
  if (plot.series[0].points.empty()) return;
  plots.push_back(figureOf(plot, titles.name, titles.title, pointsOf(figures, titles.column, "")));
  plots.back().caption = titles.caption;
}

/// Returns a map of the figures, whose places form a grid; its axes end half a cell beyond them.
MapPlot mapOf(Figures figures) {
  MapPlot plot;
  std::ranges::stable_sort(
      figures, {}, [](const MeasuredFigure* one) { return std::pair(one->of.up, one->of.across); });
  std::vector<double> across, up;
  for (const MeasuredFigure* one : figures) {
    if (one->of.up == figures.front()->of.up) across.push_back(one->of.across);
    if (up.empty() || up.back() != one->of.up) up.push_back(one->of.up);
    plot.values.push_back(one->value);
  }
  plot.columns = int(across.size());
  const auto ends = [](const std::vector<double>& places) {
    const double half = (places.back() - places.front()) / (2 * double(places.size() - 1));
    return std::array{places.front() - half, places.back() + half};
  };
  if (across.size() < 2 || up.size() < 2 || across.size() * up.size() != figures.size()) return {};
  plot.across = ends(across);
  plot.up = ends(up);
  return plot;
}

/// Returns ticks at round depths on an axis of dioptres.
std::vector<Tick> depthTicks(const std::array<double, 2>& dioptres, double distance) {
  std::vector<Tick> ticks;
  const double range = dioptres[1] - dioptres[0];
  const auto add = [&](double z) {
    if (z >= 0.999 * distance) return;
    const double at = dioptresAt(z, distance);
    if (at < dioptres[0] || at > dioptres[1] || std::ranges::any_of(ticks, [&](const Tick& tick) {
          return std::abs(tick.value - at) < range / 12;
        }))
      return;
    ticks.push_back(
        {at, z == 0 ? "0" : (z < 0 ? "−" : "+") + numberText(fourDigits(std::abs(100 * z)))});
  };
  add(0);
  for (const double decade : {0.1, 1.0, 0.01, 10.0, 0.001})
    for (const double digit : {1.0, 2.0, 5.0, 3.0, 1.5})
      for (const double sign : {-1.0, 1.0}) add(sign * digit * decade);
  return ticks;
}

}  // namespace

MapPlot mtfMap(const Bench& bench, const std::vector<MeasuredFigure>& figures) {
  MapPlot plot = mapOf(chosen(figures, "mtf", ""));
  if (plot.columns == 0) return plot;
  const double distance = bench.distance();
  const std::size_t axis = mainAxis(bench);
  plot.titleAcross = "depth in cm, + in front; even in dioptres";
  plot.titleUp = "cycles per degree";
  plot.unit = "contrast";
  plot.contours = {0.5, 0.1};
  plot.ticks = depthTicks(plot.across, distance);
  // The eye's limits have their names above, those without an eye below.
  const auto upright = [&](double dioptres, const std::string& name, bool isAbove) {
    if (dioptres > plot.across[0] && dioptres < plot.across[1])
      plot.lines.push_back(
          {{dioptres, plot.up[isAbove ? 0 : 1]}, {dioptres, plot.up[isAbove ? 1 : 0]}, name});
  };
  if (bench.display().directions[axis] > 1) {
    const double depth = bench.pitch(axis) / bench.step(axis);
    upright(-depth / (distance * distance), "sharp from here", true);
    upright(depth / (distance * distance), "to here", true);
    const char* const equal =
        bench.sheet() != nullptr ? "one view = one lens" : "one direction = one hogel";
    if (depth < distance) upright(dioptresAt(depth, distance), equal, false);
    upright(dioptresAt(-depth, distance), "", false);
  }
  const double limit = distance * std::acos(-1) / 180 / (2 * bench.pitch(axis));
  const std::string whose = bench.sheet() != nullptr ? "lenses'" : "hogels'";
  plot.lines.push_back({{plot.across[1], limit}, {plot.across[0], limit}, whose + " limit 1/(2p)"});
  return plot;
}

MapPlot zoneMap(const Bench& bench, const std::vector<MeasuredFigure>& figures) {
  MapPlot plot = mapOf(chosen(figures, "viewingZone", "share"));
  if (plot.columns == 0) return plot;
  plot.titleAcross = "x in m";
  plot.titleUp = "distance from the panel in m";
  plot.unit = "share";
  plot.contours = {0.95};
  const double half = bench.display().size[0] / 2;
  plot.up[0] = 0;
  plot.lines.push_back({{-half, 0}, {half, 0}, ""});
  const Vec3& eye = bench.eye();
  plot.lines.push_back({{eye.x, eye.z}, {eye.x, eye.z}, "eye"});
  return plot;
}

namespace {

/// Adds a map, which is flatter on a page unless it is square.
void addMap(const MapPlot& plot, Figure figure, const std::string& label, bool isSquare,
            std::vector<Figure>& plots) {
  if (plot.columns == 0) return;
  figure.draw = [plot, label, isSquare](double width) {
    const bool isForPage = width > columnUnits;
    PlotBox box{.width = width, .height = isForPage ? 400.0 : 280.0, .top = 26};
    if (isSquare) {  // the scale of colours is beside it
      constexpr double beside = 64;
      const double side = isForPage ? 330 : width - box.left - box.right - beside;
      box.right = width - box.left - side - beside;
      box.height = box.top + side + box.below;
    }
    return svgOf(plot, box, styleFor(width), label);
  };
  plots.push_back(std::move(figure));
}

void addMtf(const Bench& bench, const std::vector<MeasuredFigure>& figures,
            std::vector<Figure>& plots) {
  addMap(mtfMap(bench, figures),
         {"mtf",
          "Contrast over depth and detail",
          "Gratings on planes, as the eye sees them; lines of contrast 0.5 and 0.1.",
          {},
          pointsOf(chosen(figures, "mtf", ""), "dioptres", "cycles_per_degree"),
          true},
         "Contrast over depth and cycles per degree", false, plots);
}

void addZone(const Bench& bench, const std::vector<MeasuredFigure>& figures,
             std::vector<Figure>& plots) {
  const std::string whatOfIt = bench.sheet() != nullptr
                                   ? "The share of the panel that no flip separates from an eye"
                                   : "The share of the panel that sends light to an eye";
  addMap(zoneMap(bench, figures),
         {"viewing_zone",
          "Viewing zone from above",
          whatOfIt + "; the line is 0.95.",
          {},
          pointsOf(chosen(figures, "viewingZone", "share"), "x", "z"),
          true},
         "Share of the panel seen, over the eye's place", false, plots);
}

void addMatrix(const std::vector<MeasuredFigure>& figures, std::vector<Figure>& plots) {
  const Figures all = chosen(figures, "crosstalkMatrix", "");
  MapPlot plot = mapOf(all);
  plot.titleAcross = "direction in which the eye is";
  plot.titleUp = "direction that is lit";
  plot.unit = "light";
  addMap(plot,
         {"crosstalk_matrix",
          "Crosstalk between directions",
          "Luminance, as a part of that in the lit direction.",
          {},
          pointsOf(all, "seen", "lit")},
         "Light of each direction in its neighbours", true, plots);
}

/// Whether a figure belongs into the table: its name has few places, or it is no ratio of a plot.
bool isInTable(const MeasuredFigure& one, const std::map<std::string, int>& counts) {
  return counts.at(one.of.figure) <= 20 || !one.of.unit.empty();
}

std::string tableOf(const std::vector<MeasuredFigure>& figures) {
  std::map<std::string, int> counts;
  for (const MeasuredFigure& one : figures) ++counts[one.of.figure];
  Table table{{"figure", "where", "value", "unit", "closed form", "difference"}};
  std::string text = "<div class=\"scroll\"><table class=\"sorts\"><thead><tr>";
  for (const std::string& head : table[0]) text += "<th>" + head + "</th>";
  text += "</tr></thead><tbody>\n";
  for (const MeasuredFigure& one : figures) {
    if (!isInTable(one, counts)) continue;
    const auto [unit, factor] = readUnitOf(one);
    table.push_back({one.of.figure, one.of.where, readValue(factor * one.value), unit,
                     readValue(factor * one.of.closedForm), readValue(factor * one.difference())});
    text += "<tr>";
    for (std::size_t k = 0; k < table.back().size(); ++k)
      text += (k == 2 || k > 3 ? "<td class=\"n\">" : "<td>") + escaped(table.back()[k]) + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n" + latexPart(latexTable(table));
}

std::string agreementText(const std::vector<MeasuredFigure>& figures) {
  const auto [count, most] = agreementOf(figures);
  if (count == 0) return {};
  return "<p>Over " + std::to_string(count) +
         " gratings, simulated contrast and its law differ by at most " +
         numberText(fourDigits(most)) + ".</p>\n";
}

std::string facts(const MeasureRequest& request, const Bench& bench) {
  const auto pair = [](const auto& values) {
    return numberText(values[0]) + " × " + numberText(values[1]);
  };
  const PanelParams& display = request.display;
  const Vec3& eye = bench.eye();
  const std::string shown =
      bench.sheet() != nullptr
          ? readValue(display.directions[0]) + " views under a lens sheet of " +
                readValue(1000 * bench.pitch(0)) + " mm, " + pair(display.hogels) + " px, cone " +
                numberText(display.fov[0])
          : pair(display.hogels) + " hogels of " + pair(display.directions) +
                " directions, field of view " + pair(display.fov);
  return "<p>" + pair(display.size) + " m, " + shown + "°. Eye of the state “" +
         escaped(request.session.cameras.front().camera.name) + "” at (" + readValue(eye.x) + ", " +
         readValue(eye.y) + ", " + readValue(eye.z) + ") m of the panel; leakage " +
         (bench.psf().windowSize > 1 ? "σ " + numberText(bench.psf().sigma) + " in " +
                                           std::to_string(bench.psf().windowSize)
                                     : std::string("none")) +
         "; pupil " +
         (bench.pupil().diameter > 0 ? numberText(1000 * bench.pupil().diameter) + " mm"
                                     : std::string("none")) +
         ". Luminance is relative.</p>\n";
}

}  // namespace

Agreement agreementOf(const std::vector<MeasuredFigure>& figures) {
  Agreement agreement;
  for (const MeasuredFigure& one : figures) {
    if (one.of.figure != "mtf" || std::isnan(one.difference())) continue;
    agreement.most = std::max(agreement.most, std::abs(one.difference()));
    ++agreement.gratings;
  }
  return agreement;
}

ReadUnit readUnitOf(const MeasuredFigure& one) {
  constexpr double decimetre = 0.1;
  const double value = std::isnan(one.value) ? one.of.closedForm : one.value;
  if (one.of.unit == "m" && std::abs(value) < decimetre) return {"mm", 1000};
  return {one.of.unit};
}

std::string readValue(double value) {
  if (std::isnan(value)) return "–";
  return std::isinf(value) ? "∞" : numberText(fourDigits(value));
}

std::vector<Figure> plotsOf(const Bench& bench, const std::vector<MeasuredFigure>& figures) {
  std::vector<Figure> plots;
  addMtf(bench, figures, plots);
  addCurve(chosen(figures, "throughFocus", ""),
           {"through_focus", "Contrast through focus",
            "A grating behind the panel, over the distance at which the pupil is focused.",
            "focus in dioptres, 1/m", "contrast", "dioptres"},
           plots);
  addZone(bench, figures, plots);
  addCurve(
      chosen(figures, "crosstalk", "x="),
      {"crosstalk", "Crosstalk over the head's place",
       "What the left eye sees of the right eye's picture, in linear light, as a part of its own "
       "picture; 0 is the designated eye position.",
       "head's place in m", "crosstalk", "x"},
      plots);
  addMatrix(figures, plots);
  addCurve(chosen(figures, "angularProfile", "angle"),
           {"angular_profile",
            bench.sheet() != nullptr ? "Light of one view over angle"
                                     : "Light of one direction over angle",
            bench.sheet() != nullptr ? "Luminance, as a part of that in the view's middle."
                                     : "Luminance, as a part of that in the direction's middle.",
            "angle in °", "luminance", "angle"},
           plots);
  addCurve(chosen(figures, "angularResolution", "contrast"),
           {"angular_resolution", "Contrast over directions",
            "Waves over directions, of so many directions a period.", "directions a period",
            "contrast", "period"},
           plots);
  return plots;
}

std::string measurePage(const MeasureRequest& request, const Bench& bench,
                        const Measured& measured) {
  std::string body =
      "<h1>" +
      std::string(bench.twin() != nullptr ? "A unit of the display of " : "The display of ") +
      escaped(request.name) + "</h1>\n" + facts(request, bench);
  for (const std::string& line : measured.left)
    body += "<p>Not measured, " + escaped(line) + ".</p>\n";
  body += agreementText(measured.figures) + tableOf(measured.figures);
  for (const Figure& plot : plotsOf(bench, measured.figures))
    body += "<h2>" + plot.title + "</h2>\n" + figureTag(plot);
  return pageOf("Hogelscope measures: " + request.name, body);
}

}  // namespace hogelscope
