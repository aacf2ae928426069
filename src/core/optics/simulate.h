// SPDX-License-Identifier: BSD-3-Clause
// The reference engine: the light that a pixel of a camera state receives, in double precision,
// without optimisations, written to be read beside docs/formulas.md.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/optics/field_leakage.h"
#include "core/optics/image.h"
#include "core/optics/method.h"
#include "core/optics/session.h"

namespace hogelscope {

/// Everything that one image depends on. `display` has its hogels and directions resolved.
struct RenderJob {
  std::shared_ptr<const LightFieldSource> lightField;
  PanelParams display;
  SamplingParams sampling;
  CameraState state;
  Method method{};       ///< for the fast engine; the reference engine ignores it
  bool isIdeal = false;  ///< Renderer then makes the ideal view, see ideal_view.h
  int bits = 8;  ///< bits of the image's values, see Image; for Renderer and StreamingRenderer
  bool keepsUnrounded = false;         ///< the image also has its unrounded values; for the same
  std::shared_ptr<const Twin> twin{};  ///< the unit that is seen; null: the display as designed
  bool operator==(const RenderJob&) const = default;
};

/// Throws InputError if the view has no light field, or one that is not the display's size, or if
/// its twin needs another psf.light or sampling.reconstruction.
void checkContent(const RenderJob& job);
void checkContent(const RenderJob& job, const Display& display);  ///< of that job

/// The light of a pixel in code values.
struct PixelLight : Rgb {
  bool isSeen = true;  ///< all points of the aperture see the display
};

/// Returns the point of the plane z = 1 whose light falls through the lens on `onSensor`; none if
/// there is no ray.
std::optional<Vec2> idealPoint(const Distortion& distortion, LensMapping mapping,
                               const Vec2& onSensor);

class Simulation {
 public:
  /// Throws InputError if the state has no camera frame, or the light field is not the display's
  /// size.
  explicit Simulation(RenderJob job);

  /// Returns the light of pixel (x, y); none if none of its rays meets the display inside its
  /// angular field.
  [[nodiscard]] std::optional<PixelLight> pixel(int x, int y) const;

  /// Writes pixel (x, y) of the image and of its mask.
  void render(int x, int y, Image& image) const;

 private:
  [[nodiscard]] std::optional<std::array<Hit, 3>> hitsOf(const Vec2& ideal,
                                                         const RigidTransform& from) const;
  [[nodiscard]] std::vector<Vec2> ideals(int x, int y) const;
  [[nodiscard]] std::optional<Rgb> lightFrom(const RigidTransform& point,
                                             const std::vector<Vec2>& ideals) const;
  [[nodiscard]] Rgb leaked(const TexelIndex& at) const;
  [[nodiscard]] Rgb spotLight(const Hit& hit, const std::vector<double>& spot) const;
  [[nodiscard]] Rgb reconstructed(const Hit& hit) const;
  [[nodiscard]] Rgb sent(const std::array<Hit, 3>& hits) const;

  RenderJob m_job;
  Display m_display;
  Camera m_camera;
  Distortion m_distortion;
  Psf m_psf;
  std::optional<FieldLeakage> m_leakage;  ///< a twin's, in place of m_psf
  std::vector<RaySample> m_samples;
  Aperture m_aperture;
  std::vector<RigidTransform> m_displayFromPoint;  ///< for each point of the aperture
};

/// Renders the whole image on the calling thread: the oracle of the tests.
Image simulate(const RenderJob& job);

}  // namespace hogelscope
