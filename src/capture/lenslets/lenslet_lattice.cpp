// SPDX-License-Identifier: BSD-3-Clause
#include "capture/lenslets/lenslet_lattice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hogelscope {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Tests whether a lenslet's directions are all in the image.
class WholeLenslets {
 public:
  WholeLenslets(const LensletLattice& lattice, const LensletArea& area) : m_lattice(lattice) {
    const double pitch = lattice.pitch();
    const double halfU = std::min(area.du - 1.0, pitch) / 2;
    const double halfV = std::min(area.dv - 1.0, pitch) / 2;
    const double cosine = std::abs(lattice.step.real()) / pitch;
    const double sine = std::abs(lattice.step.imag()) / pitch;
    m_marginX = halfU * cosine + halfV * sine - 0.5 - tiny;
    m_marginY = halfU * sine + halfV * cosine - 0.5 - tiny;
    m_right = area.width - 1 - m_marginX;
    m_bottom = area.height - 1 - m_marginY;
  }

  [[nodiscard]] bool hasLenslet(double n, int j) const {
    const PicturePoint at = m_lattice.middle(n, j);
    return at.real() >= m_marginX && at.real() <= m_right && at.imag() >= m_marginY &&
           at.imag() <= m_bottom;
  }

  /// Whether the one or two lenslets of a hogel are whole.
  [[nodiscard]] bool hasHogel(int i, int j) const {
    const double n = m_lattice.lensletOfHogel(i, j);
    return hasLenslet(std::floor(n + tiny), j) && hasLenslet(std::ceil(n - tiny), j);
  }

 private:
  static constexpr double tiny = 1e-6;

  const LensletLattice& m_lattice;
  double m_marginX = 0;
  double m_marginY = 0;
  double m_right = 0;
  double m_bottom = 0;
};

/// Rows [first, last] of lenslets.
struct Rows {
  int first = 0;
  int last = -1;
  [[nodiscard]] int count() const { return std::max(0, last - first + 1); }
};

/// Returns by how many lenslets a straight column shifts to the left at a row, because every second
/// row of a hexagonal grid's column lies half a pitch to the right.
int shiftOf(LensletGrid grid, int row) {
  return grid == LensletGrid::square ? 0 : (row - (row & 1)) / 2;
}

/// Returns the rows of whole lenslets of a column around row 0.
Rows rowsOfColumn(const WholeLenslets& whole, const LensletLattice& lattice, int column) {
  const auto isWhole = [&](int j) {
    return whole.hasLenslet(column - shiftOf(lattice.grid, j), j);
  };
  if (!isWhole(0)) return {};
  Rows rows{0, 0};
  while (isWhole(rows.first - 1)) --rows.first;
  while (isWhole(rows.last + 1)) ++rows.last;
  return rows;
}

struct Corner {
  std::size_t column = 0;
  int row = 0;
};

/// Returns the top left corner of the largest rectangle in columns that all have row 0, or none.
Corner largestRectangle(const std::vector<Rows>& columns) {
  Corner corner;
  double most = 0;
  for (std::size_t first = 0; first < columns.size(); ++first) {
    Rows common = columns[first];
    for (std::size_t last = first; last < columns.size() && common.count() > 0; ++last) {
      common = {std::max(common.first, columns[last].first),
                std::min(common.last, columns[last].last)};
      const double count = double(last - first + 1) * common.count();
      if (count <= most) continue;
      most = count;
      corner = {first, common.first};
    }
  }
  return corner;
}

}  // namespace

double LensletLattice::rotation() const {
  return std::arg(step) / degree;
}

LensletPlace LensletLattice::nearestTo(const PicturePoint& point) const {
  const PicturePoint away = (point - origin) / step;
  const int row = int(std::lround(away.imag() / rowDistance()));
  return {int(std::lround(away.real() - row * rowStep().real())), row};
}

PicturePoint LensletLattice::rowStep() const {
  return grid == LensletGrid::square ? PicturePoint(0, 1)
                                     : PicturePoint(0.5, std::numbers::sqrt3 / 2);
}

LensletLattice latticeOf(const LensletParams& params) {
  return {params.grid, PicturePoint(params.origin[0], params.origin[1]),
          std::polar(params.pitch, params.rotation * degree)};
}

HogelBlock blockFromOrigin(const LensletLattice& lattice, const LensletArea& area) {
  const WholeLenslets whole(lattice, area);
  HogelBlock best{lattice, 0, 0};
  int ny = area.height;
  for (int i = 0; ny > 0; ++i) {
    int rows = 0;
    while (rows < ny && whole.hasHogel(i, rows)) ++rows;
    ny = rows;
    if ((i + 1) * double(ny) > best.nx * double(best.ny)) best = {lattice, i + 1, ny};
  }
  return best;
}

HogelBlock largestBlock(const LensletLattice& lattice, const LensletArea& area) {
  // Row 0 is moved to the image's middle, so that every column of a good block has it.
  LensletLattice moved = lattice;
  const PicturePoint centre((area.width - 1) / 2.0, (area.height - 1) / 2.0);
  const auto [n, row] = lattice.nearestTo(centre);
  moved.origin = lattice.middle(n, row);
  const WholeLenslets whole(moved, area);
  const int most = int((area.width + area.height) / lattice.pitch()) + 1;
  std::vector<Rows> columns;
  for (int column = -most; column <= most; ++column)
    columns.push_back(rowsOfColumn(whole, moved, column));
  const auto [first, top] = largestRectangle(columns);
  HogelBlock largest{moved, 0, 0};
  for (const int right : {0, 1}) {  // half a lenslet of a hexagonal grid's rows may be missing
    LensletLattice from = moved;
    from.origin = moved.middle(int(first) - most + right - shiftOf(lattice.grid, top), top);
    const HogelBlock block = blockFromOrigin(from, area);
    if (double(block.nx) * block.ny > double(largest.nx) * largest.ny) largest = block;
  }
  return largest;
}

}  // namespace hogelscope
