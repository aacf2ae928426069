// SPDX-License-Identifier: BSD-3-Clause
// The range in which a lens model is valid, for --explain, the report and the distortion dock. It
// is computed from the rays that images use. Along 720 directions it marches in steps in which the
// Jacobian's least eigenvalue cannot reach 0, so no fold is stepped over.
#pragma once

#include <string>

#include "core/lens/lens_table.h"

namespace hogelscope {

struct LensCertificate {
  double validRadius = 0;      ///< the model is one-to-one within it, in units of the plane z = 1
  double reach = 0;            ///< largest |ideal point| that a pixel of the image has
  double worstResidual = 0;    ///< largest |model(ideal) - pixel|, in pixels; 0 for direct mapping
  std::size_t withoutRay = 0;  ///< pixels
  std::size_t pixels = 0;
  bool endsAtRightAngle = false;  ///< a fisheye that does not fold before 90° off the axis
};

/// Certifies the rays of the pixels' centres, the same that images use. Throws Cancelled.
LensCertificate certify(const LensKey& lens, const ParallelRows& parallelRows,
                        const Progress& progress = {});

/// Returns the distance from the centre to the nearest point where the Jacobian is singular, over
/// 720 directions, or one if all are alike; infinite if there is none within 100 (89.4° off the
/// axis).
double validRadius(const Distortion& distortion, const Progress& progress = {});

/// Describes a certificate in one line.
std::string certificateText(const LensCertificate& certificate);

}  // namespace hogelscope
