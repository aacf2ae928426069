// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/optimise_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/optics/eyes.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/content_hash.h"
#include "io/files/folders.h"
#include "io/scene/twin_content.h"
#include "io/store/store_writer.h"
#include "optimise/optimise_page.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

bool leaks(const CameraState& state) {
  return state.psf.windowSize > 1;
}

std::string pathOf(std::size_t state, const char* part) {
  return "cameras[" + std::to_string(state) + "]." + part;
}

/// Returns the light that leaks. Throws InputError if states differ.
LightModel lightOf(const Session& session) {
  const auto first = std::ranges::find_if(session.cameras, leaks);
  if (first == session.cameras.end()) return session.cameras.front().psf.light;
  for (std::size_t k = 0; k < session.cameras.size(); ++k)
    if (leaks(session.cameras[k]) && session.cameras[k].psf.light != first->psf.light)
      throw InputError(pathOf(k, "psf.light"),
                       "differs from that of \"" + first->camera.name +
                           "\": one content cannot be solved in both lights");
  return first->psf.light;
}

/// Throws InputError for errors of a unit that a problem per hogel does not know.
void checkTwin(const Twin& twin, bool isOfViews) {
  const auto refuse = [](const std::string& part, const std::string& what) {
    throw InputError(part, what +
                               ": content is optimised for gains, shifts and dead pixels of "
                               "hogels alone; leave it out with --set");
  };
  if (twin.leaksOverField() || twin.leaksByColour())
    refuse("twin.leakage", "differs over the field or by colour");
  if (twin.params().light != LightErrors{}) refuse("twin.light", "is not as designed");
  if (isOfViews && twin.traits().splitsColours)
    refuse("twin.colour", "takes the colours of a ray to different pixels");
}

void checkSession(const Session& session) {
  const OptimiseParams& params = session.optimise;
  requireHogels(session.display, "optimised content");
  if (session.cameras.empty())
    throw InputError("cameras", "is empty: the states say how much the display leaks");
  if (session.sampling.reconstruction != Reconstruction::nearest)
    throw InputError("sampling.reconstruction",
                     "must be \"nearest\": interpolated texels are no property of a display, and "
                     "content is for the display as built");
  if (params.lift[0] + params.lift[1] >= 1)
    throw InputError("optimise.lift", "leaves no contrast: the sum must be below 1");
  if (params.target == OptimiseTarget::ideal) requireLive(session);
  if (params.target == OptimiseTarget::light) return;
  for (std::size_t k = 0; k < session.cameras.size(); ++k)
    if (session.cameras[k].pupil.diameter > 0)
      throw InputError(pathOf(k, "pupil"),
                       "has a pixel see several hogels, which cannot be solved one by one: set "
                       "pupil.diameter to 0, or optimise.target to \"light\"");
}

/// Returns the different leakages of the states, and that of each state.
std::vector<StatesLeakage> leakagesOf(const Session& session, const LightFieldSize& size,
                                      std::vector<std::size_t>& ofStates) {
  std::vector<StatesLeakage> leakages;
  for (const CameraState& state : session.cameras) {
    PsfParams psf = state.psf;
    if (!leaks(state)) psf = {};
    psf.light = LightModel::encoded;  // the window is the same in both lights
    auto found = std::ranges::find(leakages, psf, &StatesLeakage::psf);
    if (found == leakages.end())
      found = leakages.insert(found, {psf, HogelLeakage(psf, size.du, size.dv)});
    ++found->states;
    ofStates.push_back(std::size_t(found - leakages.begin()));
  }
  return leakages;
}

std::string decibels(double value) {
  return std::isinf(value) ? "identical pictures" : rounded(value, 2) + " dB";
}

/// Returns the part of their light that all hogels of a unit with gains are left.
double dimmingOf(const OptimisedContent& content) {
  const Twin* const twin = content.what().twin.get();
  return twin != nullptr && twin->hasGains() ? twin->leastGain() : 1;
}

/// Returns the warnings that hold of a result.
std::vector<std::string> warningsOf(const Session& session, const PanelParams& display,
                                    const OptimisedContent& content, const Judgement& judgement) {
  std::vector<std::string> warnings;
  const LightFieldSize size = content.size();
  for (const StatesLeakage& one : content.what().leakages)
    if (constexpr double little = 0.01; size.du * size.dv > 1 && leastTransfer(one.psf) < little)
      warnings.push_back("sigma " + numberText(one.psf.sigma) +
                         ": some detail over directions does not pass the leakage at all, and no "
                         "content brings it back");
  const bool isPrefiltered = hasPrefilter(session);
  const JudgedContent base = isPrefiltered ? prefilteredContent : beforeContent;
  const std::string reference =
      session.optimise.target == OptimiseTarget::ideal ? "ideal" : "display";
  const double without = meanOf(judgement.views, reference, true, base).psnr;
  const double with = meanOf(judgement.views, reference, true, afterContent).psnr;
  if (with < without && session.optimise.target != OptimiseTarget::views)
    warnings.push_back("eyes that it was not optimised for see " + decibels(without - with) +
                       " less than " + (isPrefiltered ? "of the prefiltered content" : "before") +
                       (session.optimise.target == OptimiseTarget::light
                            ? std::string()
                            : ": give states at most " +
                                  numberText(fourDigits(stepOfDirections(session, display) / 3)) +
                                  " m apart, or a larger optimise.keep"));
  const double less = judgement.ifNarrower[afterContent].psnr;
  if (less < judgement.ifNarrower[base].psnr)
    warnings.push_back("if sigma is in truth " + numberText(Judgement::narrower) +
                       " of what psf "
                       "says, these eyes see " +
                       decibels(less) + " in place of " +
                       decibels(judgement.ifNarrower[base].psnr) +
                       ": too large a sigma is worse than none; rather underestimate it");
  return warnings;
}

