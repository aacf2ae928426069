// SPDX-License-Identifier: BSD-3-Clause
#include "core/cameras/camera_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/base/error.h"
#include "core/optics/state_name.h"

namespace hogelscope {

namespace {

struct Maker {
  const CameraSet& set;
  const std::array<double, 2>& panel;
  RandomNumbers random;

  [[nodiscard]] int count() const { return set.params.count; }

  CameraPose pose(const Vec3& eye, double weight = 1) {
    return {eye, lookatFrom(set.region, eye, panel, random), weight};
  }

  std::vector<CameraPose> operator()(std::monostate) {
    return posesIn(set.region, count(), panel, random);
  }
  std::vector<CameraPose> operator()(const Mixture& mixture);
  std::vector<CameraPose> operator()(const PoseList& list);
  std::vector<CameraPose> operator()(const PosePath& path);
  std::vector<CameraPose> operator()(const Trace& trace);
  std::vector<CameraPose> operator()(const CalibratedCameras& /*cameras*/) { return {}; }
};

/// Returns the number of states of each part; those left over by rounding down go to the largest
/// remainders, the first of equal ones.
std::vector<int> sharesOf(const std::vector<Mixture::Part>& parts, int count) {
  double total = 0;
  for (const Mixture::Part& part : parts) total += part.weight;
  std::vector<int> shares;
  std::vector<double> remainders;
  for (const Mixture::Part& part : parts) {
    const double exact = count * (part.weight / total);
    shares.push_back(static_cast<int>(std::floor(exact + 1e-9)));
    remainders.push_back(exact - shares.back());
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return remainders[a] > remainders[b] + 1e-9;
  });
  const int left = count - std::accumulate(shares.begin(), shares.end(), 0);
  for (int k = 0; k < left; ++k) ++shares[order[std::size_t(k) % order.size()]];
  return shares;
}

std::vector<CameraPose> Maker::operator()(const Mixture& mixture) {
  const std::vector<int> shares = sharesOf(mixture.parts, count());
  std::vector<CameraPose> poses;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (shares[k] == 0) continue;
    const auto part = posesIn(mixture.parts[k].region, shares[k], panel, random);
    poses.insert(poses.end(), part.begin(), part.end());
  }
  return poses;
}

std::vector<CameraPose> Maker::operator()(const PoseList& list) {
  std::vector<CameraPose> poses;
  for (const KeyPose& key : list.poses) {
    poses.push_back(pose(key.eye, key.weight));
    if (key.hasLookat()) poses.back().lookat = key.lookat;
  }
  return poses;
}

Vec3 between(const Vec3& a, const Vec3& b, double share) {
  return a + share * (b - a);
}

std::vector<CameraPose> Maker::operator()(const PosePath& path) {
  std::vector<double> at{0};  // length of the path up to each key pose
  for (std::size_t k = 1; k < path.poses.size(); ++k)
    at.push_back(at.back() + length(path.poses[k].eye - path.poses[k - 1].eye));
  std::vector<CameraPose> poses;
  for (int k = 0; k < count(); ++k) {
    const double share = count() == 1 ? 0.5 : double(k) / (count() - 1);
    const double along = share * at.back();
    const auto next = std::upper_bound(at.begin() + 1, at.end() - 1, along);
    const auto to = std::size_t(next - at.begin());
    const double span = at[to] - at[to - 1];
    const double part = span > 0 ? (along - at[to - 1]) / span : 0;
    const KeyPose& a = path.poses[to - 1];
    const KeyPose& b = path.poses[to];
    poses.push_back(pose(between(a.eye, b.eye, part), a.weight + part * (b.weight - a.weight)));
    if (a.hasLookat()) poses.back().lookat = between(a.lookat, b.lookat, part);
  }
  return poses;
}

