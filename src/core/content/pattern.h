// SPDX-License-Identifier: BSD-3-Clause
// Test content in closed form for light fields of any size: one row of the hogel image at a time.
#pragma once

#include <cstdint>

#include "core/panel/display.h"

namespace hogelscope {

/// The parameters of a pattern. Lengths are in metres, angles in degrees.
struct PatternParams {
  double depth = 0.1;
  double period = 0.05;
  double angle = 5;
};

void describe(ParameterVisitor& v, PatternParams& p);

class Pattern {
 public:
  virtual ~Pattern() = default;
  /// Writes row y of the hogel image (layout `hogels`): 8-bit RGB of its nx·du pixels. May be
  /// called from several threads.
  virtual void row(int y, std::uint8_t* rgb) const = 0;
};

}  // namespace hogelscope