/// Returns the light field that was written.
LightFieldParams writtenLightField(const OptimiseRequest& request, const LightFieldSize& size) {
  LightFieldParams written;
  written.file = request.output.string();
  written.viewingDistance = request.session.lightField.viewingDistance;
  switch (request.layout) {
    case ExportLayout::views:
      written.layout = Layout::views;
      break;
    case ExportLayout::quilt: {
      written.layout = Layout::quilt;
      const auto [columns, rows] = quiltTilesFor(size, request.output, request.session.lightField);
      written.quiltColumns = columns;
      written.quiltRows = rows;
      break;
    }
    case ExportLayout::pack:
      written.layout = Layout::pack;
      break;
    default:
      written.layout = Layout::hogels;
  }
  return written;
}

/// Returns a key that depends on all that the solved rows do, and not on where the files are.
std::string keyOf(const Session& session, const LightFieldFile& file, const Progress& progress) {
  std::vector<fs::path> files = filesOf(session, file);
  std::ranges::copy(picturesOf(session), std::back_inserter(files));
  return contentHash(std::string(programVersion()) + "\n" + textOf(session) + "\n" +
                     (files.empty() ? "" : contentHash(files, progress)));
}

fs::path rowsOf(const OptimiseRequest& request) {
  return request.output.string() + ".rows";
}

/// Throws InputError for names that would be found wrong after all has been solved.
void checkNames(const OptimiseRequest& request) {
  if (request.output.string().find(frameMark) != std::string::npos)
    throw InputError(request.output.string(),
                     "has the number of a frame: optimised content is one frame");
  std::vector<fs::path> files{tableOf(request), pageOf(request)};
  if (request.layout != ExportLayout::views) files.push_back(request.output);
  for (const fs::path& file : files)
    if (isFolder(file)) throw InputError(file.string(), "is a folder: choose another --output");
}

void writePack(const OptimiseRequest& request, OptimisedContent& content, const std::string& key,
               const Progress& progress) {
  const std::size_t memory = allowedMemory() / (content.isStream() ? 1 : 2);
  PackPlan plan = planPack(request.session.lightField, content, request.session.display, memory);
  plan.header.source += " optimised " + key;
  pack(content, plan, request.output, 0, progress);
  if (content.figures().weight == 0) content.solveShard(progress);  // the store was there already
}

}  // namespace

std::vector<fs::path> picturesOf(const Session& session) {
  std::vector<fs::path> pictures;
  if (session.optimise.target != OptimiseTarget::views) return pictures;
  const std::string& folder = session.optimise.views;
  if (folder.empty())
    throw InputError("optimise.views", "is missing: a folder with a picture for each state");
  if (!isFolder(folder)) throw InputError("optimise.views", folder + " is no folder of pictures");
  const std::vector<fs::path> files = filesIn(folder);
  for (const CameraState& state : session.cameras) {
    const std::string name = fileNameOf(state.camera.name);
    std::vector<fs::path> found;
    std::ranges::copy_if(files, std::back_inserter(found),
                         [&](const fs::path& file) { return file.stem() == name; });
    const auto png = std::ranges::find(found, ".png", &fs::path::extension);
    if (png != found.end()) found = {*png};
    if (found.empty())
      throw InputError(
          folder, "has no picture " + name + ".png of the state \"" + state.camera.name + "\"");
    if (found.size() > 1)
      throw InputError(folder, "has several files " + name +
                                   ".…: which is the picture of the state \"" + state.camera.name +
                                   "\"? Call it " + name + ".png");
    pictures.push_back(found.front());
  }
  return pictures;
}

ExportLayout optimiseLayout(const std::string& name, const fs::path& output) {
  const std::optional<ExportLayout> layout = exportLayoutNamed(name);
  if (!layout || *layout == ExportLayout::mosaic || *layout == ExportLayout::woven)
    throw InputError("--optimise", "\"" + name + "\" is not one of hogels, views, quilt, pack");
  const std::string ending = lowerCase(output.extension().string());
  if (*layout == ExportLayout::pack && ending != ".tif" && ending != ".tiff")
    throw InputError(output.string(), "is the name of a store, which is a TIFF: end it in .tif");
  return *layout;
}

