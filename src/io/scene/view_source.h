// SPDX-License-Identifier: BSD-3-Clause
// Opens light fields, and makes the views of a session's states.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/optics/simulate.h"
#include "io/files/files_in_use.h"
#include "io/layouts/layouts.h"

namespace hogelscope {

/// Returns the properties of a layout.
const LayoutType& typeOf(Layout layout);

/// Returns the kind of a file or folder, by its name or its first bytes.
Holder holderOf(const std::string& file, const YuvParams& yuv = {});

/// Opens a light field. A live scene's content is read here, and reports to `progress`. Throws
/// InputError (missing, damaged, or not of the display's size); Cancelled.
std::unique_ptr<LightFieldFile> openLightField(const LightFieldParams& params,
                                               const DisplayParams& display,
                                               const Progress& progress = {});

/// Returns all files that a session's results depend on, with those of its open light field.
std::vector<std::filesystem::path> filesOf(const Session& session, const LightFieldFile& file);
/// Opens the light field for that; without the light field's parts if it cannot be opened.
std::vector<std::filesystem::path> filesOf(const Session& session);

/// Opens the views that a lens sheet's panel is woven of: a quilt's, or those of a live scene; on a
/// display of hogels as openLightField(). Throws as that, also for a picture of the panel.
std::unique_ptr<LightFieldFile> openUnwoven(const LightFieldParams& params,
                                            const DisplayParams& display,
                                            const Progress& progress = {});

/// Returns the number of views that a lens sheet shows: those of the quilt or of the live scene; 0
/// if it is not known, as of a panel's picture.
int viewsOnSheet(const Session& session);

/// The common part of the views of a session's states, read once and shared: a job without a state.
struct ViewSource : RenderJob {
  /// The session's files: nothing replaces them while views are made of them.
  std::shared_ptr<const FilesInUse> files;
  std::vector<std::string> warnings;  ///< what is assumed of the maps of the session's twin

  [[nodiscard]] RenderJob job(const CameraState& ofView) const {
    RenderJob job = *this;
    job.state = ofView;
    return job;
  }
};

/// Reads a twin's maps for a display with its hogels and directions. Returns null for one without
/// errors. What is assumed of the maps is added to `warnings`. Throws InputError (also if its
/// hogels do not fit into the allowed memory), Cancelled.
std::shared_ptr<const Twin> twinOf(const TwinParams& params, const PanelParams& display,
                                   std::vector<std::string>* warnings = nullptr,
                                   const Progress& progress = {});

/// Returns the source of a session's views of a light field, without `files`. Throws InputError as
/// resolved() and twinOf(), and Cancelled.
ViewSource viewSourceOf(const Session& session, std::shared_ptr<const LightFieldSource> lightField,
                        const Progress& progress = {});

/// Reads the session's light field, or opens it if it is a store that is larger than `use.memory`
/// bytes, or a live scene. Throws InputError, or Cancelled.
ViewSource loadViewSource(const Session& session, const Progress& progress,
                          const SourceUse& use = {});
/// Reads the session's light field, which is open already as `file`.
ViewSource loadViewSource(const Session& session, LightFieldFile& file, const Progress& progress,
                          const SourceUse& use = {});
/// Throws InputError unless the session's light field is live, so that it has ideal views.
void requireLive(const Session& session);
/// Returns the source of a session's views of an open light field, which has no texels yet: for
/// StateImages and StreamingRenderer. Throws as viewSourceOf().
ViewSource unloadedViewSource(const Session& session, const LightFieldFile& file,
                              const Progress& progress = {});

/// Whether the session's light field has several frames; false if it cannot be opened.
bool isInTime(const Session& session);

/// Whether both sessions read the same light field. Their displays need only have the same hogels
/// and directions, and the same rays if it is live.
bool readTheSame(const Session& a, const Session& b);

/// Returns a light field of the kind that holderOf() returns: views, a store, a mesh, or else a
/// quilt (by its name) or a hogel image. `yuv` has what raw YUV does not say. Throws InputError for
/// a mesh if there is no plugin for it.
LightFieldParams lightFieldOf(const std::string& file, const YuvParams& yuv = {});

/// Returns `params` with another file, of the same layout if both files are of the same kind;
/// otherwise, or if one is live, as lightFieldOf().
LightFieldParams withFile(const LightFieldParams& params, const std::string& file);

/// Returns an edited light field with the default fields of a new layout or source. Throws
/// InputError if there is no such source.
LightFieldParams withDefaults(const LightFieldParams& before, LightFieldParams after);

}  // namespace hogelscope
