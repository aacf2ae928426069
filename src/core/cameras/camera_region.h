// SPDX-License-Identifier: BSD-3-Clause
// The positions and look-at points of the cameras of a set: a region in front of the display, and
// their distribution over it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parameters.h"
#include "core/base/random_numbers.h"

namespace hogelscope {

enum class CameraSpread { uniform, random, normal };
enum class RegionShape { box, plane, arc };
enum class LookAt { fixed, nearest, jittered };

/// A camera set's `cameraRegion`, in the display frame; lengths in metres, angles in degrees.
struct CameraRegionParams {
  CameraSpread distribution = CameraSpread::uniform;
  RegionShape region = RegionShape::plane;
  Vec3 centre{0, 0, 0.6};
  Vec3 extent{0.4, 0.4, 0.4};
  std::array<double, 2> distance{0.6, 0.6};
  std::array<double, 2> angle{-25, 25};
  std::array<double, 2> elevation{0, 0};
  double deviation = 0.25;
  LookAt lookat = LookAt::fixed;
  Vec3 target;
  double jitter = 0.05;
  bool operator==(const CameraRegionParams&) const = default;
};

void describe(ParameterVisitor& v, CameraRegionParams& p);

/// Checks rules that involve several fields. Throws InputError; paths begin with `path`.
void check(const CameraRegionParams& region, const std::string& path);

/// One camera of a set, in the display frame.
struct CameraPose {
  Vec3 eye;
  Vec3 lookat;
  double weight = 1;
  double time = notGiven;  ///< seconds, of a trace in front of a light field in time
};

/// The size of a grid: `columns` along x or the angle, `rows` along y or the
/// elevation, `layers` along z or the distance.
struct GridSize {
  int columns = 1;
  int rows = 1;
  int layers = 1;
  bool operator==(const GridSize&) const = default;
};

/// Returns the grid of at least `count` points over the region that has steps of about the same
/// length along each side and few surplus points: least Σ ln²(n/ideal n) + ln(points/count).
GridSize gridFor(const CameraRegionParams& region, int count);

/// Returns `count` poses spread over the region. `panel` is the display's width and height.
///
/// uniform: the points of gridFor(), the region's ends included, nearest layer first, top row
/// first, from the left. Of its M points those numbered ⌊(2k+1)M / 2·count⌋ are used, so that the
/// omitted ones are spread too. random, normal: x, y, z (of an arc: angle, elevation, distance)
/// independent of each other, uniform, or Gaussian about the region's middle and truncated to it.
/// The first n poses do not depend on `count`.
std::vector<CameraPose> posesIn(const CameraRegionParams& region, int count,
                                const std::array<double, 2>& panel, RandomNumbers& random);

/// Returns the look-at point of a camera at `eye`, by the region's rule.
Vec3 lookatFrom(const CameraRegionParams& region, const Vec3& eye,
                const std::array<double, 2>& panel, RandomNumbers& random);

}  // namespace hogelscope
