// SPDX-License-Identifier: BSD-3-Clause
// The display: a panel of hogels, each with a lens that gives every directional pixel a direction.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parameters.h"
#include "core/light_field/light_field_source.h"
#include "core/panel/hogel_lens.h"
#include "core/panel/lens_sheet.h"
#include "core/panel/panel_map.h"

namespace hogelscope {

/// The session's `display`. Lengths are in metres, angles in degrees.
struct DisplayParams {
  Vec3 position;
  Vec3 orientation;
  std::array<double, 2> size{0.5, 0.5};
  std::array<int, 2> hogels{0, 0};      ///< 0: given by the light field
  std::array<int, 2> directions{0, 0};  ///< 0: given by the light field
  std::array<double, 2> fov{60, 60};
  HogelLensModel lens = HogelLensModel::rectilinear;
  std::string lensSource;  ///< the name of the lens plugin
  LensParams lensParams;
  std::optional<SheetDisplay> sheet;  ///< display.kind "sheet"; none: of hogels
  bool operator==(const DisplayParams&) const = default;
};

/// The display with what its light field says of it.
struct PanelParams : DisplayParams {
  double viewingDistance = notGiven;  ///< LightFieldParams::viewingDistance, metres
  bool operator==(const PanelParams&) const = default;
};

/// Visits `lensSource` only if the lens is a plugin; `lensParams` are a separate object, named
/// after it.
void describe(ParameterVisitor& v, DisplayParams& p);

/// Returns the hogels' lens across (axis 0, u) or down (axis 1, v). Throws InputError if a plugin's
/// lens cannot be opened.
std::shared_ptr<const HogelLens> lensOf(const DisplayParams& params, std::size_t axis);

/// Where a point of the world is as the panel's middle sees it.
struct EyePlace {
  Vec3 point;           ///< in the display frame, metres
  double distance = 0;  ///< metres
  double angle = 0;     ///< from the panel's normal, degrees, 0 … 180
  double across = 0;    ///< the same in the plane of x and z; positive on the panel's right
};
EyePlace eyePlaceOf(const DisplayParams& display, const Vec3& point);

/// The channel of a twin's rays that stands for all.
constexpr std::size_t greenChannel = 1;

/// The real-valued indices at which a ray meets the display; floor gives the hogel and direction.
struct Hit {
  double i = 0;
  double j = 0;
  double u = 0;
  double v = 0;
};

class Twin;

/// Tells what a kind of display, or one unit of it, does to rays and light: data, to be asked in
/// place of the kind.
struct DisplayTraits {
  bool hasDirections = true;      ///< hogels of several directions; otherwise of one pixel
  bool movesRays = false;         ///< rays meet other pixels than the lattice's
  bool splitsColours = false;     ///< red, green and blue of a ray meet different pixels
  bool changesLight = false;      ///< Twin::lit() changes the light of a ray
  bool drivesTexels = false;      ///< texels send other light than their code values say, or none
  bool needsLinearLight = false;  ///< psf.light must be "linear"
  bool hasUnlikeHogels = false;   ///< hogels differ, so that they are not interpolated
  /// Parts of a ray's light that come from the pixels k = −K … K beside the one that it meets,
  /// along a row; empty: all of it comes from that one.
  std::vector<double> spot{};
};

/// Whether the hogels of a display have several directions, which can leak, be interpolated and be
/// measured; the pixels behind a lens sheet have one.
bool hasDirections(const DisplayParams& display);

/// A kind of display whose pixels are not where the lattice of hogels has them, or do not send the
/// light that their code values say. A new kind is one of these, and a line in kindOf().
class DisplayKind {
 public:
  virtual ~DisplayKind() = default;
  [[nodiscard]] virtual const DisplayTraits& traits() const = 0;
  /// Returns what a ray of one colour meets, in the display frame; also beyond the panel and the
  /// field. None if the eye is not in front of the panel or the ray points away from it.
  [[nodiscard]] virtual std::optional<Hit> meet(const Vec3& eye, const Vec3& direction,
                                                std::size_t channel) const = 0;
  /// Returns the ray of green light from the middle of a directional pixel: the inverse of meet();
  /// none where it is the lattice's.
  [[nodiscard]] virtual std::optional<PanelRay> rayOf(const TexelIndex& /*at*/) const {
    return std::nullopt;
  }
  // For kernels and figures of these kinds alone; null for others.
  [[nodiscard]] virtual const Twin* twin() const { return nullptr; }  ///< one that moves rays
  [[nodiscard]] virtual const LensSheet* sheet() const { return nullptr; }
  /// Adds to a map of rays what the kernels of this kind need.
  virtual void complete(PanelMap& /*map*/) const {}
  /// Throws InputError if the display cannot show content of this size.
  virtual void checkContent(const LightFieldSize& /*size*/) const {}
};

/// Returns a display's kind, with the errors of the unit that was built; null: the lattice as
/// designed. Throws InputError.
std::shared_ptr<const DisplayKind> kindOf(const PanelParams& params,
                                          std::shared_ptr<const Twin> twin);

/// The panel's geometry, which rays are intersected with. If the light field has a viewing
/// distance, all hogels' fields coincide on the plane at that distance, and a direction (u, v) is a
/// point of it: the slopes of a direction then depend on the hogel's position.
class Display {
 public:
  /// `params.hogels` and `params.directions` must be given. With a twin rays meet the unit that was
  /// built. Throws InputError as lensOf() does.
  explicit Display(const PanelParams& params, std::shared_ptr<const Twin> twin = nullptr);

