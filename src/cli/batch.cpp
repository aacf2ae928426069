// SPDX-License-Identifier: BSD-3-Clause
// Batch mode: the jobs of the command line.
#include "cli/batch.h"

#include <filesystem>
#include <iostream>

#include "cli/explain.h"
#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/progress_bar.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/engine/renderer.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/output_folder.h"
#include "io/images/image_writer.h"
#include "io/scene/scene.h"
#include "report/passing_pictures.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

class Pictures {
 public:
  explicit Pictures(const Options& options) : m_options(options) {}

  [[nodiscard]] std::vector<fs::path> filesOf(const std::vector<CameraState>& states) const {
    std::vector<fs::path> files;
    for (const CameraState& state : states) {
      files.push_back(file(state, m_options.format));
      if (m_options.masks) files.push_back(file(state, "mask.png"));
    }
    return files;
  }

  /// An Image or a FloatImage.
  template <class AnyImage>
  void write(const CameraState& state, const AnyImage& image) const {
    writeImage(file(state, m_options.format), image.width, image.height, image.rgb);
    if (m_options.masks) writeMask(file(state, "mask.png"), image.width, image.height, image.seen);
  }

 private:
  [[nodiscard]] fs::path file(const CameraState& state, const std::string& ending) const {
    return fs::path(m_options.output) / (state.camera.name + "." + ending);
  }

  const Options& m_options;
};

/// From a light field in memory or in a store.
void renderLoaded(const Session& session, const Options& options, const Progress& progress) {
  const Scene scene =
      loadScene(session, part(progress, 0, 0.5), allowedMemory(), {.threads = threadCount()});
  if (options.explain) std::cout << explanations(scene, session, part(progress, 0.5, 0.5));
  const Pictures pictures(options);
  Renderer renderer;
  const auto count = double(session.cameras.size());
  for (std::size_t k = 0; k < session.cameras.size(); ++k) {
    const CameraState& state = session.cameras[k];
    const Progress of =
        part(progress, 0.5 + 0.5 * double(k) / count, 0.5 + 0.5 * double(k + 1) / count);
    if (options.format == "png")
      pictures.write(state, renderer.render(scene.view(state), of));
    else
      pictures.write(state, renderer.renderFloat(scene.view(state), of));
  }
}

void renderPassing(LightFieldFile& file, const Session& session, const Options& options,
                   const Progress& progress) {
  if (options.format != "png")
    throw InputError("--format " + options.format,
                     "needs the light field in memory or in a store: give it more --memory, or "
                     "--pack it first");
  const Scene scene = unloadedScene(session, file);
  if (options.explain) std::cout << explanations(scene, session, part(progress, 0, 0));
  std::vector<View> views;
  for (const CameraState& state : session.cameras) views.push_back(scene.view(state));
  const std::vector<StatePicture> made =
      picturesInPassing(file, views, allowedMemory(), parallelRows, progress);
  const Pictures pictures(options);
  std::optional<InputError> first;
  for (std::size_t k = 0; k < made.size(); ++k) {
    const std::string& problem = made[k].problem;
    if (problem.empty())
      pictures.write(session.cameras[k], made[k].image);
    else if (!first)
      first.emplace(session.cameras[k].camera.name, problem);
  }
  if (first) throw *first;
}

}  // namespace

int render(const Options& options) {
  const Session session = loadSelected(options);
  // A bad one leaves no folder behind.
  const auto file = openLightField(session.lightField, session.display);
  checkOutputs(Pictures(options).filesOf(session.cameras), inputsOf(options, file.get()));
  makeFolder(options.output);
  const bool isPassing = mustPass(*file, allowedMemory());
  announcePassing(*file, allowedMemory(), options);
  ProgressBar bar("rendering", options.quiet);
  if (isPassing)
    renderPassing(*file, session, options, bar.progress());
  else
    renderLoaded(session, options, bar.progress());
  bar.done();
  if (!options.quiet)
    std::cout << session.cameras.size() << " picture(s) in " << options.output << "\n";
  return 0;
}

int runBatch(const Options& options) {
  setThreads(options.threads);
  try {
    return jobOf(options.command).run(options);
  } catch (const InputError& error) {
    const bool isOfOption = std::string_view(error.what()).starts_with("--");
    throw options.session.empty() || isOfOption ? error : error.in(options.session);
  }
}

}  // namespace hogelscope
