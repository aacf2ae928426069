// SPDX-License-Identifier: BSD-3-Clause
// The figures of a display: what each is of, how it is simulated, and its closed form. Names,
// procedures and formulas are in docs/formulas.md, Measures of a display. --measure runs the whole
// list as a campaign, a sweep takes single figures of it for each design, the window the maps
// alone; nothing here knows how a view is rendered.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

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

/// Returns all figures of the bench's display. `ipd` is the distance between the eyes, `pupil` a
/// diameter for what needs one and whose state has none, metres.
std::vector<Measurement> allMeasurements(const Bench& bench, double ipd, double pupil);

/// The groups that allMeasurements() joins, in its order.
void addDataSheet(const Bench& bench, double pupil, std::vector<Measurement>& all);
void addViewingSpace(const Bench& bench, double ipd, std::vector<Measurement>& all);
void addPhotometry(const Bench& bench, std::vector<Measurement>& all);
void addGratings(const Bench& bench, double pupil, std::vector<Measurement>& all);
/// The group that a lens sheet has in place of those before addGratings().
void addLensSheet(const Bench& bench, double ipd, std::vector<Measurement>& all);

/// The axis along which figures of one axis are measured: across, or down if the display has but
/// one direction across.
inline std::size_t mainAxis(const Bench& bench) {
  return bench.display().directions[0] > 1 ? 0 : 1;
}

/// Returns an eye that is moved to a place along an axis.
inline Vec3 movedTo(Vec3 eye, double place, std::size_t axis) {
  (axis == 0 ? eye.x : eye.y) = place;
  return eye;
}

/// Returns "across" or "down".
inline std::string axisName(std::size_t axis) {
  return axis == 0 ? "across" : "down";
}

/// Returns the half width of the viewing zone of the whole panel at a distance, D tan(F/2) − W/2
/// along an axis, below 0 if there is none: the closed form of linear lenses.
double halfZone(const Bench& bench, double distance, std::size_t axis);

/// Returns the share of the panel that sends light to an eye, counted over 800 rays along each
/// axis; 1 only if its edges do, too.
double shareSeen(const Bench& bench, const Vec3& eye);

/// Returns the crosstalk between the two eyes of a head at `head`, (L_KW − L_KK)/(L_WK − L_KK) of
/// the left eye in linear light, in a spot in the panel's middle, if the light that leaves to the
/// right of `border` is the right eye's.
double crosstalk(Bench& bench, const Vec3& head, double ipd, double border);

}  // namespace hogelscope
