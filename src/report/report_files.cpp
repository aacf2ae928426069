// SPDX-License-Identifier: BSD-3-Clause
#include "report/report_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/text.h"
#include "core/cameras/frame_states.h"
#include "core/metrics/error_map.h"
#include "core/optics/eyes.h"
#include "io/files/atomic_file.h"
#include "io/images/image_writer.h"
#include "page/figure.h"
#include "report/page/report_tables.h"
#include "report/page/test_names.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Returns "views/testN_WHICH", N from 1.
std::string viewName(const ChosenView& view) {
  return "views/test" + std::to_string(view.test + 1) + "_" + view.which;
}

fs::path viewFile(const fs::path& folder, const ChosenView& view, const char* ending) {
  return folder / (viewName(view) + ending + ".png");
}

/// Returns the name of a view in names of its pictures: its state's, or "STATE.frame0010". `last`
/// is the report's last frame.
std::string pictureName(const std::string& state, std::optional<int> frame, int last) {
  return frame ? state + ".frame" + frameDigits(*frame, {0, last, 1}) : state;
}

fs::path referenceImage(const fs::path& folder, const std::string& state) {
  return folder / "reference" / (fileNameOf(state) + ".png");
}

fs::path testImage(const fs::path& folder, std::size_t test, const std::string& state) {
  return folder / ("test" + std::to_string(test + 1)) / (fileNameOf(state) + ".png");
}

std::string pngOf(const Image& image, const Progress& progress = {}) {
  return encodedPng(image.width, image.height, image.rgb, progress);
}

/// Returns the bytes of PNG for each figure of a kind whose share of the page is `share`. Base64
/// has four characters for three bytes.
std::size_t roomFor(double share, std::size_t figures) {
  return std::size_t(share * 0.75 * double(mostPictureBytes) / double(figures));
}

constexpr double shareOfPanels = 0.1;
constexpr std::size_t viewsOfTest = 3;  ///< the worst, the median and the best

/// Returns means of scale × scale pixels, of fewer at the right and at the bottom.
Image reduced(const Image& image, int scale) {
  Image small((image.width + scale - 1) / scale, (image.height + scale - 1) / scale);
  auto to = small.rgb.begin();
  for (int y = 0; y < image.height; y += scale)
    for (int x = 0; x < image.width; x += scale) {
      const int right = std::min(x + scale, image.width);
      const int bottom = std::min(y + scale, image.height);
      std::array<int, 3> sum{};
      for (int row = y; row < bottom; ++row)
        for (int k = 3 * x; k < 3 * right; ++k)
          sum[std::size_t(k % 3)] +=
              image.rgb[std::size_t(3 * row) * std::size_t(image.width) + std::size_t(k)];
      const int count = (right - x) * (bottom - y);
      for (const int one : sum) *to++ = static_cast<std::uint8_t>((one + count / 2) / count);
    }
  return small;
}

/// Images of one size, scaled down together to at most `room` bytes.
struct Shrunk {
  std::vector<std::string> pngs;
  int scale = 1;
};

Shrunk shrunk(const std::vector<const Image*>& images, std::size_t room,
              const Progress& progress = {}) {
  constexpr int least = 32;  // pixels; smaller images show nothing
  Shrunk result;
  for (;; ++result.scale) {
    result.pngs.clear();
    std::size_t bytes = 0;
    for (const Image* image : images) {
      result.pngs.push_back(pngOf(reduced(*image, result.scale), progress));
      bytes += result.pngs.back().size();
    }
    if (bytes <= room || std::max(images[0]->width, images[0]->height) <= least * result.scale)
      return result;
  }
}

void writePng(const fs::path& file, const Image& image, const Progress& progress = {}) {
  writeImage(file, image.width, image.height, image.rgb, progress);
}

/// Writes the image with its full depth: 16 bits for more than 8.
void writeImage(const fs::path& file, const Image& image, const Progress& progress) {
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

/// Returns a line for each cell, row by row: its column and row from the top left, its values.
std::string cellsCsv(const std::string& heads, int columns,
                     const std::vector<std::vector<float>>& values) {
  Table table = csvRows(heads);
  for (std::size_t cell = 0; cell < values[0].size(); ++cell)
    table.push_back({std::to_string(cell % std::size_t(columns)),
                     std::to_string(cell / std::size_t(columns)),
                     numberCell(double(values[0][cell])), numberCell(double(values[1][cell]))});
  return csvText(table);
}

/// Returns the positions of values within [low, high], as shares.
std::vector<double> sharesOf(std::vector<double> values, double low, double high) {
  if (high > low)
    for (double& value : values) value = (value - low) / (high - low);
  return values;
}

}  // namespace

