// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/ray_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/engine/hogel_pixels.h"
#include "core/engine/view_rays.h"

namespace hogelscope {

namespace {

/// Sums of a row of pixels.
struct MoveSums {
  double u = 0;
  double v = 0;
  double squares = 0;
  double count = 0;

  /// `first` is the first of the two axes along which cells are compared.
  void add(const CellBatch& from, const CellBatch& to, std::size_t k, std::size_t first) {
    const auto move = [&](std::size_t axis) {
      return double(to.cell[axis][k]) - double(from.cell[axis][k]) + double(to.place[axis][k]) -
             double(from.place[axis][k]);
    };
    const auto [du, dv] = std::pair(move(first), move(first + 1));
    u += du;
    v += dv;
    squares += du * du + dv * dv;
    ++count;
  }
  void add(const MoveSums& other) {
    u += other.u;
    v += other.v;
    squares += other.squares;
    count += other.count;
  }
};

}  // namespace

RayMoves movesOf(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                 const Progress& progress) {
  RenderJob design = middleRays(job);
  design.twin = nullptr;
  const ViewRays from(design, tables, parallelRows, progress);
  const ViewRays to(middleRays(job), tables, parallelRows, progress);
  const std::size_t axis = hasDirections(job.display) ? 2 : 0;
  const auto [width, height] = job.state.camera.res;
  std::vector<MoveSums> rows(static_cast<std::size_t>(height));
  parallelRows(height, [&, width = width](int begin, int end) {
    CellBatch designed;
    CellBatch built;
    for (int y = begin; y < end; ++y)
      for (int x0 = 0; x0 < width; x0 += batchSize) {
        const int count = std::min(batchSize, width - x0);
        from.cells(y, x0, count, {}, designed);
        to.cells(y, x0, count, {}, built);
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
          if (designed.seen[k] != 0 && built.seen[k] != 0)
            rows[static_cast<std::size_t>(y)].add(designed, built, k, axis);
      }
  });
  MoveSums sum;
  for (const MoveSums& row : rows) sum.add(row);  // in one order for any number of threads
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (sum.count == 0) return {nan, nan};
  const double mean = sum.squares / sum.count;
  const double meanU = sum.u / sum.count;
  const double meanV = sum.v / sum.count;
  return {std::sqrt(mean), std::sqrt(std::max(0.0, mean - meanU * meanU - meanV * meanV))};
}

}  // namespace hogelscope
