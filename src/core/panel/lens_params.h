// SPDX-License-Identifier: BSD-3-Clause
// A plugin's hogel lens: its parameters, and the lenses that they have made.
#pragma once

#include "core/base/plugin_params.h"
#include "core/panel/hogel_lens.h"
#include "sdk/hogelscope/plugin.h"

namespace hogelscope {

/// Copies share the lenses that they have opened, so a display can be made again and again, and a
/// file that changes meanwhile does not change a job.
class LensParams : public PluginParams<plugin::HogelLens> {
 public:
  LensParams() = default;
  explicit LensParams(Make make);

  /// Returns the lens across (axis 0, u) or down (axis 1, v) for a full field of `fov` degrees.
  /// Only the first call with the same values opens it. Throws InputError: what the plugin says, or
  /// it is no growing function with an inverse.
  [[nodiscard]] std::shared_ptr<const HogelLens> lens(std::size_t axis, double fov) const;

 private:
  struct Opened;
  std::shared_ptr<Opened> m_opened;
};

}  // namespace hogelscope
