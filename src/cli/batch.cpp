// SPDX-License-Identifier: BSD-3-Clause
// Batch mode: the jobs of the command line.
#include "cli/batch.h"

#include <vtkNew.h>

#include <filesystem>
#include <iostream>

#include "cli/camera_job.h"
#include "cli/explain.h"
#include "cli/generate_job.h"
#include "cli/info.h"
#include "cli/inputs.h"
#include "cli/progress_bar.h"
#include "cli/report_job.h"
#include "cli/stability_job.h"
#include "cli/tradeoff_job.h"
#include "core/error.h"
#include "io/atomic_file.h"
#include "io/image_file.h"
#include "io/light_field_file.h"
#include "io/session_file.h"
#include "vtk/vtkHogelViewFilter.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

int render(const Options& options) {
  const Session session = loadSelected(options);
  (void)openLightField(session.lightField, session.display);  // a bad one leaves no folder behind
  makeFolder(options.output);
  ProgressBar bar("rendering", options.quiet);
  const Scene scene = loadScene(session, part(bar.progress(), 0, 0.5));
  if (options.explain) std::cout << explanations(scene, session);
  const vtkNew<vtkHogelViewFilter> filter;
  const auto count = double(session.cameras.size());
  for (std::size_t k = 0; k < session.cameras.size(); ++k) {
    const CameraState& state = session.cameras[k];
    filter->SetProgress(
        part(bar.progress(), 0.5 + 0.5 * double(k) / count, 0.5 + 0.5 * double(k + 1) / count));
    filter->SetView(scene.view(state));
    const fs::path file = fs::path(options.output) / (state.camera.name + "." + options.format);
    const auto [width, height] = state.camera.res;
    if (options.format != "png") writeImage(file, width, height, filter->GetCodeValues());
    if (options.format == "png" || options.masks) {
      const Image image = filter->GetImage();
      if (options.format == "png") writeImage(file, width, height, image.rgb);
      if (options.masks)
        writeMask(fs::path(options.output) / (state.camera.name + ".mask.png"), width, height,
                  image.seen);
    }
  }
  bar.done();
  if (!options.quiet)
    std::cout << session.cameras.size() << " picture(s) in " << options.output << "\n";
  return 0;
}

int runJob(const Options& options) {
  vtkObject::GlobalWarningDisplayOff();  // what fails comes back as InputError
  vtkHogelViewFilter::SetThreads(options.threads);
  switch (options.command) {
    case Command::render:
      return render(options);
    case Command::report:
      return reportJob(options);
    case Command::makeCameras:
      return makeCameras(options);
    case Command::generate:
      return generateJob(options);
    case Command::tradeoff:
      return tradeoff(options);
    case Command::stability:
      return stabilityJob(options);
    case Command::info:
      std::cout << infoText(options.infoFile);
      return 0;
    case Command::version:
      std::cout << "hogelscope " HOGELSCOPE_VERSION "\n";
      return 0;
    default:
      std::cout << helpText(options.files.empty() ? "" : options.files.front());
      return 0;
  }
}

}  // namespace

int runBatch(const Options& options) {
  try {
    return runJob(options);
  } catch (const InputError& error) {
    throw options.session.empty() ? error : error.in(options.session);
  }
}

}  // namespace hogelscope
