// SPDX-License-Identifier: BSD-3-Clause
// Draws a light field's views in the order of the display, with arrows.
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "io/opening/contrast.h"
#include "io/opening/grey_views.h"
#include "io/opening/opening.h"

namespace hogelscope {

namespace {

const cv::Scalar white(255, 255, 255);
const cv::Scalar yellow(255, 210, 0);
const cv::Scalar blue(80, 190, 255);

/// Returns which of `count` views are shown: the first, the last, some evenly between, and
/// `middle`.
std::vector<int> shownOf(int count, int middle) {
  constexpr int most = 5;
  const int shown = std::min(count, most);
  std::vector<int> indices;
  indices.reserve(std::size_t(shown));
  for (int k = 0; k < shown; ++k)
    indices.push_back(shown == 1 ? 0 : int(std::lround(double(k) * (count - 1) / (shown - 1))));
  if (shown == most && middle > indices[most / 2 - 1] && middle < indices[most / 2 + 1])
    indices[most / 2] = middle;
  return indices;
}

class Sheet {
 public:
  Sheet(const GreyViews& views, const LightFieldOrder& order, const AssumedOrder& assumed)
      : m_views(views),
        m_assumed(assumed),
        m_middle{order.measured.middleRow, order.measured.middleColumn},
        m_motions(order.measured.motions) {
    const bool isTransposed =
        order.measured.isTransposed && assumed.used.pattern != order.found.pattern;
    m_isUp = assumed.rows == RowOrder::bottomUp;
    m_isLeft = assumed.columns == ColumnOrder::rightLeft;
    m_isAsMeasured = !isTransposed;
    if (order.isExchanged && m_isAsMeasured) {
      std::swap(m_middle[0], m_middle[1]);
      for (PlaceMotion& motion : m_motions) std::swap(motion.alongColumns, motion.alongRows);
    }
    m_rows = shownOf(views.grid.rows, m_middle[0]);
    m_columns = shownOf(views.grid.columns, m_middle[1]);
    if (m_isUp) std::reverse(m_rows.begin(), m_rows.end());
    if (m_isLeft) std::reverse(m_columns.begin(), m_columns.end());
  }

  Preview draw(const Progress& progress) {
    const GreyPicture first = firstThere();
    m_scale = double(tileSide) / std::max(first.width, first.height);
    m_tile = {std::max(1, cvRound(first.width * m_scale)),
              std::max(1, cvRound(first.height * m_scale))};
    const bool isKnown = m_assumed.sureness != Sureness::unknown;
    m_bottom = border + int(m_rows.size()) * (m_tile.height + gap);
    m_sheet.create(m_bottom + (isKnown ? 0 : adviceHeight),
                   std::max(leastWidth, border + int(m_columns.size()) * (m_tile.width + gap)));
    m_sheet.setTo(cv::Scalar(32, 34, 38));
    const std::vector<cv::Mat3f> tiles = readTiles(progress);
    std::vector<float> values;
    for (const cv::Mat3f& tile : tiles)
      if (!tile.empty())
        values.insert(values.end(), tile.ptr<float>(), tile.ptr<float>() + 3 * tile.total());
    const Contrast contrast(std::move(values));
    for (std::size_t k = 0; k < tiles.size(); ++k)
      putView(int(k % m_columns.size()), int(k / m_columns.size()), tiles[k], contrast);
    putWords();
    if (!isKnown) putAdvice();
    Image image(m_sheet.cols, m_sheet.rows);
    image.rgb.assign(m_sheet.data, m_sheet.data + 3 * m_sheet.total());
    return {std::move(image), contrast.isStretched()};
  }

 private:
  static constexpr int tileSide = 240;
  static constexpr int gap = 6;
  static constexpr int border = 78;  // for the words above and on the left
  static constexpr int leastWidth = 640;
  static constexpr int adviceHeight = 64;

  /// Returns the first view that is not missing; there is at least one.
  [[nodiscard]] GreyPicture firstThere() const {
    for (int row = 0; row < m_views.grid.rows; ++row)
      for (int column = 0; column < m_views.grid.columns; ++column)
        if (m_views.grid.has(row, column)) return m_views.grid.view(row, column);
    return {1, 1, {0}};
  }

  /// Reads the views that are shown, row by row, in the size of the tiles; none for a missing one.
  [[nodiscard]] std::vector<cv::Mat3f> readTiles(const Progress& progress) const {
    std::vector<cv::Mat3f> tiles;
    const double count = double(m_rows.size() * m_columns.size());
    for (const int row : m_rows)
      for (const int column : m_columns) {
        const auto k = double(tiles.size());
        tiles.emplace_back();
        if (m_views.grid.has(row, column))
          readTile(row, column, tiles.back(), part(progress, k / count, (k + 1) / count));
      }
    return tiles;
  }

  /// Reads a view in colour, or grey if the light field is too large for that.
  void readTile(int row, int column, cv::Mat3f& tile, const Progress& progress) const {
    const int how = m_scale < 1 ? cv::INTER_AREA : cv::INTER_NEAREST;
    if (m_views.colours) {
      FloatImage view = m_views.colours(row, column, progress);
      cv::resize(cv::Mat(view.height, view.width, CV_32FC3, view.rgb.data()), tile, m_tile, 0, 0,
                 how);
      return;
    }
    GreyPicture view = m_views.grid.view(row, column);
    cv::Mat small;
    cv::resize(cv::Mat(view.height, view.width, CV_8U, view.values.data()), small, m_tile, 0, 0,
               how);
    cv::cvtColor(small, small, cv::COLOR_GRAY2RGB);
    small.convertTo(tile, CV_32F);
  }

