// SPDX-License-Identifier: BSD-3-Clause
// The session's `sampling`: how rays are taken through the lens and turned into pixels.
#pragma once

#include "core/base/parameters.h"

namespace hogelscope {

enum class LensMapping { exact, direct };
enum class Reconstruction { nearest, bilinear, quadrilinear };

struct SamplingParams {
  LensMapping mapping = LensMapping::exact;
  Reconstruction reconstruction = Reconstruction::nearest;
  int samplesPerPixel = 1;
  double tolerance = 0;  ///< RMS error that a cheaper picture may have, code values
  bool operator==(const SamplingParams&) const = default;
};

void describe(ParameterVisitor& v, SamplingParams& p);

/// As documents write it.
std::string_view nameOf(Reconstruction reconstruction);

}  // namespace hogelscope
