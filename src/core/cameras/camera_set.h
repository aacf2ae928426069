// SPDX-License-Identifier: BSD-3-Clause
// Camera sets, which add many states to a session, from a distribution, a list, a path or a
// viewer's trace.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/cameras/calibrated_camera.h"
#include "core/cameras/camera_region.h"
#include "core/optics/session.h"

namespace hogelscope {

/// A camera set's `cameraSet`.
struct CameraSetParams {
  int count = 16;
  int seed = 1;
  std::string name;
  std::string templateState;
  bool keepTemplate = true;
  double place = 0.01;
  double scale = notGiven;
  bool operator==(const CameraSetParams&) const = default;
};

void describe(ParameterVisitor& v, CameraSetParams& p);

/// A user-defined pose in the display frame, in metres.
struct KeyPose {
  Vec3 eye{notGiven, notGiven, notGiven};
  Vec3 lookat{notGiven, notGiven, notGiven};
  double weight = 1;
  [[nodiscard]] bool hasLookat() const { return lookat.x != notGiven; }
};

void describe(ParameterVisitor& v, KeyPose& p);

/// Several regions that share the states by weight, rounded by largest remainders.
struct Mixture {
  struct Part {
    double weight = 1;
    CameraRegionParams region;
  };
  std::vector<Part> parts;
};

/// A list of poses, each of which gives a state.
struct PoseList {
  std::vector<KeyPose> poses;
};

/// States at equal steps along straight lines between at least two poses. Either all poses have a
/// look-at or none; it changes linearly along the lines, as the weight does.
struct PosePath {
  std::vector<KeyPose> poses;
};

/// A camera set's `trace`: the columns of a file of a viewer's positions, and their units.
struct TraceParams {
  std::string file;
  std::string time = "time";
  std::string x = "x";
  std::string y = "y";
  std::string z = "z";
  std::string recording;
  std::string only;
  double timeUnit = 1;
  Vec3 origin;
  Vec3 scale{1, 1, 1};
  bool holds = false;
};

void describe(ParameterVisitor& v, TraceParams& p);

/// At least two positions of a viewer. Samples are in the middles of equal time spans, linear
/// between the points or, if it `holds`, at the previous point; samples in the same cube of side
/// `place` (centred on its multiples) become one state at their mean, weighted by their number.
struct Trace {
  struct Point {
    double time = 0;  ///< seconds since the first point, never falling; the last one's is above 0
    Vec3 eye;
  };
  std::vector<Point> points;
  bool holds = false;
};

/// The description of a camera set. Without a source it is `region`'s own distribution; with one,
/// `region` gives the look-at of states without their own. Cameras of a file are in the world.
struct CameraSet {
  CameraSetParams params;
  CameraRegionParams region;
  std::variant<std::monostate, Mixture, PoseList, PosePath, Trace, CalibratedCameras> source;
  std::string traceFile = {};           ///< that the Trace, or the cameras, were read from
  std::vector<std::string> notes = {};  ///< what was guessed of it, and what is left aside
  /// Each sample of a trace is a state with its time, wherever it is: for a light field in time.
  bool keepsTimes = false;
};

/// Returns the poses in the display frame, but none of a file's cameras, which are statesOf();
/// `panel` is the display's width and height. Random numbers are seeded (std::mt19937_64) and drawn
/// in the order of the states.
std::vector<CameraPose> posesOf(const CameraSet& set, const std::array<double, 2>& panel);

/// Returns the session with the set's states appended, without the template unless `keepTemplate`,
/// otherwise unchanged. Lens, intrinsics, PSF, resolution and field of view are the template's, or
/// those of a file's cameras; up is the panel's, or theirs. Positions are rounded to 1e-9 m, so
/// that they do not depend on a machine's sine. Throws InputError if there is no such template or a
/// state is invalid in a session.
Session withCameras(const Session& session, const CameraSet& set);

}  // namespace hogelscope
