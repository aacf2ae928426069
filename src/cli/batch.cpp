// SPDX-License-Identifier: BSD-3-Clause
// Batch mode: the jobs of the command line.
#include "cli/batch.h"

#include <vtkNew.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "cli/camera_job.h"
#include "cli/explain.h"
#include "cli/info.h"
#include "cli/inputs.h"
#include "cli/progress_bar.h"
#include "cli/stability_job.h"
#include "cli/tradeoff_job.h"
#include "core/error.h"
#include "core/pattern.h"
#include "core/plan.h"
#include "core/report.h"
#include "core/report_page.h"
#include "io/atomic_file.h"
#include "io/image_file.h"
#include "io/light_field_file.h"
#include "io/session_file.h"
#include "vtk/parallel_rows.h"
#include "vtk/vtkHogelViewFilter.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

void savePicture(const fs::path& folder, const std::string& name, const Image& image) {
  writeImage(folder / (name + ".png"), image.width, image.height, image.rgb);
}

void explainAll(const Scene& scene, const Session& session, const Options& options) {
  if (!options.explain) return;
  for (const CameraState& state : session.cameras) std::cout << explanation(scene.view(state));
}

int render(const Options& options) {
  const Session session = loadSelected(options);
  (void)openLightField(session.lightField, session.display);  // a bad one leaves no folder behind
  makeFolder(options.output);
  ProgressBar bar("rendering", options.quiet);
  const Scene scene = loadScene(session, part(bar.progress(), 0, 0.5));
  explainAll(scene, session, options);
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

/// A test light field, in the place of the session's own.
Session testSession(const Session& session, const std::string& test) {
  Session result = session;
  if (isSessionFile(test)) {
    const Session other = loadSession(test);
    result.display = other.display;
    result.lightField = other.lightField;
  } else {
    const bool isFolder = fs::is_directory(test);
    if (isFolder != (session.lightField.layout == Layout::views)) {
      result.lightField = {};  // the session's own layout says nothing about it
      result.lightField.layout = isFolder ? Layout::views : Layout::hogels;
    }
    result.lightField.file = test;
    check(result);
  }
  return result;
}

std::vector<Image> renderAll(const Session& session, const Options& options,
                             const Progress& progress) {
  const Scene scene = loadScene(session, part(progress, 0, 0.3));
  explainAll(scene, session, options);
  const vtkNew<vtkHogelViewFilter> filter;
  std::vector<Image> images;
  const auto count = double(session.cameras.size());
  for (const CameraState& state : session.cameras) {
    const auto k = double(images.size());
    filter->SetProgress(part(progress, 0.3 + 0.7 * k / count, 0.3 + 0.7 * (k + 1) / count));
    filter->SetView(scene.view(state));
    images.push_back(filter->GetImage());
  }
  return images;
}

void saveAll(const fs::path& folder, const Session& session, const std::vector<Image>& images) {
  makeFolder(folder);
  for (std::size_t k = 0; k < images.size(); ++k)
    savePicture(folder, session.cameras[k].camera.name, images[k]);
}

/// Rows in the order of the states, then of the tests.
std::vector<ReportRow> compareAll(const Session& session, const Options& options,
                                  const Progress& progress) {
  const fs::path folder = options.output;
  const double share = 1 / double(options.tests.size() + 1);
  const std::vector<Image> references = renderAll(session, options, part(progress, 0, share));
  if (options.images) saveAll(folder / "reference", session, references);
  std::vector<ReportRow> rows(references.size() * options.tests.size());
  for (std::size_t t = 0; t < options.tests.size(); ++t) {
    const double from = share * double(t + 1);
    const std::vector<Image> images = renderAll(testSession(session, options.tests[t]), options,
                                                part(progress, from, from + share));
    if (options.images) saveAll(folder / ("test" + std::to_string(t + 1)), session, images);
    for (std::size_t k = 0; k < images.size(); ++k) {
      advance(progress, from + share);
      rows[k * options.tests.size() + t] = {session.cameras[k].camera.name, options.tests[t],
                                            compare(references[k], images[k]),
                                            session.cameras[k].camera.eye};
    }
  }
  return rows;
}

/// A lens that several states have is certified once.
std::vector<ReportLens> certifyAll(const Session& session) {
  std::vector<LensKey> keys;
  std::vector<ReportLens> lenses;
  for (const CameraState& state : session.cameras) {
    const LensKey key = lensKeyOf(state, session.sampling);
    const auto same = std::size_t(std::find(keys.begin(), keys.end(), key) - keys.begin());
    lenses.push_back({state.camera.name,
                      same < keys.size() ? lenses[same].certificate : certify(key, parallelRows)});
    keys.push_back(key);
  }
  return lenses;
}

int gate(const std::vector<ReportRow>& rows, const Options& options) {
  if (!options.failBelow) return 0;
  int status = 0;
  for (const ReportRow& row : rows) {
    const double db = psnr(row.metrics.mse);
    if (db >= *options.failBelow) continue;
    std::cerr << "hogelscope: " << row.state << ": " << row.test << ": " << numberText(db)
              << " dB is below " << numberText(*options.failBelow) << "\n";
    status = 1;
  }
  return status;
}

int report(const Options& options) {
  Session session = loadSelected(options);
  session.sampling.tolerance = 0;  // differences are the light fields', not the methods'
  for (const std::string& test : options.tests) {
    const Session other = testSession(session, test);
    (void)openLightField(other.lightField, other.display);  // a bad one is told before the work
  }
  makeFolder(options.output);
  ProgressBar bar("comparing", options.quiet);
  const std::vector<ReportRow> rows = compareAll(session, options, bar.progress());
  const fs::path folder = options.output;
  writeTextFile(folder / "report.csv", csv(rows));
  writeTextFile(folder / "report.html", reportPage(rows, certifyAll(session), options.session));
  bar.done();
  if (!options.quiet) {
    std::cout << summaryText(summarise(rows), rows);
    std::cout << "report in " << (folder / "report.csv").string() << " and "
              << (folder / "report.html").string() << "\n";
  }
  return gate(rows, options);
}

int generate(const Options& options) {
  const Session session = loadSession(options.session, options.overrides);
  const DisplayParams& display = session.display;
  if (display.hogels[0] < 1 || display.directions[0] < 1)
    throw InputError(options.session, "display.hogels",
                     "and directions are needed to make content");
  const LightFieldSize size{display.hogels[0], display.hogels[1], display.directions[0],
                            display.directions[1]};
  const ScenePattern pattern(display);
  if (const fs::path folder = fs::path(options.output).parent_path(); !folder.empty())
    makeFolder(folder);
  ProgressBar bar("generating", options.quiet);
  ImageRowWriter writer(options.output, size.width(), size.height());
  std::vector<std::uint8_t> row(3 * size.width());
  for (int y = 0; y < int(size.height()); ++y) {
    advance(bar.progress(), y / double(size.height()));
    for (int x = 0; x < int(size.width()); ++x) {
      const Rgb c = pattern.texel({x / size.du, y / size.dv, x % size.du, y % size.dv});
      std::uint8_t* rgb = &row[3 * std::size_t(x)];
      rgb[0] = quantised(c.r);
      rgb[1] = quantised(c.g);
      rgb[2] = quantised(c.b);
    }
    writer.write(row);
  }
  writer.finish();
  bar.done();
  if (!options.quiet)
    std::cout << options.output << ": " << size.width() << "×" << size.height() << " px\n";
  return 0;
}

}  // namespace

namespace {

int runJob(const Options& options) {
  vtkObject::GlobalWarningDisplayOff();  // what fails comes back as InputError
  vtkHogelViewFilter::SetThreads(options.threads);
  switch (options.command) {
    case Command::render:
      return render(options);
    case Command::report:
      return report(options);
    case Command::makeCameras:
      return makeCameras(options);
    case Command::generate:
      return generate(options);
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
