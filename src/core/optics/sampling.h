// SPDX-License-Identifier: BSD-3-Clause
// The session's `sampling`: how rays pass through the lens and become pixels.
#pragma once

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

/// Returns the name used in documents.
std::string_view nameOf(Reconstruction reconstruction);

}  // namespace hogelscope
