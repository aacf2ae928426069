// SPDX-License-Identifier: BSD-3-Clause
// The page of a sweep: parallel coordinates, a matrix of scatter plots, the table.
#include <algorithm>
#include <cmath>

#include "core/base/axis.h"
#include "core/base/colour_map.h"
#include "core/base/text.h"
#include "measure/measure_page.h"
#include "measure/session_numbers.h"
#include "measure/sweep.h"
#include "page/html.h"
#include "page/latex_table.h"
#include "page/plot.h"

namespace hogelscope {

namespace {

constexpr const char* front = "#c2410c";  ///< of the Pareto front
constexpr const char* others = "#0072b2";

/// A parameter or a figure: its name and its value in each row.
struct Column {
  std::string name;
  std::vector<double> values;      ///< NaN if unknown
  std::vector<std::string> texts;  ///< of values that are not numbers, by their numbers
  double low = 0;
  double high = 1;

  [[nodiscard]] bool isConstant() const { return !(high > low); }
};

/// Finds the range of finite values.
void findRange(Column& column) {
  column.low = std::numeric_limits<double>::infinity();
  column.high = -column.low;
  for (const double value : column.values) {
    if (!std::isfinite(value)) continue;
    column.low = std::min(column.low, value);
    column.high = std::max(column.high, value);
  }
  if (!(column.low <= column.high)) column.low = column.high = 0;
}

std::vector<Column> columnsOf(const SweepTable& table, const std::vector<SweepRow>& rows) {
  std::vector<Column> columns;
  for (std::size_t p = 0; p < table.parameters.size(); ++p) {
    Column column{table.parameters[p].name, {}, {}};
    const bool areNumbers = std::ranges::all_of(
        rows, [p](const SweepRow& row) { return numberOf(row.design[p]).has_value(); });
    for (const SweepRow& row : rows) {
      const std::string& text = row.design[p];
      auto known = std::ranges::find(column.texts, text);
      if (!areNumbers && known == column.texts.end())
        known = column.texts.insert(column.texts.end(), text);
      column.values.push_back(areNumbers ? *numberOf(text) : double(known - column.texts.begin()));
    }
    findRange(column);
    columns.push_back(std::move(column));
  }
  for (std::size_t f = 0; f < table.figures.size(); ++f) {
    Column column{table.figures[f], {}, {}};
    for (const SweepRow& row : rows) column.values.push_back(row.figures[f]);
    findRange(column);
    columns.push_back(std::move(column));
  }
  return columns;
}

std::string colourOf(const SweepRow& row) {
  return row.isPareto ? front : others;
}

/// Rows in the order in which they are drawn: the front on top.
std::vector<std::size_t> drawingOrder(const std::vector<SweepRow>& rows) {
  std::vector<std::size_t> order;
  for (const bool isFront : {false, true})
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (rows[k].isPareto == isFront) order.push_back(k);
  return order;
}

std::string titleOf(const std::vector<Column>& columns, std::size_t row) {
  std::string text = "design " + std::to_string(row + 1);
  for (const Column& column : columns)
    text += "\n" + column.name + ": " +
            (column.texts.empty() ? numberText(fourDigits(column.values[row]))
                                  : column.texts[std::size_t(column.values[row])]);
  return "<title>" + escaped(text) + "</title>";
}

/// Returns the rows of names above axes so far apart, such that none lies on another one.
std::size_t rowsOfNames(const std::vector<Column>& columns, double step) {
  double widest = 0;
  for (const Column& column : columns) widest = std::max(widest, textWidth(column.name) + 8);
  return std::clamp<std::size_t>(std::size_t(std::ceil(widest / step)), 1, columns.size());
}

std::string parallelPlot(const std::vector<Column>& columns, const std::vector<SweepRow>& rows,
                         double width) {
  constexpr double left = 24, right = 44, below = 12, axes = 234, line = 16;
  const double step = (width - left - right) / std::max(1.0, double(columns.size()) - 1);
  const std::size_t names = rowsOfNames(columns, step);
  const double top = line * double(names) + 12;
  const double bottom = top + axes;
  const auto axisOf = [&](const Column& column) {
    return Axis{column.isConstant() ? column.low - 0.5 : column.low,
                column.isConstant() ? column.low + 0.5 : column.high, bottom, top};
  };
  std::string text = svgStart(std::string(styleFor(width)) + " brushed", width,
                              numberText(bottom + below), "Designs over parameters and figures") +
                     "\n";
  for (const std::size_t row : drawingOrder(rows)) {
    std::string points;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double value = columns[c].values[row];
      if (!std::isfinite(value)) continue;
      points += (points.empty() ? "" : " ") + coordinate(left + step * double(c)) + "," +
                coordinate(axisOf(columns[c]).at(value));
    }
    text += "<polyline data-row=\"" + std::to_string(row) + "\" points=\"" + points +
            "\" fill=\"none\" stroke=\"" + colourOf(rows[row]) + "\" stroke-width=\"" +
            (rows[row].isPareto ? "1.8" : "1") + "\" stroke-opacity=\".7\">" +
            titleOf(columns, row) + "</polyline>\n";
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const double x = left + step * double(c);
    const Axis axis = axisOf(columns[c]);
    // Names of the first and the last axis begin and end within the figure.
    const double half = textWidth(columns[c].name) / 2;
    const double middle =
        std::clamp(x, std::min(half, width / 2), width - std::min(half, width / 2));
    text += svgLine(x, top, x, bottom, "stroke=\"#111\"") +
            svgTextOver(middle, line * double(c % names + 1) - 2, "middle",
                        shortName(columns[c].name, width));
    const auto tick = [&](double value, const std::string& name) {
      text += svgTextOver(x + 5, axis.at(value) + 4, "start", shortName(name, step));
    };
    if (columns[c].texts.empty()) {
      for (const Tick& one : linearTicks(axis, 5)) tick(one.value, one.text);
    } else {
      for (std::size_t k = 0; k < columns[c].texts.size(); ++k)
        tick(double(k), columns[c].texts[k]);
    }
    text += "<rect class=\"brush\" data-column=\"" + std::to_string(c) + "\" x=\"" +
            coordinate(x - 12) + "\" y=\"" + coordinate(top) + "\" width=\"24\" height=\"" +
            coordinate(bottom - top) + "\" fill=\"#000\" fill-opacity=\"0\"/>\n";
  }
  return text + "</svg>\n";
}

std::string scatterPlot(const std::vector<Column>& all, const std::vector<SweepRow>& rows,
                        double width) {
  std::vector<Column> columns;
  for (const Column& column : all)
    if (!column.isConstant()) columns.push_back(column);
  constexpr double gap = 12, left = 66, below = 34, line = 16;
  const auto count = double(columns.size());
  const double side = (width - left) / std::max(1.0, count) - gap;
  // Names that are wider than their fields stand below; the fields have their numbers.
  const bool areBelow = std::ranges::any_of(
      columns, [side](const Column& column) { return textWidth(column.name) > side; });
  const double height = count * (side + gap) + below;
  std::string text =
      svgStart(styleFor(width), width, numberText(height + (areBelow ? line * count : 0)),
               "Each pair of parameters and figures") +
      "\n";
  for (std::size_t k = 0; areBelow && k < columns.size(); ++k)
    text += svgText(left, height + line * (double(k) + 0.7), "start",
                    std::to_string(k + 1) + "  " + columns[k].name);
  for (std::size_t j = 0; j < columns.size(); ++j)
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double x = left + double(i) * (side + gap);
      const double y = double(j) * (side + gap);
      text += svgRectangle(x, y, side, side, "class=\"frame\"");
      if (i == j) {
        text += svgText(x + side / 2, y + side / 2 + 4, "middle",
                        areBelow ? std::to_string(i + 1) : columns[i].name);
        continue;
      }
      const Axis across{columns[i].low, columns[i].high, x + 5, x + side - 5};
      const Axis up{columns[j].low, columns[j].high, y + side - 5, y + 5};
      for (const std::size_t row : drawingOrder(rows)) {
        const double a = columns[i].values[row];
        const double b = columns[j].values[row];
        if (!std::isfinite(a) || !std::isfinite(b)) continue;
        text += "<circle data-row=\"" + std::to_string(row) + "\" cx=\"" +
                coordinate(across.at(a)) + "\" cy=\"" + coordinate(up.at(b)) + "\" r=\"" +
                (rows[row].isPareto ? "3" : "2") + "\" fill=\"" + colourOf(rows[row]) +
                "\" fill-opacity=\".7\"/>";
      }
      if (j + 1 == columns.size() && columns[i].texts.empty())
        for (const Tick& tick : linearTicks(across, std::max(1, int(side / 34))))
          text += svgText(across.at(tick.value), y + side + 15, "middle", tick.text);
      if (i == 0 && columns[j].texts.empty())
        for (const Tick& tick : linearTicks(up, 3))
          text += svgText(left - 5, up.at(tick.value) + 4, "end", tick.text);
      text += "\n";
    }
  return text + "</svg>\n";
}

