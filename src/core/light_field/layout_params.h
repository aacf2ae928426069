// SPDX-License-Identifier: BSD-3-Clause
// The parameters of single layouts: an image taken through an array of lenslets, a file of raw
// YUV, and a live scene (those of its content, and those of its sampling).
#pragma once

#include <array>
#include <string>

#include "core/base/parameters.h"
#include "core/base/plugin_params.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

enum class LensletGrid { square, hexagonal };

/// The parameters of an image taken through an array of lenslets. Values that are not given are
/// found in the white image (docs/formulas.md, Lenslets).
struct LensletParams {
  std::string white;  ///< an image of even light; "" = the light field itself
  std::string dark;   ///< an image without light; "" = none
  LensletGrid grid = LensletGrid::square;
  double pitch = notGiven;     ///< pixels between neighbours in a row
  double rotation = notGiven;  ///< degrees, of a row; clockwise in the image is positive
  /// x and y of the first lenslet's middle; the middle of the top left pixel is (0, 0).
  std::array<double, 2> origin{notGiven, notGiven};
  double gain = 1;  ///< factor of the light, for images that use few of their bits
  [[nodiscard]] bool isOriginGiven() const {
    return origin[0] != notGiven && origin[1] != notGiven;
  }
  bool operator==(const LensletParams&) const = default;
};

/// The parameters of a file of raw YUV.
enum class YuvSampling { s420, s444 };
enum class YuvMatrix { bt709, bt601 };
enum class YuvRange { limited, full };

/// The format of one image: its planes Y, Cb, Cr, one after the other (docs/formulas.md, Raw YUV).
struct YuvParams {
  std::array<int, 2> size{0, 0};  ///< width and height in pixels, 0 = not given
  YuvSampling sampling = YuvSampling::s420;
  int bits = 8;  ///< 8: bytes; 10: words of 16 bits, the low byte first
  YuvMatrix matrix = YuvMatrix::bt709;
  YuvRange range = YuvRange::limited;
  bool operator==(const YuvParams&) const = default;
};

using ContentParams = PluginParams<plugin::ContentSource>;

/// The sampling of a live scene. A texel is the mean over `samples` points of hogel aperture ×
/// directional pixel, on a rank-1 lattice that is the same for every texel.
struct LiveParams {
  int samples = 1;                       ///< 1: the middle only
  std::array<double, 2> fill{1, 1};      ///< sampled part of a hogel's side and of a direction's
  std::array<double, 2> depth{-10, 10};  ///< content is cut to these z, metres
  bool operator==(const LiveParams&) const = default;
};

void describe(ParameterVisitor& v, LiveParams& p);

}  // namespace hogelscope
