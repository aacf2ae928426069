// SPDX-License-Identifier: BSD-3-Clause
// The simulation itself: which light one pixel of a camera state receives. This is the reference
// engine: double precision, no tricks, written to be read against docs/formulas.md.
#pragma once

#include <memory>
#include <optional>

#include "core/optics/image.h"
#include "core/optics/method.h"
#include "core/optics/session.h"

namespace hogelscope {

/// All that one picture depends on. `display` has its hogels and directions resolved.
struct View {
  std::shared_ptr<const LightFieldSource> lightField;
  DisplayParams display;
  SamplingParams sampling;
  CameraState state;
  Method method{};  ///< the fast engine's; the reference approximates nothing
  bool operator==(const View&) const = default;
};

/// Throws InputError where the view has no light field, or one that is not the display's size.
void checkContent(const View& view);

/// Through the lens, backwards: the point of the plane z = 1 whose light falls on `onSensor`; none
/// where there is no ray.
std::optional<Vec2> idealPoint(const Distortion& distortion, LensMapping mapping,
                               const Vec2& onSensor);

class Simulation {
 public:
  /// Throws InputError where the state has no camera frame or the light field is not the display's
  /// size.
  explicit Simulation(View view);

  /// What pixel (x, y) shows, in code values; none if none of its rays meets the display inside
  /// its angular field.
  [[nodiscard]] std::optional<Rgb> pixel(int x, int y) const;

  /// Pixel (x, y) of the picture, both sides of it.
  void render(int x, int y, Image& image) const;

 private:
  [[nodiscard]] std::optional<Rgb> ray(double px, double py) const;
  [[nodiscard]] std::optional<Hit> hitOf(double px, double py) const;
  [[nodiscard]] Rgb reconstructed(const Hit& hit) const;

  View m_view;
  Display m_display;
  Camera m_camera;
  Distortion m_distortion;
  Psf m_psf;
  RigidTransform m_displayFromCamera;
};

/// The whole picture on the calling thread: the oracle of the tests.
Image simulate(const View& view);

}  // namespace hogelscope
