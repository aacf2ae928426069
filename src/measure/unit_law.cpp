// SPDX-License-Identifier: BSD-3-Clause
#include "measure/unit_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace hogelscope {

namespace {

/// An error of a twin that some formulas do not know.
struct Error {
  const char* name;
  bool (*isSet)(const TwinParams& twin);
};

constexpr Error wedge{"lensArray.wedge", [](const TwinParams& twin) {
                        return twin.lensArray.wedge != LensArrayErrors{}.wedge;
                      }};
constexpr Error outside{"lensArray.outside", [](const TwinParams& twin) {
                          return twin.lensArray.outside != OutsideField::dark;
                        }};
constexpr Error wavelengths{"colour.wavelengths", [](const TwinParams& twin) {
                              return twin.colour.wavelengths != ColourErrors{}.wavelengths;
                            }};
constexpr Error growth{"leakage.sigmaGrowth",
                       [](const TwinParams& twin) { return twin.leakage.sigmaGrowth != 0; }};
constexpr Error falloff{"light.falloff",
                        [](const TwinParams& twin) { return twin.light.falloff != 0; }};
constexpr Error bits{"light.bits", [](const TwinParams& twin) { return twin.light.bits != 0; }};
constexpr Error eotf{"light.eotf",
                     [](const TwinParams& twin) { return twin.light.eotf != Eotf::srgb; }};
constexpr Error fill{"light.fill",
                     [](const TwinParams& twin) { return twin.light.fill != LightErrors{}.fill; }};
constexpr Error dead{"dead", [](const TwinParams& twin) { return twin.dead != DeadParts{}; }};
constexpr Error shift{"random.shift",
                      [](const TwinParams& twin) { return twin.random.shift.sigma > 0; }};
constexpr Error gain{"random.gain",
                     [](const TwinParams& twin) { return twin.random.gain.sigma > 0; }};
constexpr Error hogels{"maps.hogels",
                       [](const TwinParams& twin) { return !twin.maps.hogels.empty(); }};
constexpr Error directions{"maps.directions",
                           [](const TwinParams& twin) { return !twin.maps.directions.empty(); }};
constexpr Error kernels{"maps.kernels",
                        [](const TwinParams& twin) { return !twin.maps.kernels.empty(); }};
constexpr Error height{"maps.height",
                       [](const TwinParams& twin) { return !twin.maps.height.empty(); }};

constexpr std::array ofLattice{height};
constexpr std::array ofDirections{outside, hogels, directions, height};
constexpr std::array ofZone{wedge, outside, shift, hogels, directions, height};
constexpr std::array ofGratings{wedge, outside, wavelengths, growth, falloff,    bits,    eotf,
                                fill,  dead,    gain,        hogels, directions, kernels, height};
constexpr std::array ofLight{falloff, bits, eotf, fill, dead, gain, hogels, directions, kernels};

/// A figure of a unit, and the errors that its formula does not know.
struct UnitFigure {
  std::string_view name;
  std::span<const Error> unknown;
};

constexpr std::array figures{UnitFigure{"hogelPitch", ofLattice},
                             UnitFigure{"slopeStep", ofDirections},
                             UnitFigure{"degreesPerDirection", ofDirections},
                             UnitFigure{"directionsPerPupil", ofDirections},
                             UnitFigure{"parallaxStep", ofDirections},
                             UnitFigure{"megapixels", {}},
                             UnitFigure{"viewingZone", ofZone},
                             UnitFigure{"spatialResolution", ofGratings},
                             UnitFigure{"mtf", ofGratings},
                             UnitFigure{"depthOfField", ofGratings},
                             UnitFigure{"depthOfField50", ofGratings},
                             UnitFigure{"depthOfField10", ofGratings},
                             UnitFigure{"throughFocus", ofGratings},
                             UnitFigure{"uniformity", ofLight},
                             UnitFigure{"contrast", ofLight}};

}  // namespace

UnitLaw unitLawOf(const TwinParams& twin) {
  const LensArrayErrors& array = twin.lensArray;
  UnitLaw law;
  for (std::size_t channel = 0; channel < 3; ++channel)
    law.scale[channel] = (1 + twin.colour.scale[channel]) * (1 + array.gapError);
  law.offset = array.offset;
  law.pitchError = array.pitchError;
  law.turn = std::cos(array.rotation * std::numbers::pi / 180);
  law.defocus = (1 + array.gapError) / (1 + array.focalError) - 1;
  law.shiftSigma = twin.random.shift.sigma;
  law.black = twin.light.black;
  law.ambient = twin.light.ambient;
  return law;
}

std::string whyNotOfUnit(std::string_view figure, const TwinParams& twin) {
  const auto known = std::ranges::find(figures, figure, &UnitFigure::name);
  if (known == figures.end()) return "no formula is of a unit";
  const auto unknown =
      std::ranges::find_if(known->unknown, [&](const Error& error) { return error.isSet(twin); });
  if (unknown == known->unknown.end()) return {};
  return "no formula knows twin." + std::string(unknown->name);
}

}  // namespace hogelscope
