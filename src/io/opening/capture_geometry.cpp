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
      seenOf(*distance, *focal, *sensor, width, height), {metres, metres}, *distance, true};
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
  return CaptureGeometry{seenOf(*distance, (*camera)[0], (*camera)[1], width, height),
                         {across > 0 ? across : longer, down > 0 ? down : longer},
                         *distance,
                         false};
}

}  // namespace

std::array<double, 2> CaptureGeometry::fovOf(int columns, int rows) const {
  const auto angle = [&](int count, double step) {
    return 360 / std::numbers::pi * std::atan(count * step / (2 * distance));
  };
  return {angle(columns, spacing[0]), angle(rows, spacing[1])};
}

std::array<double, 2> CaptureGeometry::shearOf(int width, int height) const {
  if (isShifted) return {0, 0};
  return {spacing[0] / panel[0] * width, spacing[1] / panel[1] * height};
}

std::optional<CaptureGeometry> captureGeometry(const fs::path& folder, const ViewFiles& views,
                                               int width, int height) {
  if (auto geometry = ofHci(folder / "parameters.cfg", width, height)) return geometry;
  return ofRenderer(folder / "config.cfg", views, width, height);
}

}  // namespace hogelscope