  [[nodiscard]] const LightFieldSize& size() const { return m_size; }
  [[nodiscard]] const RigidTransform& displayFromWorld() const { return m_displayFromWorld; }
  [[nodiscard]] const DisplayTraits& traits() const { return m_traits; }
  [[nodiscard]] const Twin* twin() const { return m_kind ? m_kind->twin() : nullptr; }
  [[nodiscard]] const LensSheet* sheet() const { return m_kind ? m_kind->sheet() : nullptr; }
  /// Throws InputError if the display cannot show content of this size.
  void checkContent(const LightFieldSize& size) const;
  /// Returns the hogels' lens across (axis 0, u) or down (axis 1, v).
  [[nodiscard]] const HogelLens& lens(std::size_t axis) const { return *m_lenses[axis]; }

  /// Returns the hit of a ray from an eye, both in the display frame (docs/formulas.md, Hit).
  /// Returns none if the eye is not in front of the panel, or the ray points away from it, misses
  /// it, or lies outside the hogel's angular field. Colours of a twin may have hits of their own.
  [[nodiscard]] std::optional<Hit> hit(const Vec3& eye, const Vec3& direction,
                                       std::size_t channel = greenChannel) const;

  /// Returns the hit with the panel's plane, also beyond the panel and the angular field. Returns
  /// none if the eye is not in front of the plane or the ray points away from it.
  [[nodiscard]] std::optional<Hit> intersectPlane(const Vec3& eye, const Vec3& direction,
                                                  std::size_t channel = greenChannel) const;
  [[nodiscard]] bool isOnPanel(const Hit& place) const;
  [[nodiscard]] bool isInField(const Hit& place) const;

  /// Returns the map of the rays from `eye` (display frame, metres), which is in front of the
  /// panel.
  [[nodiscard]] PanelMap mapFrom(const Vec3& eye) const;

  /// Returns the slopes dx/dz, dy/dz of a real-valued direction, u = 0 … du, v = 0 … dv, in the
  /// panel's centre.
  [[nodiscard]] Vec2 slopes(double u, double v) const;
  /// Returns the amount by which the slopes of every direction are smaller at a point of the panel
  /// (metres) than in its centre: the point / viewingDistance, or 0.
  [[nodiscard]] Vec2 turn(const Vec2& place) const {
    return {m_convergence * place.x, m_convergence * place.y};
  }
  /// Returns a point of the panel's plane in metres: i = 0 … nx, j = 0 … ny.
  [[nodiscard]] Vec2 position(double i, double j) const;

  /// Returns the ray from the middle of a hogel through the middle of a directional pixel: the
  /// inverse of hit(), for content. A twin's is that of green light.
  [[nodiscard]] PanelRay rayOf(const TexelIndex& at) const;

 private:
  PanelParams m_params;
  LightFieldSize m_size;
  RigidTransform m_displayFromWorld;
  std::array<std::shared_ptr<const HogelLens>, 2> m_lenses;
  double m_convergence;
  std::shared_ptr<const DisplayKind> m_kind;
  DisplayTraits m_traits;
};

}  // namespace hogelscope
