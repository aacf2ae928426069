// SPDX-License-Identifier: BSD-3-Clause
// The pinhole camera of a state: pose, field of view, resolution (its frame is OpenCV's); its
// stepwise moves and turns, for the keys of the Camera menu.
#pragma once

#include <array>
#include <string>

#include "core/base/geometry.h"
#include "core/base/parameters.h"

namespace hogelscope {

/// The camera part of a state. Lengths are in metres; `fov` is the vertical angle in degrees.
struct CameraParams {
  std::string name;
  Vec3 eye{0, 0, 0.559};
  Vec3 lookat;
  Vec3 up{0, 1, 0};
  double fov = 60;
  std::array<int, 2> res{600, 600};
  double weight = 1;
  double time = notGiven;  ///< seconds from the first frame of a light field in time
  bool operator==(const CameraParams&) const = default;
};

void describe(ParameterVisitor& v, CameraParams& p);

/// Whether eye, lookat and up give the camera a frame.
bool hasFrame(const CameraParams& p);

/// A calibrated camera's `intrinsics`, in pixels of the state's own images; they replace `fov` if
/// fx is given. Without fy the pixels are square, without cx or cy the axis passes through the
/// middle of the image.
struct IntrinsicsParams {
  double fx = notGiven;
  double fy = notGiven;
  double cx = notGiven;
  double cy = notGiven;
  [[nodiscard]] bool isGiven() const { return fx != notGiven; }
  bool operator==(const IntrinsicsParams&) const = default;
};

void describe(ParameterVisitor& v, IntrinsicsParams& p);

/// A state's `stereo`: the state is a head with two eyes, see eyes.h.
struct StereoParams {
  double ipd = 0;  ///< the distance between the pupils, metres; 0: one eye
  bool operator==(const StereoParams&) const = default;
};

void describe(ParameterVisitor& v, StereoParams& p);

/// A pinhole camera: +x right, +y down, +z forward; pixel centres at integers, the axis through
/// ((w-1)/2, (h-1)/2) unless the intrinsics say otherwise.
class Camera {
 public:
  /// Throws InputError ("lookat" or "up") if the camera has no frame.
  explicit Camera(const CameraParams& params, const IntrinsicsParams& intrinsics = {});

  /// Returns the camera's pose: its axes are right, down and forward, its origin is the eye.
  [[nodiscard]] const RigidTransform& worldFromCamera() const { return m_worldFromCamera; }
  /// Returns the focal lengths in pixels, across and down: both (h/2) / tan(fov/2) without
  /// intrinsics.
  [[nodiscard]] Vec2 focalLength() const { return m_focal; }
  /// Returns the principal point in pixels.
  [[nodiscard]] Vec2 centre() const { return m_centre; }
  /// Returns the point (x, y, 1) of the image plane under a pixel, in the camera frame.
  [[nodiscard]] Vec2 normalised(double px, double py) const {
    return {(px - m_centre.x) / m_focal.x, (py - m_centre.y) / m_focal.y};
  }

 private:
  RigidTransform m_worldFromCamera;
  Vec2 m_focal;
  Vec2 m_centre;
};

/// The motions of a camera. Walk (forward), strafe (to the right) and rise (along `up`) move both
/// eye and look-at, so that the view keeps its direction. Turn (to the right, about `up`), tilt
/// (upwards) and roll (clockwise, about the view) keep the eye; orbits (to the right about `up`,
/// and upwards) keep the look-at. All keep the distance between the two.
enum class Motion { walk, strafe, rise, turn, tilt, roll, orbitAcross, orbitUp };

/// Returns the size of a step: 0.01 m for the first three motions, 2° for the others.
double stepOf(Motion motion);

/// Moves a camera by `amount` metres or degrees; negative reverses the direction. Tilt and orbitUp
/// end one degree before the view is parallel to `up`. Throws InputError if eye, lookat and up give
/// no frame.
CameraParams moved(const CameraParams& camera, Motion motion, double amount);

/// Returns the camera turned to the panel's middle; an eye behind the panel, or in its plane, is
/// taken to the same place in front, at least 1 cm away. `up` becomes the panel's where the old one
/// gives no frame.
CameraParams facing(CameraParams camera, const RigidTransform& worldFromPanel);

}  // namespace hogelscope
