// SPDX-License-Identifier: BSD-3-Clause
// Hogel lenses, which spread the directional pixels of a hogel over its angular field
// (docs/formulas.md, Hit): their interface, and the parameters of those of plugins.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/base/plugin_params.h"
#include "sdk/hogelscope/plugin.h"

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

/// Copies share the opened lenses, so a display can be made repeatedly, and a lens file that
/// changes meanwhile does not change a job.
class LensParams : public PluginParams<plugin::HogelLens> {
 public:
  LensParams() = default;
  explicit LensParams(Make make);

  /// Returns the lens across (axis 0, u) or down (axis 1, v) for a full field of `fov` degrees.
  /// Only the first call with the same values opens it. Throws InputError with the plugin's
  /// message, or if the lens is not an increasing function with an inverse.
  [[nodiscard]] std::shared_ptr<const HogelLens> lens(std::size_t axis, double fov) const;

 private:
  struct Opened;
  std::shared_ptr<Opened> m_opened;
};

}  // namespace hogelscope
