// SPDX-License-Identifier: BSD-3-Clause
// --export: the session's light field in another layout.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/jobs/pack_job.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/rig_file.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/images/video_writer.h"
#include "io/opening/session_around.h"
#include "io/scene/light_field_export.h"
#include "io/scene/view_source.h"
#include "optimise/judged_eyes.h"
#include "web/view_page.h"

namespace hogelscope {

namespace {

namespace fs = std::filesystem;

/// Returns the session's display; the light field is opened only if it has to say the display's
/// hogels or directions: a rig is made before its content.
PanelParams panelOf(const Session& session) {
  const PanelParams display = displayOf(session);
  const auto isGiven = [](const std::array<int, 2>& counts) {
    return counts[0] > 0 && counts[1] > 0;
  };
  if (isGiven(display.hogels) && isGiven(display.directions)) return display;
  return resolved(display, openLightField(session.lightField, session.display)->size());
}

int exportRig(const Session& session, const CommandLine& line) {
  requireHogels(session.display, "a rig");
  const fs::path output = line.text("output");
  const fs::path gltf = fs::path(output).replace_extension(".gltf");
  if (gltf == output)
    throw InputError("--output " + output.string(),
                     "is the name of the glTF file beside the rig: end it in .json");
  const FilesInUse inUse(filesOf(session));
  checkResults(line, session, {output, gltf});
  const std::vector<RigCamera> rig = rigOf(panelOf(session));
  makeFolderOf(output);
  writeTextFile(output, rigText(rig));
  writeTextFile(gltf, rigGltf(rig));
  if (finish(line, session))
    std::cout << printable(output.string()) << ", " << printable(gltf.string()) << ": "
              << rig.size() << " camera(s)\n";
  return 0;
}

int exportPage(const Session& session, const CommandLine& line) {
  requirePage(session);
  PageOptions options;
  if (line.has("quality"))
    options.quality = line.text("quality") == "exact" ? PageQuality::exact : PageQuality::small;
  options.experiment = line.text("experiment", "");
  if (line.has("experiment") && !line.has("test"))
    throw InputError("command line", "--experiment", "compares light fields: give --test LF too");
  const fs::path output = line.text("output");
  const Input input(session, openLightField(session.lightField, session.display));
  warnOfFrames(line, input.file->frames());
  const std::string name = fs::path(line.text("session")).stem().string();
  options.title = name.empty() ? "hogelscope" : name;
  std::vector<PageContent> contents{{name, input.file}};
  std::vector<fs::path> files;
  for (const std::string& test : line.texts("test")) {
    const Session other = withLightField(session, test);
    contents.push_back(
        {fs::path(test).stem().string(), openLightField(other.lightField, other.display)});
    std::ranges::copy(filesOf(other, *contents.back().file), std::back_inserter(files));
  }
  const FilesInUse testsInUse(files);
  checkResults(line, session, {output});
  makeFolderOf(output);
  ProgressBar bar("exporting", line.has("quiet"));
  const ViewPage page = viewPage(session, contents, options, bar.progress());
  writeTextFile(output, page.html);
  bar.done();
  if (!finish(line, session)) return 0;
  std::cout << printable(output.string()) << ": a page of "
            << numberText(fourDigits(double(page.html.size()) / 1e6)) << " MB\n";
  for (const std::string& note : page.notes) std::cout << note << "\n";
  if (line.has("experiment"))
    std::cout << questionsOf(options.experiment, contents.size(), session.cameras.size())
              << " question(s) for each viewer\n";
  return 0;
}

/// Writes a video of the frames, each of which is a picture.
void exportVideo(ExportLayout layout, const Input& input, const CommandLine& line,
                 const std::vector<FrameOutput>& frames, const Progress& progress) {
  LightFieldFile& file = *input.file;
  const fs::path output = line.text("output");
  if (layout == ExportLayout::views || layout == ExportLayout::pack)
    throw InputError("--output " + output.string(), "is a video's name, but " + line.subject +
                                                        " are no picture of a frame: put "
                                                        "{T} into another name");
  const double rate = frameRateOf(input.session.lightField, file);
  if (!(rate > 0))
    throw InputError("--output " + output.string(),
                     "needs lightField.fps: the light field does not say its frame rate");
  std::optional<VideoWriter> video;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const auto count = double(frames.size());
    const Progress own = part(progress, double(k) / count, double(k + 1) / count);
    file.select(frames[k].frame);
    const ExportedPicture picture = exportedPicture(layout, input.session, file, output, own);
    if (!video) video.emplace(output, std::array{picture.width, picture.height}, rate);
    video->add(picture.rgb, own);
  }
  video->finish(progress);
}

/// Writes the frames, each to its output. Returns how many there are.
std::size_t exportFrames(ExportLayout layout, const Input& input, const CommandLine& line) {
  LightFieldFile& file = *input.file;
  const std::vector<FrameOutput> frames = outputsOfFrames(line, file);
  const std::string output = line.text("output");
  const bool isVideo = isVideoName(output) && output.find(frameMark) == std::string::npos &&
                       !file.frames().isStill();
  std::set<fs::path> outputs;
  for (const FrameOutput& frame : frames) outputs.insert(frame.output);
  checkResults(line, input.session, {outputs.begin(), outputs.end()});
  ProgressBar bar("exporting", line.has("quiet"));
  for (const fs::path& each : outputs) makeFolderOf(each);
  if (isVideo)
    exportVideo(layout, input, line, frames, bar.progress());
  else
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const auto count = double(frames.size());
      file.select(frames[k].frame);
      exportAs(layout, input.session, file, frames[k].output,
               part(bar.progress(), double(k) / count, double(k + 1) / count));
    }
  bar.done();
  return frames.size();
}

