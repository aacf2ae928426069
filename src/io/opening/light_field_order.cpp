// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/light_field_order.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "capture/names/name_pattern.h"
#include "core/base/text.h"
#include "io/opening/grey_views.h"

namespace hogelscope {

const char* nameOf(RowOrder order) {
  return order == RowOrder::topDown ? "top-down" : "bottom-up";
}

const char* nameOf(ColumnOrder order) {
  return order == ColumnOrder::leftRight ? "left-right" : "right-left";
}

const char* nameOf(Sureness sureness) {
  return sureness == Sureness::sure ? "sure" : sureness == Sureness::likely ? "likely" : "unknown";
}

RowOrder reversed(RowOrder order) {
  return order == RowOrder::topDown ? RowOrder::bottomUp : RowOrder::topDown;
}

ColumnOrder reversed(ColumnOrder order) {
  return order == ColumnOrder::leftRight ? ColumnOrder::rightLeft : ColumnOrder::leftRight;
}

namespace {

/// The order of rows and columns of the files.
struct Order {
  RowOrder rows = RowOrder::topDown;
  ColumnOrder columns = ColumnOrder::leftRight;
  bool operator==(const Order&) const = default;
};

/// Returns the order of the files that a session's parameters give.
Order orderSaidBy(const LightFieldParams& params) {
  Order order;
  if (isGridOfViews(params.layout)) order = {params.rows, params.columns};
  if (params.incoming) order = {reversed(order.rows), reversed(order.columns)};
  return order;
}

bool areCoordinatesAlone(const std::string& pattern) {
  return !pattern.empty() && namePattern(pattern).meaning().find_first_of("xy") == 0;
}

/// Returns the order from positions in names: x to the right and y downwards, as in those of
/// Stanford and light-field-renderer; exchanged in a transposed grid of coordinates.
std::optional<Order> orderSaidByNames(const GreyViews& views, bool isTransposed) {
  if (!views.columnsFromTo || !views.rowsFromTo) return std::nullopt;
  if (isTransposed && !areCoordinatesAlone(views.pattern)) return std::nullopt;
  const auto [x0, x1] = isTransposed ? *views.rowsFromTo : *views.columnsFromTo;
  const auto [y0, y1] = isTransposed ? *views.columnsFromTo : *views.rowsFromTo;
  if (x0 == x1 || y0 == y1) return std::nullopt;
  return Order{y1 > y0 ? RowOrder::topDown : RowOrder::bottomUp,
               x1 > x0 ? ColumnOrder::leftRight : ColumnOrder::rightLeft};
}

constexpr double clearCorrelation = 0.5;

/// Whether the motion of depths allows an order: x along columns correlates with y along rows if
/// both have the same order.
bool fitsMotion(const Order& order, double correlation) {
  const bool areAlike =
      (order.rows == RowOrder::topDown) == (order.columns == ColumnOrder::leftRight);
  return std::abs(correlation) < clearCorrelation || areAlike == (correlation > 0);
}

/// Combines the evidence of images, names and session.
class Judgement {
 public:
  Judgement(const ViewOrder& measured, const std::optional<Order>& names, const Order& said)
      : m_measured(measured), m_order(said) {
    const Order seen{measured.rows, measured.columns};
    if (measured.isInconsistent) {
      m_reason =
          "rows or columns of views contradict their neighbours: try "
          "lightField.scan=serpentine, or another display.directions";
    } else if (names && !(measured.isTransposed && measured.sureness != Sureness::unknown)) {
      withNames(*names, seen);
    } else if (measured.sureness != Sureness::unknown) {
      m_order = seen;
      m_sureness = measured.sureness;
      m_reason = evidence();
    } else {
      withoutEvidence(seen);
    }
  }

  [[nodiscard]] const Order& order() const { return m_order; }
  [[nodiscard]] Sureness sureness() const { return m_sureness; }
  [[nodiscard]] const std::string& reason() const { return m_reason; }

 private:
  void withNames(const Order& names, const Order& seen) {
    const double correlation = m_measured.correlation;
    const bool isMeasured = std::abs(correlation) >= clearCorrelation;
    if (m_measured.sureness == Sureness::unknown && fitsMotion(names, correlation)) {
      m_order = names;
      if (!isOutvoted()) m_sureness = Sureness::likely;
      m_reason = std::string("positions in the file names") +
                 (isMeasured ? ", and " + evidence() : "; the pictures do not tell");
      return;
    }
    m_order = seen;
    m_sureness = m_measured.sureness;
    m_reason = evidence();
    if (names == seen)
      m_reason = "positions in the file names, and " + m_reason;
    else
      m_reason += "; the positions in the file names say the opposite";
    // If the names agree with motion and occlusions, a likely order becomes a sure one.
    if (names == seen && isMeasured && m_sureness == Sureness::likely) m_sureness = Sureness::sure;
    if (names != seen) m_sureness = std::min(m_sureness, Sureness::likely);
  }

