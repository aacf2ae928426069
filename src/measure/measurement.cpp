// SPDX-License-Identifier: BSD-3-Clause
// The list of figures, and of all measurements of a display.
#include "measure/measurement.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hogelscope {

namespace {

using enum SweptWith;

// The procedures are in data_sheet, viewing_space, photometry, lens_sheet_figures and gratings.
constexpr std::array rows{
    FigureRow{"hogelPitch", "m", true, bench},
    FigureRow{"slopeStep", "", false, bench},
    FigureRow{"degreesPerDirection", "°", true, bench},
    FigureRow{"directionsPerPupil", "", false, bench},
    FigureRow{"megapixels", "Mpx", false, bench, "Pixels", 8, true},
    FigureRow{"viewsPerMetre", "1/m", true},
    FigureRow{"viewingCone", "°", true},
    FigureRow{"flip", "m", true},
    FigureRow{"pseudoscopic", "", true},
    FigureRow{"lobe", "views", true},
    FigureRow{"viewingZone", "m", true, bench, "Viewing zone's width", 4},
    FigureRow{"qualifiedViewingSpace", "m", false, bench},
    FigureRow{"crosstalk", "", true, bench, "Crosstalk of two eyes", 5, true},
    FigureRow{"crosstalkMatrix"},
    FigureRow{"angularProfile", "°", true, bench},
    FigureRow{"angularResolution", "°", false, bench, "Angular resolution", 6, true},
    FigureRow{"uniformity", "", false, bench},
    FigureRow{"contrast", "", false, bench},
    FigureRow{"spatialResolution", "1/mm", false, bench, "Detail on the panel", 7},
    FigureRow{"mtf"},
    FigureRow{"depthOfField", "m", true, bench},
    FigureRow{"depthOfField50", "m", false, bench, "Depth at contrast 0.5", 1},
    FigureRow{"depthOfField10", "m", false, bench, "Depth at contrast 0.1", 2},
    FigureRow{"depthFront", "m", true, bench, "Sharp in front", 3},
    FigureRow{"depthBehind", "m", true, bench},
    FigureRow{"viewsFront", "m", true},
    FigureRow{"viewsBehind", "m", true},
    FigureRow{"parallaxStep", "m", true, bench},
    FigureRow{"throughFocus"},
    FigureRow{"diffraction", "", false, bench},
    FigureRow{"psnr:ideal", "dB", false, views, "PSNR to the ideal view", 9},
    FigureRow{"psnr:design", "dB", false, views, "PSNR to the design", 10},
    FigureRow{"milliseconds", "ms", false, clock}};

}  // namespace

std::span<const FigureRow> figureRows() {
  return rows;
}

const FigureRow& figureRow(std::string_view name) {
  static constexpr FigureRow other{};
  const auto row = std::ranges::find(rows, name, &FigureRow::name);
  return row == rows.end() ? other : *row;
}

std::vector<Measurement> allMeasurements(const Bench& bench, double ipd, double pupil) {
  std::vector<Measurement> all;
  if (bench.sheet() != nullptr) {
    addLensSheet(bench, ipd, all);
  } else {
    addDataSheet(bench, pupil, all);
    addViewingSpace(bench, ipd, all);
    addPhotometry(bench, all);
  }
  addGratings(bench, pupil, all);
  return all;
}

std::vector<std::string> keepThoseOfUnit(std::vector<Measurement>& all, const TwinParams& twin) {
  std::vector<std::pair<std::string, std::string>> left;  // figures, for each reason
  std::string before;
  std::erase_if(all, [&](const Measurement& one) {
    const std::string why = whyNotOfUnit(one.figure, twin);
    if (!why.empty() && one.figure != before) {
      auto same = std::ranges::find(left, why, &std::pair<std::string, std::string>::first);
      if (same == left.end()) same = left.insert(same, {why, ""});
      same->second += (same->second.empty() ? "" : ", ") + one.figure;
    }
    before = one.figure;
    return !why.empty();
  });
  std::vector<std::string> lines;
  for (const auto& [why, figures] : left) lines.push_back("since " + why + ": " + figures);
  return lines;
}

}  // namespace hogelscope
