// SPDX-License-Identifier: BSD-3-Clause
#include "io/twin/twin_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/panel/hogel_lens.h"
#include "io/files/atomic_file.h"
#include "io/files/system_limits.h"
#include "io/images/channel_file.h"
#include "io/images/image_file.h"
#include "io/images/image_writer.h"
#include "io/twin/direction_fit.h"
#include "io/twin/measured_directions.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

enum class MapRange { any, notNegative, positive };

/// A channel of a file and the plane that it is; Plane is TwinPlane, const where it is written.
template <class Plane>
struct MapChannel {
  std::string name;
  Plane* plane = nullptr;
  MapRange range = MapRange::any;
};

template <class Plane>
using MapChannels = std::vector<MapChannel<Plane>>;

template <class Plane, class Planes>
void addGains(MapChannels<Plane>& channels, Planes& gain) {
  constexpr std::array names{"gain.R", "gain.G", "gain.B"};
  for (std::size_t c = 0; c < names.size(); ++c)
    channels.push_back({names[c], &gain[c], MapRange::notNegative});
}

template <class Plane, class Maps>
MapChannels<Plane> hogelChannels(Maps& maps) {
  MapChannels<Plane> channels{{"shift.x", &maps.shiftX},
                              {"shift.y", &maps.shiftY},
                              {"tilt.x", &maps.tiltX},
                              {"tilt.y", &maps.tiltY},
                              {"gap", &maps.gap}};
  addGains(channels, maps.gain);
  return channels;
}

MapChannels<TwinPlane> directionChannels(TwinMaps& maps) {
  MapChannels<TwinPlane> channels{
      {"move.u", &maps.moveU}, {"move.v", &maps.moveV}, {"sigma", &maps.sigma, MapRange::positive}};
  addGains(channels, maps.directionGain);
  return channels;
}

/// Returns names for an error line, the first of very many.
std::string listOf(const std::vector<std::string>& names) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, names.size()); ++k)
    text += (k == 0 ? "" : ", ") + names[k];
  return names.size() > most ? text + ", …" : text;
}

/// Throws InputError if a file has more pixels than the display has of `what`.
void checkSize(const ChannelFile& file, const std::array<int, 2>& most, const std::string& what) {
  if (file.width() > std::size_t(most[0]) || file.height() > std::size_t(most[1]))
    throw InputError(file.file().string(), "size",
                     pairText(int(file.width()), int(file.height())) + " px are more than the " +
                         pairText(most[0], most[1]) + " " + what);
}

TwinPlane planeOf(ChannelFile& file, std::size_t channel, MapRange range,
                  const Progress& progress) {
  TwinPlane plane{int(file.width()), int(file.height()), file.read(channel, progress)};
  const auto bad = std::ranges::find_if(plane.values, [range](float value) {
    return range != MapRange::any && !(range == MapRange::positive ? value > 0 : value >= 0);
  });
  if (bad == plane.values.end()) return plane;
  throw file.errorAt(channel, std::size_t(bad - plane.values.begin()),
                     "is " + numberText(double(*bad)) +
                         (range == MapRange::positive ? ", not above 0" : ", below 0"));
}

/// Fills the planes of the channels that a file has.
void readChannels(ChannelFile& file, const MapChannels<TwinPlane>& channels,
                  const Progress& progress) {
  std::vector<std::string> known;
  for (const auto& channel : channels) known.push_back(channel.name);
  for (const std::string& name : file.names())
    if (std::ranges::find(known, name) == known.end())
      throw InputError(file.file().string(), "channel \"" + name + "\"",
                       "is not one of " + listOf(known));
  const auto count = double(file.names().size());
  for (std::size_t k = 0; k < file.names().size(); ++k) {
    const auto at = std::ranges::find(known, file.names()[k]) - known.begin();
    const auto& [name, plane, range] = channels[std::size_t(at)];
    *plane = planeOf(file, k, range, part(progress, double(k) / count, double(k + 1) / count));
  }
}

void readHogels(const fs::path& path, const PanelParams& design, TwinMaps& maps,
                const Progress& progress) {
  ChannelFile file(path);
  checkSize(file, design.hogels, "hogels of the display");
  readChannels(file, hogelChannels<TwinPlane>(maps), progress);
}

void readHeight(const fs::path& path, TwinMaps& maps, const Progress& progress) {
  constexpr int largest = 16384;
  ChannelFile file(path);
  checkSize(file, {largest, largest}, "that a height map may have");
  const std::vector<std::string>& names = file.names();
  const auto found = std::ranges::find(names, "height");
  if (found == names.end() && names.size() > 1)
    throw InputError(path.string(), "",
                     "has no channel \"height\", but several others: " + listOf(names));
  const std::size_t channel = found == names.end() ? 0 : std::size_t(found - names.begin());
  maps.height = planeOf(file, channel, MapRange::any, progress);
}

