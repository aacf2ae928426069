// SPDX-License-Identifier: BSD-3-Clause
// What the views of a session's states have in common.
#pragma once

#include <memory>
#include <string>

#include "core/optics/simulate.h"
#include "io/files/system_limits.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Throws InputError that names the file: missing, damaged, or not the display's size.
std::unique_ptr<LightFieldFile> openLightField(const LightFieldParams& params,
                                               const DisplayParams& display);

/// What the views of a session's states have in common: read once, shared.
struct Scene {
  std::shared_ptr<const LightFieldSource> lightField;
  DisplayParams display;  ///< resolved
  SamplingParams sampling;

  [[nodiscard]] View view(const CameraState& state) const {
    return {lightField, display, sampling, state};
  }
};

/// Would all of it take at most `memory` bytes?
bool fitsInMemory(const LightFieldFile& file, std::size_t memory);

/// How views fetch what they need of a store.
struct StoreUse {
  /// Bytes of decoded blocks that are kept, for an eye that moves: two views of the paper's light
  /// field. For views that have nothing in common new memory takes longer than decoding.
  std::size_t cache = 1000000000;
  int threads = 0;  ///< for each view; 0 = all
};

/// Reads the session's light field, or opens it where it is a store that is larger than `memory`
/// bytes. Throws InputError, or Cancelled.
Scene loadScene(const Session& session, const Progress& progress,
                std::size_t memory = allowedMemory(), const StoreUse& use = {});
/// The same of a light field that is open already: `file` is the session's.
Scene loadScene(const Session& session, LightFieldFile& file, const Progress& progress,
                std::size_t memory = allowedMemory(), const StoreUse& use = {});
/// For StreamingRenderer: the light field has no texels. The tolerance is 0, since no view can be
/// probed before the texels have come.
Scene unloadedScene(const Session& session, const LightFieldFile& file);

/// Do both sessions have the same light field in memory? Their displays may be otherwise different.
bool readTheSame(const Session& a, const Session& b);

/// A folder of views, a store, a quilt by its name, or a hogel image.
LightFieldParams lightFieldOf(const std::string& file);

/// Another file with the layout of `params`, unless one is a folder or a store and the other is
/// not.
LightFieldParams withFile(const LightFieldParams& params, const std::string& file);

}  // namespace hogelscope
