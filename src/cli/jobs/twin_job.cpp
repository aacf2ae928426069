// SPDX-License-Identifier: BSD-3-Clause
// --make-twin: a unit whose random errors are drawn and written as maps.
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs/all_jobs.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/panel/twin.h"
#include "io/documents/twin_file.h"
#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"
#include "io/files/folders.h"
#include "io/scene/view_source.h"
#include "io/twin/twin_maps.h"

namespace hogelscope {

int runMakeTwin(const CommandLine& line) {
  const Session session = loadSessionOf(line);
  inFile(line.text("session"), [&] { requireHogels(session.display, "a twin"); });
  const std::string name = line.text("session");
  const std::filesystem::path output = line.text("output");
  const std::filesystem::path maps = std::filesystem::path(output).replace_extension(".hogels.exr");
  if (output.extension() != ".json")
    throw InputError(output.string(), "cannot be written", "a twin's name ends in .json");
  if (session.twin.random.shift.sigma == 0 && session.twin.random.gain.sigma == 0)
    throw InputError(name, "twin.random", "draws nothing: give shift or gain a sigma");
  const auto file = openLightField(session.lightField, session.display);
  const FilesInUse inUse(filesOf(session, *file));
  checkResults(line, session, {output, maps});
  const PanelParams display = resolved(displayOf(session), file->size());
  const auto twin = inFile(name, [&] { return twinOf(session.twin, display); });
  TwinParams drawn = session.twin;
  drawn.random = {};
  drawn.maps.hogels = maps.string();
  const std::string document = textFor(output, drawn);  // refuses names before anything is written
  makeFolderOf(output);
  (void)AtomicFile(output);  // refuses what is no file before the maps are written
  writeHogelMaps(maps, twin->drawn());
  writeTextFile(output, document);
  if (!line.has("quiet"))
    std::cout << printable(output.string()) << ", " << printable(maps.string()) << ": "
              << pairText(display.hogels[0], display.hogels[1]) << " hogels\n";
  return 0;
}

}  // namespace hogelscope
