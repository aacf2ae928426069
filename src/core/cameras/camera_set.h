// SPDX-License-Identifier: BSD-3-Clause
// Camera sets: many states for a session at once, from a distribution, a list, a path or a viewer's
// trace.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/cameras/camera_region.h"
#include "core/optics/session.h"

namespace hogelscope {

/// A camera set's `cameraSet`.
struct CameraSetParams {
  int count = 16;
  int seed = 1;
  std::string name;
  std::string templateState;
  double place = 0.01;
  bool operator==(const CameraSetParams&) const = default;
};

void describe(ParameterVisitor& v, CameraSetParams& p);

/// A pose that a user gives, in the display frame, metres.
struct KeyPose {
  Vec3 eye{notGiven, notGiven, notGiven};
  Vec3 lookat{notGiven, notGiven, notGiven};
  double weight = 1;
  [[nodiscard]] bool hasLookat() const { return lookat.x != notGiven; }
};

void describe(ParameterVisitor& v, KeyPose& p);

/// Shares of several regions: by weight, rounded so that the largest remainders gain.
struct Mixture {
  struct Part {
    double weight = 1;
    CameraRegionParams region;
  };
  std::vector<Part> parts;
};

/// Each pose is a state.
struct PoseList {
  std::vector<KeyPose> poses;
};

/// States at equal steps along straight lines from pose to pose, of which there are two at least.
/// Either all poses have a look-at or
/// none; it changes along the lines, as the weight does.
struct PosePath {
  std::vector<KeyPose> poses;
};

/// A viewer's positions, two at least. Samples in the middles of equal spans of time, positions
/// straight from point to point; samples in the same cube of side `place` (cubes about its
/// multiples) are one state at their mean, which weighs as many as they are.
struct Trace {
  struct Point {
    double time = 0;  ///< seconds, rising
    Vec3 eye;
  };
  std::vector<Point> points;
};

/// What to make. Without another source it is `region`'s own distribution; for the others `region`
/// says where states look that have no look-at.
struct CameraSet {
  CameraSetParams params;
  CameraRegionParams region;
  std::variant<std::monostate, Mixture, PoseList, PosePath, Trace> source;
};

/// In the display frame; `panel` is the display's width and height. Seeded: std::mt19937_64, drawn
/// in the order of the states.
std::vector<CameraPose> posesOf(const CameraSet& set, const std::array<double, 2>& panel);

/// The session with the set's states added at its end, all else as it was. Lens, intrinsics, PSF,
/// resolution and field of view are the template's; up is the panel's. Positions are rounded to
/// 1e-9 m, so that they do not depend on a machine's sine. Throws InputError: no such template, a
/// state that a session would refuse.
Session withCameras(const Session& session, const CameraSet& set);

}  // namespace hogelscope