std::vector<CameraPose> Maker::operator()(const Trace& trace) {
  struct Place {
    Vec3 sum;
    int samples = 0;
  };
  std::vector<CameraPose> timed;
  std::vector<Place> places;
  std::map<std::array<double, 3>, std::size_t> known;
  std::size_t to = 1;
  for (int k = 0; k < count(); ++k) {
    const double time = trace.points.back().time * ((k + 0.5) / count());
    while (to + 1 < trace.points.size() && trace.points[to].time <= time) ++to;
    const Trace::Point& a = trace.points[to - 1];
    const Trace::Point& b = trace.points[to];
    const double share = trace.holds ? 0 : (time - a.time) / (b.time - a.time);
    const Vec3 eye = between(a.eye, b.eye, share);
    if (set.keepsTimes) {
      timed.push_back(pose(eye));
      timed.back().time = time;
      continue;
    }
    const Vec3 cell = (1 / set.params.place) * eye;
    const auto [found, isNew] = known.try_emplace(
        {std::round(cell.x), std::round(cell.y), std::round(cell.z)}, places.size());
    if (isNew) places.emplace_back();
    Place& place = places[found->second];
    place.sum = place.sum + eye;
    ++place.samples;
  }
  if (set.keepsTimes) return timed;
  std::vector<CameraPose> poses;
  poses.reserve(places.size());
  for (const Place& place : places)
    poses.push_back(pose((1.0 / place.samples) * place.sum, place.samples));
  return poses;
}

std::size_t templateIndex(const Session& session, const std::string& name) {
  if (name.empty() && !session.cameras.empty()) return 0;
  for (std::size_t k = 0; k < session.cameras.size(); ++k)
    if (session.cameras[k].camera.name == name) return k;
  throw InputError("cameraSet.template", "\"" + name + "\" is no state of the session");
}

std::string prefixOf(const CameraSet& set) {
  if (!set.params.name.empty()) return set.params.name + "-";
  if (set.source.index() == 0) {
    constexpr std::array<const char*, 3> spreads{"uniform-", "random-", "normal-"};
    return spreads[std::size_t(set.region.distribution)];
  }
  constexpr std::array<const char*, 6> sources{"",      "mixture-", "pose-",
                                               "path-", "trace-",   "camera-"};
  return sources[set.source.index()];
}

/// Returns the largest number that follows the prefix, in any case, in a state's name.
long long lastNumber(const Session& session, const std::string& prefix) {
  const std::u32string folded = caseFolded(prefix);
  long long last = 0;
  for (const CameraState& state : session.cameras) {
    const std::u32string name = caseFolded(state.camera.name);
    if (!name.starts_with(folded)) continue;
    const std::u32string digits = name.substr(folded.size());
    const bool isNumber = !digits.empty() && digits.size() <= 9 &&
                          digits.find_first_not_of(U"0123456789") == std::u32string::npos;
    if (isNumber) last = std::max(last, std::stoll(std::string(digits.begin(), digits.end())));
  }
  return last;
}

/// Formats a number padded to `digits` digits, so that sets added later sort with the first one.
std::string numbered(const std::string& prefix, long long number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return prefix + std::string(digits - text.size(), '0') + text;
}

double roundedToNanometres(double metres) {
  return std::round(metres * 1e9) / 1e9 + 0.0;  // no -0
}

Vec3 rounded(const Vec3& p) {
  return {roundedToNanometres(p.x), roundedToNanometres(p.y), roundedToNanometres(p.z)};
}

/// Returns the cameras in metres, under the set's name if it has one.
CalibratedCameras scaled(CalibratedCameras file, const CameraSetParams& params) {
  const double scale = params.scale == notGiven ? 1 : params.scale;
  const std::size_t digits = std::max<std::size_t>(4, std::to_string(file.cameras.size()).size());
  for (std::size_t k = 0; k < file.cameras.size(); ++k) {
    CalibratedCamera& camera = file.cameras[k];
    if (camera.pose) camera.pose->origin = scale * camera.pose->origin;
    if (!params.name.empty()) camera.name = numbered(params.name + "-", (long long)(k + 1), digits);
  }
  return file;
}

void checkReach(const Vec3& p, const std::string& name, const char* field) {
  constexpr double farthest = 1e6;  // as in the description of CameraParams
  if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > farthest)
    throw InputError(name + "." + field, "is out of range in the world: -1e+06 to 1e+06 m");
}

}  // namespace

void describe(ParameterVisitor& v, CameraSetParams& p) {
  auto& [count, seed, name, templateState, keepTemplate, place, scale] = p;
  v.group("cameraSet", "A camera set: how many states, and what they have in common.");
  v.field("count", count, {1, 100000, 1}, "", "States to make; of a trace: samples in time.");
  v.field("seed", seed, {0, 2147483647, 1}, "", "Of the random numbers.");
  v.field("name", name,
          "What the states' names begin with, before - and a number; empty: the kind of set.");
  v.field("template", templateState,
          "Name of the state that lens, intrinsics, PSF, resolution and field of view are taken "
          "from; empty: the session's first.");
  v.field(
      "keepTemplate", keepTemplate,
      "Leaves that state in the session, where it also counts in reports; false: takes it out.");
  v.field("place", place, {1e-6, 1e3, 0.001}, "m",
          "Trace: samples within a cube of this side become one state, whose weight is their "
          "number.");
  v.field("scale", scale, {1e-9, 1e9, 0.001, true}, "m",
          "File of cameras: one unit of its places; not given: a metre.");
}

