// SPDX-License-Identifier: BSD-3-Clause
// --report: every state from the session's light field and from each test, compared.
#include "cli/report_job.h"

#include <vtkNew.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "cli/explain.h"
#include "cli/inputs.h"
#include "cli/progress_bar.h"
#include "cli/report_groups.h"
#include "core/plan.h"
#include "core/report_page.h"
#include "core/summary_page.h"
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

std::vector<Image> renderAll(const Session& session, const Options& options,
                             const Progress& progress) {
  const Scene scene = loadScene(session, part(progress, 0, 0.3));
  if (options.explain) std::cout << explanations(scene, session);
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
    const std::vector<Image> images = renderAll(withLightField(session, options.tests[t]), options,
                                                part(progress, from, from + share));
    if (options.images) saveAll(folder / ("test" + std::to_string(t + 1)), session, images);
    for (std::size_t k = 0; k < images.size(); ++k) {
      advance(progress, from + share);
      rows[k * options.tests.size() + t] = {session.cameras[k].camera.name, options.tests[t],
                                            compare(references[k], images[k], parallelRows),
                                            session.cameras[k].camera.eye,
                                            session.cameras[k].camera.weight};
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

/// Opens every test, so that a bad one is told before the work, and gives their sizes on disk.
std::vector<TestSize> checkTests(const Session& session, const Options& options) {
  std::vector<TestSize> sizes;
  for (const std::string& test : options.tests) {
    const Session other = withLightField(session, test);
    const LightFieldSize size = openLightField(other.lightField, other.display)->size();
    sizes.push_back(
        {test, other.lightField.file, double(size.nx) * size.ny * double(size.du) * size.dv});
  }
  return sizes;
}

void writeTables(const fs::path& folder, const std::vector<ReportRow>& rows,
                 const std::vector<TestSummary>& summaries, const std::vector<BdRow>& comparisons) {
  writeTextFile(folder / "report.csv", csv(rows));
  writeTextFile(folder / "metrics.csv", metricsCsv(rows));
  writeTextFile(folder / "summary.csv", summaryCsv(summaries));
  if (!comparisons.empty()) writeTextFile(folder / "bd.csv", bdCsv(comparisons));
}

}  // namespace

int reportJob(const Options& options) {
  Session session = loadSelected(options);
  session.sampling.tolerance = 0;  // differences are the light fields', not the methods'
  const std::vector<RateGroup> groups = rateGroups(options, checkTests(session, options));
  makeFolder(options.output);
  ProgressBar bar("comparing", options.quiet);
  const std::vector<ReportRow> rows = compareAll(session, options, bar.progress());
  const std::vector<TestSummary> summaries = summariseTests(rows, groups);
  const std::vector<BdRow> comparisons = bdRows(summaries, groups);
  const fs::path folder = options.output;
  writeTables(folder, rows, summaries, comparisons);
  ReportPage page;
  page.session = options.session;
  page.display =
      resolved(session.display, openLightField(session.lightField, session.display)->size());
  page.rows = rows;
  page.summaries = summaries;
  page.comparisons = comparisons;
  page.lenses = certifyAll(session);
  writeTextFile(folder / "report.html", html(page));
  bar.done();
  if (!options.quiet) {
    std::cout << summaryText(summarise(rows), rows) << bdText(comparisons);
    std::cout << "report in " << (folder / "report.csv").string() << " and "
              << (folder / "report.html").string() << "\n";
  }
  return gate(rows, options);
}

}  // namespace hogelscope
