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
#include "core/cameras/camera_path.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/files/system_limits.h"
#include "io/images/image_writer.h"
#include "io/images/video_writer.h"

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
  std::optional<VideoWriter> video = {};

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

/// Writes the images of all states; for PNG without a video, continues after a state that cannot be
/// rendered.
void renderAll(LightFieldFile& file, const Session& session, RenderOutput& output,
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
      if (output.video) throw InputError(session.cameras[k].camera.name, error.what());
      if (!first) first.emplace(session.cameras[k].camera.name, error.what());
    }
    if (image) output.write(session.cameras[k], *image);
    if (output.video) output.video->add(image->rgb, of);
  }
  if (output.video) output.video->finish(progress);
  if (first) throw *first;
}

/// Keeps the shard's share of the states, which may be empty.
void keepShard(Session& session, const Shard& shard) {
  std::vector<CameraState> own;
  for (std::size_t k = 0; k < session.cameras.size(); ++k)
    if (shard.has(k)) own.push_back(session.cameras[k]);
  session.cameras = std::move(own);
}

/// Throws InputError if other options or the states keep a video from being made.
void requireVideo(const CommandLine& line, const Session& session) {
  if (!line.has("video")) throw InputError("--fps", "belongs to --video");
  if (line.has("shard") || line.has("format"))
    throw InputError("--video",
                     "is of all pictures, and these are PNG: leave out --shard, --format");
  requireOneSize(session.cameras);
}

}  // namespace

int runRender(const CommandLine& line) {
  Session session = loadSelected(line);
  if (line.has("between"))
    session.cameras = statesAlong({PathKind::between, int(*line.number("between"))}, session, 0);
  if (line.has("video") || line.has("fps")) requireVideo(line, session);
  if (const auto shard = shardOf(line)) keepShard(session, *shard);
  // Opened first, so that an invalid file leaves no folder behind.
  const auto file = openLightField(session.lightField, session.display);
  RenderOutput output{line.text("output"), line.text("format", "png"), line.has("masks"),
                      line.has("explain"), line.has("ideal")};
  if (output.isIdeal) requireLive(session);
  std::vector<fs::path> files = output.allFiles(session.cameras);
  if (line.has("video")) files.emplace_back(line.text("video"));
  checkOutputs(files, inputFiles({line.text("session"), line.text("calibration")}, session, *file));
  keepSession(line, session);
  warnOfCuts(*file, session, line);
  if (line.has("video")) {
    makeFolderOf(line.text("video"));
    output.video.emplace(line.text("video"), session.cameras[0].camera.res,
                         line.number("fps").value_or(30));
  }
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