void describe(ParameterVisitor& v, TraceParams& p) {
  auto& [file, time, x, y, z, recording, only, timeUnit, origin, scale, holds] = p;
  v.group("trace", "A viewer's trace: the names of its columns, and their units.");
  v.field("file", file, "The CSV file; relative to the document.");
  v.field("time", time, "Name of the column of the time.");
  v.field("x", x, "Name of the column of the place across.");
  v.field("y", y, "Name of the column of the place upwards.");
  v.field("z", z,
          "Name of the column of the distance from the panel; without a column z it is that of "
          "cameraRegion.centre.");
  v.field("recording", recording,
          "Name of the column that says which recording (stimulus, trial) a line belongs to; the "
          "time between two recordings does not count. Empty: all lines are one.");
  v.field("only", only, "The one recording that is used; empty: all.");
  v.field("timeUnit", timeUnit, {1e-9, 1e6, 1e-3}, "s", "One unit of the time: 0.001 for ms.");
  v.field("origin", origin, {-1e9, 1e9, 1}, "",
          "What the columns x, y, z say at the middle of the panel: 4 for views numbered 0 … 8.");
  v.field("scale", scale, {-1e6, 1e6, 1e-3}, "m",
          "One unit of x, y, z; below 0 where the file counts leftwards or downwards.");
  v.field("holds", holds,
          "The viewer stays at a line's place until the next line, as where only changes are "
          "written; otherwise moves straight to the next.");
}

void describe(ParameterVisitor& v, KeyPose& p) {
  auto& [eye, lookat, weight] = p;
  v.group("pose", "A pose of a list or a path, in the display frame.");
  v.field("eye", eye, {-1e4, 1e4, 0.01, true}, "m", "The pinhole.");
  v.field("lookat", lookat, {-1e4, 1e4, 0.01, true}, "m",
          "A point in the middle of the picture; left out: by cameraRegion.lookat.");
  v.field("weight", weight, {0, 1e6, 0.1}, "", "How much the state counts in weighted means.");
}

std::vector<CameraPose> posesOf(const CameraSet& set, const std::array<double, 2>& panel) {
  return std::visit(Maker{set, panel, RandomNumbers(std::uint64_t(set.params.seed))}, set.source);
}

Session withCameras(const Session& session, const CameraSet& set) {
  const std::size_t at = templateIndex(session, set.params.templateState);
  const CameraState& model = session.cameras[at];
  const RigidTransform world =
      transformFromPose(session.display.position, session.display.orientation);
  const std::vector<CameraPose> poses = posesOf(set, session.display.size);
  const std::string prefix = prefixOf(set);
  const long long before = lastNumber(session, prefix);
  const std::size_t digits =
      std::max<std::size_t>(4, std::to_string(before + (long long)poses.size()).size());
  Session result = session;
  if (!set.params.keepTemplate) result.cameras.erase(result.cameras.begin() + std::ptrdiff_t(at));
  if (const auto* file = std::get_if<CalibratedCameras>(&set.source)) {
    for (CameraState& state :
         statesOf(scaled(*file, set.params), model, world.origin, result.cameras))
      result.cameras.push_back(std::move(state));
    return result;
  }
  for (std::size_t k = 0; k < poses.size(); ++k) {
    CameraState state = model;
    state.camera.name = numbered(prefix, before + 1 + (long long)k, digits);
    state.camera.eye = rounded(world.point(poses[k].eye));
    state.camera.lookat = rounded(world.point(poses[k].lookat));
    state.camera.up = rounded(world.yAxis);
    state.camera.weight = poses[k].weight;
    if (poses[k].time != notGiven) state.camera.time = poses[k].time;
    checkReach(state.camera.eye, state.camera.name, "eye");
    checkReach(state.camera.lookat, state.camera.name, "lookat");
    check(state, k == 0 ? "cameraSet" : state.camera.name);
    result.cameras.push_back(std::move(state));
  }
  return result;
}

}  // namespace hogelscope
