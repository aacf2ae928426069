// SPDX-License-Identifier: BSD-3-Clause
// The parameters of a live scene: those of its content, and those of its sampling.
#pragma once

#include <array>

#include "core/base/plugin_params.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

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
