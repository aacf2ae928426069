// SPDX-License-Identifier: BSD-3-Clause
// Live scenes as light fields that can be opened.
#pragma once

#include "core/content/live_source.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Whether the name is that of a mesh: of a kind that the plugin "mesh" shows (.glb, .gltf, .obj,
/// .ply), or of another one, which lightFieldOfMesh() refuses.
bool isMeshFile(const std::string& file);

/// Returns a live light field of a mesh, with the size and position in the file. Throws InputError
/// if its kind is not read or the plugin cannot be used.
LightFieldParams lightFieldOfMesh(const std::string& file);

class LiveFile : public LightFieldFile {
 public:
  /// Opens the content for the display, which gives hogels and directions. Throws InputError,
  /// Cancelled.
  LiveFile(const LightFieldParams& params, const DisplayParams& display,
           const Progress& progress = {});

  [[nodiscard]] LightFieldSize size() const override { return Display(m_display).size(); }
  [[nodiscard]] std::vector<std::filesystem::path> files() const override;
  [[nodiscard]] std::string cutWarning(const CameraState& state) const override;
  /// Says what a capture does not cover.
  [[nodiscard]] std::vector<std::string> warnings() const override;
  [[nodiscard]] StoredType type() const override;
  /// Traces the whole light field into memory.
  [[nodiscard]] LightField read(const Progress& progress) override;
  /// Returns a LiveSource.
  [[nodiscard]] std::shared_ptr<const LightFieldSource> source(const SourceUse& use,
                                                               const Progress& progress) override;
  /// Traces some directions of a row of hogels at a time. isStream() is false, since views trace
  /// the rays that they need.
  void stream(const HogelRow& row, const Progress& progress) override;

  [[nodiscard]] const plugin::ContentSource& content() const { return *m_content; }

 private:
  LightFieldParams m_params;
  PanelParams m_display;
  std::shared_ptr<const plugin::ContentSource> m_content;
};

/// Reads a mesh and makes it fill nine tenths of a panel that has its shape, seen from the front,
/// and a longer side of 0.5 m, or less, so that the eye in front of the display (inFrontOf()) sees
/// all of the mesh within the panel's edges. A quarter of its depth, but not more than a tenth of
/// that side, is in front of the panel. Sets the content's position and scale, and the display's
/// size, hogels, directions and field of view. Throws InputError, Cancelled.
void fitMesh(LightFieldParams& params, DisplayParams& display, const Progress& progress);

}  // namespace hogelscope
