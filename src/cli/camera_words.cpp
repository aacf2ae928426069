// SPDX-License-Identifier: BSD-3-Clause
#include "cli/camera_words.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <span>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_file.h"
#include "io/documents/trace_file.h"
#include "io/files/atomic_file.h"

namespace hogelscope {

namespace {

constexpr double anyDistance = 1;  // of a trace without a column z

std::string placeText(const Vec3& p) {
  const auto text = [](double x) { return numberText(fourDigits(x) + 0.0); };  // no -0
  return "(" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) + ")";
}

/// Returns the least and the greatest coordinates.
template <class Points, class PlaceOf>
std::string rangeText(const Points& points, const PlaceOf& placeOf) {
  Vec3 least = placeOf(points.front()), most = least;
  for (const auto& point : points) {
    const Vec3 p = placeOf(point);
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }
  return placeText(least) + " … " + placeText(most);
}

std::string lensText(const FileCamera& camera) {
  std::string model = lensModelOf(camera);
  if (model == "brown") model = "Brown–Conrady";
  std::string text =
      camera.model.empty() ? model : printable(camera.model) + (model.empty() ? "" : ", " + model);
  std::span<const LensCoefficient> names;
  try {
    names = coefficientsOf(calibrationOf(camera).distortion.model);
  } catch (const InputError&) {
    text += ", not modelled";
  }
  for (std::size_t k = 0; k < camera.coefficients.size(); ++k)
    text += (k == 0 ? ": " : ", ") + (k < names.size() ? std::string(names[k].name) + " " : "") +
            numberText(camera.coefficients[k]);
  return text;
}

std::string pictureText(const Calibration& calibration) {
  const auto& [k, distortion, res, fov] = calibration;
  std::string text = res ? pairText((*res)[0], (*res)[1]) + " px" : "size not said";
  const auto add = [&text](const char* name, double value, const char* unit) {
    if (value != notGiven) text += std::string(", ") + name + " " + numberText(value) + unit;
  };
  add("fx", k.fx, "");
  add("fy", k.fy, "");
  add("cx", k.cx, "");
  add("cy", k.cy, "");
  add("across", fov[0] == notGiven ? fov[0] : fourDigits(fov[0]), "°");
  add("down", fov[1] == notGiven ? fov[1] : fourDigits(fov[1]), "°");
  return text;
}

}  // namespace

bool isTraceFile(const std::string& file) {
  constexpr std::size_t sniffed = 1 << 16;
  std::ifstream in(file, std::ios::binary);
  std::string begin(sniffed, '\0');
  in.read(begin.data(), std::streamsize(begin.size()));
  const bool isWhole = std::size_t(in.gcount()) < begin.size();
  begin.resize(std::size_t(in.gcount()));
  if (!isWhole) begin.resize(begin.rfind('\n') == std::string::npos ? 0 : begin.rfind('\n'));
  if (begin.find('\0') != std::string::npos) return false;
  try {
    (void)readTrace(begin, anyDistance);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

void printCameraFile(std::ostream& out, const std::string& file) {
  const CameraFile read = readCameraFile(file, CameraUse::poses);
  constexpr std::size_t most = 8;
  out << "cameras     " << read.cameras.size() << ", " << read.format << "\n";
  for (std::size_t k = 0; k < std::min(most, read.cameras.size()); ++k) {
    const FileCamera& camera = read.cameras[k];
    out << "camera      " << printable(camera.name) << ": " << pictureText(camera.calibration)
        << "\n"
        << "  lens      " << lensText(camera) << "\n";
    if (camera.pose)
      out << "  place     " << placeText(camera.pose->origin) << (read.hasScale ? " m" : "")
          << ", looks along " << placeText(camera.pose->zAxis) << "\n";
  }
  if (read.cameras.size() > most)
    out << "            … and " << read.cameras.size() - most << " more\n";
  std::vector<RigidTransform> poses;
  for (const FileCamera& camera : read.cameras)
    if (camera.pose) poses.push_back(*camera.pose);
  out << "poses       " << poses.size() << " of " << read.cameras.size();
  if (!poses.empty())
    out << ", at " << rangeText(poses, [](const RigidTransform& pose) { return pose.origin; })
        << (!read.hasScale ? ", in no unit that is said"
            : read.isRig   ? " m from the first"
                           : " m");
  out << "\n";
  for (const std::string& note : read.notes) out << "warning     " << note << "\n";
}

void printTraceFile(std::ostream& out, const std::string& file) {
  std::vector<std::string> notes;
  const Trace trace = inFile(
      file, [&] { return readTrace(readTextFile(file), anyDistance, TraceParams(), &notes); });
  out << "trace       " << trace.points.size() << " lines, "
      << numberText(fourDigits(trace.points.back().time)) << " s\n"
      << "places      "
      << rangeText(trace.points, [](const Trace::Point& point) { return point.eye; }) << " m\n";
  for (const std::string& note : notes) out << "warning     " << note << "\n";
}

}  // namespace hogelscope