int runExport(const CommandLine& line) {
  if (line.has("twin") && !line.has("for-twin"))
    throw InputError(
        "command line", "--twin",
        "changes no content: give --for-twin too for content that is corrected for it");
  if (line.subject == "rig" && isSessionDocument(line.text("session")))
    return exportRig(loadSession(line.text("session"), line.texts("set")), line);
  Session session = loadSessionOf(line);
  if (line.has("prefilter")) {
    if (line.subject == "rig" || !session.lightField.isLive())
      throw InputError("command line", "--prefilter",
                       "is for a live scene, whose directional pixels it averages");
    session = prefiltered(std::move(session));
  }
  if (line.subject == "rig") return exportRig(session, line);
  if (line.subject == "page") return exportPage(session, line);
  for (const char* const own : {"quality", "test", "experiment"})
    if (line.has(own))
      throw InputError("command line", "--" + std::string(own), "is for --export page");
  if (line.subject == "pack") requireHogels(session.display, "a pack");
  if (line.has("for-twin") && line.subject == "pack")
    throw InputError("command line", "--for-twin",
                     "is not for a store: export hogels or views, then pack them");
  if (line.subject == "pack") {
    const int status = packContent(session, true, line);
    finish(line, session);
    return status;
  }
  const std::optional<ExportLayout> layout = exportLayoutNamed(line.subject);
  if (!layout)
    throw InputError("--export",
                     "\"" + line.subject +
                         "\" is not one of hogels, views, quilt, mosaic, woven, pack, rig, page");
  if (std::ranges::count(exportLayoutsOf(session.display), *layout) == 0)
    throw InputError("--export " + line.subject,
                     session.display.sheet
                         ? "is for a display of hogels: give quilt, views or woven for a lens sheet"
                         : "is for a lens sheet: a session with display.kind \"sheet\"");
  const bool isForTwin = line.has("for-twin");
  if (isForTwin && session.display.sheet && layout != ExportLayout::woven)
    throw InputError("command line", "--for-twin", "is not for the views of a lens sheet");
  if (isForTwin && session.twin.isZero())
    throw InputError("command line", "--for-twin",
                     "needs a unit: --twin FILE, or a session with a twin");
  const fs::path output = line.text("output");
  const Input input(session, contentToExport(session, *layout, isForTwin));
  LightFieldFile& file = *input.file;
  std::array<int, 2> tiles{};
  if (layout == ExportLayout::quilt) tiles = quiltTilesFor(file.size(), output, session.lightField);
  const std::size_t frames = exportFrames(*layout, input, line);
  if (!finish(line, session)) return 0;
  std::cout << printable(output.string()) << ": " << line.subject;
  if (frames > 1) std::cout << ", " << frames << " frames";
  if (layout == ExportLayout::quilt)
    std::cout << ", lightField.columns=" << tiles[0] << " lightField.rows=" << tiles[1];
  if (layout == ExportLayout::mosaic)
    std::cout << ", display.directions=[" << file.size().du << "," << file.size().dv << "]";
  std::cout << "\n";
  return 0;
}

}  // namespace