  /// Decides without occlusions: motion alone allows an order and its reverse. One of them is given
  /// or the default, which is no evidence.
  void withoutEvidence(const Order& seen) {
    const double correlation = m_measured.correlation;
    if (m_measured.places == 0) {
      m_reason = "nothing in the views has enough structure to follow";
    } else if (std::abs(correlation) < clearCorrelation) {
      m_reason = "the views do not show what is near and what is far";
    } else if (fitsMotion(m_order, correlation)) {
      m_reason = evidence() + ": columns and rows fit each other, but little tells near from far";
    } else {
      m_order = seen;
      m_reason = evidence() + ": columns or rows are reversed, but little tells which";
    }
  }

  /// Returns the occlusions, counted for this order.
  [[nodiscard]] Occlusions votes() const {
    Occlusions all = m_order.columns == ColumnOrder::leftRight
                         ? m_measured.alongColumns
                         : m_measured.alongColumns.backwards();
    all +=
        m_order.rows == RowOrder::topDown ? m_measured.alongRows : m_measured.alongRows.backwards();
    return all;
  }

  [[nodiscard]] bool isOutvoted() const {
    constexpr int clearly = 3;  // one or two places may mislead
    return votes().reversed >= votes().ordered + clearly;
  }

  [[nodiscard]] std::string evidence() const {
    std::string text;
    if (m_measured.correlation != 0)
      text = "motion along columns and rows (correlation " + rounded(m_measured.correlation, 2) +
             " over " + std::to_string(m_measured.places) + " places), ";
    const Occlusions all = votes();
    return text + "what hides what (" + std::to_string(all.ordered) + " of " +
           std::to_string(all.count()) + " places)";
  }

  const ViewOrder& m_measured;
  Order m_order;
  Sureness m_sureness = Sureness::unknown;
  std::string m_reason;
};

double roundedShear(double pixels) {
  return std::round(100 * pixels) / 100 + 0.0;  // 0, not −0
}

/// Returns the shear that cancels the middle depth's motion, in the order of the parameters;
/// cameras at a given distance keep their own geometry.
std::array<double, 2> shearOf(const LightFieldParams& params, const ViewOrder& measured) {
  if (params.viewingDistance > 0) return params.shear;
  const auto [x, y] = measured.middleMotion;
  return {roundedShear(params.columns == ColumnOrder::leftRight ? -x : x),
          roundedShear(params.rows == RowOrder::topDown ? -y : y)};
}

/// Expresses the order by the layout's parameters.
class Finding {
 public:
  Finding(const LightFieldParams& params, const GreyViews& views, const ViewOrder& measured)
      : m_views(views) {
    const Judgement judgement(measured, orderSaidByNames(views, measured.isTransposed),
                              orderSaidBy(params));
    m_result.found = params;
    m_result.measured = measured;
    m_result.rows = judgement.order().rows;
    m_result.columns = judgement.order().columns;
    m_result.sureness = judgement.sureness();
    m_result.reason = judgement.reason();
    m_result.warnings = views.warnings;
    isGridOfViews(params.layout) ? sayViews() : sayDirections();
  }

  LightFieldOrder result() && { return std::move(m_result); }

 private:
  void sayViews() {
    LightFieldParams& found = m_result.found;
    const ViewOrder& measured = m_result.measured;
    if (measured.isTransposed && !measured.isInconsistent && !sayTransposed()) return;
    if (found.incoming) {
      m_result.rows = reversed(m_result.rows);
      m_result.columns = reversed(m_result.columns);
    }
    found.rows = m_result.rows;
    found.columns = m_result.columns;
    found.shear = shearOf(found, m_result.measured);
  }

  /// Exchanges rows and columns in the pattern; returns false if this is not possible.
  bool sayTransposed() {
    const std::string pattern = transposedPattern(m_views.pattern);
    if (!pattern.empty()) {
      m_result.found.pattern = pattern;
      m_result.isExchanged = true;
      m_result.reason += "; the numbers of rows are those of columns";
      return true;
    }
    m_result.sureness = Sureness::unknown;
    if (m_result.found.layout == Layout::mosaic) {
      m_result.warnings.push_back(
          "lightField: rows of tiles are columns of cameras, which no parameter of the layout "
          "mends: write the picture anew");
      return false;
    }
    if (m_views.grid.rows == 1) {
      m_result.warnings.push_back(
          "display.directions: the views stood one above the other: give [1," +
          std::to_string(m_views.grid.columns) + "]");
      return false;
    }
    const std::string names = m_views.pattern.empty() ? "" : " of \"" + m_views.pattern + "\"";
    m_result.warnings.push_back("lightField.pattern: the views run column by column, which names" +
                                names +
                                " cannot say: name the files by row and column, such as RRR_CCC");
    return false;
  }

