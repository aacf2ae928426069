// SPDX-License-Identifier: BSD-3-Clause
// How far a lens can be trusted: --explain, the report and the distortion dock show it.
#pragma once

#include <string>

#include "core/lens/lens_table.h"

namespace hogelscope {

struct LensCertificate {
  double validRadius = 0;      ///< of the model: one-to-one within it, in units of the plane z = 1
  double reach = 0;            ///< largest |ideal point| that a pixel of the picture has
  double worstResidual = 0;    ///< of model(ideal) - pixel, in pixels; 0 for direct mapping
  std::size_t withoutRay = 0;  ///< pixels
  std::size_t pixels = 0;
};

/// The pixels' centres, with the same rays as the pictures have. Throws Cancelled.
LensCertificate certify(const LensKey& lens, const ParallelRows& parallelRows,
                        const Progress& progress = {});

/// The distance from the centre to the nearest point where the Jacobian is singular, over 720
/// directions; infinite where there is none within 100 (89.4° off the axis).
double validRadius(const Distortion& distortion, const Progress& progress = {});

/// One line.
std::string certificateText(const LensCertificate& certificate);

}  // namespace hogelscope
