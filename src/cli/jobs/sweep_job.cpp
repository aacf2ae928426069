// SPDX-License-Identifier: BSD-3-Clause
// --sweep: figures of many designs.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/text.h"
#include "measure/sweep.h"

namespace hogelscope {

int runSweep(const CommandLine& line) {
  SweepRequest request;
  request.name = line.text("session");
  request.table = loadSweepTable(line.subject);
  request.session = loadSelected(line, "a sweep");
  inFile(line.subject, [&] { checkFigures(request.table, request.session); });
  request.output = line.text("output");
  request.shard = shardOf(line);
  const std::filesystem::path folder = request.output;
  const FilesInUse inUse(inputsOf(request, {}));
  std::vector<std::filesystem::path> results{folder / "sweep.csv", folder / "sweep.html"};
  if (request.table.solve) results.push_back(folder / "sweep.json");
  checkResults(line, request.session, results);
  ProgressBar bar("measuring designs", line.has("quiet"));
  const Sweep result = inFile(line.subject, [&] { return sweep(request, bar.progress()); });
  bar.done();
  if (!finish(line, request.session)) return 0;
  printFound(folder, result.replacedAnother, result.taken, "designs");
  if (printShard(request.shard, "designs", "page")) return 0;
  const auto failed =
      std::ranges::count_if(result.rows, [](const SweepRow& row) { return !row.problem.empty(); });
  if (failed > 0)
    printNote(std::to_string(failed) + " design(s) could not be measured; sweep.csv says why");
  std::cout << result.rows.size() << " designs";
  if (!request.table.pareto.empty())
    std::cout << ", " << std::ranges::count_if(result.rows, &SweepRow::isPareto)
              << " of them on the Pareto front,";
  std::cout << " in " << printable((folder / "sweep.csv").string()) << " and "
            << printable((folder / "sweep.html").string()) << "\n";
  if (result.solved) std::cout << result.solvedText << "\n";
  if (const std::string yield = yieldText(result.table, result.rows); !yield.empty())
    std::cout << yield << "\n";
  if (const std::string effect = effectText(result.table, result.rows); !effect.empty())
    std::cout << effect << "\n";
  return 0;
}

Job sweepJob() {
  return {.name = "sweep",
          .value = "TABLE.json",
          .help =
              "Measures figures of many designs, which vary parameters of the session as a table "
              "says: DIR/sweep.csv, sweep.html, plots.",
          .details =
              "TABLE.json has parameters, sampling (grid or latin-hypercube, with count and "
              "seed), figures and pareto; of units that are drawn, pass gives the yield, and solve "
              "the largest value of a parameter for a yield. After a stop the same command goes on "
              "where it was, and --shard K/N does a part, as of a report.",
          .examples =
              "  hogelscope --sweep table.json --session s.json --output sweep\n"
              "  hogelscope --sweep table.json --session s.json --output sweep --shard 2/4\n",
          .needs = {"session", "output"},
          .takes = {"set", "states", "calibration", "plugins-path", "save-session", "shard",
                    "memory", "threads", "quiet"},
          .run = runSweep};
}

}  // namespace hogelscope
