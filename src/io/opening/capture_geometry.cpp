// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/capture_geometry.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

constexpr double metresPerMillimetre = 1e-3;

/// The second word of each line of a file by its first; "=" counts as a space, lines that begin
/// with "#" or "[" are ignored.
class Settings {
 public:
  explicit Settings(const fs::path& file) : m_file(file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > mostBytes) return;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      std::ranges::replace(line, '=', ' ');
      std::istringstream words(line);
      std::string name;
      std::string value;
      if (words >> name >> value && name[0] != '#' && name[0] != '[') m_values[name] = value;
    }
  }

  /// Returns a value, none if it is missing. Throws InputError unless it is a number above 0.
  [[nodiscard]] std::optional<double> find(const std::string& name) const {
    const auto found = m_values.find(name);
    if (found == m_values.end()) return std::nullopt;
    const std::string& text = found->second;
    const std::optional<double> value = numberOf(text);
    if (!value || !(*value > 1e-9 && *value < 1e9))
      throw InputError(m_file.string(), name,
                       "is \"" + text.substr(0, 40) + "\", not a number above 0");
    return value;
  }

 private:
  static constexpr std::uintmax_t mostBytes = 1 << 20;

  fs::path m_file;
  std::map<std::string, std::string> m_values;
};

/// Returns what a camera sees at a distance; `sensor` is the longer side of the view, in the unit
/// of `focal`.
std::array<double, 2> seenOf(double distance, double focal, double sensor, int width, int height) {
  const double longer = std::max(width, height);
  return {distance * sensor / focal * width / longer, distance * sensor / focal * height / longer};
}

std::optional<CaptureGeometry> ofHci(const fs::path& file, int width, int height) {
  const Settings settings(file);
  const auto spacing = settings.find("baseline_mm");
  const auto distance = settings.find("focus_distance_m");
  const auto focal = settings.find("focal_length_mm");
  const auto sensor = settings.find("sensor_size_mm");
  if (!spacing || !distance || !focal || !sensor) return std::nullopt;
  const double metres = *spacing * metresPerMillimetre;
  return CaptureGeometry{
      seenOf(*distance, *focal, *sensor, width, height), {metres, metres}, *distance, {0, 0}};
}

/// Returns the last two numbers of a name like "…_369.2_307.7_30_36.jpg".
std::optional<std::array<double, 2>> lastNumbers(const fs::path& file) {
  std::string stem = file.stem().string();
  std::array<double, 2> numbers{};
  for (std::size_t k = 2; k-- > 0;) {
    const std::size_t at = stem.rfind('_');
    if (at == std::string::npos) return std::nullopt;
    numbers[k] = numberOf(std::string_view(stem).substr(at + 1)).value_or(0);
    if (!(numbers[k] > 0)) return std::nullopt;
    stem.resize(at);
  }
  return numbers;
}

std::optional<CaptureGeometry> ofRenderer(const fs::path& file, const ViewFiles& views, int width,
                                          int height) {
  const auto distance = Settings(file).find("focus-distance");
  const auto camera = views.files.empty() ? std::nullopt : lastNumbers(views.found().front());
  if (!distance || !camera || !views.columnsFromTo || !views.rowsFromTo) return std::nullopt;
  const auto spacing = [](const std::array<double, 2>& fromTo, int count) {
    return count > 1 ? std::abs(fromTo[1] - fromTo[0]) / (count - 1) * metresPerMillimetre : 0;
  };
  const double across = spacing(*views.columnsFromTo, views.columns);
  const double down = spacing(*views.rowsFromTo, views.rows);
  const double longer = std::max(across, down);
  if (!(longer > 0)) return std::nullopt;
  CaptureGeometry geometry{seenOf(*distance, (*camera)[0], (*camera)[1], width, height),
                           {across > 0 ? across : longer, down > 0 ? down : longer},
                           *distance,
                           {}};
  geometry.shear = {geometry.spacing[0] / geometry.panel[0] * width,
                    geometry.spacing[1] / geometry.panel[1] * height};
  return geometry;
}

/// A grid of cameras in the pixels of their views.
struct GridInPixels {
  std::array<double, 2> focal{};  ///< the mean focal lengths
  /// How far the point at infinity towards which the cameras look moves in the picture from one
  /// camera to the next to the right, and below: 0 unless they turn or their sensors are shifted.
  std::array<double, 2> drift{};
};

