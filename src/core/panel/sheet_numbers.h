// SPDX-License-Identifier: BSD-3-Clause
// Computes what a lens sheet with N views shows to an eye, in closed form (docs/formulas.md, Lens
// sheet). With pixels of the pitch q whose sub-pixels are w wide, lenses of the period p and the
// slope 1/m, and the gap g behind them, one view is p/(N g) of slope beside the next. Its light
// spreads over more: the view's own step, the sub-pixel's width and, since lenses are slanted, a
// row's height make it as wide as an even spread of
//
//     s = √((p/N)² + (w q)² + (m q)² + 12 σ²)/g
//
// which has the same variance; σ is the display's spot. A depth is sharp as on a display of hogels
// (core/panel/design_numbers.h): a grating that the eye sees as 1/(2p) on the panel has at least
// sinc(1/2) of the contrast that it has there, by sheetContrast(). More views make s no smaller
// than their sub-pixels do, and no depth sharper.
#pragma once

#include <array>

#include "core/panel/design_numbers.h"
#include "core/panel/lens_sheet.h"

namespace hogelscope {

/// Lengths are metres. What depends on the eye is 0 if the eye is not in front of the lenses.
struct SheetNumbers : SharpDepths {
  int views = 0;                  ///< N
  double period = 0;              ///< p, the sheet's resolution across
  double cone = 0;                ///< degrees
  double lobe = 0;                ///< rms of what one place sees about its view, in views
  double viewSlope = 0;           ///< p/(N g), from one view to the next
  double slopeSpread = 0;         ///< s, of one view's light
  double viewsPerMetre = 0;       ///< as the eye moves to the right
  double viewsPerPanelMetre = 0;  ///< to the right along the panel; 0 from the viewing distance
  std::array<double, 2> flips{};  ///< x of the eye at which the panel's middle shows the other end
  double viewsFront = 0;   ///< what is nearer shifts by more than a lens from view to view; ≥ 0
  double viewsBehind = 0;  ///< likewise behind the panel

  /// Returns x of the cone's middle at the eye's distance.
  [[nodiscard]] double middle() const { return (flips[0] + flips[1]) / 2; }
  /// Returns the width of the cone at the eye's distance, from one flip to the next.
  [[nodiscard]] double width() const { return flips[1] - flips[0]; }
  /// Returns the share of the places of a head from which a flip is between its eyes, so that they
  /// see their pictures exchanged.
  [[nodiscard]] double pseudoscopic(double ipd) const;
};

/// `views` is at least 1; `eye` is in the display frame. Throws InputError as check(SheetParams).
SheetNumbers sheetNumbers(const SheetDisplay& display, int views, const Vec3& eye);

/// Returns the contrast that a pinhole sees of a grating of so many cycles/m on the plane z
/// (metres in front of the pixels), whose lines are perpendicular to the axis 0, across, or 1, up:
///
///     across   sinc(f p (1 + m² z/D)/(1 + m²)) · sinc(f q (1 − z/D − w z/g)) · sinc(f q m z/g)
///              · sinc(f z p/(N g)) · Σ w_k cos(2π f k q (1 − z/D − z/g))
///     up       sinc(f' p m/(1 + m²)) · sinc(f' q (1 − w)/m) · sinc(f' q),    f' = f (1 − z/D)
///
/// D the viewing distance, w_k spotWeights(). The quilt's own pixels are not counted. Throws
/// likewise.
double sheetContrast(const SheetDisplay& display, int views, double frequency, double z,
                     std::size_t axis);

/// Returns the share of the sums of two numbers, even over the widths a > 0 and b > 0 about 0, that
/// are in low … high.
double shareOfSums(double low, double high, double a, double b);

/// Returns the share of the light that a place shows an eye of views from `low` to `high`, counted
/// from where the eye is among them: sums over the widths w and m of N q/p views, for each pixel of
/// the spot.
double lobeShare(const SheetDisplay& display, int views, double low, double high);

/// Returns the share of the panel that shows an eye what is at its own place among the views, and
/// not their repetition beyond a flip.
double shareInCone(const SheetDisplay& display, const Vec3& eye);

}  // namespace hogelscope