  /// Sets `incoming`, which flips both: images of hogels, quilts and stores have no other
  /// parameter.
  void sayDirections() {
    const bool isUp = m_result.rows == RowOrder::bottomUp;
    const bool isLeft = m_result.columns == ColumnOrder::rightLeft;
    const bool hasRows = m_views.grid.rows > 1;
    const bool hasColumns = m_views.grid.columns > 1;
    if (m_result.sureness == Sureness::unknown && m_result.measured.correlation == 0) return;
    if (m_result.measured.isTransposed || (hasRows && hasColumns && isUp != isLeft)) {
      m_result.warnings.push_back(
          std::string("lightField: ") +
          (m_result.measured.isTransposed
               ? "rows of directions are columns"
               : "directions u and v run opposite ways, so depth is reversed along one of them") +
          ", which no parameter of the layout mends: write the file anew");
      return;
    }
    m_result.found.incoming = hasColumns ? isLeft : isUp;
  }

  const GreyViews& m_views;
  LightFieldOrder m_result;
};

/// Returns the order of a quilt that is a mosaic.
LightFieldOrder likeMosaic(const LightFieldParams& params, const GreyGrid& tiles) {
  LightFieldOrder order;
  order.found = params;
  order.isLikeMosaic = true;
  order.reason = "content moves up or down between tiles, which a quilt's does not";
  order.warnings.push_back("lightField.layout: " + order.reason +
                           "; try lightField.layout=mosaic display.directions=[" +
                           std::to_string(tiles.columns) + "," + std::to_string(tiles.rows) + "]");
  return order;
}

}  // namespace

LightFieldOrder findLightFieldOrder(const LightFieldParams& params, const DisplayParams& display,
                                    const Progress& progress) {
  LightFieldOrder order;
  order.found = params;
  if (params.isLive()) {
    order.sureness = Sureness::sure;
    order.reason = "the scene is computed in this order";
    return order;
  }
  const std::optional<GreyViews> views = greyViewsOf(params, display, part(progress, 0, 0.3));
  if (!views) {
    order.reason = "the light field is too large to look at";
    return order;
  }
  if (views->tiles && hasVerticalParallax(findViewOrder(*views->tiles, part(progress, 0.3, 0.6))))
    return likeMosaic(params, *views->tiles);
  const ViewOrder measured = findViewOrder(views->grid, part(progress, 0.6, 1));
  if (views->tiles && measured.isTransposed) return likeMosaic(params, *views->tiles);
  return Finding(params, *views, measured).result();
}

LightFieldParams withOrderOf(const LightFieldParams& used, const LightFieldOrder& order) {
  LightFieldParams params = order.found;
  params.rows = used.rows;
  params.columns = used.columns;
  if (isGridOfViews(params.layout)) params.shear = shearOf(params, order.measured);
  return params;
}

std::vector<std::string> mendingOf(const LightFieldParams& used, const LightFieldOrder& order) {
  const LightFieldParams& found = order.found;
  std::vector<std::string> mending;
  const auto add = [&](const char* field, const std::string& value) {
    mending.push_back(std::string("lightField.") + field + "=" + value);
  };
  if (used.pattern != found.pattern) add("pattern", found.pattern);
  if (used.rows != found.rows) add("rows", nameOf(found.rows));
  if (used.columns != found.columns) add("columns", nameOf(found.columns));
  if (used.incoming != found.incoming) add("incoming", found.incoming ? "true" : "false");
  if (used.shear != found.shear)
    add("shear", "[" + numberText(found.shear[0]) + "," + numberText(found.shear[1]) + "]");
  return mending;
}

std::string contradictionOf(const LightFieldParams& used, const LightFieldOrder& order) {
  LightFieldOrder ofShear = order;  // another shear is the user's choice
  ofShear.found.shear = used.shear;
  if (mendingOf(used, ofShear).empty()) return {};
  const bool isCertain = order.sureness == Sureness::sure;
  std::string text =
      "lightField: the order of views contradicts their pictures, so depth is "
      "reversed along a direction; " +
      std::string(isCertain ? "mend it with" : "try");
  for (const std::string& change : mendingOf(used, order)) text += " " + change;
  return text + " (" + nameOf(order.sureness) + ")";
}

std::vector<std::string> warningsOf(const LightFieldParams& used, const LightFieldOrder& order) {
  std::vector<std::string> lines = order.warnings;
  lines.push_back(contradictionOf(used, order));
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace hogelscope