GridInPixels gridInPixels(const ViewCameras& views, int width, int height) {
  const CameraGrid& grid = views.grid;
  GridInPixels result;
  std::array<double, 2> squares{};
  const double count = double(grid.cameras.size());
  for (std::size_t k = 0; k < grid.cameras.size(); ++k) {
    const FileCamera& camera = views.cameras[grid.cameras[k]];
    const Calibration own = completed(camera.calibration, {width, height});
    const IntrinsicsParams& in = own.intrinsics;
    const std::array size{width, height};
    const std::array lengths{in.fx, in.fy == notGiven ? in.fx : in.fy}, centres{in.cx, in.cy};
    const double along = dot(camera.pose->zAxis, grid.forward);
    const std::array slopes{dot(camera.pose->xAxis, grid.forward) / along,
                            dot(camera.pose->yAxis, grid.forward) / along};
    const auto row = int(k) / grid.columns, column = int(k) % grid.columns;
    const std::array places{column - (grid.columns - 1) / 2.0, row - (grid.rows - 1) / 2.0};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double scale = double(size[axis]) / (*own.res)[axis];
      const double focal = lengths[axis] * scale;
      const double centre = centres[axis] == notGiven ? 0 : centres[axis] * scale;
      result.focal[axis] += focal / count;
      result.drift[axis] += places[axis] * (centre + focal * slopes[axis]);
      squares[axis] += places[axis] * places[axis];
    }
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (squares[axis] > 0) result.drift[axis] /= squares[axis];
  return result;
}

/// Returns the distance at which the views coincide with their shear, by least squares over both
/// axes; none, with a line, if content hardly moves or not as it would before these cameras.
std::optional<double> focusOf(const GridInPixels& pixels, const std::array<double, 2>& spacing,
                              const std::array<double, 2>& shear, std::string& why) {
  std::array<double, 2> lengths{}, moved{};  // px · m and px, of which the quotient is the distance
  for (std::size_t axis = 0; axis < 2; ++axis) {
    lengths[axis] = pixels.focal[axis] * spacing[axis];
    if (spacing[axis] > 0) moved[axis] = shear[axis] + pixels.drift[axis];
  }
  const double square = lengths[0] * lengths[0] + lengths[1] * lengths[1];
  const double perDistance = (lengths[0] * moved[0] + lengths[1] * moved[1]) / square;
  constexpr double leastMotion = 0.1, tolerance = 0.2;  // px per view; relative
  const double motion = perDistance * std::sqrt(square);
  if (!(motion >= leastMotion)) {
    why = "the views' content hardly moves, or as it would behind the cameras";
    return std::nullopt;
  }
  const double residual =
      std::hypot(moved[0] - perDistance * lengths[0], moved[1] - perDistance * lengths[1]);
  if (!(residual <= std::max(leastMotion, tolerance * motion))) {
    why = "the views' content moves by other parts across and down than their cameras do";
    return std::nullopt;
  }
  return 1 / perDistance;
}

bool isInRange(const CaptureGeometry& geometry, const std::array<double, 2>& fov) {
  constexpr double least = 1e-5, most = 1e5, leastAngle = 0.01, mostAngle = 179.9, mostShear = 1e4;
  const auto isSize = [](double value) { return value > least && value < most; };
  return std::ranges::all_of(geometry.panel, isSize) && isSize(geometry.distance) &&
         std::ranges::all_of(
             fov, [](double value) { return value >= leastAngle && value <= mostAngle; }) &&
         std::ranges::all_of(geometry.shear,
                             [](double value) { return std::abs(value) <= mostShear; });
}

}  // namespace

std::array<double, 2> CaptureGeometry::fovOf(int columns, int rows) const {
  const auto angle = [&](int count, double step) {
    return 360 / std::numbers::pi * std::atan(count * step / (2 * distance));
  };
  return {angle(columns, spacing[0]), angle(rows, spacing[1])};
}

std::optional<CaptureGeometry> captureGeometry(const fs::path& folder, const ViewFiles& views,
                                               int width, int height) {
  if (auto geometry = ofHci(folder / "parameters.cfg", width, height)) return geometry;
  return ofRenderer(folder / "config.cfg", views, width, height);
}

std::optional<CaptureGeometry> captureGeometry(const ViewCameras& cameras, const KnownFocus& focus,
                                               int width, int height, std::string& why) {
  const GridInPixels pixels = gridInPixels(cameras, width, height);
  const auto& [focal, drift] = pixels;
  const auto& spacing = cameras.grid.spacing;
  std::optional<double> distance;
  if (focus.distance > 0)
    distance = focus.distance;
  else if (focus.shear)
    distance = focusOf(pixels, spacing, *focus.shear, why);
  else
    why = "no shear was found in the views";
  const std::string file =
      cameras.order.file + ": its cameras do not say the distance of the panel";
  if (!distance) {
    why = file + ", and " + why + "; give lightField.viewingDistance";
    return std::nullopt;
  }
  CaptureGeometry geometry{
      {*distance * width / focal[0], *distance * height / focal[1]}, spacing, *distance, {}};
  for (std::size_t axis = 0; axis < 2; ++axis)
    geometry.shear[axis] =
        spacing[axis] > 0 ? focal[axis] * spacing[axis] / *distance - drift[axis] : 0;
  for (double& step : geometry.spacing)  // one line of views has an angle down, or across, too
    if (!(step > 0)) step = std::max(spacing[0], spacing[1]);
  if (isInRange(geometry, geometry.fovOf(cameras.grid.columns, cameras.grid.rows))) return geometry;
  why = file + ", and that by the views, " + numberText(*distance) +
        " m, makes no display; give lightField.viewingDistance";
  return std::nullopt;
}

}  // namespace hogelscope
