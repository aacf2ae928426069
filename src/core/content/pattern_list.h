// SPDX-License-Identifier: BSD-3-Clause
// The list of patterns by name, and those with one formula per pixel: codes of the pixel's own
// indices, and patterns on a plane.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/content/pattern.h"

namespace hogelscope {

/// Codes a pair of indices below 4096 as R = a mod 256, G = b mod 256, B = ⌊a/256⌋ + 16 ⌊b/256⌋.
class CodePattern : public Pattern {
 public:
  enum Kind { directions, hogels, sides };  ///< sides: red (255, 0, 0) if u < du/2, else blue

  /// Throws InputError if an index does not fit.
  CodePattern(const PanelParams& display, Kind kind);
  void row(int y, std::uint8_t* rgb) const override;

 private:
  LightFieldSize m_size;
  Kind m_kind;
};

/// A plane parallel to the panel, sampled by the middle ray of each directional pixel. The
/// checkerboard's squares have a corner on the axis; the square to the right above it is white. The
/// edge goes through the axis: dark (64) to its left, bright (191) to its right.
class PlanePattern : public Pattern {
 public:
  enum Kind { checkerboard, edge };

  PlanePattern(const PanelParams& display, const PatternParams& params, Kind kind);
  void row(int y, std::uint8_t* rgb) const override;

 private:
  [[nodiscard]] std::uint8_t value(double x, double y) const;

  Display m_display;
  PatternParams m_params;
  Kind m_kind;
  Vec2 m_normal;  ///< the edge's normal, to its bright side
};

struct NamedPattern {
  std::string_view name;
  std::string_view help;  ///< a description of the content
  std::unique_ptr<Pattern> (*make)(const PanelParams& display, const PatternParams& params);
};

const std::vector<NamedPattern>& patterns();

/// Makes a pattern. Throws InputError for an unknown name, or a display without hogels or
/// directions.
std::unique_ptr<Pattern> makePattern(const std::string& name, const PanelParams& display,
                                     const PatternParams& params);

}  // namespace hogelscope