fs::path panelFile(const fs::path& folder, std::size_t test, const std::string& ending) {
  return folder / "panel_error" / ("test" + std::to_string(test + 1) + "_" + ending);
}

std::string pictureName(const std::vector<ReportRow>& rows, std::size_t row) {
  return pictureName(rows[row].state, rows[row].frame, rows.back().frame.value_or(0));
}

std::vector<fs::path> filesOf(const ReportRequest& request) {
  const fs::path folder = request.output;
  std::vector<fs::path> files{folder / "report.csv",       folder / "metrics.csv",
                              folder / "summary.csv",      folder / "bd.csv",
                              folder / "report.html",      folder / "plots" / "means.tex",
                              folder / "plots" / "bd.tex", folder / "plots" / "tests.csv"};
  if (request.hasPage) files.push_back(folder / "page.html");
  const auto plot = [&](const std::string& name) {
    for (const char* ending : figureEndings) files.push_back(folder / "plots" / (name + ending));
  };
  for (const MetricMean& mean : request.metrics.means()) {
    plot("rate_" + mean.name);
    if (!request.frames.empty()) plot("frames_" + mean.name);
    if (request.isAgainstDesign)
      for (const char* kind : {"units_", "yield_"}) plot(kind + mean.name);
  }
  for (std::size_t test = 0; test < request.tests.size(); ++test) {
    for (const char* ending : {"hogels.exr", "directions.exr", "views.exr", "hogels.png",
                               "directions.png", "views.png", "ranks.png"})
      files.push_back(panelFile(folder, test, ending));
    for (const char* which : {"worst", "median", "best"})
      for (const char* ending : {"_reference", "_test", "_difference", ""})
        files.push_back(viewFile(folder, {0, test, which}, ending));
    for (const char* kind :
         {"above", "front", "angle", "states", "hogels", "directions", "views", "ranks"})
      plot(plotNameOf(request.tests[test].name, test) + "_" + kind);
    if (!request.images) continue;
    const std::vector<int>& frames = request.frames;
    for (std::size_t view = 0; view < request.session.cameras.size(); ++view) {
      const std::string& state = request.session.cameras[view].camera.name;
      const std::string name =
          frames.empty() ? state : pictureName(state, frames[view], frames.back());
      if (test == 0) files.push_back(referenceImage(folder, name));
      files.push_back(testImage(folder, test, name));
    }
  }
  return files;
}

std::vector<std::size_t> worstFirst(const std::vector<ReportRow>& rows, const ReportOrder& order,
                                    std::size_t test) {
  std::vector<std::size_t> states;
  for (std::size_t row = test; row < rows.size(); row += order.tests)
    if (rows[row].problem.empty()) states.push_back(order.state(row));
  const auto error = [&](std::size_t state) {
    const double mse = rows[order.row(state, test)].values[mseSeenColumn];
    return std::isnan(mse) ? std::numeric_limits<double>::infinity() : mse;  // nothing seen in both
  };
  std::ranges::stable_sort(states, std::ranges::greater(), error);
  return states;
}

std::vector<fs::path> picturesOf(const fs::path& folder, const std::vector<ReportRow>& rows,
                                 const ReportOrder& order, std::size_t row) {
  const std::size_t test = order.test(row);
  const std::vector<std::size_t> states = worstFirst(rows, order, test);
  std::vector<fs::path> files;
  for (const auto& [which, at] :
       {std::pair("worst", std::size_t(0)), std::pair("median", states.size() / 2),
        std::pair("best", states.size() - 1)})
    if (files.empty() && at < states.size() && states[at] == order.state(row))
      for (const char* ending : {"_reference", "_test", "_difference"})
        files.push_back(viewFile(folder, {row, test, which}, ending));
  if (files.empty())
    files = {referenceImage(folder, pictureName(rows, row)),
             testImage(folder, test, pictureName(rows, row))};
  const bool areThere =
      std::ranges::all_of(files, [](const fs::path& file) { return fs::exists(file); });
  return areThere ? files : std::vector<fs::path>();
}

