// SPDX-License-Identifier: BSD-3-Clause
// The figures of a display: what each is of, how it is simulated, and its closed form. Procedures
// and formulas are in docs/formulas.md, Measures of a display. --measure runs the whole list as a
// run, a sweep takes single figures of it for each design, the window the maps alone; nothing
// here knows how a view is rendered.
#pragma once

#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "measure/bench.h"

namespace hogelscope {

/// The value of what cannot be measured, or has no closed form.
constexpr double noValue = std::numeric_limits<double>::quiet_NaN();
/// The code value of white test light.
constexpr double whiteCode = 255;
constexpr CodeValues white{whiteCode, whiteCode, whiteCode};

/// One figure at one place; several rows of measure.csv have the same name.
struct Measurement {
  std::string figure;
  std::string unit;                              ///< "" for ratios
  std::string where;                             ///< such as "across", "f=0.4/mm z=0.02 m"
  std::function<double(Bench& bench)> simulate;  ///< empty if there is only the closed form
  double closedForm = noValue;
  double across = 0;  ///< the place in the figure's plot
  double up = 0;
};

/// Tells what a sweep measures a figure with.
enum class SweptWith { nothing, bench, views, clock };

/// A figure and its readers. Its value for a display as a whole is that of the first measurement
/// with its name and unit.
struct FigureRow {
  std::string_view name;
  std::string_view unit{};  ///< of that value; "" for ratios
  bool isHeadline = false;  ///< whether --measure prints the value
  SweptWith sweptWith = SweptWith::nothing;
  const char* title = "";     ///< in the window's sweep, without the unit
  int inWindow = 0;           ///< place among the window's sweeps, from 1 on; 0: none
  bool isBetterLess = false;  ///< whether designs are good up to a limit, not from it on

  [[nodiscard]] bool isOf(const Measurement& one) const {
    return one.figure == name && one.unit == unit;
  }
};

/// Returns all figures of hogels, of lens sheets and of sweeps; those of --measure in the order in
/// which it prints them.
std::span<const FigureRow> figureRows();
/// Returns the row of a name; of another name, such as "mtf:0.05", that of a nameless ratio.
const FigureRow& figureRow(std::string_view name);

/// Returns all measurements of the bench's display. `ipd` is the distance between the eyes, `pupil`
/// a diameter for what needs one and whose state has none, metres.
std::vector<Measurement> allMeasurements(const Bench& bench, double ipd, double pupil);

/// Keeps the measurements that a unit with this twin has (whyNotOfUnit()). Returns for each
/// reason why others are left out "since …: FIGURES".
std::vector<std::string> keepThoseOfUnit(std::vector<Measurement>& all, const TwinParams& twin);

/// The groups that allMeasurements() joins: those of hogels, those of lens sheets, gratings on
/// both.
void addDataSheet(const Bench& bench, double pupil, std::vector<Measurement>& all);
void addViewingSpace(const Bench& bench, double ipd, std::vector<Measurement>& all);
void addPhotometry(const Bench& bench, std::vector<Measurement>& all);
void addLensSheet(const Bench& bench, double ipd, std::vector<Measurement>& all);
void addGratings(const Bench& bench, double pupil, std::vector<Measurement>& all);

/// A figure of what is seen from a place of an eye or of a head.
struct EyeFigure {
  std::function<double(Bench& bench, const Vec3& eye)> simulate;
  std::function<double(const Vec3& eye)> closedForm;
};

/// Adds the map of the viewing zone: the share of the panel seen from 41 × 25 places at the height
/// of its middle.
void addZoneMap(const Bench& bench, const EyeFigure& share, std::vector<Measurement>& all);

/// Adds the crosstalk of two eyes over 19 places of the head about the bench's eye, which is the
/// designated eye position and comes first.
void addCrosstalk(const Bench& bench, double ipd, const EyeFigure& crosstalk,
                  std::vector<Measurement>& all);

/// The light of one direction, or of one view, over the eye's angle.
struct AngularProfile {
  int lit;       ///< the direction
  int reach;     ///< directions to each side that are looked at
  int halvings;  ///< in the search for the width
  std::function<double(const Bench& bench, double direction)> angleOf;  ///< of the eye, degrees
  std::function<double(Bench& bench, double direction)> light;          ///< seen from a direction
  std::function<double(const Bench& bench, double direction)> closedForm;  ///< of its middle is 1
  std::optional<double> width;  ///< in closed form, degrees; none: is searched in `closedForm`
};

/// Adds the profile at every eighth of a direction, and its full width at half maximum.
void addProfile(const Bench& bench, const AngularProfile& profile, std::vector<Measurement>& all);

/// The axis along which figures of one axis are measured: across, or down if the display has but
/// one direction across.
inline std::size_t mainAxis(const Bench& bench) {
  return bench.display().directions[0] > 1 ? 0 : 1;
}

/// Returns an eye that is moved to a place along an axis, 2 for z.
inline Vec3 movedTo(Vec3 eye, double place, std::size_t axis) {
  (axis == 0 ? eye.x : axis == 1 ? eye.y : eye.z) = place;
  return eye;
}

/// Returns a point of an axis.
inline Vec2 onAxis(double place, std::size_t axis) {
  return axis == 0 ? Vec2{place, 0} : Vec2{0, place};
}

/// Returns "across" or "down".
inline std::string axisName(std::size_t axis) {
  return axis == 0 ? "across" : "down";
}

/// Returns a length with four digits, such as "0.02 m".
inline std::string metres(double length) {
  return numberText(fourDigits(length)) + " m";
}

inline double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

/// Returns the half width of the viewing zone of the whole panel at a distance, D tan(F/2) − W/2
/// along an axis, below 0 if there is none: the closed form of linear lenses.
double halfZone(const Bench& bench, double distance, std::size_t axis);

}  // namespace hogelscope