/// Returns by how many pixels of the design the pixels with these slopes are off, along an axis.
TwinPlane movesOf(const MeasuredDirections& table, std::size_t axis, const PanelParams& design,
                  const fs::path& file) {
  const std::shared_ptr<const HogelLens> lens = lensOf(design, axis);
  const int count = table.size[axis];
  const int sign = axis == 0 ? 1 : -1;  // v runs downwards
  TwinPlane plane{table.size[0], table.size[1], {}};
  for (int v = 0; v < plane.height; ++v)
    for (int u = 0; u < plane.width; ++u) {
      const double slope = table.values[axis][table.at(u, v)];
      const double designed = (axis == 0 ? u : v) + 0.5;
      const auto move =
          static_cast<float>(count * (0.5 + sign * lens->directionOf(slope)) - designed);
      if (!std::isfinite(move))
        throw InputError(file.string(),
                         "direction (" + std::to_string(u) + ", " + std::to_string(v) + ")",
                         "has the slope " + numberText(slope) +
                             ", which the display's hogel lens does not send");
      plane.values.push_back(move);
    }
  return plane;
}

void readTable(const fs::path& path, const PanelParams& design, TwinMaps& maps,
               std::vector<std::string>* warnings) {
  constexpr std::size_t bytes = 500;  // of a direction: the table, five planes, the fit's matrices
  checkFits(double(bytes) * design.directions[0] * design.directions[1], path);
  const std::string text = readTextFile(path);
  MeasuredDirections table =
      inFile(path.string(), [&] { return parseMeasuredDirections(text, design.directions); });
  const auto [given, fitted, degree, error] =
      inFile(path.string(), [&] { return fitDirections(table); });
  maps.moveU = movesOf(table, 0, design, path);
  maps.moveV = movesOf(table, 1, design, path);
  for (std::size_t c = 0; c < 3 && table.values.size() > 2; ++c) {
    const std::vector<double>& light = table.values[table.values.size() == 3 ? 2 : 2 + c];
    maps.directionGain[c] = {table.size[0], table.size[1], {light.begin(), light.end()}};
  }
  constexpr std::array degrees{"", "linear", "quadratic", "cubic"};
  if (fitted > 0 && warnings != nullptr)
    warnings->push_back(path.string() + ": has " + std::to_string(given) + " of " +
                        std::to_string(given + fitted) + " directions; the other " +
                        std::to_string(fitted) + " come from a " + degrees[std::size_t(degree)] +
                        " polynomial, from which the slopes of the given ones are " +
                        numberText(fourDigits(error)) + " away (rms)");
}

void readDirections(const fs::path& path, const PanelParams& design, TwinMaps& maps,
                    const Progress& progress, std::vector<std::string>* warnings) {
  if (lowerCase(path.extension().string()) == ".csv")
    return readTable(path, design, maps, warnings);
  ChannelFile file(path);
  checkSize(file, design.directions, "directions of a hogel");
  readChannels(file, directionChannels(maps), progress);
}

/// Reads kernels of each colour; Twin checks their sizes and weights.
void readKernels(const fs::path& path, TwinMaps& maps, const Progress& progress) {
  constexpr std::size_t largest = 16384;
  ImageFile file(path);
  if (file.width() > largest || file.height() > largest)
    throw InputError(path.string(), "size", "is above 16384 px across or down");
  checkFits(3.0 * sizeof(float) * double(file.width() * file.height()), path);
  for (TwinPlane& plane : maps.kernels)
    plane = {int(file.width()), int(file.height()),
             std::vector<float>(file.width() * file.height())};
  file.readRows(
      [&](std::size_t y, const float* rgb) {
        for (std::size_t x = 0; x < file.width(); ++x)
          for (std::size_t c = 0; c < 3; ++c)
            maps.kernels[c].values[y * file.width() + x] = rgb[3 * x + c];
      },
      progress);
}

}  // namespace

TwinMaps readTwinMaps(const TwinMapFiles& files, const PanelParams& design,
                      const Progress& progress, std::vector<std::string>* warnings) {
  TwinMaps maps;
  throwIfCancelled(progress);
  if (!files.hogels.empty()) readHogels(files.hogels, design, maps, part(progress, 0, 1.0 / 3));
  if (!files.directions.empty())
    readDirections(files.directions, design, maps, part(progress, 1.0 / 3, 2.0 / 3), warnings);
  if (!files.height.empty()) readHeight(files.height, maps, part(progress, 2.0 / 3, 0.9));
  if (!files.kernels.empty()) readKernels(files.kernels, maps, part(progress, 0.9, 1));
  return maps;
}

void writeHogelMaps(const fs::path& file, const TwinMaps& maps) {
  if (lowerCase(file.extension().string()) != ".exr")
    throw InputError(file.string(), "cannot be written",
                     "channels have names in EXR alone; give it the extension .exr");
  const auto channels = hogelChannels<const TwinPlane>(maps);
  int width = 0;
  int height = 0;
  for (const auto& channel : channels) {
    width = std::max(width, channel.plane->width);
    height = std::max(height, channel.plane->height);
  }
  if (width == 0) throw std::logic_error("writeHogelMaps: no map of the hogels");
  std::vector<std::pair<std::string, std::vector<float>>> planes;
  for (const auto& [name, plane, range] : channels) {
    if (plane->isEmpty()) continue;
    std::vector<float>& values = planes.emplace_back(name, std::vector<float>{}).second;
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) values.push_back(plane->atCell(i, j, width, height));
  }
  writePlanes(file, width, height, planes);
}

}  // namespace hogelscope
