// SPDX-License-Identifier: BSD-3-Clause
// A captured light field as the content of a live one, for any display: the light along a ray is
// what the capture has along it (docs/formulas.md, A capture as a scene).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/light_field/light_field.h"
#include "core/panel/display.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

class CaptureContent : public plugin::ContentSource {
 public:
  void describe(ParameterVisitor& v) override;

  /// Returns the file of the capture's session.
  [[nodiscard]] const std::string& file() const { return m_file; }
  /// Sets what open() shows: texels in memory, the display that they are for, with its hogels and
  /// directions, and the files that were read.
  void take(std::shared_ptr<const LightField> texels, const PanelParams& display,
            std::vector<std::string> files);

  /// Throws InputError without a capture.
  void open(const plugin::Panel& panel, const plugin::Place& place,
            const plugin::Progress& progress) override;
  [[nodiscard]] std::vector<std::string> files() const override { return m_files; }
  /// Says which share of the display's rays is outside what was captured.
  [[nodiscard]] std::vector<std::string> notes() const override;
  /// The depths of the capture's panel: those of its content are not known.
  void depths(double& back, double& front) const override;
  void trace(std::span<const plugin::Ray> rays, std::span<plugin::Colour> colours) const override;
  /// Sets NaN: a depth is not invented.
  [[nodiscard]] bool traceDepths(std::span<const plugin::Ray> rays,
                                 std::span<double> depths) const override;

 private:
  struct Met {
    Hit hit;
    Vec2 place;  ///< metres of the capture's own panel
    Vec2 slopes;
  };
  [[nodiscard]] std::optional<Met> meet(const plugin::Ray& ray) const;
  [[nodiscard]] Rgb light(const plugin::Ray& ray) const;
  [[nodiscard]] Rgb interpolated(const Hit& hit, const Vec2& place, const Vec2& slopes) const;
  [[nodiscard]] Rgb between(double i, double j, int u, int v) const;

  std::string m_file;
  Vec3 m_position;
  Vec3 m_orientation;
  double m_scale = 1;
  double m_focus = 0;
  bool m_interpolates = true;

  std::shared_ptr<const LightField> m_texels;
  std::optional<Display> m_display;
  std::vector<std::string> m_files;
  RigidTransform m_panel;  ///< the display's frame from that of the capture's panel
  RigidTransform m_fromDisplay;
  double m_outside = 0;  ///< the share of the display's rays
};

}  // namespace hogelscope
