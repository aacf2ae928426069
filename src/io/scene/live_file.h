// SPDX-License-Identifier: BSD-3-Clause
// Live scenes as light fields that can be opened.
#pragma once

#include <memory>
#include <vector>

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
  /// Opens the content for the display, which gives hogels and directions; of an animation the
  /// first frame. Throws InputError, Cancelled.
  LiveFile(const LightFieldParams& params, const DisplayParams& display,
           const Progress& progress = {});

  [[nodiscard]] LightFieldSize size() const override { return Display(m_display).size(); }
  [[nodiscard]] std::vector<std::filesystem::path> files() const override;
  [[nodiscard]] std::string cutWarning(const CameraState& state) const override;
  /// Says what a capture does not cover.
  [[nodiscard]] std::vector<std::string> warnings() const override;
  [[nodiscard]] StoredType type() const override;
  /// Returns those of an animation: its time k / frameRate() is frame k, up to its end.
  [[nodiscard]] FrameNumbers frames() const override { return m_frames; }
  [[nodiscard]] std::size_t framesInFiles() const override { return m_frameCount; }
  [[nodiscard]] double frameRate() const override;
  /// Shows the content at a frame. Sources of other frames that are in use keep theirs.
  void select(int frame) override;
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
  [[nodiscard]] std::shared_ptr<plugin::ContentSource> opened(const Progress& progress) const;

  LightFieldParams m_params;
  PanelParams m_display;
  /// All that were opened: one, unless a source shows one frame while another is selected.
  std::vector<std::shared_ptr<plugin::ContentSource>> m_contents;
  std::shared_ptr<plugin::ContentSource> m_content;  ///< the one that shows the selected frame
  std::size_t m_frameCount = 1;
  FrameNumbers m_frames;
};

/// Reads a mesh and makes it fill nine tenths of a panel that has its shape, seen from the front,
/// and a longer side of 0.5 m, or less, so that the eye in front of the display (inFrontOf()) sees
/// all of the mesh within the panel's edges. A quarter of its depth, but not more than a tenth of
/// that side, is in front of the panel. Sets the content's position and scale, and the display's
/// size, hogels, directions and field of view. A mesh with animations gets its first one, and all
/// of its movement fits. Throws InputError, Cancelled.
void fitMesh(LightFieldParams& params, DisplayParams& display, const Progress& progress);

}  // namespace hogelscope
