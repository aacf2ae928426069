// SPDX-License-Identifier: BSD-3-Clause
// --render: one image for each camera state.
#include <filesystem>
#include <iostream>

#include "campaign/state_images.h"
#include "cli/explain.h"
#include "cli/inputs.h"
#include "cli/jobs/all_jobs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/files/system_limits.h"
#include "io/images/image_writer.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// The files of all states and the text of --explain.
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

  /// Writes an Image or a FloatImage.
  template <class AnyImage>
  void write(const CameraState& state, const AnyImage& image) const {
    writeImage(file(state, format), image.width, image.height, image.rgb);
    if (hasMasks) writeMask(file(state, "mask.png"), image.width, image.height, image.seen);
  }
};

/// Writes the images of all states; for PNG, continues after a state that cannot be rendered.
void renderAll(LightFieldFile& file, const Session& session, const RenderOutput& output,
               const Progress& progress) {
  const bool isStreamed = mustStream(file, allowedMemory());
  if (isStreamed && output.format != "png")
    throw InputError("--format " + output.format,
                     "needs the light field in memory or in a store: give it more --memory, or "
                     "--pack it first");
  const double reading = isStreamed ? 1 : 0.5;
  StateImages images(session, file, session.cameras, {.use = {.threads = threadCount()}},
                     part(progress, 0, reading));
  if (output.isIdeal) images.showIdeal();
  if (output.isExplained)
    std::cout << explanations(images.source(), session, part(progress, reading, reading));
  Renderer renderer;
  const double each = (1 - reading) / double(session.cameras.size());
  std::optional<InputError> first;
  for (std::size_t k = 0; k < session.cameras.size(); ++k) {
    const Progress of = part(progress, reading + double(k) * each, reading + double(k + 1) * each);
    if (output.format != "png") {
      output.write(session.cameras[k], images.renderFloat(k, renderer, of));
      continue;
    }
    std::optional<Image> image;
    try {
      image = images.render(k, renderer, of);
    } catch (const InputError& error) {
      if (!first) first.emplace(session.cameras[k].camera.name, error.what());
    }
    if (image) output.write(session.cameras[k], *image);
  }
  if (first) throw *first;
}

/// Keeps the shard's share of the states, which may be empty.
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
  // Opened first, so that an invalid file leaves no folder behind.
  const auto file = openLightField(session.lightField, session.display);
  const RenderOutput output{line.text("output"), line.text("format", "png"), line.has("masks"),
                            line.has("explain"), line.has("ideal")};
  if (output.isIdeal) requireLive(session);
  checkOutputs(output.allFiles(session.cameras),
               inputFiles({line.text("session"), line.text("calibration")}, session, *file));
  keepSession(line, session);
  warnOfCuts(*file, session, line);
  makeFolder(output.folder);
  const bool isQuiet = line.has("quiet");
  announceStreaming(*file, allowedMemory(), isQuiet);
  ProgressBar bar("rendering", isQuiet);
  renderAll(*file, session, output, bar.progress());
  bar.done();
  if (!isQuiet)
    std::cout << session.cameras.size() << " picture(s) in " << printable(output.folder.string())
              << "\n";
  return 0;
}

}  // namespace hogelscope