  void putView(int x, int y, const cv::Mat3f& tile, const Contrast& contrast) {
    const int row = m_rows[std::size_t(y)];
    const int column = m_columns[std::size_t(x)];
    const cv::Rect place(
        cv::Point(border + x * (m_tile.width + gap), border + y * (m_tile.height + gap)), m_tile);
    if (!m_views.grid.has(row, column)) {
      m_sheet(place).setTo(cv::Scalar(0, 0, 0));
      write("missing", place.tl() + cv::Point(4, 14), white);
      return;
    }
    cv::Mat3b target = m_sheet(place);
    std::transform(tile.begin(), tile.end(), target.begin(), [&](const cv::Vec3f& rgb) {
      return cv::Vec3b(contrast(rgb[0]), contrast(rgb[1]), contrast(rgb[2]));
    });
    write("row " + std::to_string(row) + ", column " + std::to_string(column),
          place.tl() + cv::Point(4, 14), white);
    if (m_middle == std::array{row, column} && m_isAsMeasured) putArrows(place);
  }

  /// Draws arrows as long as the motion over some views, so that it is visible.
  void putArrows(const cv::Rect& place) {
    double longest = 0;
    for (const PlaceMotion& motion : m_motions)
      longest =
          std::max({longest, std::abs(motion.alongColumns[0]), std::abs(motion.alongRows[1])});
    if (!(longest > 0)) return;
    const double factor = 24 / longest;
    const std::size_t every = m_motions.size() / 60 + 1;
    for (std::size_t k = 0; k < m_motions.size(); k += every) {
      const auto& [at, alongColumns, alongRows] = m_motions[k];
      const cv::Point2d from(place.x + at[0] * m_scale, place.y + at[1] * m_scale);
      const auto arrow = [&](const std::array<double, 2>& motion, double sign,
                             const cv::Scalar& colour) {
        const cv::Point2d to = from + sign * factor * cv::Point2d(motion[0], motion[1]);
        cv::arrowedLine(m_sheet, from, to, colour, 1, cv::LINE_AA, 0, 0.3);
      };
      if (m_views.grid.columns > 1) arrow(alongColumns, m_isLeft ? -1 : 1, yellow);
      if (m_views.grid.rows > 1) arrow(alongRows, m_isUp ? -1 : 1, blue);
    }
  }

  void putWords() {
    write(std::string("rows ") + nameOf(m_assumed.rows) + ", columns " + nameOf(m_assumed.columns) +
              ": " + (m_assumed.isChosen ? "chosen here" : nameOf(m_assumed.sureness)),
          {8, 18}, white);
    write("from here to the right the camera goes right", {border, 62}, white);
    cv::arrowedLine(m_sheet, {border, 70}, {border + 300, 70}, white, 1, cv::LINE_AA, 0, 0.03);
    write("down", {30, border + 14}, white);
    cv::arrowedLine(m_sheet, {48, border + 22}, {48, m_bottom - 12}, white, 1, cv::LINE_AA, 0,
                    0.03);
    write("yellow: how content moves to the view on the right", {8, 36}, yellow);
    write("blue: to the view below", {430, 36}, blue);
  }

  void putAdvice() {
    write("Right if, to the view on its right, what is near moves left over what is far,",
          {8, m_bottom + 18}, white);
    write("and to the view below moves up over it. If what is far moves so, over what is near,",
          {8, m_bottom + 36}, white);
    write("depth is reversed: reverse both rows and columns.", {8, m_bottom + 54}, white);
  }

  void write(const std::string& text, const cv::Point& at, const cv::Scalar& colour) {
    constexpr double size = 0.42;
    cv::putText(m_sheet, text, at, cv::FONT_HERSHEY_SIMPLEX, size, cv::Scalar(0, 0, 0), 3,
                cv::LINE_AA);
    cv::putText(m_sheet, text, at, cv::FONT_HERSHEY_SIMPLEX, size, colour, 1, cv::LINE_AA);
  }

  const GreyViews& m_views;
  const AssumedOrder& m_assumed;
  std::array<int, 2> m_middle;  ///< row and column of the view that has arrows
  std::vector<PlaceMotion> m_motions;
  bool m_isUp = false;
  bool m_isLeft = false;
  bool m_isAsMeasured = true;
  std::vector<int> m_rows;
  std::vector<int> m_columns;
  double m_scale = 1;
  cv::Size m_tile;
  int m_bottom = 0;  ///< below the views
  cv::Mat3b m_sheet;
};

}  // namespace

Preview contactSheet(const LightFieldOrder& order, const AssumedOrder& assumed,
                     const DisplayParams& display, const Progress& progress) {
  const auto views = greyViewsOf(assumed.used, display, part(progress, 0, 0.3));
  if (!views)
    throw InputError(contentName(assumed.used), "",
                     "has no views that a contact sheet could show: it is computed, or too large");
  return Sheet(*views, order, assumed).draw(part(progress, 0.3, 1));
}

}  // namespace hogelscope
