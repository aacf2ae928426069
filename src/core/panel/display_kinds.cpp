// SPDX-License-Identifier: BSD-3-Clause
// The kinds of display.
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/panel/display.h"
#include "core/panel/twin.h"

namespace hogelscope {

namespace {

/// A lens sheet: each pixel of its panel is a hogel of one direction.
class SheetKind final : public DisplayKind {
 public:
  explicit SheetKind(const LensSheet& sheet)
      : m_sheet(sheet),
        m_traits{.hasDirections = false,
                 .movesRays = true,
                 .splitsColours = true,
                 .spot = sheet.spot()} {}

  [[nodiscard]] const DisplayTraits& traits() const override { return m_traits; }
  [[nodiscard]] std::optional<Hit> meet(const Vec3& eye, const Vec3& direction,
                                        std::size_t channel) const override {
    const std::optional<SheetHit> met = m_sheet.meet(eye, direction, channel);
    return met ? std::optional(Hit{met->column, met->row, 0.5, 0.5}) : std::nullopt;
  }
  [[nodiscard]] const LensSheet* sheet() const override { return &m_sheet; }
  void checkContent(const LightFieldSize& size) const override {
    const auto [width, height] = m_sheet.calibration().params.panel;
    if (size != LightFieldSize{width, height, 1, 1})
      throw InputError("lightField", "is not the picture of the lens sheet's panel, " +
                                         pairText(width, height) + " px");
  }

 private:
  LensSheet m_sheet;
  DisplayTraits m_traits;
};

}  // namespace

std::shared_ptr<const DisplayKind> kindOf(const PanelParams& params,
                                          std::shared_ptr<const Twin> twin) {
  if (params.sheet)
    return std::make_shared<const SheetKind>(
        LensSheet(*params.sheet, twin ? twin->params().lensArray : LensArrayErrors{}));
  return twin;
}

}  // namespace hogelscope
