// SPDX-License-Identifier: BSD-3-Clause
// The hogel lenses. A new one needs a class, a HogelLensModel and a row of two tables here.
#include "core/panel/hogel_lens.h"

#include <array>
#include <cmath>
#include <mutex>

#include "core/base/error.h"
#include "core/base/geometry.h"

namespace hogelscope {

namespace {

class OpenedLens : public HogelLens {
 public:
  explicit OpenedLens(std::unique_ptr<plugin::HogelLens> lens) : m_lens(std::move(lens)) {}

  [[nodiscard]] double directionOf(double slope) const override {
    return m_lens->directionOf(slope);
  }
  [[nodiscard]] double slopeOf(double direction) const override {
    return m_lens->slopeOf(direction);
  }

 private:
  std::unique_ptr<plugin::HogelLens> m_lens;
};

/// Throws InputError unless the lens is increasing and has its inverse at 257 directions of its
/// field; views would otherwise be wrong without a message.
void requireGrowing(const HogelLens& lens) {
  constexpr int steps = 256;
  constexpr double allowed = 1e-6;  // of the field
  double last = -HUGE_VAL;
  for (int k = 0; k <= steps; ++k) {
    const double direction = double(k) / steps - 0.5;
    const double slope = lens.slopeOf(direction);
    if (!(slope > last) || !std::isfinite(slope) ||
        !(std::abs(lens.directionOf(slope) - direction) <= allowed))
      throw InputError("display.lensSource",
                       "its lens is no growing function of the slope with an inverse");
    last = slope;
  }
}

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

/// The lenses opened so far. They are small, so none is ever removed.
struct LensParams::Opened {
  struct Lens {
    NamedValues values;
    std::size_t axis;
    double fov;
    std::shared_ptr<const HogelLens> lens;
  };
  std::mutex mutex;
  std::vector<Lens> lenses;
};

LensParams::LensParams(Make make)
    : PluginParams(std::move(make)), m_opened(std::make_shared<Opened>()) {}

std::shared_ptr<const HogelLens> LensParams::lens(std::size_t axis, double fov) const {
  if (!isGiven()) throw InputError("display.lensSource", "is missing: name the plugin of the lens");
  const std::lock_guard lock(m_opened->mutex);
  for (const Opened::Lens& known : m_opened->lenses)
    if (known.axis == axis && known.fov == fov && known.values == *this) return known.lens;
  auto made = make();
  made->open(std::int32_t(axis), fov, {".", 1});
  auto lens = std::make_shared<const OpenedLens>(std::move(made));
  requireGrowing(*lens);
  m_opened->lenses.push_back({*this, axis, fov, lens});
  return lens;
}

std::span<const std::string_view> hogelLensNames() {
  return names;
}

std::shared_ptr<const HogelLens> makeHogelLens(HogelLensModel model, double fov) {
  return makers.at(std::size_t(model))(fov);
}

}  // namespace hogelscope
