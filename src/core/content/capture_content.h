// SPDX-License-Identifier: BSD-3-Clause
// A captured light field as the content of a live one, for any display: the light along a ray is
// what the capture has along it (docs/formulas.md, A capture as a scene).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/content/live_source.h"
#include "core/light_field/light_field.h"
#include "core/panel/display.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

class CaptureContent : public plugin::ContentSource {
 public:
  static constexpr std::string_view sourceName = "session";  ///< what sessions call it

  void describe(ParameterVisitor& v) override;

  /// Returns the file of the capture's session.
  [[nodiscard]] const std::string& file() const { return m_file; }
  /// Sets what open() shows: the capture, the display that it is for, with its hogels and
  /// directions, and the files that were read.
  void take(std::shared_ptr<const LightFieldSource> capture, const PanelParams& display,
            std::vector<std::string> files);
  /// Returns the type of the capture's texels.
  [[nodiscard]] StoredType type() const { return m_capture->type(); }
  /// Returns the same with another focus.
  [[nodiscard]] std::shared_ptr<CaptureContent> focusedAt(double focus) const;
  /// Returns the depth at which the views of neighbouring directions differ by one hogel, in metres
  /// before the panel, in the capture's own size.
  [[nodiscard]] double depthOfOneHogel() const;

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
  /// A ray takes this part of one direction of one column or row of hogels.
  struct Tap {
    int hogel = 0;
    int direction = 0;
    double weight = 0;
  };
  class AxisTaps {
   public:
    void add(const Tap& tap) { m_taps[m_count++] = tap; }
    [[nodiscard]] std::span<const Tap> all() const { return std::span(m_taps).first(m_count); }

   private:
    std::array<Tap, 4> m_taps;
    std::size_t m_count = 0;
  };
  /// A ray takes each texel of `across` with each of `down`.
  struct Met {
    AxisTaps across;
    AxisTaps down;
  };
  /// The capture's columns or rows of hogels, in metres of its own panel, and its directions.
  struct Axis {
    int hogels = 0;
    double first = 0;  ///< the edge of the first one
    double pitch = 0;
    double turn = 0;             ///< 1/D, with D the viewing distance
    std::vector<double> slopes;  ///< of the middles of directions
  };
  [[nodiscard]] AxisTaps tapsOf(const Axis& axis, double direction, double hogel, double place,
                                double slope) const;
  [[nodiscard]] std::optional<Met> meet(const plugin::Ray& ray) const;
  void traceSlices(std::span<const plugin::Ray> rays, std::span<plugin::Colour> colours) const;
  void traceIn(const LightField& texels, std::span<const plugin::Ray> rays,
               std::span<plugin::Colour> colours) const;

  std::string m_file;
  Vec3 m_position;
  Vec3 m_orientation;
  double m_scale = 1;
  double m_focus = 0;
  bool m_interpolates = true;

  std::shared_ptr<const LightFieldSource> m_capture;
  std::shared_ptr<const LightField> m_texels;  ///< all of the capture, if it is in memory
  std::optional<Display> m_display;
  std::array<Axis, 2> m_axes;
  std::vector<std::string> m_files;
  RigidTransform m_panel;  ///< the display's frame from that of the capture's panel
  RigidTransform m_fromDisplay;
  double m_outside = 0;  ///< the share of the display's rays
};

}  // namespace hogelscope
