// SPDX-License-Identifier: BSD-3-Clause
// The parameters of a plugin's hogel lens, and the lenses made from them.
#pragma once

#include "core/base/plugin_params.h"
#include "core/panel/hogel_lens.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

/// Copies share the opened lenses, so a display can be made repeatedly, and a lens file that
/// changes meanwhile does not change a job.
class LensParams : public PluginParams<plugin::HogelLens> {
 public:
  LensParams() = default;
  explicit LensParams(Make make);

  /// Returns the lens across (axis 0, u) or down (axis 1, v) for a full field of `fov` degrees.
  /// Only the first call with the same values opens it. Throws InputError with the plugin's
  /// message, or if the lens is not an increasing function with an inverse.
  [[nodiscard]] std::shared_ptr<const HogelLens> lens(std::size_t axis, double fov) const;

 private:
  struct Opened;
  std::shared_ptr<Opened> m_opened;
};

}  // namespace hogelscope
