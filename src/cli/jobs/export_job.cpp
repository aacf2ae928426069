// SPDX-License-Identifier: BSD-3-Clause
// --export: the session's light field in another layout.
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs/all_jobs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/folders.h"
#include "io/scene/light_field_export.h"
#include "io/scene/view_source.h"

namespace hogelscope {

int runExport(const CommandLine& line) {
  const Session session = loadSessionOf(line);
  keepSession(line, session);
  if (line.subject == "pack") return packContent(session, true, line);
  const auto isTo = [&line](const char* layout) { return line.subject == layout; };
  const bool isQuilt = isTo("quilt");
  if (!isTo("hogels") && !isTo("views") && !isQuilt && !isTo("mosaic"))
    throw InputError("--export",
                     "\"" + line.subject + "\" is not one of hogels, views, quilt, mosaic, pack");
  const std::filesystem::path output = line.text("output");
  const auto file = openLightField(session.lightField, session.display);
  checkOutputs({output}, inputFiles({line.text("session")}, session, *file));
  std::array<int, 2> tiles{};
  if (isQuilt) tiles = quiltTilesFor(*file, output);
  makeFolderOf(output);
  ProgressBar bar("exporting", line.has("quiet"));
  (isTo("hogels")  ? exportHogels
   : isQuilt       ? exportQuilt
   : isTo("views") ? exportViews
                   : exportMosaic)(*file, output, bar.progress());
  bar.done();
  if (line.has("quiet")) return 0;
  std::cout << printable(output.string()) << ": " << line.subject;
  if (isQuilt) std::cout << ", lightField.columns=" << tiles[0] << " lightField.rows=" << tiles[1];
  if (isTo("mosaic"))
    std::cout << ", display.directions=[" << file->size().du << "," << file->size().dv << "]";
  std::cout << "\n";
  return 0;
}

}  // namespace hogelscope
