// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/lens_params.h"

#include <cmath>
#include <mutex>

#include "core/base/error.h"

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

}  // namespace hogelscope
