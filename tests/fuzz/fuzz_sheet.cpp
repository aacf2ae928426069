// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the calibrations of lens sheets: a session keeps what is read, and every sub-pixel has a
// view.
#include "core/panel/sheet_numbers.h"
#include "io/documents/sheet_file.h"
#include "io/plugins/display_json.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  const std::filesystem::path file = fileOf("json", input);
  const bool isOne = isSheetCalibration(file);
  mayRefuse([&] {
    const SheetCalibration calibration = loadSheetCalibration(file);
    require(isOne);
    SheetCalibration again;
    readParts(writtenParts(calibration), "", again);
    require(again == calibration);
    const SheetDisplay display{.calibration = calibration};
    const LensSheet sheet(display);
    const auto [width, height] = calibration.params.panel;
    for (const int column : {0, width / 2, width - 1})
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const int view = sheet.viewOf(column, height / 3, channel, 48);
        require(view >= 0 && view < 48);
        const auto hit = sheet.meet({0, 0, 0.6}, {0.1, 0.01 * column / width, -0.6}, channel);
        constexpr int beside = 17;  // where all that is farther away is put
        require(!hit || (hit->column >= -beside && hit->column <= width + beside &&
                         hit->row >= -beside && hit->row <= height + beside));
      }
    require(!(sheetNumbers(display, 48, {0, 0, 0.6}).width() < 0));
  });
}
