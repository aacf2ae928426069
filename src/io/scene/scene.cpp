// SPDX-License-Identifier: BSD-3-Clause
// Opens light fields, and makes the views of a session's states.
#include "io/scene/scene.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "core/base/error.h"
#include "io/files/folders.h"
#include "io/layouts/hogel_image.h"
#include "io/layouts/lenslet_picture.h"
#include "io/layouts/view_layouts.h"
#include "io/layouts/view_sequences.h"
#include "io/scene/live_file.h"
#include "io/store/light_field_store.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

std::unique_ptr<LightFieldFile> openStore(const LightFieldParams& params,
                                          const DisplayParams& display) {
  auto store = std::make_unique<LightFieldStore>(params.file, params.incoming);
  (void)resolved(display, store->size());  // both say the size: they must agree
  return store;
}

}  // namespace

namespace {

bool holdsViews(const std::string& file) {
  return isFolder(file) || isViewSequence(file);
}

}  // namespace

LightFieldParams lightFieldOf(const std::string& file) {
  if (!isFolder(file) && isMeshFile(file)) return lightFieldOfMesh(file);
  LightFieldParams params;
  params.file = file;
  if (holdsViews(file))
    params.layout = Layout::views;
  else if (LightFieldStore::isStore(file))
    params.layout = Layout::pack;
  else if (quiltTilesFromName(file)[0] > 0)
    params.layout = Layout::quilt;
  return params;
}

LightFieldParams withFile(const LightFieldParams& params, const std::string& file) {
  const bool isAnotherKind = params.isLive() || isMeshFile(file) ||
                             holdsViews(file) != (params.layout == Layout::views) ||
                             LightFieldStore::isStore(file) != (params.layout == Layout::pack);
  LightFieldParams result = isAnotherKind ? lightFieldOf(file) : params;
  if (!isAnotherKind) result.file = file;
  result.viewingDistance = params.viewingDistance;
  return result;
}

std::unique_ptr<LightFieldFile> openLightField(const LightFieldParams& params,
                                               const DisplayParams& display,
                                               const Progress& progress) {
  switch (params.layout) {
    case Layout::views:
      return openViews(params, display);
    case Layout::quilt:
      return openQuilt(params);
    case Layout::mosaic:
      return openMosaic(params, display);
    case Layout::lenslets:
      return openLenslets(params, display, progress);
    case Layout::pack:
      return openStore(params, display);
    case Layout::live:
      return std::make_unique<LiveFile>(params, display, progress);
    default:
      if (LightFieldStore::isStore(params.file))
        throw InputError(params.file, "lightField.layout",
                         "is \"hogels\", but the file is a store: give \"pack\"");
      return openHogelImage(params, display);
  }
}

bool readTheSame(const Session& a, const Session& b) {
  const DisplayParams& ours = a.display;
  const DisplayParams& others = b.display;
  const bool haveSameRays = ours.size == others.size && ours.fov == others.fov &&
                            ours.lens == others.lens && ours.lensSource == others.lensSource &&
                            ours.lensParams == others.lensParams;
  return a.lightField == b.lightField && ours.hogels == others.hogels &&
         ours.directions == others.directions && (haveSameRays || !a.lightField.isLive());
}

Scene unloadedScene(const Session& session, const LightFieldFile& file) {
  Scene scene{std::make_shared<const StreamedLightField>(file.size(), file.type()),
              resolved(displayOf(session), file.size()), session.sampling, false};
  scene.sampling.tolerance = 0;
  return scene;
}

void requireScene(const Session& session) {
  if (!session.lightField.isLive()) throw InputError("lightField.layout", noIdealView);
}

Scene loadScene(const Session& session, const Progress& progress, const SourceUse& use) {
  return loadScene(session, *openLightField(session.lightField, session.display, progress),
                   progress, use);
}

Scene loadScene(const Session& session, LightFieldFile& file, const Progress& progress,
                const SourceUse& use) {
  return {file.source(use, progress), resolved(displayOf(session), file.size()), session.sampling,
          false};
}

}  // namespace hogelscope