Job exportJob() {
  return {
      .name = "export",
      .value = "hogels|views|quilt|mosaic|woven|pack|rig|page",
      .help =
          "Writes the session's light field, of any layout or live, as hogels (one image), "
          "views (a folder), quilt, mosaic (one image of all views) or pack (a store); of a lens "
          "sheet as quilt or views, or as woven the panel's picture; or as rig "
          "the cameras that take its views, FILE.json and FILE.gltf; or as page one HTML file "
          "with the engine in it, in which anyone moves around the display.",
      .details =
          "Values keep their type: 8 or 16 bits or floats, which need .exr or .tif. What a "
          "live scene becomes gives the same pictures as the scene itself. Only a light "
          "field that is a store or live may be larger than memory for views, quilt "
          "and mosaic. "
          "Of a light field in time --frames, or {T} in --output, writes a file or folder for each "
          "frame; or give a quilt, mosaic or hogels the name of a video, FILE.mp4. "
          "After a stop pack goes on where it was. A rig needs "
          "lightField.viewingDistance, and no light field if the display has hogels and "
          "directions. A page opens in any browser, without a network; all of the light field is "
          "in it. Its pictures are the program's to the byte, or with --quality small, and beyond "
          "8 MB, compressed, which the page says.",
      .examples =
          "  hogelscope --export hogels --session live.json --output hogels.png\n"
          "  hogelscope --export pack --session live.json --output store.tif\n"
          "  hogelscope --export quilt --session live.json --output room_qs8x6a1.png \\\n"
          "             --set display.directions=[48,1]\n"
          "  hogelscope --export views --session moving.json --output 'frames/{T}'\n"
          "  hogelscope --export rig --session s.json --output rig.json \\\n"
          "             --set lightField.viewingDistance=0.6\n"
          "  hogelscope --export page --session s.json --output s.html --test coded.png\n"
          "  hogelscope --export page --session s.json --output votes.html --test coded.png \\\n"
          "             --experiment dsis\n",
      .needs = {"session", "output"},
      .takes = {"set", "test", "twin", "plugins-path", "save-session", "frames", "memory",
                "threads", "quiet"},
      .own =
          {{.name = "for-twin",
            .after = "save-session",
            .help =
                "Content that is corrected for the session's twin, or --twin: seen through it, it "
                "looks as the session's own does through the display as designed."},
           {.name = "prefilter",
            .after = "for-twin",
            .help = "Of a live scene: each directional pixel is the mean of optimise.samples rays, "
                    "16, over all of its hogel and direction, in place of its middle ray."},
           {.name = "quality",
            .value = "exact|small",
            .after = "prefilter",
            .choices = {"exact", "small"},
            .help = "Of a page: exact (PNG), or small (WebP). Default: exact up to 8 MB."},
           {.name = "experiment",
            .value = "pairs|dsis",
            .after = "quality",
            .choices = {"pairs", "dsis"},
            .help =
                "Of a page with --test: viewers vote on the light fields, pairs: which of two is "
                "better, dsis: how much a test's errors annoy beside the reference (BT.500). "
                "--votes reads what they save."}},
      .run = runExport};
}

}  // namespace hogelscope
