// SPDX-License-Identifier: BSD-3-Clause
// --pack: converts a light field to a store.
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/jobs/pack_job.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/session_file.h"
#include "io/files/folders.h"
#include "io/files/random_access_file.h"
#include "io/files/system_limits.h"
#include "io/store/store_writer.h"

namespace hogelscope {

namespace {

namespace fs = std::filesystem;

/// The light field to pack; the store does not contain a display that nobody specified.
struct Content {
  Session session;
  bool isDisplayGiven = false;
};

Content loadContent(const CommandLine& line) {
  const std::vector<std::string>& overrides = line.texts("set");
  if (line.has("session"))
    return {withLightField(isSessionDocument(line.text("session"))
                               ? loadSession(line.text("session"), overrides)
                               : loadSessionOf(line),
                           line.subject),
            true};
  if (isSessionFile(line.subject)) return {loadSession(line.subject, overrides), true};
  return {sessionAroundSubject(line).session, false};
}

/// Throws InputError for the name of another format: a store is a TIFF, whatever its name says.
void requireStoreName(const std::string& output) {
  const std::string extension = lowerCase(fs::path(output).extension().string());
  if (extension != ".tif" && extension != ".tiff" && !isFolder(output))
    throw InputError("--output " + output,
                     "is the name of a store, which is a TIFF: end it in .tif");
}

std::string shapeText(const StoreHeader& header) {
  const auto& [size, type, block, overview, source, display] = header;
  return pairText(size.nx, size.ny) + " hogels of " + pairText(size.du, size.dv) +
         " directions in blocks of " + pairText(block.i, block.j) + " × " +
         pairText(block.u, block.v);
}

/// Writes the frame that is selected as a store.
void packFrame(const Session& session, bool isDisplayGiven, LightFieldFile& file,
               const fs::path& output, const CommandLine& line) {
  const bool isQuiet = line.has("quiet");
  const std::size_t memory = allowedMemory() / (file.isStream() ? 1 : 2);  // half for the reader
  const PackPlan plan =
      planPack(session.lightField, file,
               isDisplayGiven ? std::optional(session.display) : std::nullopt, memory);
  makeFolderOf(output);
  if (!isQuiet)
    std::cout << shapeText(plan.header) << "; rows in memory " << bytesText(plan.memory)
              << ", on the disk about " << bytesText(plan.storeBytes) << readingTimeText(file)
              << std::endl;
  ProgressBar bar("packing", isQuiet);
  pack(file, plan, output, int(line.number("threads").value_or(0)), bar.progress());
  bar.done();
  if (!isQuiet)
    std::cout << printable(output.string()) << ": " << bytesText(RandomAccessFile(output).size())
              << "\n";
}

}  // namespace

int packContent(const Session& session, bool isDisplayGiven, const CommandLine& line) {
  const Input input(session);
  const std::vector<FrameOutput> frames = outputsOfFrames(line, *input.file);
  std::vector<fs::path> outputs;
  for (const FrameOutput& frame : frames) outputs.push_back(frame.output);
  checkResults(line, session, outputs);
  for (const fs::path& output : outputs) requireStoreName(output.string());
  for (const auto& [frame, output] : frames) {
    input.file->select(frame);
    packFrame(session, isDisplayGiven, *input.file, output, line);
  }
  return 0;
}

namespace {

int runPack(const CommandLine& line) {
  const auto [session, isDisplayGiven] = loadContent(line);
  if (typeOf(session.lightField.layout).holder == Holder::views)
    warnOf(*openLightField(session.lightField, session.display), session.lightField.file, line);
  return packContent(session, isDisplayGiven, line);
}

}  // namespace

Job packJob() {
  return {
      .name = "pack",
      .value = "LF",
      .help =
          "Writes a light field as a store: a tiled TIFF of which a view reads only what it "
          "sees, so that it need not fit into memory.",
      .details =
          "What an image of hogels does not say, display.hogels and display.directions, "
          "--session or --set says. After a stop the same command goes on where it was. Of a light "
          "field in time --frames, or {T} in --output, writes a store for each frame.",
      .examples =
          "  hogelscope --pack large.png --session s.json --output large.tif\n"
          "  hogelscope --pack large.png --output large.tif --set display.hogels=[512,512] \\\n"
          "             --set display.directions=[600,600]\n"
          "  hogelscope --pack views --output views.tif --memory 4000\n"
          "  hogelscope --pack decoded.png --session views --output decoded.tif\n",
      .needs = {"output"},
      .takes = {"session", "set", "plugins-path", "frames", "memory", "threads", "quiet"},
      .run = runPack};
}

}  // namespace hogelscope
