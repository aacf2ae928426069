// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes a twin's maps, EXRs and tables of directions: what is read has finite values, and no
// negative gains.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/images/channel_file.h"
#include "io/twin/twin_maps.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

namespace {

void check(const TwinPlane& plane, float least = std::numeric_limits<float>::lowest()) {
  require(plane.values.size() == std::size_t(plane.width) * std::size_t(plane.height));
  require(std::all_of(plane.values.begin(), plane.values.end(),
                      [least](float value) { return std::isfinite(value) && value >= least; }));
}

void read(const TwinMapFiles& files) {
  PanelParams design;
  design.hogels = {12, 9};
  design.directions = {8, 8};
  mayRefuse([&] {
    const TwinMaps maps = readTwinMaps(files, design);
    for (const TwinPlane* plane : {&maps.shiftX, &maps.shiftY, &maps.tiltX, &maps.tiltY, &maps.gap,
                                   &maps.moveU, &maps.moveV, &maps.height})
      check(*plane);
    check(maps.sigma, 0);
    for (std::size_t c = 0; c < 3; ++c) {
      check(maps.gain[c], 0);
      check(maps.directionGain[c], 0);
    }
  });
}

}  // namespace

void fuzz(std::string_view input) {
  if (!input.starts_with("\x76\x2f\x31\x01")) {  // fuzz_image has other pictures, which are slow
    TwinMapFiles table;
    table.directions = fileOf("map.csv", input).string();
    return read(table);
  }
  TwinMapFiles pictures;
  pictures.hogels = fileOf("map", input).string();
  read(pictures);
  pictures.directions = std::exchange(pictures.hogels, {});
  read(pictures);
  mayRefuse([&] {
    constexpr double most = 1e6;  // pixels; more of them find nothing new
    const ChannelFile picture(pictures.directions);
    if (double(picture.width()) * double(picture.height()) > most) return;
    pictures.height = std::exchange(pictures.directions, {});
    read(pictures);
  });
}
