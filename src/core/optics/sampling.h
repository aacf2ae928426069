// SPDX-License-Identifier: BSD-3-Clause
// The session's `sampling`: how rays pass through the lens and become pixels.
#pragma once

#include <vector>

#include "core/base/geometry.h"
#include "core/base/parameters.h"

namespace hogelscope {

enum class LensMapping { exact, direct };
enum class Reconstruction { nearest, bilinear, quadrilinear };

struct SamplingParams {
  LensMapping mapping = LensMapping::exact;
  Reconstruction reconstruction = Reconstruction::nearest;
  int samplesPerPixel = 1;
  double tolerance = 0;  ///< allowed RMS error of a cheaper image, code values
  bool operator==(const SamplingParams&) const = default;
};

void describe(ParameterVisitor& v, SamplingParams& p);

/// One of the rays of a pixel.
struct RaySample {
  int index = 0;          ///< among the pixel's rays
  Vec2 place{0.5, 0.5};   ///< position in the pixel, 0 … 1 from its upper left corner
  std::size_t point = 0;  ///< of the aperture
};

/// Returns the n × n rays of a pixel, row after row, for each point of the aperture.
std::vector<RaySample> samplesOf(int n, std::size_t points = 1);

/// Returns the name used in documents.
std::string_view nameOf(Reconstruction reconstruction);

}  // namespace hogelscope
