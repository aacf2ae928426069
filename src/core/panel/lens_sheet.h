// SPDX-License-Identifier: BSD-3-Clause
// A sheet of slanted cylindrical lenses over the sub-pixels of a panel, such as a Looking Glass has
// (docs/formulas.md, Lens sheet).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parameters.h"
#include "core/light_field/sheet_calibration.h"
#include "core/panel/twin_params.h"

namespace hogelscope {

/// A display that is a sheet over a panel, at a place. Of the display's fields, the calibration
/// gives size and field; hogels are the panel's pixels, of one direction.
struct SheetDisplay {
  SheetCalibration calibration;
  std::string file{};            ///< the document that names it, which must say the same; "": none
  double viewingDistance = 0.6;  ///< where all lenses show the same view, metres
  std::array<double, 2> emitter{
      1.0 / 3, 1.0};  ///< width and height of a sub-pixel, px; meet() uses the width
  /// Standard deviation of the light that a lens takes from beside a ray's place, along the panel's
  /// rows, metres.
  double spot = 0;
  bool operator==(const SheetDisplay&) const = default;
};
void describe(ParameterVisitor& v, SheetDisplay& p);

/// Returns the parts of a ray's light that come from the pixels k = −K … K beside the one that it
/// meets, of a spot that is `sigma` pixels wide: the discrete Gaussian e^−t I_k(t), t = sigma², of
/// just that variance (Lindeberg 1990). Their sum is 1.
std::vector<double> spotWeights(double sigma);

/// Whether a unit has only errors that a sheet can have: offset, rotation, pitch and gap.
bool isOfSheet(const TwinParams& twin);

/// Tells where a ray meets the panel: column from the left, row from the top, both maybe beside it.
struct SheetHit {
  double column;
  double row;
};

/// Gives where rays of slopes a = dx/dz, b = dy/dz from one eye end behind a sheet: functions of a
/// constant and what they grow by for each unit of a, and of b.
struct SheetHits {
  using Linear = std::array<double, 3>;
  Linear lens{};   ///< real-valued index of the lens that is met, from one beside the panel on
  Linear right{};  ///< px from the panel's left, of a ray through lens 0
  Linear up{};     ///< px from its bottom
  double rightOfLens = 0;  ///< what `right` grows by for each lens, whole ones
  double upOfLens = 0;
};

/// Tells how the kinds of pixels alternate: kind (column·c + row·r) & mask, row from the bottom.
struct CellPattern {
  int ofColumn = 0;
  int ofRow = 0;
  int mask = 0;
  std::array<SubPixels, 4> kinds{};  ///< as many as the mask counts
};

/// A sheet before its panel. Lengths are metres; x is to the right, y upwards from the middle, and
/// z = 0 is the lenses' plane, behind which the pixels are.
class LensSheet {
 public:
  /// `mounted` tells how the sheet differs from the one that the calibration is of: its offset,
  /// rotation, pitch and gap. Throws InputError as check() does.
  explicit LensSheet(const SheetDisplay& display, const LensArrayErrors& mounted = {});

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

  /// Returns spotWeights() of the display's spot; empty if it has none.
  [[nodiscard]] const std::vector<double>& spot() const { return m_spot; }

  /// Returns which of `views`, 0 from the left, a pixel's sub-pixel shows: ⌊N(1 − frac φ)⌋ at its
  /// own place. Columns count from the left, rows from the top.
  [[nodiscard]] int viewOf(int column, int row, std::size_t channel, int views) const;
  /// Fills in the views of a row's sub-pixels of one colour, from the left.
  void viewsOf(int row, std::size_t channel, int views, std::span<int> shown) const;

  /// Returns the sub-pixel of one colour that a ray meets through the sheet: on the lens's line
  /// behind which the ray ends, the nearest one. None if the eye is not in front of the lenses or
  /// the ray points away.
  [[nodiscard]] std::optional<SheetHit> meet(const Vec3& eye, const Vec3& direction,
                                             std::size_t channel) const;

  // The parts of meet(), for loops over rays from one eye.
  [[nodiscard]] SheetHits hitsFrom(const Vec3& eye) const;
  [[nodiscard]] const CellPattern& pattern() const { return m_pattern; }
  /// Returns the slope of the correction along the lens: px upwards for each px beside the middle
  /// of the sub-pixel, at most `farthestUp` to either side.
  [[nodiscard]] double slide() const { return (1 - m_emitter) * m_seenSlope; }
  static constexpr double farthestUp = 8;

 private:
  /// Returns the sub-pixels of a pixel, column and row from the left and the bottom.
  [[nodiscard]] const SubPixels& cellsAt(int column, int rowUp) const;

  /// The phases of a row's sub-pixels of one colour.
  struct RowPhases {
    std::array<double, 4> first{};  ///< of column 0, for each kind of pixel; above 0
    double perColumn = 0;
    int ofColumn = 0;  ///< kind (column·ofColumn + ofRow) & mask
    int ofRow = 0;
    int mask = 0;
    [[nodiscard]] int viewOf(int column, int views) const;
  };
  [[nodiscard]] RowPhases phasesOf(int row, std::size_t channel) const;

  CellPattern m_pattern;
  SheetCalibration m_calibration;
  double m_pixel;
  std::array<double, 2> m_size;
  double m_period;
  double m_gap;
  double m_perSlope;    ///< 1/slope
  double m_phase;       ///< φ₀
  double m_lensPeriod;  ///< p/(1 + g/D)
  double m_perSeen;     ///< 1/slope of the lenses as they are mounted
  double m_seenSlope;
  double m_seenPhase;  ///< φ₀ of them
  double m_seenGap;
  double m_emitter;
  std::vector<double> m_spot;
};

}  // namespace hogelscope
