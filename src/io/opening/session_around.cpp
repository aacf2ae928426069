// SPDX-License-Identifier: BSD-3-Clause
#include "io/opening/session_around.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "capture/order/picture_grids.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/cameras/state_list_edits.h"
#include "io/documents/session_file.h"
#include "io/documents/sheet_file.h"
#include "io/files/folders.h"
#include "io/opening/capture_geometry.h"
#include "io/opening/frame_folders.h"
#include "io/opening/view_cameras.h"
#include "io/scene/live_file.h"
#include "io/scene/numbered_frames.h"
#include "io/scene/view_source.h"
#include "io/store/light_field_store.h"

namespace hogelscope {

namespace {

/// Returns a size of this shape whose longer side is 0.5 m.
std::array<double, 2> sizeOfShape(double width, double height) {
  const double longest = std::max(width, height) / 0.5;
  return {width / longest, height / longest};
}

/// Whether hogels are so few and so large that they are rather tiles, each of which is a view.
bool areLikeTiles(const HogelGrid& grid) {
  constexpr int mostTiles = 32, leastPixels = 24;
  return std::ranges::max(grid.hogels) <= mostTiles &&
         std::ranges::min(grid.directions) >= leastPixels && grid.hogels[0] <= grid.directions[0] &&
         grid.hogels[1] <= grid.directions[1];
}

/// Whether hogels are clear and much smaller than the tiles, so that these repeat on the panel.
bool areFiner(const HogelGrid& hogels, const TileGrid& tiles) {
  constexpr int finer = 3;
  return hogels.isDistinct && hogels.hogels[0] >= finer * tiles.tiles[0] &&
         hogels.hogels[1] >= finer * tiles.tiles[1];
}

/// Puts a quilt's or a mosaic's number of views into the session.
void takeTiles(OrderedSession& result, const std::array<int, 2>& tiles, const std::string& how) {
  const bool isMosaic = result.session.lightField.layout == Layout::mosaic;
  if (isMosaic) {
    result.session.display.directions = tiles;
  } else {
    result.session.lightField.layout = Layout::quilt;
    result.session.lightField.quiltColumns = tiles[0];
    result.session.lightField.quiltRows = tiles[1];
  }
  result.assumed = (isMosaic ? "a mosaic of " : "a quilt of ") + pairText(tiles[0], tiles[1]) +
                   " views, found by " + how;
}

void takeHogels(OrderedSession& result, const HogelGrid& grid) {
  result.session.lightField.layout = Layout::hogels;
  result.session.display.hogels = grid.hogels;
  result.session.display.directions = grid.directions;
  result.assumed = pairText(grid.hogels[0], grid.hogels[1]) + " hogels of " +
                   pairText(grid.directions[0], grid.directions[1]) +
                   " directions, found by their borders in the picture";
}

void takeLenslets(OrderedSession& result, const LensletLattice& lattice) {
  result.session.lightField.layout = Layout::lenslets;
  result.session.lightField.lenslets.grid = lattice.grid;
  result.hogels = Sureness::likely;
  result.assumed = std::string("lenslets on a ") +
                   (lattice.grid == LensletGrid::square ? "square" : "hexagonal") +
                   " grid of pitch " + rounded(lattice.pitch(), 2) +
                   " px, found by their spots of light";
}

/// Recognises lenslets in an image of which nothing else is known.
std::optional<FoundLenslets> lensletsIn(const PictureRows& picture, const Progress& progress) {
  constexpr double mostPixels = 1e8;  // a few seconds
  if (double(picture.width) * double(picture.height) > mostPixels) return std::nullopt;
  LensletPlane plane{int(picture.width), int(picture.height), {}};
  plane.values.reserve(picture.width * picture.height);
  picture.read(
      [&](std::size_t, const float* rgb) {
        for (std::size_t x = 0; x < picture.width; ++x, rgb += 3)
          plane.values.push_back((rgb[0] + rgb[1] + rgb[2]) / 3);
      },
      part(progress, 0, 0.5));
  return recognisedLenslets(plane, part(progress, 0.5, 1));
}

/// What is given of a light field whose size is to be found in its image.
struct Given {
  const Session& session;
  bool isLayoutGiven = false;
  std::array<std::size_t, 2> picture{0, 0};  ///< width, height
};

/// Finds the order of what was taken for the image's layout.
void orderTaken(OrderedSession& result, const Given& given, const Progress& progress) {
  DisplayParams display = given.session.display;
  display.hogels = result.session.display.hogels;
  display.directions = result.session.display.directions;
  LightFieldParams& lightField = result.session.lightField;
  result.order = findLightFieldOrder(lightField, display, progress);
  if (lightField.layout != Layout::quilt || given.isLayoutGiven) return;
  constexpr std::size_t smallest = 100;  // pixels of a quilt's view; a mosaic's may be smaller
  const bool isSmall = result.order.sureness == Sureness::unknown && !result.order.isLikeQuilt &&
                       std::min(given.picture[0] / std::size_t(lightField.quiltColumns),
                                given.picture[1] / std::size_t(lightField.quiltRows)) < smallest;
  if (!result.order.isLikeMosaic && !isSmall) return;
  const std::array tiles{std::exchange(lightField.quiltColumns, 0),
                         std::exchange(lightField.quiltRows, 0)};
  lightField.layout = Layout::mosaic;
  takeTiles(result, tiles,
            result.order.isLikeMosaic ? "parallax along both axes"
                                      : "how alike they are, small for a quilt");
  display.directions = tiles;
  result.order = findLightFieldOrder(lightField, display, progress);
}

/// Whether views move against each other as those of neighbouring cameras do, and more at some
/// places than at others. A continuous picture that is cut into hogels moves alike everywhere.
bool doViewsAgree(const LightFieldOrder& order) {
  constexpr double clear = 0.5;
  const ViewOrder& measured = order.measured;
  return !measured.isInconsistent && !measured.isTransposed &&
         (order.sureness != Sureness::unknown || std::abs(measured.correlation) >= clear);
}

/// Judges what was found in the image by whether its views agree. An order is not surer than the
/// layout that it is of.
void judgeTaken(OrderedSession& result, bool isClear) {
  const bool isAgreed = doViewsAgree(result.order);
  const bool isOrdered = result.order.sureness != Sureness::unknown;
  result.hogels = !isAgreed              ? Sureness::unknown
                  : isClear && isOrdered ? Sureness::sure
                                         : Sureness::likely;
  if (isAgreed) return;
  result.order.sureness = Sureness::unknown;
  result.order.found.shear = {0, 0};
}

/// Whether an image may be what was taken for its layout although its views tell nothing: not where
/// enlarged pixels or content that nearly repeats look the same.
bool isLikely(const OrderedSession& taken, const PictureGrids& grids) {
  constexpr double alike = 0.35, clear = 8;
  if (taken.session.lightField.layout == Layout::hogels) return !grids.hogels->isVague;
  return (grids.tiles && grids.tiles->likeness > alike) ||
         (grids.hogels && areLikeTiles(*grids.hogels) && grids.hogels->standOut >= clear);
}

/// Tries tiles and hogels, and returns the reading whose views agree, or else the first one.
std::optional<OrderedSession> bestReading(const OrderedSession& around, const PictureGrids& grids,
                                          const Given& given, const Progress& progress) {
  const auto& [hogels, tiles] = grids;
  const bool isTiled = typeOf(around.session.lightField.layout).isOfTiles;
  constexpr double clear = 8;  // standard errors
  const bool mayBeHogels = !isTiled && hogels && (given.isLayoutGiven || !areLikeTiles(*hogels));
  const bool mayBeTiles = isTiled || !given.isLayoutGiven;
  std::vector<std::pair<OrderedSession, bool>> readings;  // whether their borders are clear
  const auto addTiles = [&](const std::array<int, 2>& numbers, const std::string& how) {
    const auto [across, down] = given.session.display.directions;
    if (isTiled && across > 0 && across * down != numbers[0] * numbers[1]) return;
    takeTiles(readings.emplace_back(around, false).first, numbers, how);
  };
  if (mayBeHogels && tiles && areFiner(*hogels, *tiles))
    takeHogels(readings.emplace_back(around, hogels->standOut >= clear).first, *hogels);
  if (mayBeTiles && tiles) addTiles(tiles->tiles, "how alike they are");
  if (mayBeTiles && hogels && areLikeTiles(*hogels) && (!tiles || tiles->tiles != hogels->hogels))
    addTiles(hogels->hogels, "their borders in the picture");
  if (mayBeHogels && (!tiles || !areFiner(*hogels, *tiles)))
    takeHogels(readings.emplace_back(around, hogels->standOut >= clear).first, *hogels);
  std::optional<OrderedSession> best;
  for (auto& [reading, isClear] : readings) {
    orderTaken(reading, given, progress);
    judgeTaken(reading, isClear && hogels->isDistinct);
    const bool isAgreed = reading.hogels != Sureness::unknown;
    if (!isAgreed && !isLikely(reading, grids)) continue;
    if (!best || isAgreed) best = std::move(reading);
    if (isAgreed) break;
  }
  return best;
}

/// Finds hogels, tiles of views, or lenslets in the image, puts them into the session with their
/// order, and describes them. Returns whether it found any. May change the layout unless it is
/// given.
bool findHogels(OrderedSession& result, Given given, const Progress& progress) {
  const LightFieldParams& lightField = result.session.lightField;
  ImageFile image(lightField.file, lightField.yuv);
  const PictureRows picture{
      image.width(), image.height(),
      [&image](const PictureRows::Row& row, const Progress& hear) { image.readRows(row, hear); }};
  const PictureGrids grids = findPictureGrids(picture, part(progress, 0, 0.5));
  given.picture = {picture.width, picture.height};
  result.hogels = Sureness::unknown;
  auto best = bestReading(result, grids, given, part(progress, 0.5, 0.7));
  const bool isAgreed = best && best->hogels != Sureness::unknown;
  if (!isAgreed && !given.isLayoutGiven)
    if (const auto lenslets = lensletsIn(picture, part(progress, 0.7, 1))) {
      takeLenslets(result, lenslets->lattice);
      return false;
    }
  if (!best) return false;
  result = std::move(*best);
  return true;
}

bool isGiven(const std::vector<std::string>& overrides, const std::string& field) {
  return std::ranges::any_of(
      overrides, [&](const std::string& text) { return text.starts_with(field + "="); });
}

bool isLayoutGiven(const std::vector<std::string>& overrides) {
  return isGiven(overrides, "lightField.layout");
}

/// Returns the session with the overrides. Unless one gives the layout, those of the light field
/// that this layout does not know are left out, since they may be of the layout to be found.
Session overriddenWhereKnown(const Session& session, const std::vector<std::string>& overrides) {
  if (isLayoutGiven(overrides)) return overridden(session, overrides);
  std::vector<std::string> known;
  for (const std::string& one : overrides) {
    try {
      if (one.starts_with("lightField.")) (void)overridden(session, {one});
      known.push_back(one);
    } catch (const InputError&) {  // thrown again once the layout is found
    }
  }
  return overridden(session, known);
}

/// Returns what overrides say of raw YUV.
YuvParams yuvOf(Session views, const std::vector<std::string>& overrides) {
  views.lightField.layout = Layout::views;
  std::vector<std::string> own;
  std::ranges::copy_if(overrides, std::back_inserter(own),
                       [](const std::string& one) { return one.starts_with("lightField.yuv"); });
  return own.empty() ? YuvParams{} : overridden(views, own).lightField.yuv;
}

/// Returns the display; `given` may contain the number of directions for views with one running
/// number.
PanelParams displayAround(const LightFieldParams& lightField, const DisplayParams& given) {
  PanelParams display;
  if (lightField.layout == Layout::hogels) {
    const ImageFile image(lightField.file, lightField.yuv);
    display.size = sizeOfShape(double(image.width()), double(image.height()));
    return display;
  }
  if (typeOf(lightField.layout).holder == Holder::store)
    if (const auto known = LightFieldStore(lightField.file).header().display) return *known;
  const LightFieldSize size = openLightField(lightField, given)->size();
  const double aspect =
      lightField.layout == Layout::quilt ? quiltNameOf(lightField.file).aspect : 0;
  display.size = aspect > 0 ? sizeOfShape(aspect, 1) : sizeOfShape(size.nx, size.ny);
  return display;
}

/// Finds the order of what is read as `said`: by cameras in a file beside views, if there is one,
/// whose grid `said` then has, or else by the pictures.
std::optional<ViewCameras> takeOrder(OrderedSession& result, Session& said, bool isScanGiven,
                                     const Progress& progress) {
  ViewCamerasSearch beside = findViewCameras(said.lightField, said.display, isScanGiven);
  std::optional<CameraOrder> order;
  if (beside.found) {
    const ViewCameras& cameras = *beside.found;
    order = cameras.order;
    said.lightField.pattern = cameras.pattern;
    said.lightField.scan = cameras.scan;
    said.display.directions = {cameras.grid.columns, cameras.grid.rows};
    result.assumed = pairText(cameras.grid.columns, cameras.grid.rows) +
                     " views by their cameras' places in " + order->file;
  }
  result.order = findLightFieldOrder(said.lightField, said.display, progress, order);
  auto& warnings = result.order.warnings;
  warnings.insert(warnings.begin(), beside.lines.begin(), beside.lines.end());
  if (beside.isContradicted) {
    result.order.sureness = Sureness::unknown;
    result.order.reason = "the cameras' places contradict the file names; " + result.order.reason;
    result.order.found.shear = said.lightField.shear;
  }
  return std::move(beside.found);
}

/// Returns the geometry of a capture, by its own file or by a file of cameras beside the views.
std::optional<CaptureGeometry> geometryOf(OrderedSession& result, const ViewFiles& views,
                                          const std::optional<ViewCameras>& cameras) {
  const LightFieldParams& lightField = result.session.lightField;
  const ImageFile first(views.found().front(), lightField.yuv);
  const auto [width, height] = std::pair(int(first.width()), int(first.height()));
  if (auto geometry = captureGeometry(lightField.file, views, width, height)) {
    result.assumed.clear();  // nothing is: that file has a scale
    return geometry;
  }
  if (!cameras) return std::nullopt;
  KnownFocus focus{lightField.viewingDistance, {}};
  if (hasMiddleMotion(result.order.measured)) focus.shear = result.order.found.shear;
  std::string why;
  auto geometry = captureGeometry(*cameras, focus, width, height, why);
  if (!why.empty()) result.order.warnings.push_back(why);
  if (geometry && !cameras->hasScale) result.assumed += ", whose unit is taken for the metre";
  return geometry;
}

/// Puts the panel into the plane in focus if the capture gives the positions of its cameras.
/// Returns whether it does. Tells of directions that the file names contradict.
bool takeGeometry(OrderedSession& result, const DisplayParams& given,
                  const std::optional<ViewCameras>& cameras) {
  Session& session = result.session;
  LightFieldParams& lightField = session.lightField;
  if (lightField.layout != Layout::views || !isFolder(lightField.file)) return false;
  const ViewFiles views = findViews(lightField, given.directions);
  if (!views.ignored.empty()) result.order.warnings.push_back(views.ignored);
  if (cameras && cameras->isCounted) session.display.directions = given.directions;
  const auto geometry = geometryOf(result, views, cameras);
  if (!geometry) return false;
  const auto rounded = [](std::array<double, 2> pair) {  // for readers of the session
    for (double& value : pair) value = std::round(value * 1e6) / 1e6;
    return pair;
  };
  session.display.size = rounded(geometry->panel);
  session.display.fov = rounded(geometry->fovOf(views.columns, views.rows));
  lightField.viewingDistance = std::round(geometry->distance * 1e6) / 1e6;
  lightField.shear = rounded(geometry->shear);
  return true;
}

/// Returns what the overrides say of the names of frames, and leaves the others there.
LightFieldParams takeFrameNames(std::vector<std::string>& overrides, const std::string& file) {
  constexpr std::string_view ofPattern = "lightField.pattern=";
  LightFieldParams params;
  params.file = file;
  std::erase_if(overrides, [&](const std::string& text) {
    if (text.starts_with(ofPattern)) params.pattern = text.substr(ofPattern.size());
    return text.starts_with(ofPattern) || text.starts_with("lightField.frames=") ||
           text.starts_with("lightField.fps=");
  });
  return params;
}

OrderedSession sessionAroundStill(const std::string& file,
                                  const std::vector<std::string>& overrides,
                                  const Progress& progress) {
  OrderedSession result;
  Session& session = result.session;
  session.lightField = lightFieldOf(file);
  addState(session, inFrontOf(displayOf(session)));
  if (const YuvParams yuv = yuvOf(session, overrides); yuv != YuvParams{})
    session.lightField = lightFieldOf(file, yuv);
  if (session.lightField.isLive()) {
    fitMesh(session.lightField, session.display, progress);
  } else {
    Session said = overriddenWhereKnown(session, overrides);  // which may contain how to read it
    session.lightField = said.lightField;
    const auto isWhole = [&said] {
      return typeOf(said.lightField.layout).isWhole(said.lightField, said.display);
    };
    bool isOrdered = false;
    std::optional<ViewCameras> cameras;
    if (!isWhole()) {
      isOrdered = findHogels(result, {said, isLayoutGiven(overrides), {}}, part(progress, 0, 0.8));
      said.lightField = session.lightField;
      said.display.hogels = session.display.hogels;
      said.display.directions = session.display.directions;
    }
    if (isWhole()) {
      if (!isOrdered)
        cameras =
            takeOrder(result, said, isGiven(overrides, "lightField.scan"), part(progress, 0.8, 1));
      session.lightField = result.order.found;
    }
    const PanelParams around = displayAround(session.lightField, said.display);
    session.display = around;
    const Layout layout = session.lightField.layout;
    if (layout == Layout::hogels || layout == Layout::mosaic) {
      session.display.hogels = said.display.hogels;
      session.display.directions = said.display.directions;
    }
    if (around.viewingDistance > 0) session.lightField.viewingDistance = around.viewingDistance;
    if (takeGeometry(result, said.display, cameras)) {
      result.order.found.viewingDistance = session.lightField.viewingDistance;
      result.order.found.shear = session.lightField.shear;
    }
  }
  session.cameras = {inFrontOf(displayOf(session))};
  session = overridden(session, overrides);
  const bool isOrderGiven = session.lightField.rows != result.order.found.rows ||
                            session.lightField.columns != result.order.found.columns;
  if (isGridOfViews(session.lightField.layout) && isOrderGiven) {
    session.lightField = withOrderOf(session.lightField, result.order);
    session = overridden(session, overrides);
  }
  return result;
}

/// As sessionAroundStill(); says of a picture whether those beside it may be further frames.
OrderedSession sessionBesideFrames(const std::string& file,
                                   const std::vector<std::string>& overrides,
                                   const Progress& progress) {
  OrderedSession result = sessionAroundStill(file, overrides, progress);
  const Layout layout = result.session.lightField.layout;
  if (typeOf(layout).holder != Holder::picture || result.hogels == Sureness::unknown) return result;
  const std::string frames = framesBeside(file, progress);
  if (!frames.empty()) result.order.warnings.push_back(frames);
  return result;
}

}  // namespace

OrderedSession orderedSessionAround(const std::string& file,
                                    const std::vector<std::string>& overrides,
                                    const Progress& progress) {
  std::vector<std::string> ofStill = overrides;
  LightFieldParams names = takeFrameNames(ofStill, file);
  std::optional<FoundFrames> found;
  if (!isNumbered(names) && names.pattern.empty()) found = framesInFolder(file, progress);
  if (found) names.file = found->file;
  if (!isNumbered(names)) return sessionBesideFrames(file, overrides, progress);
  const LightFieldParams still = firstStillOf(names);
  if (!still.pattern.empty()) ofStill.push_back("lightField.pattern=" + still.pattern);
  OrderedSession result = sessionAroundStill(still.file, ofStill, progress);
  for (LightFieldParams* const params : {&result.session.lightField, &result.order.found}) {
    params->file = names.file;
    if (!names.pattern.empty()) params->pattern = names.pattern;
  }
  if (found) {
    result.assumed = (result.assumed.empty() ? "" : result.assumed + "; ") +
                     "frames, one in each " + (isFolder(still.file) ? "folder " : "file ") +
                     std::filesystem::path(found->file).filename().string();
    result.hogels = found->sureness;
  }
  result.session = overridden(result.session, overrides);
  return result;
}

OrderedSession withViews(const Session& session, const LightFieldParams& views,
                         const Progress& progress) {
  OrderedSession result;
  result.session = session;
  Session said = session;
  said.lightField = views;
  const std::optional<ViewCameras> cameras = takeOrder(result, said, false, progress);
  result.session.lightField = result.order.found;
  if (cameras && cameras->isCounted) result.session.display.directions = said.display.directions;
  return result;
}

void addWarnings(std::vector<std::string>& warnings, const LightFieldFile& file) {
  for (const std::string& line : file.warnings())
    if (std::ranges::find(warnings, line) == warnings.end()) warnings.push_back(line);
}

void addFileWarnings(std::vector<std::string>& warnings, const LightFieldParams& params,
                     const DisplayParams& display) {
  const LayoutType& type = typeOf(params.layout);
  try {
    if (type.holder == Holder::views || type.isOfTiles)
      return addWarnings(warnings, *openLightField(params, display));
    if (type.holder != Holder::picture) return;
    for (const std::string& note : ImageFile(firstStillOf(params).file, params.yuv).notesOfOne())
      warnings.push_back("the picture " + note);
  } catch (const InputError&) {
  }
}

bool isWhole(const Session& session) {
  return session.lightField.layout != Layout::hogels || session.display.hogels[0] > 0;
}

LightFieldSize sizeOf(const Session& session) {
  return session.lightField.isLive() ? Display(displayOf(session)).size()
                                     : openLightField(session.lightField, session.display)->size();
}

AssumedOrder orderOf(const OrderedSession& subject) {
  const Session& session = subject.session;
  AssumedOrder assumed;
  if (!isWhole(session)) {
    assumed.used = session.lightField;
    assumed.warnings = {
        "display.hogels and display.directions are not given, and the file does not say them"};
    addFileWarnings(assumed.warnings, session.lightField, session.display);
    return assumed;
  }
  if (session.lightField.isLive())
    return assumedOrder(session.lightField, sizeOf(session), subject.order);
  const auto file = openLightField(session.lightField, session.display);
  assumed = assumedOrder(session.lightField, file->size(), subject.order);
  addWarnings(assumed.warnings, *file);
  if (session.lightField.layout != Layout::lenslets) return assumed;
  assumed.lenslets = lensletsOf(session.lightField, session.display);
  if (const std::string warning = warningOf(session.lightField, *assumed.lenslets);
      !warning.empty())
    assumed.warnings.push_back(warning);
  return assumed;
}

Session sessionAround(const std::string& file, const std::vector<std::string>& overrides,
                      const Progress& progress) {
  return orderedSessionAround(file, overrides, progress).session;
}

DisplayParams withCalibration(const DisplayParams& display, const std::string& calibration) {
  DisplayParams result;
  result.position = display.position;
  result.orientation = display.orientation;
  SheetDisplay& sheet = result.sheet.emplace(display.sheet.value_or(SheetDisplay{}));
  sheet.calibration = loadSheetCalibration(calibration);
  sheet.file = calibration;
  result.size = LensSheet(sheet).size();
  result.fov.fill(sheet.calibration.params.cone);
  return result;
}

Session onSheet(const LightFieldParams& quilt, const std::string& calibration) {
  if (quilt.layout != Layout::quilt)
    throw InputError(contentName(quilt), "lightField.layout",
                     "must be \"quilt\" for a lens sheet that is opened with a calibration");
  Session session;
  session.lightField = quilt;
  session.lightField.viewingDistance = notGiven;
  session.display = withCalibration({}, calibration);
  inFile(contentName(quilt), [&] { checkLightField(session); });
  session.cameras = {inFrontOf({session.display, session.display.sheet->viewingDistance})};
  return session;
}

Session withLightField(const Session& session, const std::string& file) {
  Session result = session;
  if (isSessionFile(file)) {
    const Session other = loadSession(file);
    result.display = other.display;
    result.lightField = other.lightField;
  } else {
    result.lightField = withFile(session.lightField, file);
    checkLightField(result);
  }
  return result;
}

bool canCompare(const Session& session, const std::string& file, const Progress& progress) {
  try {
    const Session other = withLightField(session, file);
    const auto lightField = openLightField(other.lightField, other.display, progress);
    (void)resolved(displayOf(other), lightField->size());
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace hogelscope
