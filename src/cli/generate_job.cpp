// SPDX-License-Identifier: BSD-3-Clause
// --generate: one row of hogels is made while the last one is written.
#include "cli/generate_job.h"

#include <filesystem>
#include <future>
#include <iostream>

#include "cli/inputs.h"
#include "cli/progress_bar.h"
#include "core/pattern.h"
#include "io/atomic_file.h"
#include "io/degradation.h"
#include "io/image_file.h"
#include "io/pattern_params.h"
#include "io/session_file.h"
#include "vtk/parallel_rows.h"

namespace hogelscope {

namespace {

using Band = std::vector<std::uint8_t>;

Band bandOf(const Pattern& pattern, const LightFieldSize& size, int j,
            const Degradation& degradation) {
  const std::size_t rowBytes = 3 * size.width();
  Band band(rowBytes * std::size_t(size.dv));
  parallelRows(size.dv, [&](int begin, int end) {
    for (int v = begin; v < end; ++v)
      pattern.row(j * size.dv + v, &band[std::size_t(v) * rowBytes]);
  });
  degrade(degradation, size, j, band);
  return band;
}

void writeBand(ImageRowWriter& writer, const Band& band, std::size_t rowBytes) {
  for (std::size_t at = 0; at < band.size(); at += rowBytes)
    writer.write({band.data() + at, rowBytes});
}

void writeAll(const Pattern& pattern, const LightFieldSize& size, const Degradation& degradation,
              const std::string& file, const Progress& progress) {
  ImageRowWriter writer(file, size.width(), size.height());
  Band written;
  std::future<void> writing;
  for (int j = 0; j < size.ny; ++j) {
    advance(progress, j / double(size.ny));
    Band band = bandOf(pattern, size, j, degradation);
    if (writing.valid()) writing.get();
    written = std::move(band);
    writing = std::async(std::launch::async, [&] { writeBand(writer, written, 3 * size.width()); });
  }
  writing.get();
  writer.finish();
}

}  // namespace

int generateJob(const Options& options) {
  std::vector<std::string> ofSession;
  std::vector<std::string> ofPattern;
  for (const std::string& text : options.overrides)
    (isOfPattern(text) ? ofPattern : ofSession).push_back(text);
  const Session session = loadSession(options.session, ofSession);
  const DisplayParams& display = session.display;
  const auto pattern = makePattern(options.pattern, display, patternParams(ofPattern));
  Degradation degradation;
  if (!options.degrade.empty()) degradation = parseDegradation(options.degrade);
  if (options.seed) degradation.seed = *options.seed;
  if (const auto folder = std::filesystem::path(options.output).parent_path(); !folder.empty())
    makeFolder(folder);
  const LightFieldSize size{display.hogels[0], display.hogels[1], display.directions[0],
                            display.directions[1]};
  ProgressBar bar("generating", options.quiet);
  writeAll(*pattern, size, degradation, options.output, bar.progress());
  bar.done();
  if (!options.quiet)
    std::cout << options.output << ": " << size.width() << "×" << size.height() << " px\n";
  return 0;
}

}  // namespace hogelscope
