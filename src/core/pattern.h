// SPDX-License-Identifier: BSD-3-Clause
// Test content in closed form for light fields of any size: one row of the hogel image at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/display.h"

namespace hogelscope {

/// What --generate makes of a pattern: `pattern` in --set. Lengths in metres, angles in degrees.
struct PatternParams {
  double depth = 0.1;
  double period = 0.05;
  double angle = 5;
};

void describe(ParameterVisitor& v, PatternParams& p);

class Pattern {
 public:
  virtual ~Pattern() = default;
  /// Row y of the hogel image (layout `hogels`): 8-bit RGB of its nx·du pixels. May be called from
  /// several threads.
  virtual void row(int y, std::uint8_t* rgb) const = 0;
};

/// What a pattern is called, and what it shows.
struct PatternName {
  std::string_view name;
  std::string_view help;
};

const std::vector<PatternName>& patternNames();

/// Throws InputError: a name that is not known, a display without hogels or directions.
std::unique_ptr<Pattern> makePattern(const std::string& name, const DisplayParams& display,
                                     const PatternParams& params);

}  // namespace hogelscope
