// SPDX-License-Identifier: BSD-3-Clause
// --optimise: content that makes up for the display's leakage.
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/optics/eyes.h"
#include "optimise/optimise_page.h"
#include "optimise/optimise_run.h"

namespace hogelscope {

namespace {

namespace fs = std::filesystem;

int runOptimise(const CommandLine& line) {
  const ExportLayout layout = optimiseLayout(line.subject, line.text("output"));
  if (layout != ExportLayout::pack && line.has("shard"))
    throw InputError("command line", "--shard", "is for --optimise pack");
  const Session session = withEyes(loadSelected(line, "optimised content"));
  const std::string name = fs::path(line.text("session")).stem().string();
  const OptimiseRequest request{name, session, layout, line.text("output"), shardOf(line)};
  ProgressBar bar("optimising", line.has("quiet"));
  const auto content = optimisedContent(session, part(bar.progress(), 0, 0.1));
  const Input input(session, content);
  const FilesInUse pictures(picturesOf(session));
  warnOfFrames(line, content->frames());
  checkResults(line, session, {request.output, tableOf(request), pageOf(request)});
  const std::optional<Optimised> result = optimise(request, *content, part(bar.progress(), 0.1, 1));
  bar.done();
  if (!finish(line, session)) return 0;
  if (!result) {
    std::cout << "shard " << textOf(*request.shard) << ": rows of hogels in "
              << printable(request.output.string()) << ".rows, for the command without --shard\n";
    return 0;
  }
  std::cout << printable(request.output.string()) << ": " << line.subject << "\n"
            << meansText(*result) << "the best content would have at most "
            << rounded(openDecibels(result->figures), 2) << " dB more\n"
            << "table and page in " << printable(tableOf(request).string()) << " and .html\n";
  for (const std::string& warning : result->warnings)
    std::cerr << "hogelscope: attention: " << printable(warning) << "\n";
  return 0;
}

}  // namespace

Job optimiseJob() {
  return {
      .name = "optimise",
      .value = "hogels|views|quilt|pack",
      .help =
          "Writes the content that makes up for the display's leakage: of each hogel the values "
          "whose light, as it leaks, comes closest to what should be seen; FILE.csv and FILE.html "
          "say what it is worth.",
      .details =
          "The states say how much the display leaks (psf). What should be seen is the light "
          "field's own light (optimise.target \"light\"), of a live scene over all of each "
          "directional pixel; or the ideal views of the states; or a picture for each state. "
          "Views are compared before and after, also those of eyes that it was not optimised for, "
          "and what the best content could at most have more is proven. "
          "A unit's content (twin) makes up for its gains, shifts and dead pixels too. "
          "After a stop pack goes on where it was; --shard shares its rows of hogels.",
      .examples =
          "  hogelscope --optimise hogels --session s.json --output optimised.png\n"
          "  hogelscope --optimise views --session live.json --output optimised \\\n"
          "             --set optimise.target=ideal --set optimise.keep=0.3\n"
          "  hogelscope --optimise pack --session live.json --output optimised.tif --shard 1/4\n",
      .needs = {"session", "output"},
      .takes = {"set", "states", "twin", "plugins-path", "save-session", "shard", "memory",
                "threads", "quiet"},
      .run = runOptimise};
}

}  // namespace hogelscope
