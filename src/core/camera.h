// SPDX-License-Identifier: BSD-3-Clause
// The pinhole camera of a state: pose, field of view, resolution; its frame is OpenCV's.
#pragma once

#include <array>
#include <string>

#include "core/geometry.h"
#include "core/parameters.h"

namespace hogelscope {

/// The camera part of a state. Lengths in metres, `fov` is the vertical angle in degrees.
struct CameraParams {
  std::string name;
  Vec3 eye{0, 0, 0.559};
  Vec3 lookat;
  Vec3 up{0, 1, 0};
  double fov = 60;
  std::array<int, 2> res{600, 600};
  bool operator==(const CameraParams&) const = default;
};

void describe(ParameterVisitor& v, CameraParams& p);

/// +x right, +y down, +z forward; pixel centres at integers, (w-1)/2, (h-1)/2 on the axis.
class Camera {
 public:
  /// Throws InputError ("lookat" or "up") where eye, lookat and up give no frame.
  explicit Camera(const CameraParams& params);

  /// Columns right, down, forward; origin at the eye.
  [[nodiscard]] const RigidTransform& worldFromCamera() const { return m_worldFromCamera; }
  /// Focal length in pixels, f = (h/2) / tan(fov/2).
  [[nodiscard]] double focalLength() const { return m_focal; }
  /// Principal point in pixels.
  [[nodiscard]] Vec2 centre() const { return m_centre; }
  /// The point (x, y, 1) of the image plane under a pixel, in the camera frame.
  [[nodiscard]] Vec2 normalised(double px, double py) const {
    return {(px - m_centre.x) / m_focal, (py - m_centre.y) / m_focal};
  }

 private:
  RigidTransform m_worldFromCamera;
  double m_focal;
  Vec2 m_centre;
};

}  // namespace hogelscope
