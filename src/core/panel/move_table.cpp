// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/move_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hogelscope {

namespace {

/// The steepest growth of u's or v's move, summed over both axes, for each direction.
double steepest(const std::vector<MoveTable::Pair>& moves, std::size_t axis,
                const std::array<int, 2>& size, const std::array<double, 2>& cells) {
  const auto width = std::size_t(size[0]);
  float across = 0;
  float down = 0;
  for (std::size_t at = 0; at < moves.size(); ++at) {
    if (at % width != 0) across = std::max(across, std::abs(moves[at][axis] - moves[at - 1][axis]));
    if (at >= width) down = std::max(down, std::abs(moves[at][axis] - moves[at - width][axis]));
  }
  return double(across) * cells[0] + double(down) * cells[1];
}

}  // namespace

MoveTable::MoveTable(const TwinPlane& moveU, const TwinPlane& moveV,
                     const std::array<int, 2>& directions)
    : m_directions(directions) {
  const TwinPlane& plane = moveU.isEmpty() ? moveV : moveU;
  if (plane.width < 2 || plane.height < 2) return;
  m_size = {plane.width, plane.height};
  for (std::size_t axis = 0; axis < 2; ++axis)
    m_cells[axis] = double(m_size[axis]) / directions[axis];
  for (std::size_t at = 0; at < plane.values.size(); ++at) {
    m_moves.push_back(
        {moveU.isEmpty() ? 0 : moveU.values[at], moveV.isEmpty() ? 0 : moveV.values[at]});
    for (std::size_t axis = 0; axis < 2; ++axis)
      m_largest[axis] = std::max(m_largest[axis], std::abs(double(m_moves.back()[axis])));
  }
  prepareBack();
}

/// The inverse is u₀ + d(u₀), where d = −m(u₀ + d). If moves differ by L at most for two places
/// that are 1 apart, d differs by L/(1 − L); each cell's d is found from its neighbour's by one
/// step, which makes an error L times as large.
void MoveTable::prepareBack() {
  constexpr std::size_t mostCells = std::size_t(1) << 22;
  const auto cellsOf = [&](int perDirection) {
    return std::size_t(m_directions[0]) * std::size_t(m_directions[1]) * std::size_t(perDirection) *
           std::size_t(perDirection);
  };
  m_perDirection = 4;
  while (m_perDirection > 1 && cellsOf(m_perDirection) > mostCells) m_perDirection /= 2;
  const int columns = m_directions[0] * m_perDirection;
  const int rows = m_directions[1] * m_perDirection;
  m_back.reserve(std::size_t(columns) * std::size_t(rows));
  const std::array growth{steepest(m_moves, 0, m_size, m_cells),
                          steepest(m_moves, 1, m_size, m_cells)};
  const double most = std::max(growth[0], growth[1]);
  constexpr double tooSteep = 0.9;
  if (most > tooSteep) {
    m_back.resize(cellsOf(m_perDirection));
    m_error = {1, 1};
    return;
  }
  const auto next = [&](int column, int row, const std::array<double, 2>& beside) {
    const std::array<double, 2> m = moveAt((column + 0.5) / m_perDirection + beside[0],
                                           (row + 0.5) / m_perDirection + beside[1])
                                        .m;
    return std::array{-m[0], -m[1]};
  };
  std::array<double, 2> first{};
  for (int step = 0; step < 200; ++step) first = next(0, 0, first);
  for (int row = 0; row < rows; ++row) {
    std::array<double, 2> at = first = next(0, row, first);
    for (int column = 0; column < columns; ++column) {
      at = next(column, row, at);
      m_back.push_back({static_cast<float>(at[0]), static_cast<float>(at[1])});
    }
  }
  const double step = 1.0 / m_perDirection;
  const double beside = step * most / (1 - most) / (1 - most);
  constexpr double rounding = 1e-4;
  for (std::size_t axis = 0; axis < 2; ++axis)
    m_error[axis] = growth[axis] * (step / 2 / (1 - most) + beside) + rounding;
}

MoveTable::Move MoveTable::moveAt(double u, double v) const {
  std::array<int, 2> cell{};
  std::array<double, 2> share{};
  std::array<double, 2> perDirection{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double at = (axis == 0 ? u : v) * m_cells[axis] - 0.5;
    const double last = m_size[axis] - 1;
    const double inside = at > 0 ? (at < last ? at : last) : 0;
    cell[axis] = std::min(static_cast<int>(inside), m_size[axis] - 2);
    share[axis] = inside - cell[axis];
    perDirection[axis] = inside == at ? m_cells[axis] : 0;
  }
  const Pair* const upper =
      &m_moves[std::size_t(cell[1]) * std::size_t(m_size[0]) + std::size_t(cell[0])];
  const Pair* const lower = upper + m_size[0];
  Move move;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double along = double(upper[1][axis]) - double(upper[0][axis]);
    const double alongLower = double(lower[1][axis]) - double(lower[0][axis]);
    const double onUpper = double(upper[0][axis]) + share[0] * along;
    const double onLower = double(lower[0][axis]) + share[0] * alongLower;
    move.m[axis] = onUpper + share[1] * (onLower - onUpper);
    move.across[axis] = perDirection[0] * (along + share[1] * (alongLower - along));
    move.down[axis] = perDirection[1] * (onLower - onUpper);
  }
  return move;
}

/// Newton's steps from the table. The map does not fold, so that few are needed; a step after which
/// more is left, beyond a steep cell of the map, is halved. Within a cell of the map the error
/// after a step is far below the step.
std::array<double, 2> MoveTable::solve(double u0, double v0) const {
  const auto cellOf = [&](double place, std::size_t axis) {
    const int last = m_directions[axis] * m_perDirection - 1;
    const double at = place * m_perDirection;
    return std::size_t(at > 0 ? (at < last ? static_cast<int>(at) : last) : 0);
  };
  const Pair& back =
      m_back[cellOf(v0, 1) * std::size_t(m_directions[0]) * std::size_t(m_perDirection) +
             cellOf(u0, 0)];
  double u = u0 + double(back[0]);
  double v = v0 + double(back[1]);
  double stepU = 0;
  double stepV = 0;
  double left = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 100; ++step) {
    const Move at = moveAt(u, v);
    const double restU = u0 - u - at.m[0];
    const double restV = v0 - v - at.m[1];
    const double rest = std::max(std::abs(restU), std::abs(restV));
    if (rest >= left) {
      stepU /= 2;
      stepV /= 2;
      u -= stepU;
      v -= stepV;
      continue;
    }
    left = rest;
    const double across = 1 + at.across[0];
    const double down = 1 + at.down[1];
    const double perDeterminant = 1 / (across * down - at.down[0] * at.across[1]);
    stepU = (restU * down - restV * at.down[0]) * perDeterminant;
    stepV = (restV * across - restU * at.across[1]) * perDeterminant;
    u += stepU;
    v += stepV;
    constexpr double enough = 1e-6;
    if (std::abs(stepU) < enough && std::abs(stepV) < enough) break;
  }
  return {u, v};
}

}  // namespace hogelscope