void writeTables(const fs::path& folder, const Report& report, const MetricSet& metrics) {
  makeFolder(folder / "plots");
  writeTextFile(folder / "metrics.csv", metricsCsv(report.rows, metrics));
  writeTextFile(folder / "summary.csv", summaryCsv(report.summaries, metrics));
  if (!report.comparisons.empty()) {
    writeTextFile(folder / "bd.csv", bdCsv(report.comparisons));
    writeTextFile(folder / "plots" / "bd.tex", bdTex(report.comparisons, metrics));
  }
  writeTextFile(folder / "plots" / "means.tex", meansTex(report.summaries, metrics));
  Table names{{"number", "test", "plots"}};
  for (std::size_t test = 0; test + 1 < report.summaries.size(); ++test)
    names.push_back({std::to_string(test + 1), report.summaries[test].test,
                     plotNameOf(report.summaries[test].test, test)});
  writeTextFile(folder / "plots" / "tests.csv", csvText(names));
  writeTextFile(folder / "report.csv", reportCsv(report.rows, metrics));
}

void writeImages(const fs::path& folder, std::size_t test, const std::string& name,
                 const ViewPair& pair, const Progress& progress) {
  const fs::path reference = referenceImage(folder, name);
  const fs::path own = testImage(folder, test, name);
  makeFolder(reference.parent_path());
  makeFolder(own.parent_path());
  if (test == 0) writeImage(reference, pair.reference, progress);
  writeImage(own, pair.test, progress);
}

ReportPanel writePanelError(const fs::path& folder, std::size_t test, const ReportRequest& request,
                            const PanelError& error, const std::vector<double>& viewErrors,
                            const PanelParams& display) {
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
  const std::size_t room = roomFor(shareOfPanels, 4 * request.tests.size());
  ReportPanel page{request.tests[test].name, shrunk({&hogels}, room).pngs[0],
                   shrunk({&directions}, room).pngs[0], figuresOf(error, display)};
  page.hogelCells =
      cellsCsv("hogel_x,hogel_y,mse,pixels", size.nx,
               {meanSquares(error.hogels(), error.perCode()), pixelCounts(error.hogels())});
  page.directionCells =
      cellsCsv("direction_u,direction_v,mse,pixels", size.du,
               {meanSquares(error.directions(), error.perCode()), pixelCounts(error.directions())});
  if (viewErrors.empty()) return page;
  page.viewScale = scaleEndOf(viewErrors);
  page.agreement = agreementOf(viewErrors, error);
  const Image views = directionImage(sharesOf(viewErrors, 0, page.viewScale), display);
  const Image ranks = directionImage(sharesOf(page.agreement.rankDifferences, -1, 1), display);
  writePlanes(panelFile(folder, test, "views.exr"), size.du, size.dv,
              {{"mse", {viewErrors.begin(), viewErrors.end()}}});
  writePng(panelFile(folder, test, "views.png"), views);
  writePng(panelFile(folder, test, "ranks.png"), ranks);
  page.viewCells =
      cellsCsv("direction_u,direction_v,mse,rank_difference", size.du,
               {{viewErrors.begin(), viewErrors.end()},
                {page.agreement.rankDifferences.begin(), page.agreement.rankDifferences.end()}});
  page.views = shrunk({&views}, room).pngs[0];
  page.ranks = shrunk({&ranks}, room).pngs[0];
  return page;
}

std::size_t roomForView(const std::vector<ReportView>& before, std::size_t tests) {
  constexpr double shareOfFirst = 2.0 / 3;
  const std::size_t all = roomFor(1 - shareOfPanels, 1);
  if (tests > 1 && before.size() < viewsOfTest)
    return roomFor((1 - shareOfPanels) * shareOfFirst, viewsOfTest);
  std::size_t used = 0;
  for (const ReportView& view : before)
    used += view.reference.size() + view.test.size() + view.difference.size();
  return (all - std::min(used, all)) / (viewsOfTest * tests - before.size());
}

ReportView writeView(const fs::path& folder, const ChosenView& view, std::size_t room,
                     const ViewPair& pair, const SheetLabels& labels, const Progress& progress) {
  makeFolder(folder / "views");
  const DifferenceImage difference = differenceImage(pair.reference, pair.test);
  writeImage(viewFile(folder, view, "_reference"), pair.reference, progress);
  writeImage(viewFile(folder, view, "_test"), pair.test, progress);
  writePng(viewFile(folder, view, "_difference"), difference.image, progress);
  writePng(viewFile(folder, view, ""), comparisonSheet(pair.reference, pair.test, labels),
           progress);
  Shrunk page = shrunk({&pair.reference, &pair.test, &difference.image}, room, progress);
  return {view.row,
          view.which,
          std::move(page.pngs[0]),
          std::move(page.pngs[1]),
          std::move(page.pngs[2]),
          difference.gain,
          page.scale,
          viewName(view)};
}

}  // namespace hogelscope
