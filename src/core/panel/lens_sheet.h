// SPDX-License-Identifier: BSD-3-Clause
// A sheet of slanted cylindrical lenses over the sub-pixels of a panel, such as a Looking Glass has
// (docs/formulas.md, Lens sheet).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parameters.h"

namespace hogelscope {

/// The places of a pixel's red, green and blue, px from its middle: to the right, upwards.
using SubPixels = std::array<std::array<double, 2>, 3>;

/// One unit's figures, as its vendor counts them.
struct SheetParams {
  double pitch = notGiven;         ///< lenses an inch, across the lenses
  double slope = notGiven;         ///< a lens goes up by −slope for each unit to the right
  double center = notGiven;        ///< phase of the panel's middle, periods of the views
  double dpi = notGiven;           ///< pixels an inch
  std::array<int, 2> panel{0, 0};  ///< px
  double cone = notGiven;          ///< angle into which a lens spreads what is behind it, degrees
  bool operator==(const SheetParams&) const = default;
};

/// Throws InputError for a figure that is missing, and for a slope of 0.
void check(const SheetParams& params);
void describe(ParameterVisitor& v, SheetParams& p);

/// A calibration: its figures, and where the sub-pixels are.
struct SheetCalibration {
  std::string serial{};
  SheetParams params;
  /// The kinds of pixels; one: vertical stripes of red, green and blue.
  std::vector<SubPixels> cells{{{{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 0}}}};
  int pattern = 0;  ///< how kinds alternate, CellPatternMode 0 … 4
  bool operator==(const SheetCalibration&) const = default;
};

/// A display that is a sheet over a panel, at a place. Of the display's fields, the calibration
/// gives size and field; hogels are the panel's pixels, of one direction.
struct SheetDisplay {
  SheetCalibration calibration;
  std::string file{};            ///< the document that names it, which must say the same; "": none
  double viewingDistance = 0.6;  ///< where all lenses show the same view, metres
  std::array<double, 2> emitter{
      1.0 / 3, 1.0};  ///< width and height of a sub-pixel, px; meet() uses the width
  bool operator==(const SheetDisplay&) const = default;
};
void describe(ParameterVisitor& v, SheetDisplay& p);

/// Tells where a ray meets the panel: column from the left, row from the top, both maybe beside it.
struct SheetHit {
  double column;
  double row;
};

/// A sheet before its panel. Lengths are metres; x is to the right, y upwards from the middle, and
/// z = 0 is the lenses' plane, behind which the pixels are.
class LensSheet {
 public:
  /// Throws InputError as check() does.
  explicit LensSheet(const SheetDisplay& display);

  [[nodiscard]] const SheetCalibration& calibration() const { return m_calibration; }
  [[nodiscard]] double pixel() const { return m_pixel; }  ///< pitch of the pixels
  [[nodiscard]] const std::array<double, 2>& size() const { return m_size; }  ///< of the panel
  /// Returns the period of the lenses' images along x, p = (0.0254/pitch)/cos(atan(1/slope)).
  [[nodiscard]] double period() const { return m_period; }
  /// Returns the number of lenses along the panel's width, P.
  [[nodiscard]] double lenses() const { return m_size[0] / m_period; }
  /// Returns the angle of the lenses to the vertical, degrees; positive: the top leans to the
  /// right.
  [[nodiscard]] double slant() const;
  /// Returns the distance from lenses to pixels, in air, g = p/(2 tan(cone/2)).
  [[nodiscard]] double gap() const { return m_gap; }

  /// Returns which of `views`, 0 from the left, a pixel's sub-pixel shows: ⌊N(1 − frac φ)⌋ at its
  /// own place. Columns count from the left, rows from the top.
  [[nodiscard]] int viewOf(int column, int row, std::size_t channel, int views) const;

  /// Returns the sub-pixel of one colour that a ray meets through the sheet: on the lens's line
  /// behind which the ray ends, the nearest one. None if the eye is not in front of the lenses or
  /// the ray points away.
  [[nodiscard]] std::optional<SheetHit> meet(const Vec3& eye, const Vec3& direction,
                                             std::size_t channel) const;

 private:
  /// Returns the sub-pixels of a pixel, column and row from the left and the bottom.
  [[nodiscard]] const SubPixels& cellsAt(int column, int rowUp) const;

  SheetCalibration m_calibration;
  double m_pixel;
  std::array<double, 2> m_size;
  double m_period;
  double m_gap;
  double m_perSlope;    ///< 1/slope
  double m_phase;       ///< φ₀
  double m_lensPeriod;  ///< p/(1 + g/D)
  double m_emitter;
};

}  // namespace hogelscope
