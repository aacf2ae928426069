// SPDX-License-Identifier: BSD-3-Clause
// A display on the test bench: it shows test light in closed form, and the engine looks at it along
// lines. All is in the display frame, whatever the display's pose. A lens sheet shows the light as
// views have it that are woven for it.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "core/engine/renderer.h"
#include "core/optics/session.h"
#include "core/panel/sheet_numbers.h"
#include "core/panel/twin.h"
#include "measure/unit_law.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

/// Code values of the three channels, not rounded. Channels do not mix, so that one look can be at
/// three kinds of test light.
using CodeValues = std::array<double, 3>;
/// Returns one value in all channels.
inline CodeValues grey(double value) {
  return {value, value, value};
}

/// Test light: what a ray of the display carries.
using TestLight = std::function<CodeValues(const plugin::Ray& ray)>;

/// Returns the point of a ray on the plane z, metres.
inline Vec2 pointOf(const plugin::Ray& ray, double z) {
  return {ray.x + ray.a * (z - ray.z), ray.y + ray.b * (z - ray.z)};
}

/// A point of the panel as the eye sees it.
struct BenchPoint {
  double place = 0;  ///< along the line, metres from the panel's centre
  CodeValues values{};
  double direction = 0;  ///< real-valued direction along the line's axis
};

class Bench {
 public:
  /// Takes the eye, the PSF and the pupil of a state. A lens sheet's views are the display's
  /// directions across. With a twin the unit is on the bench; test light is still the design's
  /// content. Throws InputError if the eye is not in front of the panel.
  Bench(const PanelParams& display, const CameraState& state,
        std::shared_ptr<const Twin> twin = nullptr);

  [[nodiscard]] const PanelParams& display() const { return m_display; }
  /// Returns what rays meet.
  [[nodiscard]] const Display& panel() const { return m_panel; }
  /// Null for a design.
  [[nodiscard]] const Twin* twin() const { return m_twin.get(); }
  [[nodiscard]] const UnitLaw& law() const { return m_law; }
  [[nodiscard]] const Vec3& eye() const { return m_eye; }
  [[nodiscard]] double distance() const { return m_eye.z; }
  [[nodiscard]] const PsfParams& psf() const { return m_psf; }
  [[nodiscard]] const PupilParams& pupil() const { return m_pupil; }
  /// Null for hogels. Functions on hogels and directions must not be called for a lens sheet.
  [[nodiscard]] const LensSheet* sheet() const { return m_panel.sheet(); }
  /// Returns what the lens sheet shows to the eye; not for hogels.
  [[nodiscard]] SheetNumbers numbersOfSheet() const {
    return sheetNumbers(*m_display.sheet, m_display.directions[0], m_eye);
  }
  /// Returns the pitch of hogels as designed; of a lens sheet the lenses' period across, and the
  /// pixels' up.
  [[nodiscard]] double pitch(std::size_t axis) const { return m_pitches[axis]; }
  /// Returns the slope step s in the middle of the field; of a lens sheet the width s of a view's
  /// light (core/panel/sheet_numbers.h), 0 up.
  [[nodiscard]] double step(std::size_t axis) const { return m_steps[axis]; }
  /// Whether slopes are even over directions, so that closed forms hold everywhere.
  [[nodiscard]] bool isLinear(std::size_t axis) const;

  /// Returns the bench of a pinhole and a display without leakage.
  [[nodiscard]] Bench withoutBlur() const;
  void setPupil(const PupilParams& pupil) { m_pupil = pupil; }

  /// Returns the real-valued direction along an axis of a ray's light.
  [[nodiscard]] double directionOf(const plugin::Ray& ray, std::size_t axis) const;
  /// Returns the middle of the hogel that is nearest to the panel's centre, along an axis.
  [[nodiscard]] double middleHogel(std::size_t axis) const;
  /// Returns the eye's place along an axis at which it sees a direction in the hogel at `place`.
  [[nodiscard]] double eyePlaceFor(double direction, double place, std::size_t axis) const;

  /// Looks from an eye at `count` points of the panel, evenly from `from` to a greater `to` along
  /// an axis and at `across` on the other one. Points that do not see the display are left out.
  /// Throws InputError, Cancelled.
  [[nodiscard]] std::vector<BenchPoint> look(const TestLight& light, const Vec3& eye,
                                             std::size_t axis, double from, double to, int count,
                                             double across = 0);
  /// Returns the values at one point of the panel; NaN if it is not seen.
  [[nodiscard]] CodeValues lookAt(const TestLight& light, const Vec3& eye, const Vec2& point);

  /// Turn a wave of −1 … 1 into code values and back, such that what the display sums is
  /// proportional to it: in linear light, unless only the leakage sums, in code values; if both
  /// leakage in code values and the pupil in linear light do, the wave is small enough for either.
  [[nodiscard]] double codeOf(double wave) const;
  [[nodiscard]] double waveOf(double code) const;

  /// Returns 1-D weights of the PSF along an axis, −reach … reach, of sum 1.
  [[nodiscard]] std::vector<double> weights() const;

 private:
  [[nodiscard]] bool sumsLinear() const {
    return m_psf.light == LightModel::linear || (m_pupil.diameter > 0 && m_psf.windowSize == 1);
  }

  PanelParams m_display;
  std::shared_ptr<const Twin> m_twin;
  UnitLaw m_law;
  Display m_panel;
  Vec3 m_eye;
  PsfParams m_psf;
  PupilParams m_pupil;
  std::array<double, 2> m_pitches{};
  std::array<double, 2> m_steps{};
  Renderer m_renderer{serialRows};
};

/// Narrows a bench's pupil while it lives, such that the panel sees it under 1° at most: the
/// angular aperture that IDMS 17.2 allows.
class MeterAperture {
 public:
  explicit MeterAperture(Bench& bench);
  ~MeterAperture() { m_bench.setPupil(m_own); }
  MeterAperture(const MeterAperture&) = delete;
  MeterAperture& operator=(const MeterAperture&) = delete;

 private:
  Bench& m_bench;
  PupilParams m_own;
};

}  // namespace hogelscope