double leastTransfer(const PsfParams& psf) {
  const std::vector<double> weights = gaussianWeights(psf.sigma, psf.windowSize / 2);
  const int reach = psf.windowSize / 2;
  double least = 1;
  constexpr int steps = 200;
  for (int step = 0; step <= steps; ++step) {
    double sum = 0, whole = 0;
    for (int x = -reach; x <= reach; ++x) {
      const double weight = weights[std::size_t(x + reach)];
      whole += weight;
      sum += weight * std::cos(std::numbers::pi * step / steps * x);
    }
    least = std::min(least, std::abs(sum) / whole);
  }
  return least;
}

std::shared_ptr<OptimisedContent> optimisedContent(const Session& session,
                                                   const Progress& progress) {
  checkSession(session);
  const OptimiseParams& params = session.optimise;
  const bool isLive = session.lightField.isLive();
  const std::vector<fs::path> pictures = picturesOf(session);
  const Session own = hasPrefilter(session) ? prefiltered(session) : session;
  std::shared_ptr<LightFieldFile> file =
      openLightField(own.lightField, own.display, part(progress, 0, 0.2));
  ViewSource source = unloadedViewSource(session, *file, part(progress, 0.2, 0.3));
  Optimisation what{params, lightOf(session), {}, nullptr, nullptr};
  std::vector<std::size_t> ofStates;
  what.leakages = leakagesOf(session, file->size(), ofStates);
  const bool isOfViews = params.target != OptimiseTarget::light;
  if (isOfViews && isLive)  // the ideal views read no texels
    source.lightField = file->source({.memory = allowedMemory() / 4}, part(progress, 0.3, 0.4));
  if (source.twin) {
    checkTwin(*source.twin, isOfViews);
    file = std::make_shared<TwinContent>(file, source.display, source.twin);
    what.twin = source.twin;
  }
  if (isOfViews) {
    std::vector<TargetView> views;
    for (std::size_t k = 0; k < session.cameras.size(); ++k)
      views.push_back({session.cameras[k], ofStates[k], pictures.empty() ? "" : pictures[k]});
    what.wishes = std::make_shared<SeenTexels>(source, views, what.leakages.size(), what.light,
                                               allowedMemory() / 4, part(progress, 0.4, 1));
    if (!(what.wishes->meanWeight() > 0))
      throw InputError("cameras", "no state sees the display: there is nothing to optimise for");
  }
  if (what.isIdentity() && !isLive)
    throw InputError("cameras",
                     "no state has leakage (psf.windowSize above 1), and the light field's own "
                     "light is what is shown: there is nothing to optimise");
  return std::make_shared<OptimisedContent>(file, std::move(what));
}

fs::path tableOf(const OptimiseRequest& request) {
  if (request.layout != ExportLayout::views)
    return fs::path(request.output).replace_extension(".csv");
  const bool endsInSlash = !request.output.has_filename();
  return (endsInSlash ? request.output.parent_path() : request.output).string() + ".csv";
}

fs::path pageOf(const OptimiseRequest& request) {
  return tableOf(request).replace_extension(".html");
}

std::optional<Optimised> optimise(const OptimiseRequest& request, OptimisedContent& content,
                                  const Progress& progress) {
  const Progress solving = part(progress, 0, 0.7);
  checkNames(request);
  if (request.layout == ExportLayout::quilt)
    (void)quiltTilesFor(content.size(), request.output, request.session.lightField);
  makeFolderOf(request.output);
  if (request.layout == ExportLayout::pack) {
    const std::string key = keyOf(request.session, content, part(progress, 0, 0.02));
    const auto rows = std::make_shared<SolvedRows>(rowsOf(request), key, request.shard);
    content.keepRows(rows);
    if (request.shard) {
      content.solveShard(progress);
      return std::nullopt;
    }
    writePack(request, content, key, solving);
  } else {
    exportAs(request.layout, request.session, content, request.output, solving);
  }
  Session session = request.session;
  const LightFieldSize size = content.size();
  session.display.hogels = {size.nx, size.ny};
  session.display.directions = {size.du, size.dv};
  const GivenAway away{content.what().light, session.optimise.lift, dimmingOf(content)};
  Optimised result{content.figures(),
                   judge(session, writtenLightField(request, size), picturesOf(session), away,
                         part(progress, 0.7, 1)),
                   {}};
  result.warnings = warningsOf(session, displayOf(session), content, result.judgement);
  writeTextFile(tableOf(request), csv(result, content));
  writeTextFile(pageOf(request), optimisePage(request, result, content));
  if (request.layout == ExportLayout::pack) SolvedRows::remove(rowsOf(request));
  return result;
}

}  // namespace hogelscope
