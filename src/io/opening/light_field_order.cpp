// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/light_field_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "capture/names/name_pattern.h"
#include "capture/names/view_grid.h"
#include "core/base/text.h"
#include "io/opening/grey_views.h"
#include "io/scene/numbered_frames.h"

namespace hogelscope {

const char* nameOf(RowOrder order) {
  return order == RowOrder::topDown ? "top-down" : "bottom-up";
}

const char* nameOf(ColumnOrder order) {
  return order == ColumnOrder::leftRight ? "left-right" : "right-left";
}

const char* nameOf(ViewScan scan) {
  constexpr std::array names{"raster", "serpentine", "columns", "columns-serpentine"};
  return names[std::size_t(scan)];
}

const char* nameOf(QuiltStart start) {
  return start == QuiltStart::bottomLeft ? "bottom-left" : "top-left";
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
  Judgement(const ViewOrder& measured, const std::optional<Order>& names, const Order& said,
            const std::optional<CameraOrder>& cameras)
      : m_measured(measured), m_order(said) {
    const Order seen{measured.rows, measured.columns};
    if (cameras) {
      withCameras(*cameras, names, seen);
    } else if (measured.isInconsistent) {
      m_reason =
          "rows or columns of views contradict their neighbours: try another display.directions";
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
  /// Returns what contradicts the cameras' places.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return m_warnings; }

 private:
  void withCameras(const CameraOrder& cameras, const std::optional<Order>& names,
                   const Order& seen) {
    m_order = {cameras.rows, cameras.columns};
    m_sureness = Sureness::sure;
    m_reason = "the cameras' places in " + cameras.file;
    const std::string used = cameras.file + ": its cameras' places are used, but ";
    if (names && *names != m_order)
      m_warnings.push_back(used + "the positions in the file names say the opposite");
    const bool isSeen = m_measured.sureness != Sureness::unknown;
    const bool fits = isSeen ? seen == m_order : fitsMotion(m_order, m_measured.correlation);
    if (fits && !m_measured.isInconsistent && !m_measured.isTransposed) return;
    m_sureness = Sureness::likely;
    m_warnings.push_back(used + "the pictures contradict them: " + evidence() +
                         "; are its poses in the axes of their own format?");
  }

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
    } else if (votes().isLeaning() && isOutvoted()) {
      m_order = seen;
      m_reason = evidence() + ": too few to be likely";
    } else if (std::abs(correlation) < clearCorrelation) {
      m_reason = "the views do not show what is near and what is far";
    } else if (fitsMotion(m_order, correlation)) {
      m_reason = evidence() + ": rows and columns agree, but little tells near from far";
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
  std::vector<std::string> m_warnings;
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
  Finding(const LightFieldParams& params, const GreyViews& views, const ViewOrder& measured,
          const std::optional<CameraOrder>& cameras)
      : m_views(views), m_isOfCameras(cameras.has_value()) {
    const bool isTransposed = !cameras && measured.isTransposed;
    const Judgement judgement(measured, orderSaidByNames(views, isTransposed), orderSaidBy(params),
                              cameras);
    m_result.found = params;
    m_result.measured = measured;
    m_result.rows = judgement.order().rows;
    m_result.columns = judgement.order().columns;
    m_result.sureness = judgement.sureness();
    m_result.reason = judgement.reason();
    m_result.warnings = views.warnings;
    for (const std::string& line : judgement.warnings()) m_result.warnings.push_back(line);
    if (views.isLoose) {
      m_result.sureness = Sureness::unknown;
      m_result.reason = "so many numbers are missing that the grid is a guess; " + m_result.reason;
    }
    isGridOfViews(params.layout) ? sayViews() : sayDirections();
  }

  LightFieldOrder result() && { return std::move(m_result); }

 private:
  void sayViews() {
    LightFieldParams& found = m_result.found;
    const ViewOrder& measured = m_result.measured;
    const bool isTransposed = measured.isTransposed && !measured.isInconsistent;
    if (!m_isOfCameras && isTransposed && !sayTransposed()) return;
    if (found.incoming) {
      m_result.rows = reversed(m_result.rows);
      m_result.columns = reversed(m_result.columns);
    }
    found.rows = m_result.rows;
    found.columns = m_result.columns;
    if (m_result.sureness != Sureness::unknown && (!m_isOfCameras || hasMiddleMotion(measured)))
      found.shear = shearOf(found, measured);
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
    const std::string text = "the views run column by column: ";
    if (m_views.isCounted)
      m_result.warnings.push_back("lightField.scan: " + text + "give lightField.scan=columns " +
                                  "display.directions=[" + std::to_string(m_views.grid.rows) + "," +
                                  std::to_string(m_views.grid.columns) + "]");
    else
      m_result.warnings.push_back("lightField.pattern: " + text +
                                  "name the files by row and column, such as RRR_CCC");
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
  bool m_isOfCameras;
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

/// Whether content moves along a grid's rows and columns as before one row, or column, of cameras
/// after the other.
bool isInOrder(const ViewOrder& measured, const GreyGrid& grid) {
  if (grid.rows == 1 || grid.columns == 1) return true;
  return !measured.isInconsistent && !measured.isTransposed &&
         std::abs(measured.correlation) >= clearCorrelation;
}

double differenceOf(const GreyPicture& one, const GreyPicture& other) {
  double sum = 0;
  for (std::size_t k = 0; k < one.values.size(); ++k)
    sum += std::abs(double(one.values[k]) - double(other.values[k]));
  return sum / double(one.values.size());
}

/// Returns the distance of the rows that are compared with those above them: few need to be read.
int stepOfRows(const GreyGrid& tiles) {
  constexpr int most = 4;
  return std::max(1, tiles.rows / most);
}

/// Returns the mean difference between the last tile of a row and the first one of the next, for
/// rows that follow upwards or downwards.
double jumpOf(const GreyGrid& tiles, QuiltStart start) {
  double sum = 0, count = 0;
  for (int row = 1; row < tiles.rows; row += stepOfRows(tiles)) {
    const bool isUpwards = start == QuiltStart::bottomLeft;
    const int from = isUpwards ? row : row - 1, to = isUpwards ? row - 1 : row;
    if (!tiles.has(from, tiles.columns - 1) || !tiles.has(to, 0)) continue;
    sum += differenceOf(tiles.view(from, tiles.columns - 1), tiles.view(to, 0));
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

/// Returns the mean difference of tiles that lie one below the other.
double stepDownOf(const GreyGrid& tiles) {
  double sum = 0, count = 0;
  for (int row = 1; row < tiles.rows; row += stepOfRows(tiles))
    for (const int column : {0, tiles.columns - 1}) {
      if (!tiles.has(row, column) || !tiles.has(row - 1, column)) continue;
      sum += differenceOf(tiles.view(row, column), tiles.view(row - 1, column));
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

enum class TileOrder { unknown, quilt, mosaic };

/// Returns whether tiles are rows of cameras: one below the other is the next view, and the first
/// of a row is not the next one after the last of another. In a quilt it is the other way round.
TileOrder tileOrderOf(const GreyGrid& tiles) {
  if (tiles.rows < 2 || tiles.columns < 2) return TileOrder::unknown;
  constexpr double clear = 0.85;
  const double step = stepDownOf(tiles);
  const double jump =
      std::min(jumpOf(tiles, QuiltStart::bottomLeft), jumpOf(tiles, QuiltStart::topLeft));
  return step < clear * jump   ? TileOrder::mosaic
         : jump < clear * step ? TileOrder::quilt
                               : TileOrder::unknown;
}

/// Returns the views of a grid that is counted in one way as they lie if they are counted in
/// another.
GreyGrid recounted(const GreyGrid& grid, ViewScan from, ViewScan to) {
  const auto rows = std::size_t(grid.rows), columns = std::size_t(grid.columns);
  const SequenceGrid before{rows, columns, from}, after{rows, columns, to};
  const auto cellOf = [=](std::size_t cell) { return before.cellOf(after.viewOf(cell)); };
  GreyGrid result{grid.rows, grid.columns, [=, view = grid.view](int row, int column) {
                    const std::size_t cell =
                        cellOf(std::size_t(row) * columns + std::size_t(column));
                    return view(int(cell / columns), int(cell % columns));
                  }};
  for (std::size_t cell = 0; cell < grid.isMissing.size(); ++cell)
    result.isMissing.push_back(grid.isMissing[cellOf(cell)]);
  return result;
}

/// Counts the views in another way if they are in order then. Cameras that go to and fro have the
/// end of a line beside the beginning of the next; else rows may be columns.
void findScan(LightFieldParams& params, GreyViews& views, ViewOrder& measured,
              const Progress& progress) {
  const GreyGrid raster = recounted(views.grid, params.scan, ViewScan::raster);
  constexpr double clear = 0.85;
  const bool isToAndFro = jumpOf(raster, QuiltStart::topLeft) < clear * stepDownOf(raster);
  const std::array scans = isToAndFro
                               ? std::array{ViewScan::serpentine, ViewScan::columnsSerpentine}
                               : std::array{ViewScan::raster, ViewScan::columns};
  if (!isToAndFro && params.scan == scans[0] && !measured.isTransposed) return;
  for (const ViewScan scan : scans) {
    if (scan == params.scan) continue;
    GreyGrid grid = recounted(raster, ViewScan::raster, scan);
    const ViewOrder order = findViewOrder(grid, progress);
    if (!isInOrder(order, grid)) continue;
    params.scan = scan;
    views.grid = std::move(grid);
    measured = order;
    return;
  }
}

/// Whether the tiles of a quilt follow one another from its other corner: the step to the next row
/// is one view there, and nearly two rows from the wrong corner.
bool startsElsewhere(const GreyGrid& tiles, QuiltStart start) {
  if (tiles.columns < 2) return false;
  constexpr double clear = 0.75;
  const bool isUpwards = start == QuiltStart::bottomLeft;
  return jumpOf(tiles, isUpwards ? QuiltStart::topLeft : QuiltStart::bottomLeft) <
         clear * jumpOf(tiles, start);
}

}  // namespace

bool hasMiddleMotion(const ViewOrder& measured) {
  return measured.places > 0 && !measured.isInconsistent && !measured.isTransposed;
}

LightFieldOrder findLightFieldOrder(const LightFieldParams& params, const DisplayParams& display,
                                    const Progress& progress,
                                    const std::optional<CameraOrder>& cameras) {
  if (isNumbered(params)) {  // the views of all frames are in one order
    const LightFieldParams still = firstStillOf(params);
    LightFieldOrder order = findLightFieldOrder(still, display, progress, cameras);
    order.found.file = params.file;
    if (!params.pattern.empty()) order.found.pattern = params.pattern;
    order.found.frames = params.frames;
    order.found.fps = params.fps;
    return order;
  }
  LightFieldOrder order;
  order.found = params;
  if (params.isLive()) {
    order.sureness = Sureness::sure;
    order.reason = "the scene is computed in this order";
    return order;
  }
  std::optional<GreyViews> views = greyViewsOf(params, display, part(progress, 0, 0.3));
  if (!views) {
    order.reason = "the light field is too large to look at";
    return order;
  }
  const TileOrder tileOrder = views->tiles ? tileOrderOf(*views->tiles) : TileOrder::unknown;
  if (views->tiles && (tileOrder == TileOrder::mosaic ||
                       hasVerticalParallax(findViewOrder(*views->tiles, part(progress, 0.3, 0.5)))))
    return likeMosaic(params, *views->tiles);
  LightFieldParams counted = params;
  if (views->tiles && startsElsewhere(*views->tiles, params.quiltStart)) {
    counted.quiltStart =
        params.quiltStart == QuiltStart::bottomLeft ? QuiltStart::topLeft : QuiltStart::bottomLeft;
    views = greyViewsOf(counted, display, part(progress, 0.5, 0.6));
  }
  ViewOrder measured = findViewOrder(views->grid, part(progress, 0.6, 0.8));
  if (views->tiles && measured.isTransposed) return likeMosaic(params, *views->tiles);
  if (!cameras && views->isCounted && !isInOrder(measured, views->grid))
    findScan(counted, *views, measured, part(progress, 0.8, 1));
  LightFieldOrder found = Finding(counted, *views, measured, cameras).result();
  found.isLikeQuilt = tileOrder == TileOrder::quilt;
  return found;
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
  if (used.scan != found.scan) add("scan", nameOf(found.scan));
  if (used.quiltStart != found.quiltStart) add("start", nameOf(found.quiltStart));
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
  const bool isOtherCount =
      used.scan != order.found.scan || used.quiltStart != order.found.quiltStart;
  std::string text = std::string("lightField: the order of views contradicts their pictures") +
                     (isOtherCount ? "; " : ", so depth is reversed along a direction; ") +
                     (isCertain ? "mend it with" : "try");
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
