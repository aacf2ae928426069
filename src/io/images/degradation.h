// SPDX-License-Identifier: BSD-3-Clause
// Degrades a light field like a codec, a sensor or a lens, one row of hogels at a time.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/progress.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

struct Degradation {
  enum class Kind { none, jpeg, noise, blur };
  Kind kind = Kind::none;
  double amount = 0;       ///< quality 1 … 100; σ in code values; σ in directional pixels
  std::uint64_t seed = 1;  ///< seed of the noise
};

/// Parses a text such as "jpeg:60", "noise:2" or "blur:1". Throws InputError.
Degradation parseDegradation(const std::string& text);

/// Degrades the j-th row of hogels, `band`: dv rows of 3·nx·du values. jpeg: encoded and decoded by
/// OpenCV (4:2:0), each row of hogels as a separate image, in pieces of at most 65 488 columns; if
/// dv is a multiple of 16, equal to coding the whole image, except for the colour of the rows at
/// its border, which decoders smooth across blocks. noise: Gaussian, independent for each value,
/// depending on its place and the seed only. blur: Gaussian within each hogel, with its edge
/// repeated. Throws Cancelled.
void degrade(const Degradation& degradation, const LightFieldSize& size, int j,
             std::span<std::uint8_t> band, const Progress& progress = {});

}  // namespace hogelscope
