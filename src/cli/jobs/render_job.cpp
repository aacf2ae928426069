// SPDX-License-Identifier: BSD-3-Clause
// --render: one image for each camera state.
#include <filesystem>
#include <iostream>

#include "cli/explain.h"
#include "cli/inputs.h"
#include "cli/jobs/all_jobs.h"
#include "cli/progress_bar.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/unicode.h"
#include "core/engine/renderer.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/output_folder.h"
#include "io/files/system_limits.h"
#include "io/images/image_writer.h"
#include "io/scene/scene.h"
#include "report/streamed_images.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// The files of all states and the words of --explain.
struct RenderOutput {
  fs::path folder;
  std::string format;
  bool hasMasks = false;
  bool isExplained = false;
  bool isIdeal = false;

  [[nodiscard]] fs::path file(const CameraState& state, const std::string& ending) const {
    return folder / (state.camera.name + "." + ending);
  }
  [[nodiscard]] std::vector<fs::path> allFiles(const std::vector<CameraState>& states) const {
    std::vector<fs::path> files;
    for (const CameraState& state : states) {
      files.push_back(file(state, format));
      if (hasMasks) files.push_back(file(state, "mask.png"));
    }
    return files;
  }

  /// An Image or a FloatImage.
  template <class AnyImage>
  void write(const CameraState& state, const AnyImage& image) const {
    writeImage(file(state, format), image.width, image.height, image.rgb);
    if (hasMasks) writeMask(file(state, "mask.png"), image.width, image.height, image.seen);
  }
};

/// Renders from a light field in memory or in a store.
void renderLoaded(const Session& session, const RenderOutput& output, const Progress& progress) {
  Scene scene = loadScene(session, part(progress, 0, 0.5), {.threads = threadCount()});
  scene.isIdeal = output.isIdeal;
  if (output.isExplained) std::cout << explanations(scene, session, part(progress, 0.5, 0.5));
  Renderer renderer;
  const auto count = double(session.cameras.size());
  for (std::size_t k = 0; k < session.cameras.size(); ++k) {
    const CameraState& state = session.cameras[k];
    const Progress of =
        part(progress, 0.5 + 0.5 * double(k) / count, 0.5 + 0.5 * double(k + 1) / count);
    if (output.format == "png")
      output.write(state, renderer.render(scene.job(state), of));
    else
      output.write(state, renderer.renderFloat(scene.job(state), of));
  }
}

/// Renders all images while the light field is read once.
void renderPassing(LightFieldFile& file, const Session& session, const RenderOutput& output,
                   const Progress& progress) {
  if (output.format != "png")
    throw InputError("--format " + output.format,
                     "needs the light field in memory or in a store: give it more --memory, or "
                     "--pack it first");
  const Scene scene = unloadedScene(session, file);
  if (output.isExplained) std::cout << explanations(scene, session, part(progress, 0, 0));
  std::vector<RenderJob> views;
  for (const CameraState& state : session.cameras) views.push_back(scene.job(state));
  const std::vector<StateImage> results =
      renderStreamed(file, views, allowedMemory(), parallelRows, progress);
  std::optional<InputError> first;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const std::string& problem = results[k].problem;
    if (problem.empty())
      output.write(session.cameras[k], results[k].image);
    else if (!first)
      first.emplace(session.cameras[k].camera.name, problem);
  }
  if (first) throw *first;
}

/// Its share of the states may be none.
void keepShard(Session& session, const Shard& shard) {
  std::vector<CameraState> own;
  for (std::size_t k = 0; k < session.cameras.size(); ++k)
    if (shard.has(k)) own.push_back(session.cameras[k]);
  session.cameras = std::move(own);
}

}  // namespace

int runRender(const CommandLine& line) {
  Session session = loadSelected(line);
  if (const auto shard = shardOf(line)) keepShard(session, *shard);
  // Opened first, so that a bad one leaves no folder behind.
  const auto file = openLightField(session.lightField, session.display);
  const RenderOutput output{line.text("output"), line.text("format", "png"), line.has("masks"),
                            line.has("explain"), line.has("ideal")};
  if (output.isIdeal) requireScene(session);
  checkOutputs(output.allFiles(session.cameras),
               inputFiles({line.text("session"), line.text("calibration")}, session, *file));
  keepSession(line, session);
  makeFolder(output.folder);
  const bool isPassing = mustPass(*file, allowedMemory());
  const bool isQuiet = line.has("quiet");
  announcePassing(*file, allowedMemory(), isQuiet);
  ProgressBar bar("rendering", isQuiet);
  if (isPassing)
    renderPassing(*file, session, output, bar.progress());
  else
    renderLoaded(session, output, bar.progress());
  bar.done();
  if (!isQuiet)
    std::cout << session.cameras.size() << " picture(s) in " << printable(output.folder.string())
              << "\n";
  return 0;
}

}  // namespace hogelscope
