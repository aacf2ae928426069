// SPDX-License-Identifier: BSD-3-Clause
// --pack: converts a light field to a store.
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs/all_jobs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/session_file.h"
#include "io/files/files_in_use.h"
#include "io/files/folders.h"
#include "io/files/random_access_file.h"
#include "io/files/system_limits.h"
#include "io/scene/view_source.h"
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

}  // namespace

int packContent(const Session& session, bool isDisplayGiven, const CommandLine& line) {
  const std::string output = line.text("output");
  const bool isQuiet = line.has("quiet");
  const auto file = openLightField(session.lightField, session.display);
  const FilesInUse inUse(filesOf(session, *file));
  checkResults(line, session, {output});
  requireStoreName(output);
  const std::size_t memory = allowedMemory() / (file->isStream() ? 1 : 2);  // half for the reader
  const PackPlan plan =
      planPack(session.lightField, *file,
               isDisplayGiven ? std::optional(session.display) : std::nullopt, memory);
  makeFolderOf(output);
  if (!isQuiet)
    std::cout << shapeText(plan.header) << "; rows in memory " << bytesText(plan.memory)
              << ", on the disk about " << bytesText(plan.storeBytes) << readingTimeText(*file)
              << std::endl;
  ProgressBar bar("packing", isQuiet);
  pack(*file, plan, output, int(line.number("threads").value_or(0)), bar.progress());
  bar.done();
  if (!isQuiet)
    std::cout << printable(output) << ": " << bytesText(RandomAccessFile(output).size()) << "\n";
  return 0;
}

int runPack(const CommandLine& line) {
  const auto [session, isDisplayGiven] = loadContent(line);
  if (typeOf(session.lightField.layout).holder == Holder::views)
    warnOf(*openLightField(session.lightField, session.display), session.lightField.file, line);
  return packContent(session, isDisplayGiven, line);
}

}  // namespace hogelscope
