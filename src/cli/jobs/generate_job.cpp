// SPDX-License-Identifier: BSD-3-Clause
// --generate: computes a row of hogels while the previous one is written.
#include <cmath>
#include <filesystem>
#include <future>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/content/pattern_list.h"
#include "io/documents/light_field_params.h"
#include "io/documents/session_file.h"
#include "io/files/folders.h"
#include "io/files/system_limits.h"
#include "io/images/degradation.h"
#include "io/images/image_writer.h"
#include "study/time_budget.h"

namespace hogelscope {

namespace {

namespace fs = std::filesystem;
using Band = std::vector<std::uint8_t>;

Band makeBand(const Pattern& pattern, const LightFieldSize& size, int j,
              const Degradation& degradation, const Progress& progress) {
  const std::size_t rowBytes = 3 * size.width();
  Band band(rowBytes * std::size_t(size.dv));
  parallelRows(size.dv, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) {
      throwIfCancelled(progress);
      pattern.row(j * size.dv + v, &band[std::size_t(v) * rowBytes]);
    }
  });
  degrade(degradation, size, j, band, progress);
  return band;
}

void writeBand(ImageRowWriter& writer, const Band& band, std::size_t rowBytes,
               const Progress& progress) {
  for (std::size_t at = 0; at < band.size(); at += rowBytes) {
    throwIfCancelled(progress);
    writer.write(band.data() + at);
  }
}

struct Cost {
  double seconds = 0;
  double bytes = 0;  ///< on disk
};

/// Estimates the cost of the whole light field from a few rows of hogels.
Cost estimateCost(const Pattern& pattern, const LightFieldSize& size,
                  const Degradation& degradation, const fs::path& file, const Progress& progress) {
  const int sampled = std::min(4, size.ny);
  ImageRowWriter writer(file, size.width(), std::size_t(sampled * size.dv));
  double making = 0;
  double writing = 0;
  for (int k = 0; k < sampled; ++k) {
    const Progress ofBand = part(progress, k / double(sampled), (k + 1) / double(sampled));
    double start = steadySeconds();
    const Band band =
        makeBand(pattern, size, (2 * k + 1) * size.ny / (2 * sampled), degradation, ofBand);
    making += steadySeconds() - start;
    start = steadySeconds();
    writeBand(writer, band, 3 * size.width(), ofBand);
    writing += steadySeconds() - start;
  }
  const auto bytes = double(writer.discard());
  const double whole = double(size.ny) / sampled;
  return {whole * std::max(writing, making + writing / threadCount()), whole * bytes};
}

/// Prints the expected time and file size before a long wait. Throws InputError if the disk has too
/// little space.
void announceCost(const Pattern& pattern, const LightFieldSize& size,
                  const Degradation& degradation, const fs::path& file, bool isQuiet) {
  constexpr std::size_t largeBytes = 1000000000;
  if (3 * size.width() * size.height() < largeBytes) return;
  ProgressBar bar("estimating", isQuiet);
  const Cost cost = estimateCost(pattern, size, degradation, file, bar.progress());
  bar.done();
  checkRoomOnDisk(file, std::uint64_t(cost.bytes));
  if (!isQuiet)
    std::cout << size.width() << "×" << size.height() << " px, on the disk about "
              << bytesText(std::size_t(cost.bytes)) << ", " << std::ceil(cost.seconds / 60)
              << " min" << std::endl;
}

void writeBands(const Pattern& pattern, const LightFieldSize& size, const Degradation& degradation,
                const std::string& file, const Progress& progress) {
  ImageRowWriter writer(file, size.width(), size.height());
  Band written;
  std::future<void> writing;
  for (int j = 0; j < size.ny; ++j) {
    const Progress ofBand = part(progress, j / double(size.ny), (j + 1) / double(size.ny));
    Band band = makeBand(pattern, size, j, degradation, ofBand);
    if (writing.valid()) writing.get();
    written = std::move(band);
    writing = std::async([&, ofBand] { writeBand(writer, written, 3 * size.width(), ofBand); });
  }
  writing.get();
  writer.finish();
}

/// Returns the display of a document, whose light field need not exist yet, or of a new session for
/// a folder, an image or a mesh, with its hogel and direction counts; `input` is then that
/// session's.
PanelParams displayToFill(const CommandLine& line, std::optional<Input>& input) {
  if (isSessionDocument(line.text("session")))
    return displayOf(loadSession(line.text("session"), line.texts("set")));
  return input.emplace(loadSessionOf(line)).display();
}

int runGenerate(const CommandLine& line) {
  std::optional<Input> input;
  const PanelParams display = displayToFill(line, input);
  const auto pattern = makePattern(line.subject, display, patternParams(line.jobOverrides));
  Degradation degradation;
  if (line.has("degrade")) degradation = parseDegradation(line.text("degrade"));
  const std::optional<double> seed = line.number("seed");
  if (seed && degradation.kind != Degradation::Kind::noise)
    throw InputError("--seed", "is of the noise; it needs --degrade noise:SIGMA");
  if (seed) degradation.seed = std::uint64_t(*seed);
  const std::string output = line.text("output");
  checkOutputs({output});
  makeFolderOf(output);
  const LightFieldSize size{display.hogels[0], display.hogels[1], display.directions[0],
                            display.directions[1]};
  const bool isQuiet = line.has("quiet");
  announceCost(*pattern, size, degradation, output, isQuiet);
  ProgressBar bar("generating", isQuiet);
  writeBands(*pattern, size, degradation, output, bar.progress());
  bar.done();
  if (!isQuiet)
    std::cout << printable(output) << ": " << size.width() << "×" << size.height() << " px\n";
  return 0;
}

/// Returns a list such as "scene, spheres.", optionally with the content of each.
std::string patternList(bool isExplained) {
  std::string text;
  for (const auto& [name, help, make] : patterns()) {
    if (!text.empty()) text += isExplained ? "; " : ", ";
    text += name;
    if (isExplained) text.append(" (").append(help).append(")");
  }
  return text + ".";
}

}  // namespace

Job generateJob() {
  return {
      .name = "generate",
      .value = "PATTERN",
      .help =
          "Writes a test light field of the session's display, of any size: " + patternList(false),
      .details = "PATTERN is one of: " + patternList(true),
      .examples =
          "  hogelscope --generate scene --session s.json --output scene.png\n"
          "  hogelscope --generate scene --session s.json --output noisy.png --degrade noise:2\n"
          "  hogelscope --generate directions --session views --output directions.png\n"
          "  hogelscope --generate edge --session s.json --output edge.png --set "
          "pattern.depth=0.2 \\\n"
          "             --set display.hogels=[256,256]\n",
      .sections = {"pattern"},
      .needs = {"session", "output"},
      .takes = {"set", "plugins-path", "seed", "threads", "quiet"},
      .own = {{.name = "degrade",
               .value = "HOW",
               .after = "seed",
               .help =
                   "Makes a worse copy: jpeg:QUALITY, noise:SIGMA in code values, or blur:SIGMA "
                   "in directional pixels."}},
      .run = runGenerate};
}

}  // namespace hogelscope
