// SPDX-License-Identifier: BSD-3-Clause
// Opens light fields, and makes the views of a session's states.
#include "io/scene/scene.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "core/base/error.h"
#include "io/files/folders.h"
#include "io/layouts/hogel_image.h"
#include "io/layouts/view_layouts.h"
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

LightFieldParams lightFieldOf(const std::string& file) {
  LightFieldParams params;
  params.file = file;
  if (isFolder(file))
    params.layout = Layout::views;
  else if (LightFieldStore::isStore(file))
    params.layout = Layout::pack;
  else if (quiltTilesFromName(file)[0] > 0)
    params.layout = Layout::quilt;
  return params;
}

LightFieldParams withFile(const LightFieldParams& params, const std::string& file) {
  const bool isAnotherKind = isFolder(file) != (params.layout == Layout::views) ||
                             LightFieldStore::isStore(file) != (params.layout == Layout::pack);
  if (isAnotherKind) return lightFieldOf(file);
  LightFieldParams result = params;
  result.file = file;
  return result;
}

std::unique_ptr<LightFieldFile> openLightField(const LightFieldParams& params,
                                               const DisplayParams& display) {
  switch (params.layout) {
    case Layout::views:
      return openViews(params, display);
    case Layout::quilt:
      return openQuilt(params);
    case Layout::pack:
      return openStore(params, display);
    default:
      if (LightFieldStore::isStore(params.file))
        throw InputError(params.file, "lightField.layout",
                         "is \"hogels\", but the file is a store: give \"pack\"");
      return openHogelImage(params, display);
  }
}

bool readTheSame(const Session& a, const Session& b) {
  return a.lightField == b.lightField && a.display.hogels == b.display.hogels &&
         a.display.directions == b.display.directions;
}

Scene unloadedScene(const Session& session, const LightFieldFile& file) {
  Scene scene{std::make_shared<const StreamedLightField>(file.size(), file.type()),
              resolved(session.display, file.size()), session.sampling};
  scene.sampling.tolerance = 0;
  return scene;
}

bool fitsInMemory(const LightFieldFile& file, std::size_t memory) {
  try {
    return LightField::bytes(file.size(), file.type()) <= memory;
  } catch (const std::length_error&) {
    return false;
  }
}

Scene loadScene(const Session& session, const Progress& progress, std::size_t memory,
                const StoreUse& use) {
  return loadScene(session, *openLightField(session.lightField, session.display), progress, memory,
                   use);
}

Scene loadScene(const Session& session, LightFieldFile& file, const Progress& progress,
                std::size_t memory, const StoreUse& use) {
  Scene scene{nullptr, resolved(session.display, file.size()), session.sampling};
  if (session.lightField.layout == Layout::pack && !fitsInMemory(file, memory))
    scene.lightField = std::make_shared<const LightFieldStore>(
        session.lightField.file, session.lightField.incoming, std::min(memory, use.cache),
        use.threads);
  else
    scene.lightField = std::make_shared<const LightField>(file.read(progress));
  return scene;
}

}  // namespace hogelscope
