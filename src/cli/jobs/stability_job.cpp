// SPDX-License-Identifier: BSD-3-Clause
// --stability: where methods fail, as a table and as maps.
#include "cli/jobs/stability_job.h"

#include <filesystem>
#include <iostream>

#include "chart/stability_map.h"
#include "cli/inputs.h"
#include "cli/progress_bar.h"
#include "core/base/parallel.h"
#include "core/engine/plan.h"
#include "io/documents/calibration_file.h"
#include "io/files/atomic_file.h"
#include "io/files/output_folder.h"
#include "study/stability.h"

namespace hogelscope {

namespace {

std::vector<NamedLens> lensesFor(const Options& options) {
  std::vector<NamedLens> lenses = hardLenses();
  if (options.calibrations.empty()) return lenses;
  for (const NamedCalibration& camera : loadCalibrations(options.calibrations)) {
    CameraState state;
    apply(camera.calibration, state);
    lenses.push_back({camera.name, lensKeyOf(state, {})});
  }
  return lenses;
}

}  // namespace

int stabilityJob(const Options& options) {
  const std::vector<NamedLens> lenses = lensesFor(options);
  const std::filesystem::path folder = options.output;
  checkOutputs({folder / "stability.csv", folder / "stability.png"}, inputsOf(options));
  makeFolder(folder);
  ProgressBar bar("measuring", options.quiet);
  const Stability stability = measureStability(lenses, parallelRows, bar.progress());
  const OffscreenPainting painting;
  const std::string picture =
      pngOf([&stability](QPainter& painter,
                         const QSizeF& size) { paintStabilityMaps(painter, size, stability.maps); },
            stabilityMapsSize());
  writeTextFile(folder / "stability.csv", csv(stability));
  writeTextFile(folder / "stability.png", picture);
  bar.done();
  if (!options.quiet)
    std::cout << lenses.size() << " lens(es) and two maps in "
              << (folder / "stability.csv").string() << " and "
              << (folder / "stability.png").string() << "\n";
  return 0;
}

}  // namespace hogelscope
