// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/view_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/base/error.h"
#include "core/panel/twin.h"
#include "io/documents/session_file.h"
#include "io/files/files_in_use.h"
#include "io/files/folders.h"
#include "io/files/system_limits.h"
#include "io/plugins/plugin_library.h"
#include "io/scene/live_file.h"
#include "io/scene/numbered_frames.h"
#include "io/scene/woven_file.h"
#include "io/store/light_field_store.h"
#include "io/twin/twin_maps.h"

namespace hogelscope {

namespace {

std::unique_ptr<LightFieldFile> openStore(const LightFieldParams& params,
                                          const DisplayParams& display, const Progress&) {
  auto store = std::make_unique<LightFieldStore>(params.file, params.incoming);
  (void)resolved({display, params.viewingDistance},
                 store->size());  // the sizes of both must agree
  return store;
}

std::unique_ptr<LightFieldFile> openLive(const LightFieldParams& params,
                                         const DisplayParams& display, const Progress& progress) {
  return std::make_unique<LiveFile>(params, display, progress);
}

std::unique_ptr<LightFieldFile> openWoven(const LightFieldParams& params,
                                          const DisplayParams& display, const Progress& progress) {
  if (!display.sheet)
    throw InputError("lightField.layout",
                     "is \"woven\", the picture of a lens sheet's panel: give display.kind "
                     "\"sheet\"");
  return hogelsLayout.open(params, display, progress);
}

/// Returns the calibration for which views are woven.
const SheetCalibration& weaveOf(const LightFieldParams& params, const SheetDisplay& sheet) {
  return params.calibration ? *params.calibration : sheet.calibration;
}

/// Returns the display of hogels that has a sheet's views as its directions: each camera stands in
/// the viewing plane, before the panel's middle, and sees all of the panel.
DisplayParams displayOfViews(const DisplayParams& display) {
  const double tangent = std::tan(radians(display.fov[0]) / 2);
  DisplayParams views = display;
  views.sheet.reset();
  views.fov[1] =
      2 * std::atan(tangent / std::max(1, display.directions[0])) * 180 / std::numbers::pi;
  return views;
}

std::unique_ptr<LightFieldFile> openOnSheet(const LightFieldParams& params,
                                            const DisplayParams& display,
                                            const Progress& progress) {
  if (params.layout == Layout::woven) return openWoven(params, display, progress);
  const LensSheet sheet({.calibration = weaveOf(params, *display.sheet)});
  return std::make_unique<WovenFile>(openUnwoven(params, display, progress), sheet,
                                     params.isLive());
}

const LayoutType packLayout{.open = openStore, .holder = Holder::store};
const LayoutType liveLayout{.open = openLive, .holder = Holder::scene};
const LayoutType wovenLayout{.open = openWoven};

std::unique_ptr<LightFieldFile> openStill(const LightFieldParams& params,
                                          const DisplayParams& display, const Progress& progress) {
  if (params.layout == Layout::hogels && LightFieldStore::isStore(params.file))
    throw InputError(params.file, "lightField.layout",
                     "is \"hogels\", but the file is a store: give \"pack\"");
  if (display.sheet) return openOnSheet(params, display, progress);
  return typeOf(params.layout).open(params, display, progress);
}

/// Whether a file is raw YUV.
bool isYuv(const std::string& file) {
  return file.ends_with(".yuv");
}

/// Whether a file is raw YUV of which nothing says that it has several pictures.
bool isYuvPicture(const std::string& file, const YuvParams& yuv) {
  try {
    return isYuv(file) && ImageFile(file, yuv).frames() == 1;
  } catch (const InputError&) {
    return true;  // a session has to give its size
  }
}

}  // namespace

const LayoutType& typeOf(Layout layout) {
  static constexpr std::array<const LayoutType*, 8> types{
      &hogelsLayout,   &viewsLayout, &quiltLayout, &mosaicLayout,
      &lensletsLayout, &packLayout,  &liveLayout,  &wovenLayout};  // as the enumeration has them
  return *types[std::size_t(layout)];
}

Holder holderOf(const std::string& file, const YuvParams& yuv) {
  if (const std::string first = firstFileOf(file); first != file) return holderOf(first, yuv);
  if (isYuvPicture(file, yuv)) return Holder::picture;
  if (isFolder(file)) return Holder::views;
  if (LightFieldStore::isStore(file)) return Holder::store;  // whose pages are alike
  if (isViewSequence(file)) return Holder::views;
  return isMeshFile(file) ? Holder::scene : Holder::picture;
}

LightFieldParams lightFieldOf(const std::string& file, const YuvParams& yuv) {
  if (const std::string first = firstFileOf(file); first != file) {
    LightFieldParams params = lightFieldOf(first, yuv);
    params.file = file;
    return params;
  }
  const Holder holder = holderOf(file, yuv);
  if (holder == Holder::scene) return lightFieldOfMesh(file);
  LightFieldParams params;
  params.file = file;
  params.yuv = yuv;
  const bool areQuilts = quiltNameOf(file).tiles[0] > 0 && !isFolder(file);  // of a video, too
  if (holder == Holder::views && !areQuilts)
    params.layout = Layout::views;
  else if (holder == Holder::store)
    params.layout = Layout::pack;
  else if (areQuilts)
    params.layout = Layout::quilt;
  return params;
}

namespace {

/// Whether the files have the frames of the pattern: once, and at all.
bool hasFramesOf(const LightFieldParams& params) {
  if (params.pattern.find(frameMark) == std::string::npos) return true;
  if (params.file.find(frameMark) != std::string::npos) return false;
  try {
    (void)firstStillOf(params);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

LightFieldParams withFile(const LightFieldParams& params, const std::string& file) {
  const Holder holder = typeOf(params.layout).holder;
  const bool isPossible = holderOf(file) == holder || (isYuv(file) && holder == Holder::views);
  const bool isAnotherKind = params.isLive() || !isPossible;
  LightFieldParams result = isAnotherKind ? lightFieldOf(file) : params;
  if (!isAnotherKind) result.file = file;
  if (!isAnotherKind && !hasFramesOf(result)) result.pattern.clear();
  result.viewingDistance = params.viewingDistance;
  return result;
}

std::unique_ptr<LightFieldFile> openLightField(const LightFieldParams& params,
                                               const DisplayParams& display,
                                               const Progress& progress) {
  if (isNumbered(params))
    return std::make_unique<NumberedFrames>(params, display, openStill, progress);
  auto file = openStill(params, display, progress);
  (void)listedFrames(params, file->frames());
  return file;
}

std::vector<std::filesystem::path> filesOf(const Session& session, const LightFieldFile& file) {
  std::vector<std::filesystem::path> files = sessionFiles(session);
  std::ranges::copy(file.files(), std::back_inserter(files));
  return files;
}

std::vector<std::filesystem::path> filesOf(const Session& session) {
  try {
    return filesOf(session, *openLightField(session.lightField, session.display));
  } catch (const InputError&) {
    std::vector<std::filesystem::path> files = sessionFiles(session);
    files.emplace_back(contentName(session.lightField));
    return files;
  }
}

std::unique_ptr<LightFieldFile> openUnwoven(const LightFieldParams& params,
                                            const DisplayParams& display,
                                            const Progress& progress) {
  if (!display.sheet) return openLightField(params, display, progress);
  if (params.layout == Layout::woven)
    throw InputError("lightField.layout",
                     "is \"woven\", a picture of the panel, which does not say its views");
  if (!params.isLive()) return typeOf(params.layout).open(params, display, progress);
  LightFieldParams views = params;
  views.viewingDistance = display.sheet->viewingDistance;
  return openLive(views, displayOfViews(display), progress);
}

bool isInTime(const Session& session) {
  try {
    return !openLightField(session.lightField, session.display)->frames().isStill();
  } catch (const InputError&) {
    return false;
  }
}

int viewsOnSheet(const Session& session) {
  if (session.lightField.isLive()) return std::max(session.display.directions[0], 0);
  const auto [columns, rows] = quiltTilesOf(session.lightField);
  return columns * rows;
}

bool readTheSame(const Session& a, const Session& b) {
  const DisplayParams& ours = a.display;
  const DisplayParams& others = b.display;
  const bool haveSameRays = ours.size == others.size && ours.fov == others.fov &&
                            ours.lens == others.lens && ours.lensSource == others.lensSource &&
                            ours.lensParams == others.lensParams;
  if (ours.sheet.has_value() != others.sheet.has_value()) return false;
  const bool areWovenAlike =
      !ours.sheet ||
      (weaveOf(a.lightField, *ours.sheet) == weaveOf(b.lightField, *others.sheet) &&
       (!a.lightField.isLive() || ours.sheet->viewingDistance == others.sheet->viewingDistance));
  return a.lightField == b.lightField && areWovenAlike && ours.hogels == others.hogels &&
         ours.directions == others.directions && (haveSameRays || !a.lightField.isLive());
}

std::shared_ptr<const Twin> twinOf(const TwinParams& params, const PanelParams& display,
                                   std::vector<std::string>* warnings, const Progress& progress) {
  if (params.isZero()) return nullptr;
  checkFits(Twin::bytesFor(params, display), "twin");
  const Progress stop = progress ? Progress([&](double) { return progress(0); }) : Progress();
  return std::make_shared<const Twin>(params, readTwinMaps(params.maps, display, stop, warnings),
                                      display, stop);
}

ViewSource viewSourceOf(const Session& session, std::shared_ptr<const LightFieldSource> lightField,
                        const Progress& progress) {
  ViewSource source;
  source.lightField = std::move(lightField);
  source.display = resolved(displayOf(session), source.lightField->size());
  source.sampling = session.sampling;
  source.twin = twinOf(session.twin, source.display, &source.warnings, progress);
  return source;
}

ViewSource unloadedViewSource(const Session& session, const LightFieldFile& file,
                              const Progress& progress) {
  ViewSource source = viewSourceOf(
      session, std::make_shared<const StreamedLightField>(file.size(), file.type()), progress);
  source.files = std::make_shared<const FilesInUse>(filesOf(session, file));
  if (session.lightField.isLive())
    for (const std::string& warning : file.warnings()) source.warnings.push_back(warning);
  return source;
}

void requireLive(const Session& session) {
  if (!session.lightField.isLive()) throw InputError("lightField.layout", noIdealView);
}

ViewSource loadViewSource(const Session& session, const Progress& progress, const SourceUse& use) {
  return loadViewSource(session, *openLightField(session.lightField, session.display, progress),
                        progress, use);
}

ViewSource loadViewSource(const Session& session, LightFieldFile& file, const Progress& progress,
                          const SourceUse& use) {
  // The twin's maps, and what is wrong with them, come before the light field is read.
  ViewSource source = unloadedViewSource(session, file, progress);
  source.lightField = file.source(use, progress);
  return source;
}

LightFieldParams withDefaults(const LightFieldParams& before, LightFieldParams after) {
  if (after.layout != before.layout && after.isLive()) {
    after = {};
    after.layout = Layout::live;
    after.source = "scene";
  } else if (!after.isLive() && before.isLive()) {
    const Layout layout = after.layout;
    after = {};
    after.layout = layout;
  }
  if (after.layout == Layout::woven) after.calibration.reset();
  if (after.calibration != before.calibration) after.calibrationFile.clear();
  if (after.source != before.source)
    after.content = after.source.empty() ? ContentParams() : contentParamsOf(after.source);
  return after;
}

}  // namespace hogelscope
