// SPDX-License-Identifier: BSD-3-Clause
// --stability: the failures of methods, as a table and as maps.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "chart/stability_charts.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/engine/plan.h"
#include "io/cameras/camera_file.h"
#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"

namespace hogelscope {

namespace {

/// Returns the hard lenses, followed by those of `calibrations` ("" for none).
std::vector<NamedLens> allLenses(const std::string& calibrations) {
  std::vector<NamedLens> lenses = hardLenses();
  if (calibrations.empty()) return lenses;
  for (const NamedCalibration& camera : loadCalibrations(calibrations)) {
    CameraState state;
    apply(camera.calibration, state);
    lenses.push_back({camera.name, lensKeyOf(state, {})});
  }
  return lenses;
}

int runStability(const CommandLine& line) {
  const std::string calibrations = line.text("calibrations");
  const std::vector<NamedLens> lenses = allLenses(calibrations);
  const std::filesystem::path folder = line.text("output");
  const std::size_t first = hardLenses().size();
  const bool hasOwn = lenses.size() > first;
  checkOutputs({folder / "stability.csv", folder / "stability.png", folder / "lenses.png"});
  makeFolder(folder);
  ProgressBar bar("measuring", line.has("quiet"));
  const Stability stability = measureStability(lenses, parallelRows, bar.progress());
  const OffscreenPainting painting;
  const std::string picture =
      pngOf([&stability](QPainter& painter,
                         const QSizeF& size) { paintStabilityMaps(painter, size, stability.maps); },
            stabilityMapsSize());
  const auto lensPictures = [&](QPainter& painter, const QSizeF& size) {
    paintLensPictures(painter, size, stability, first);
  };
  writeTextFile(folder / "stability.csv", csv(stability));
  writeTextFile(folder / "stability.png", picture);
  if (hasOwn)
    writeTextFile(folder / "lenses.png", pngOf(lensPictures, lensPicturesSize(stability, first)));
  bar.done();
  if (line.has("quiet")) return 0;
  std::cout << lenses.size() << " lens(es) and two maps in "
            << printable((folder / "stability.csv").string()) << " and "
            << printable((folder / "stability.png").string()) << "\n";
  for (std::size_t k = first; k < lenses.size(); ++k)
    std::cout << "  " << printable(lenses[k].name) << ": "
              << distortionModelNames()[std::size_t(lenses[k].key.distortion.model)] << "\n";
  if (hasOwn)
    std::cout << std::min(lenses.size() - first, mostLensPictures)
              << " lens(es) of the calibrations, pixel by pixel, in "
              << printable((folder / "lenses.png").string()) << "\n";
  return 0;
}

}  // namespace

Job stabilityJob() {
  return {.name = "stability",
          .help =
              "Measures where methods fail: which ways to invert a lens find the right ray, which "
              "a wrong one or none, and other unstable cases: DIR/stability.csv, .png.",
          .examples =
              "  hogelscope --stability --output stability\n"
              "  hogelscope --stability --output stability --calibrations cameras.json\n",
          .needs = {"output"},
          .takes = {"threads", "quiet"},
          .own = {{.name = "calibrations",
                   .value = "FILE",
                   .after = "calibration",
                   .isInput = true,
                   .help = "Adds lenses: a JSON list of cameras, or a file as for --calibration."}},
          .run = runStability};
}

}  // namespace hogelscope
