// SPDX-License-Identifier: BSD-3-Clause
// --make-twin: a unit whose random errors are drawn and written as maps.
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/panel/twin.h"
#include "io/documents/twin_file.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/twin/twin_maps.h"

namespace hogelscope {

namespace {

int runMakeTwin(const CommandLine& line) {
  const Session session = loadSessionOf(line);
  requireHogels(session.display, "a twin");
  const std::string name = line.text("session");
  const std::filesystem::path output = line.text("output");
  const std::filesystem::path maps = std::filesystem::path(output).replace_extension(".hogels.exr");
  if (output.extension() != ".json")
    throw InputError(output.string(), "cannot be written", "a twin's name ends in .json");
  if (session.twin.random.shift.sigma == 0 && session.twin.random.gain.sigma == 0)
    throw InputError(name, "twin.random", "draws nothing: give shift or gain a sigma");
  const Input input(session);
  checkResults(line, session, {output, maps});
  const PanelParams display = input.display();
  const auto twin = twinOf(session.twin, display);
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

}  // namespace

Job twinJob() {
  return {.name = "make-twin",
          .help =
              "Draws the random errors of the session's twin, or of --twin, and writes a twin "
              "without random numbers: --output F.json, and F.hogels.exr with what was drawn.",
          .examples =
              "  hogelscope --make-twin --session data/room.json --twin unit7.json --output "
              "drawn.json\n"
              "  hogelscope --make-twin --session s.json --set twin.random.seed=8 \\\n"
              "             --set twin.random.shift.sigma=5e-6 --output unit8.json\n",
          .needs = {"session", "output"},
          .takes = {"set", "twin", "plugins-path", "memory", "quiet"},
          .run = runMakeTwin};
}

}  // namespace hogelscope
