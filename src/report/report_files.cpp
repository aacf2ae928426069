// SPDX-License-Identifier: BSD-3-Clause
// The files of a report.
#include "report/report_files.h"

#include <algorithm>
#include <cmath>

#include "core/metrics/difference.h"
#include "io/files/atomic_file.h"
#include "io/images/image_writer.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

fs::path panelFile(const fs::path& folder, std::size_t test, const std::string& ending) {
  return folder / "panel_error" / ("test" + std::to_string(test + 1) + "_" + ending);
}

std::string pngOf(const Image& image, const Progress& progress = {}) {
  return encodedPng(image.width, image.height, image.rgb, progress);
}

void writePng(const fs::path& file, const Image& image, const Progress& progress = {}) {
  writeImage(file, image.width, image.height, image.rgb, progress);
}

/// With all bits that it has: 16 in the file for more than 8.
void writeView(const fs::path& file, const Image& image, const Progress& progress) {
  if (image.bits == 8) return writePng(file, image, progress);
  ImageRowWriter writer(file, std::size_t(image.width), std::size_t(image.height),
                        StoredType::uint16);
  std::vector<double> values(3 * std::size_t(image.width));
  std::vector<std::uint16_t> row(values.size());
  for (int y = 0; y < image.height; ++y) {
    reportProgress(progress, double(y) / image.height);
    readCodeValues(image, std::size_t(y) * values.size(), values);
    std::ranges::transform(values, row.begin(), [](double value) {
      return static_cast<std::uint16_t>(std::lround(257 * value));
    });
    writer.write(row.data());
  }
  writer.finish();
}

void writeCells(const fs::path& file, int width, int height,
                const std::vector<PanelError::Cell>& cells, int perCode) {
  writePlanes(file, width, height,
              {{"mse", meanSquares(cells, perCode)}, {"pixels", pixelCounts(cells)}});
}

}  // namespace

fs::path referenceImage(const fs::path& folder, const std::string& state) {
  return folder / "reference" / (state + ".png");
}

fs::path testImage(const fs::path& folder, std::size_t test, const std::string& state) {
  return folder / ("test" + std::to_string(test + 1)) / (state + ".png");
}

std::vector<fs::path> filesOf(const ReportRequest& request) {
  const fs::path folder = request.output;
  std::vector<fs::path> files{folder / "report.csv", folder / "metrics.csv", folder / "summary.csv",
                              folder / "bd.csv", folder / "report.html"};
  for (std::size_t test = 0; test < request.tests.size(); ++test) {
    for (const char* ending : {"hogels.exr", "directions.exr", "hogels.png", "directions.png"})
      files.push_back(panelFile(folder, test, ending));
    if (!request.images) continue;
    for (const CameraState& state : request.session.cameras) {
      files.push_back(referenceImage(folder, state.camera.name));
      files.push_back(testImage(folder, test, state.camera.name));
    }
  }
  return files;
}

void writeTables(const fs::path& folder, const Report& report, const MetricSet& metrics) {
  writeTextFile(folder / "report.csv", reportCsv(report.rows, metrics));
  writeTextFile(folder / "metrics.csv", metricsCsv(report.rows, metrics));
  writeTextFile(folder / "summary.csv", summaryCsv(report.summaries, metrics));
  if (!report.comparisons.empty()) writeTextFile(folder / "bd.csv", bdCsv(report.comparisons));
}

void writeImages(const fs::path& folder, std::size_t test, const std::string& state,
                 const ViewPair& pair, const Progress& progress) {
  const fs::path reference = referenceImage(folder, state);
  const fs::path own = testImage(folder, test, state);
  makeFolder(reference.parent_path());
  makeFolder(own.parent_path());
  if (test == 0) writeView(reference, pair.reference, progress);
  writeView(own, pair.test, progress);
}

ReportPanel writePanelError(const fs::path& folder, std::size_t test, const std::string& name,
                            const PanelError& error, const DisplayParams& display) {
  makeFolder(folder / "panel_error");
  const LightFieldSize& size = error.size();
  const Image hogels = hogelErrorImage(error, display);
  const Image directions = directionErrorImage(error, display);
  writeCells(panelFile(folder, test, "hogels.exr"), size.nx, size.ny, error.hogels(),
             error.perCode());
  writeCells(panelFile(folder, test, "directions.exr"), size.du, size.dv, error.directions(),
             error.perCode());
  writePng(panelFile(folder, test, "hogels.png"), hogels);
  writePng(panelFile(folder, test, "directions.png"), directions);
  return {name, pngOf(hogels), pngOf(directions), figuresOf(error, display)};
}

ReportView viewOf(std::size_t row, const std::string& which, const ViewPair& pair,
                  const Progress& progress) {
  const DifferenceImage difference = differenceImage(pair.reference, pair.test);
  return {row,
          which,
          pngOf(pair.reference, progress),
          pngOf(pair.test, progress),
          pngOf(difference.image, progress),
          difference.gain};
}

}  // namespace hogelscope
