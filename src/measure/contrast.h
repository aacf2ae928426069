// SPDX-License-Identifier: BSD-3-Clause
// The contrast with which a display shows gratings: simulated, and its law (docs/formulas.md,
// Measures of a display).
#pragma once

#include "measure/bench.h"

namespace hogelscope {

/// A grating parallel to the panel, whose lines are perpendicular to an axis.
struct Grating {
  double frequency = 0;  ///< cycles/m on its own plane
  double z = 0;          ///< its plane, metres; less than the eye's distance
};

/// Returns the contrast that the bench's eye sees, as a part of the grating's own: the amplitude of
/// the grating's frequency, averaged over the phases that it may have to hogels and directions,
/// which the eye takes by moving over the width of one direction. Throws InputError, Cancelled.
double contrast(Bench& bench, const Grating& grating, std::size_t axis);

/// Returns the law of the same:
///     sinc(f p) · sinc(f s z) · |Σ w_k cos(2π f s z k)| · 2 J₁(v)/v,   v = π f A |1 − (D − z)/Φ|
/// with hogel pitch p, slope step s, weights w of the leakage, pupil A focused at Φ, and the eye at
/// D. On a display with the viewing distance V, p (1 − z/V) is in place of p. Of a unit also what
/// its UnitLaw changes (docs/formulas.md, Measures of a unit). Of a lens sheet, sheetContrast()
/// times the last factor.
double contrastLaw(const Bench& bench, const Grating& grating, std::size_t axis);

/// Returns how far a lens sheet's picture of the plane z shifts to the right on the panel from one
/// view to the next, as eyes in their middles see it, metres. Throws as contrast().
double shiftOfViews(Bench& bench, double z);

/// Returns the least depth behind the panel (> 0, metres) at which `fall` of a depth comes down to
/// `level`; infinite if it never does. `first` is a depth of about that size.
double depthOfFall(const std::function<double(double depth)>& fall, double level, double first);

}  // namespace hogelscope