/// Returns the names of the table's columns, with units.
std::vector<std::string> headsOf(const SweepRequest& request) {
  const SweepTable& table = request.table;
  std::vector<std::string> heads{"design"};
  const auto add = [&heads](const std::string& name, const std::string& unit) {
    heads.push_back(unit.empty() ? name : name + " (" + unit + ")");
  };
  const std::vector<SessionNumber> numbers = numbersOf(request.session);
  for (const SweepParameter& parameter : table.parameters) {
    const auto number = std::ranges::find(numbers, parameter.name, &SessionNumber::name);
    add(parameter.name, number == numbers.end() ? std::string() : number->unit);
  }
  for (const std::string& figure : table.figures) add(figure, std::string(figureRow(figure).unit));
  return heads;
}

/// Returns a parameter's value, a number with the digits that count.
std::string shortened(const std::string& value) {
  const auto number = numberOf(value);
  return number ? numberText(fourDigits(*number)) : value;
}

std::string tableOf(const SweepRequest& request, const std::vector<SweepRow>& rows) {
  const SweepTable& table = request.table;
  Table best{headsOf(request)};
  if (!table.pareto.empty()) best[0].emplace_back("Pareto");
  std::string text = "<div class=\"scroll\"><table class=\"sorts\"><thead><tr>";
  for (const std::string& head : best[0]) text += "<th class=\"n\">" + escaped(head) + "</th>";
  text += "</tr></thead><tbody>\n";
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::vector<std::string> cells{std::to_string(k + 1)};
    for (const std::string& value : rows[k].design) cells.push_back(shortened(value));
    for (const double value : rows[k].figures) cells.push_back(readValue(value));
    if (!table.pareto.empty()) cells.emplace_back(rows[k].isPareto ? "yes" : "");
    text += "<tr>";
    for (const std::string& one : cells) text += "<td class=\"n\">" + escaped(one) + "</td>";
    if (!rows[k].problem.empty())
      text += "<td class=\"problem\">" + escaped(rows[k].problem) + "</td>";
    text += "</tr>\n";
    if (rows[k].isPareto || table.pareto.empty()) best.push_back(std::move(cells));
  }
  return text + "</tbody></table></div>\n" + latexPart(latexTable(best));
}

