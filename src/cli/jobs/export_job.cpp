// SPDX-License-Identifier: BSD-3-Clause
// --export: the session's light field in another layout.
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs/all_jobs.h"
#include "cli/progress_bar.h"
#include "core/base/error.h"
#include "core/base/unicode.h"
#include "io/documents/session_file.h"
#include "io/files/output_folder.h"
#include "io/scene/light_field_export.h"
#include "io/scene/scene.h"

namespace hogelscope {

int runExport(const CommandLine& line) {
  const Session session = loadSessionOf(line);
  keepSession(line, session);
  if (line.subject == "pack") return packContent(session, true, line);
  const bool isHogels = line.subject == "hogels";
  const bool isQuilt = line.subject == "quilt";
  if (!isHogels && !isQuilt && line.subject != "views")
    throw InputError("--export",
                     "\"" + line.subject + "\" is not one of hogels, views, quilt, pack");
  const std::filesystem::path output = line.text("output");
  const auto file = openLightField(session.lightField, session.display);
  checkOutputs({output}, inputFiles({line.text("session")}, session, *file));
  const QuiltTiles tiles = isQuilt ? quiltTilesFor(*file, output) : QuiltTiles{};
  makeFolderOf(output);
  ProgressBar bar("exporting", line.has("quiet"));
  if (isHogels)
    exportHogels(*file, output, bar.progress());
  else if (isQuilt)
    exportQuilt(*file, output, bar.progress());
  else
    exportViews(*file, output, bar.progress());
  bar.done();
  if (line.has("quiet")) return 0;
  std::cout << printable(output.string()) << ": " << line.subject;
  if (isQuilt)
    std::cout << ", lightField.columns=" << tiles.columns << " lightField.rows=" << tiles.rows;
  std::cout << "\n";
  return 0;
}

}  // namespace hogelscope
