// SPDX-License-Identifier: BSD-3-Clause
// The hogel lenses. A new one needs a class, a HogelLensModel and a row of two tables here.
#include "core/panel/hogel_lens.h"

#include <array>
#include <cmath>

#include "core/base/geometry.h"

namespace hogelscope {

namespace {

/// Spaces directions evenly in slope, as behind an ideal lens.
class RectilinearLens : public HogelLens {
 public:
  explicit RectilinearLens(double fov) : m_width(2 * std::tan(radians(fov) / 2)) {}

  [[nodiscard]] double directionOf(double slope) const override { return slope / m_width; }
  [[nodiscard]] double slopeOf(double direction) const override { return direction * m_width; }
  [[nodiscard]] bool isLinear() const override { return true; }

 private:
  double m_width;  ///< the field's width in slopes
};

/// Spaces directions evenly in angle.
class EquiangularLens : public HogelLens {
 public:
  explicit EquiangularLens(double fov) : m_field(radians(fov)) {}

  [[nodiscard]] double directionOf(double slope) const override {
    return std::atan(slope) / m_field;
  }
  [[nodiscard]] double slopeOf(double direction) const override {
    return std::tan(direction * m_field);
  }

 private:
  double m_field;
};

template <class Lens>
std::shared_ptr<const HogelLens> make(double fov) {
  return std::make_shared<const Lens>(fov);
}

using MakeLens = std::shared_ptr<const HogelLens> (*)(double fov);

// Each HogelLensModel has one row; the last one, plugin, is not made here.
constexpr std::array<std::string_view, 3> names{"rectilinear", "equiangular", "plugin"};
constexpr std::array<MakeLens, 2> makers{make<RectilinearLens>, make<EquiangularLens>};

}  // namespace

std::span<const std::string_view> hogelLensNames() {
  return names;
}

std::shared_ptr<const HogelLens> makeHogelLens(HogelLensModel model, double fov) {
  return makers.at(std::size_t(model))(fov);
}

}  // namespace hogelscope
