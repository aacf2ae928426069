// SPDX-License-Identifier: BSD-3-Clause
// The parameters of a twin: how one unit of a display differs from its design. Lengths are in
// metres, angles in degrees; the viewer's right and up are positive (docs/formulas.md, Twin).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/parameters.h"

namespace hogelscope {

/// Light whose pixel would lie outside the hogel's own: none, or the neighbour's pixel.
enum class OutsideField { dark, neighbour };

/// `twin.lensArray`: the sheet of lenses, of the design's lattice, as it was mounted.
struct LensArrayErrors {
  std::array<double, 2> offset{};
  double rotation = 0;                 ///< counter-clockwise for the viewer
  std::array<double, 2> pitchError{};  ///< parts of the pitch
  double gapError = 0;                 ///< part of the gap between pixels and lenses
  std::array<double, 2> wedge{};       ///< gap error from the panel's left to right, bottom to top
  double focalError = 0;               ///< part of the focal length
  OutsideField outside = OutsideField::dark;
  bool operator==(const LensArrayErrors&) const = default;
};

/// `twin.colour`: of red, green and blue.
struct ColourErrors {
  std::array<double, 3> scale{};        ///< parts by which a direction's index is larger
  std::array<double, 3> wavelengths{};  ///< metres, for diffraction; 0: none
  bool operator==(const ColourErrors&) const = default;
};

/// `twin.leakage`.
struct LeakageErrors {
  double sigmaGrowth = 0;  ///< k of σ (1 + k ρ²), ρ = 1 at the middle of the field's sides
  bool operator==(const LeakageErrors&) const = default;
};

enum class Eotf { srgb, gamma22, gamma24, linear };

/// `twin.light`. Black and ambient are parts of the light of white.
struct LightErrors {
  double black = 0;
  std::array<double, 3> ambient{};
  double falloff = 0;  ///< n of cosⁿ of a direction's angle
  int bits = 0;        ///< of the panel's code values; 0: as the light field's
  Eotf eotf = Eotf::srgb;
  std::array<double, 2> fill{1, 1};  ///< parts of a directional pixel that send light
  bool operator==(const LightErrors&) const = default;
};

/// `twin.dead`: rows and columns of pixels of the hogel image, from its top and its left, and
/// hogels (i, j).
struct DeadParts {
  std::vector<int> rows;
  std::vector<int> columns;
  std::vector<std::array<int, 2>> hogels;
  bool operator==(const DeadParts&) const = default;
};

/// A normal draw for each hogel; `length` (in hogels) is the distance at which draws are correlated
/// by 1/e, 0 where they are independent.
struct RandomErrors {
  double sigma = 0;
  double length = 0;
  bool operator==(const RandomErrors&) const = default;
};

struct RandomShift : RandomErrors {};  ///< sigma in metres, across and down
struct RandomGain : RandomErrors {};   ///< sigma as a part of the gain, of all colours together

/// `twin.random`.
struct TwinRandom {
  int seed = 1;
  RandomShift shift;
  RandomGain gain;
  bool operator==(const TwinRandom&) const = default;
};

/// `twin.maps`: files of measured values; "" where there is none.
struct TwinMapFiles {
  std::string hogels;
  std::string directions;
  std::string kernels;
  int kernelTiles = 1;  ///< kernels across, and down
  std::string height;
  /// Returns those that are given, to be changed.
  [[nodiscard]] std::vector<std::string*> files();
  bool operator==(const TwinMapFiles&) const = default;
};

/// A session's `twin`.
struct TwinParams {
  LensArrayErrors lensArray;
  ColourErrors colour;
  LeakageErrors leakage;
  LightErrors light;
  DeadParts dead;
  TwinRandom random;
  TwinMapFiles maps;
  bool operator==(const TwinParams&) const = default;

  /// Whether the unit is as designed: no parameter that does something by itself differs.
  [[nodiscard]] bool isZero() const;
  /// Whether it scales or adds light, without what its maps say: psf.light must then be "linear".
  [[nodiscard]] bool changesLight() const {
    return light != LightErrors{} || random.gain.sigma > 0;
  }
};

void describe(ParameterVisitor& v, LensArrayErrors& p);
void describe(ParameterVisitor& v, ColourErrors& p);
void describe(ParameterVisitor& v, LeakageErrors& p);
void describe(ParameterVisitor& v, LightErrors& p);
void describe(ParameterVisitor& v, TwinRandom& p);
void describe(ParameterVisitor& v, RandomShift& p);
void describe(ParameterVisitor& v, RandomGain& p);
void describe(ParameterVisitor& v, TwinMapFiles& p);

/// Visit the parts in the order of documents (SectionVisitor, io/json/sections.h).
template <class Visitor>
void describeParts(Visitor& v, TwinRandom& random) {
  v.fields(random);
  v.optional("shift", random.shift);
  v.optional("gain", random.gain);
}
template <class Visitor>
void describeParts(Visitor& v, TwinMapFiles& maps) {
  v.fields(maps);
  for (std::string* const file : maps.files()) v.file(*file);
}
template <class Visitor>
void describeParts(Visitor& v, TwinParams& twin) {
  v.optional("lensArray", twin.lensArray);
  v.optional("colour", twin.colour);
  v.optional("leakage", twin.leakage);
  v.optional("light", twin.light);
  v.optional("dead", twin.dead);
  v.optional("random", twin.random);
  v.optional("maps", twin.maps);
}

}  // namespace hogelscope
