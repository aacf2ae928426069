// SPDX-License-Identifier: BSD-3-Clause
// A display and the maps that are read for it, for tests of twins' files.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/twin/twin_maps.h"
#include "tests/io/documents.h"

/// A display of 40 mm × 30 mm.
inline hogelscope::PanelParams designOf(std::array<int, 2> hogels = {4, 3},
                                        std::array<int, 2> directions = {8, 8}) {
  hogelscope::PanelParams design;
  design.size = {0.04, 0.03};
  design.hogels = hogels;
  design.directions = directions;
  design.fov = {50, 40};
  return design;
}

/// Returns the file at its place, by the first letters of its name.
inline hogelscope::TwinMapFiles filesOf(const std::string& file) {
  hogelscope::TwinMapFiles files;
  (file.starts_with("hogels")   ? files.hogels
   : file.starts_with("height") ? files.height
                                : files.directions) = file;
  return files;
}

inline hogelscope::TwinMaps read(const std::string& file,
                                 const hogelscope::PanelParams& design = designOf(),
                                 std::vector<std::string>* warnings = nullptr) {
  return hogelscope::readTwinMaps(filesOf(file), design, {}, warnings);
}

/// Returns the line of the error; empty if there is none.
inline QByteArray errorWith(const std::string& file) {
  return errorOf([&] { (void)read(file); }).toUtf8();
}

/// Whether a plane has this size and exactly these values.
inline bool isPlane(const hogelscope::TwinPlane& plane, int width, int height,
                    const std::vector<float>& values) {
  return plane.width == width && plane.height == height && plane.values == values;
}

/// Of a const or another TwinMaps: the hogels' in the order of their channels, the directions', the
/// panel's.
template <class Maps>
auto allPlanes(Maps& maps) {
  return std::array{&maps.shiftX,
                    &maps.shiftY,
                    &maps.tiltX,
                    &maps.tiltY,
                    &maps.gap,
                    &maps.gain[0],
                    &maps.gain[1],
                    &maps.gain[2],
                    &maps.moveU,
                    &maps.moveV,
                    &maps.sigma,
                    &maps.directionGain[0],
                    &maps.directionGain[1],
                    &maps.directionGain[2],
                    &maps.height};
}

/// Which of allPlanes() have values, as "0" and "1".
inline std::string filled(const hogelscope::TwinMaps& maps) {
  std::string text;
  for (const hogelscope::TwinPlane* plane : allPlanes(maps)) text += plane->isEmpty() ? '0' : '1';
  return text;
}
