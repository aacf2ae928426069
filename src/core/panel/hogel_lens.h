// SPDX-License-Identifier: BSD-3-Clause
// The interface of hogel lenses, which spread a hogel's directional pixels over its angular field
// (docs/formulas.md, Hit).
#pragma once

#include <memory>
#include <span>
#include <string_view>

namespace hogelscope {

/// The model of a hogel's lens; `plugin` is the lens of DisplayParams::lensSource.
enum class HogelLensModel { rectilinear, equiangular, plugin };

/// Returns the names used in documents, in the order of HogelLensModel.
std::span<const std::string_view> hogelLensNames();

/// One axis of a hogel's lens. A slope is dx/dz or dy/dz of the light; a direction is a coordinate
/// in the angular field, from -1/2 to 1/2.
class HogelLens {
 public:
  HogelLens() = default;
  HogelLens(const HogelLens&) = delete;
  HogelLens& operator=(const HogelLens&) = delete;
  virtual ~HogelLens() = default;

  [[nodiscard]] virtual double directionOf(double slope) const = 0;
  /// Returns the slope of a direction, the inverse of directionOf().
  [[nodiscard]] virtual double slopeOf(double direction) const = 0;
  /// Whether directionOf() is slope / slopeOf(1): rays are then cast without calling it.
  [[nodiscard]] virtual bool isLinear() const { return false; }
};

/// Makes a lens of the program's own; `fov` is the full angle of the field in degrees.
std::shared_ptr<const HogelLens> makeHogelLens(HogelLensModel model, double fov);

}  // namespace hogelscope
