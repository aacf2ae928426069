// SPDX-License-Identifier: BSD-3-Clause
#include "capture/order/camera_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/text.h"

namespace hogelscope {

namespace {

constexpr std::size_t mostCamerasOfGrid = 10000;  // each is compared with all others
constexpr double mostAngle = 5;                   // degrees
constexpr double mostOffset = 0.1;                // of the spacing

std::string angleText(double degrees) {
  return rounded(degrees, 1) + "°";
}

double degreesBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

/// The mean axes of all cameras: right, down, forward, and their mean place.
RigidTransform meanPose(const std::vector<RigidTransform>& poses) {
  RigidTransform mean{{}, {}, {}, {}};
  for (const RigidTransform& pose : poses) {
    mean.xAxis = mean.xAxis + pose.xAxis;
    mean.zAxis = mean.zAxis + pose.zAxis;
    mean.origin = mean.origin + 1.0 / double(poses.size()) * pose.origin;
  }
  mean.zAxis = normalise(mean.zAxis);
  mean.xAxis = normalise(mean.xAxis - dot(mean.xAxis, mean.zAxis) * mean.zAxis);
  mean.yAxis = cross(mean.zAxis, mean.xAxis);
  return mean;
}

/// Returns the median step from a camera to the nearest one that is within 45° of an axis, x or y
/// as the cameras see it; none if no camera has one.
std::optional<Vec3> stepAlong(const std::vector<Vec3>& places, double Vec3::*along,
                              double Vec3::*across) {
  std::array<std::vector<double>, 3> steps;
  for (const Vec3& from : places) {
    std::optional<Vec3> nearest;
    const auto distanceOf = [&](const Vec3& d) { return d.*along + std::abs(d.*across); };
    for (const Vec3& to : places) {
      const Vec3 d = to - from;
      if (d.*along > std::abs(d.*across) && (!nearest || distanceOf(d) < distanceOf(*nearest)))
        nearest = d;
    }
    if (!nearest) continue;
    steps[0].push_back(nearest->x);
    steps[1].push_back(nearest->y);
    steps[2].push_back(nearest->z);
  }
  if (steps[0].empty()) return std::nullopt;
  const auto median = [](std::vector<double>& values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  return Vec3{median(steps[0]), median(steps[1]), median(steps[2])};
}

struct LatticeIndex {
  double column = 0, row = 0;  ///< whole numbers
};

/// Places on a lattice: a place is origin + column · across + row · down.
class PlaneLattice {
 public:
  /// Starts at the place next to the middle, which is 0.
  PlaneLattice(const std::vector<Vec3>& places, const Vec3& across, const Vec3& down)
      : m_places(places),
        m_origin(*std::ranges::min_element(places, {}, length)),
        m_across(across),
        m_down(down) {
    // The steps are exact enough for a few cells; the more cells agree, the farther they reach.
    double farthest = 0;
    for (double reach = 2;; reach *= 2) {
      number();
      fit(reach);
      farthest = 0;
      for (const LatticeIndex& at : m_indices)
        farthest = std::max({farthest, std::abs(at.column), std::abs(at.row)});
      if (!(farthest > reach) || reach > double(mostCamerasOfGrid)) break;
    }
    number();
  }

  [[nodiscard]] const Vec3& across() const { return m_across; }
  [[nodiscard]] const Vec3& down() const { return m_down; }
  [[nodiscard]] const std::vector<LatticeIndex>& indices() const { return m_indices; }

  /// Returns the greatest distance of a place from its lattice point.
  [[nodiscard]] double offset() const {
    double most = 0;
    for (std::size_t k = 0; k < m_places.size(); ++k) {
      const auto [column, row] = m_indices[k];
      const double own = length(m_places[k] - m_origin - column * m_across - row * m_down);
      if (!(own <= most)) most = own;  // also one that is no number
    }
    return most;
  }

 private:
  void number() {
    const double area = m_across.x * m_down.y - m_across.y * m_down.x;
    m_indices.clear();
    for (const Vec3& place : m_places) {
      const Vec3 d = place - m_origin;
      m_indices.push_back({std::round((d.x * m_down.y - d.y * m_down.x) / area),
                           std::round((m_across.x * d.y - m_across.y * d.x) / area)});
    }
  }

  /// Fits origin and steps, by least squares, to the places within `reach` cells of the middle. A
  /// step along which there is one line stays.
  void fit(double reach) {
    double count = 0;
    LatticeIndex mean;
    Vec3 middle;
    const auto each = [&](const auto& use) {
      for (std::size_t k = 0; k < m_places.size(); ++k)
        if (std::abs(m_indices[k].column) <= reach && std::abs(m_indices[k].row) <= reach)
          use(m_indices[k], m_places[k]);
    };
    each([&](const LatticeIndex& at, const Vec3& place) {
      ++count;
      mean = {mean.column + at.column, mean.row + at.row};
      middle = middle + place;
    });
    if (!(count > 0)) return;
    mean = {mean.column / count, mean.row / count};
    middle = 1 / count * middle;
    double cc = 0, rr = 0, cr = 0;
    Vec3 c, r;
    each([&](const LatticeIndex& at, const Vec3& place) {
      const double column = at.column - mean.column, row = at.row - mean.row;
      cc += column * column, rr += row * row, cr += column * row;
      c = c + column * (place - middle);
      r = r + row * (place - middle);
    });
    constexpr double least = 1e-6;
    if (const double det = cc * rr - cr * cr; det > least) {
      m_across = 1 / det * (rr * c - cr * r);
      m_down = 1 / det * (cc * r - cr * c);
    } else if (cc > least && !(rr > least)) {
      m_across = 1 / cc * c;
    } else if (rr > least && !(cc > least)) {
      m_down = 1 / rr * r;
    }
    m_origin = middle - mean.column * m_across - mean.row * m_down;
  }

  const std::vector<Vec3>& m_places;
  Vec3 m_origin, m_across, m_down;
  std::vector<LatticeIndex> m_indices;
};

CameraGrid refused(const std::string& why) {
  CameraGrid grid;
  grid.refusal = why;
  return grid;
}

/// Returns why the directions of view are no grid's; "" if they are.
std::string refusalOfAxes(const std::vector<RigidTransform>& poses, const RigidTransform& mean) {
  double most = 0;
  for (const RigidTransform& pose : poses)
    most = std::max(
        {most, degreesBetween(pose.zAxis, mean.zAxis), degreesBetween(pose.xAxis, mean.xAxis)});
  const bool isMean = length(mean.zAxis) > 0.5 && length(mean.xAxis) > 0.5;
  if (isMean && most <= mostAngle) return {};
  return "its cameras do not look the same way" +
         (isMean ? ", but up to " + angleText(most) + " from their mean" : std::string());
}

/// Puts the cameras into the cells of their rectangle; refuses unless each has one.
CameraGrid inCells(const std::vector<LatticeIndex>& indices) {
  const auto [left, right] = std::ranges::minmax(indices, {}, &LatticeIndex::column);
  const auto [top, bottom] = std::ranges::minmax(indices, {}, &LatticeIndex::row);
  const double columns = right.column - left.column + 1, rows = bottom.row - top.row + 1;
  const auto count = double(indices.size());
  if (!(columns <= count && rows <= count && columns * rows <= count))
    return refused("its " + std::to_string(indices.size()) + " cameras leave places of a grid of " +
                   numberText(columns) + "×" + numberText(rows) + " empty");
  CameraGrid grid;
  grid.columns = int(columns);
  grid.rows = int(rows);
  grid.cameras.assign(std::size_t(columns * rows), indices.size());
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const double at = (indices[k].row - top.row) * columns + indices[k].column - left.column;
    std::size_t& cell = grid.cameras[std::size_t(at)];
    if (cell != indices.size()) return refused("two of its cameras stand at one place of the grid");
    cell = k;
  }
  return grid;
}

}  // namespace

CameraGrid cameraGridOf(const std::vector<RigidTransform>& poses) {
  if (poses.size() < 2) return refused("it has fewer than two cameras");
  if (poses.size() > mostCamerasOfGrid)
    return refused("it has more than " + std::to_string(mostCamerasOfGrid) + " cameras");
  const RigidTransform mean = meanPose(poses);
  if (const std::string why = refusalOfAxes(poses, mean); !why.empty()) return refused(why);
  std::vector<Vec3> places;
  const RigidTransform camerasFromWorld = mean.inverse();
  for (const RigidTransform& pose : poses) places.push_back(camerasFromWorld.point(pose.origin));
  const auto across = stepAlong(places, &Vec3::x, &Vec3::y);
  const auto down = stepAlong(places, &Vec3::y, &Vec3::x);
  if (!across && !down) return refused("its cameras stand in no rows and columns");
  // A single line has no second step: one as long across it finds places beside the line.
  const PlaneLattice lattice(places, across.value_or(Vec3{down ? down->y : 0, 0, 0}),
                             down.value_or(Vec3{0, across ? across->x : 0, 0}));
  double shortest = 0;
  for (const Vec3& step :
       {across ? lattice.across() : lattice.down(), down ? lattice.down() : lattice.across()})
    shortest = shortest > 0 ? std::min(shortest, length(step)) : length(step);
  if (const double offset = lattice.offset(); !(offset <= mostOffset * shortest))
    return refused("its cameras stand up to " + numberText(std::round(100 * offset / shortest)) +
                   " % of their spacing beside a regular plane grid");
  const double turn = std::max(across ? degreesBetween(lattice.across(), {1, 0, 0}) : 0,
                               down ? degreesBetween(lattice.down(), {0, 1, 0}) : 0);
  if (!(turn <= mostAngle))
    return refused("its cameras' grid is turned by " + angleText(turn) + " against their pictures");
  CameraGrid grid = inCells(lattice.indices());
  grid.forward = mean.zAxis;
  if (grid.columns > 1) grid.spacing[0] = lattice.across().x;
  if (grid.rows > 1) grid.spacing[1] = lattice.down().y;
  return grid;
}

}  // namespace hogelscope