/// Says which contrast figures are of, if they are of several.
std::string contrastsText(const SweepTable& table) {
  const bool hasDepths = std::ranges::any_of(table.figures, [](const std::string& figure) {
    return figure == "depthOfField50" || figure == "depthOfField10";
  });
  if (!hasDepths) return {};
  return "<p>depthOfField50 and depthOfField10 are depths at which contrast falls to 0.5 and 0.1 "
         "of "
         "what it is on the panel, where hogels leave 0.64 of this grating (sinc ½). mtf:Z is the "
         "contrast itself.</p>\n";
}

}  // namespace

std::vector<Figure> sweepPlots(const SweepTable& table, const std::vector<SweepRow>& rows) {
  const std::vector<Column> columns = columnsOf(table, rows);
  const std::string points = csv(table, rows);
  const auto figure = [&](const char* name, const char* title, const auto& plot) {
    return Figure{name,   title, "", [=](double width) { return plot(columns, rows, width); },
                  points, true};
  };
  return {figure("parallel", "Parallel coordinates", parallelPlot),
          figure("scatter", "Pairs", scatterPlot)};
}

std::string sweepPage(const SweepRequest& request, const std::vector<SweepRow>& rows,
                      const std::string& solved) {
  const auto plots = sweepPlots(request.table, rows);
  const auto best = std::ranges::count_if(rows, &SweepRow::isPareto);
  std::string body =
      "<h1>Designs of " + escaped(request.name) + "</h1>\n<p>" + std::to_string(rows.size()) +
      (request.table.sampling == SweepSampling::grid ? " designs of a grid"
                                                     : " designs of a Latin hypercube");
  if (!request.table.pareto.empty())
    body += "; " + std::to_string(best) + " (red) are on the Pareto front";
  if (!solved.empty()) body += ". " + escaped(solved);
  if (!request.table.pass.empty()) body += ". " + escaped(yieldText(request.table, rows));
  if (const std::string effect = effectText(request.table, rows); !effect.empty())
    body += ". " + escaped(effect);
  return pageOf("Hogelscope sweep: " + request.name,
                body +
                    ".</p>\n<h2>Parallel coordinates</h2>\n<p>Each line is a design. Drag along "
                    "an axis to keep a range of it; click on the axis to take it back.</p>\n" +
                    figureTag(plots[0]) + "<h2>Pairs</h2>\n" + figureTag(plots[1]) +
                    "<h2>Designs</h2>\n" + contrastsText(request.table) + tableOf(request, rows));
}

}  // namespace hogelscope
