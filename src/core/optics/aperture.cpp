// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/aperture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/random_numbers.h"
#include "core/panel/design_numbers.h"

namespace hogelscope {

namespace {

constexpr std::array<std::string_view, 3> patternNames{"Vogel spiral", "grid", "random"};

/// The golden angle, in radians.
constexpr double goldenAngle = 2.39996;

std::vector<Vec2> spiralPoints(double radius, int count) {
  std::vector<Vec2> points;
  for (int k = 0; k < count; ++k) {
    const double r = radius * std::sqrt((k + 0.5) / count);
    points.push_back({r * std::cos(goldenAngle * k), r * std::sin(goldenAngle * k)});
  }
  return points;
}

std::vector<Vec2> gridPoints(double radius, int across) {
  std::vector<Vec2> points;
  for (int row = 0; row < across; ++row)
    for (int column = 0; column < across; ++column) {
      const Vec2 p{(2 * column + 1.0) / across - 1, (2 * row + 1.0) / across - 1};
      if (std::hypot(p.x, p.y) <= 1) points.push_back({radius * p.x, radius * p.y});
    }
  return points;
}

std::vector<Vec2> randomPoints(double radius, int count) {
  RandomNumbers random(20261126);
  std::vector<Vec2> points;
  for (int k = 0; k < count; ++k) {
    const double r = radius * std::sqrt(random.unit());
    const double angle = 2 * std::numbers::pi * random.unit();
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return points;
}

/// Returns the depth of a display along a camera's axis: of the panel's plane, or of its centre
/// where the axis does not meet it in front of the camera.
double depthOf(const CameraParams& camera, const DisplayParams& display) {
  if (const double distance = axisDistance(camera, display); distance > 0) return distance;
  const Vec3 way = display.position - camera.eye;
  const double depth = dot(way, Camera(camera).worldFromCamera().zAxis);
  return depth > 0 ? depth : length(way);
}

}  // namespace

void describe(ParameterVisitor& v, PupilParams& p) {
  auto& [diameter, focus, samples] = p;
  v.group("pupil", "The pupil of the viewer's eye, or the aperture of a camera.");
  v.field("diameter", diameter, {0, 1, 0.0005, false, 0, 0.008}, "m",
          "0 is a pinhole, which sees everything sharp; people's pupils have 0.002 to 0.008.");
  v.count(diameter > 0);
  v.field("focus", focus, {0, 1e6, 0.01, false, 0, 2}, "m",
          "Distance along the camera's axis that is sharp; 0: the panel.");
  v.field({"samples", "Samples"}, samples, {0, Aperture::mostSamples, 1, false, 0, 256}, "",
          "Points of the pupil from which images are taken and summed; 0: as many as the display "
          "needs.");
  v.count(true);
}

std::string_view nameOf(AperturePattern pattern) {
  return patternNames[static_cast<std::size_t>(pattern)];
}

std::vector<Vec2> discPoints(AperturePattern pattern, double diameter, int count) {
  const double radius = diameter / 2;
  if (pattern == AperturePattern::vogel) return spiralPoints(radius, count);
  if (pattern == AperturePattern::random) return randomPoints(radius, count);
  int across = 1;
  while (int(gridPoints(radius, across).size()) < count) ++across;
  return gridPoints(radius, across);
}

double axisDistance(const CameraParams& camera, const DisplayParams& display) {
  const RigidTransform displayFromWorld =
      transformFromPose(display.position, display.orientation).inverse();
  const double height = displayFromWorld.point(camera.eye).z;
  const double fall = displayFromWorld.direction(Camera(camera).worldFromCamera().zAxis).z;
  const double distance = -height / fall;
  return std::isfinite(distance) && distance > 0 ? distance : 0;
}

Aperture apertureOf(const PupilParams& pupil, const CameraParams& camera,
                    const PanelParams& display, AperturePattern pattern) {
  Aperture aperture;
  if (!(pupil.diameter > 0)) return aperture;
  aperture.focus = pupil.focus > 0 ? pupil.focus : axisDistance(camera, display);
  if (!(aperture.focus > 0)) throw InputError("pupil.focus", noFocusOnPanel);
  const double distance = depthOf(camera, display);
  const DesignNumbers numbers = designNumbers(display, camera.eye);
  for (const std::size_t axis : {0, 1}) {
    aperture.directions =
        std::max(aperture.directions, pupil.diameter / (distance * numbers.slopeStep.at(axis)));
    aperture.hogels =
        std::max(aperture.hogels, pupil.diameter * std::abs(1 - distance / aperture.focus) /
                                      numbers.hogelPitch.at(axis));
  }
  const double spread = aperture.directions + aperture.hogels;
  // Beyond the largest int the count is far beyond the most samples.
  aperture.wanted = static_cast<int>(std::clamp(std::ceil(4 * spread * spread), 1.0, 1e9));
  if (pupil.samples == 0 && spread < Aperture::negligible) return aperture;
  const int count =
      pupil.samples > 0 ? pupil.samples : std::min(aperture.wanted, Aperture::mostSamples);
  aperture.isPinhole = false;
  aperture.points.clear();
  for (const Vec2& offset : discPoints(pattern, pupil.diameter, count))
    aperture.points.push_back({offset, {-offset.x / aperture.focus, -offset.y / aperture.focus}});
  return aperture;
}

}  // namespace hogelscope
