// SPDX-License-Identifier: BSD-3-Clause
// Invented rows of a trade-off, like those of a session of a megapixel.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "study/tradeoff.h"

struct SampleRow {
  const char* method;
  double milliseconds;
  double rmse;
};

inline std::vector<hogelscope::TradeoffRow> rowsOf(const std::vector<SampleRow>& samples) {
  std::vector<hogelscope::TradeoffRow> rows;
  for (const SampleRow& sample : samples) {
    hogelscope::TradeoffRow row;
    row.method = sample.method;
    const auto has = [&row](const char* part) { return row.method.find(part) != row.method.npos; };
    const bool isLens = has("direct") || has("fixed") || has("Newton") || has("table");
    row.lens = isLens ? row.method : "exact";
    row.reconstruction = has("linear") ? "bilinear" : "nearest";
    row.psf = has("PSF") ? "off" : "full";
    row.samples = has("×") ? 2 : 1;
    row.scale = has("size") ? 2 : 1;
    row.precision = has("float") ? "float" : "double";
    setTimes(row, {sample.milliseconds});
    row.rmse = sample.rmse;
    row.psnr = sample.rmse > 0 ? 20 * std::log10(255 / sample.rmse)
                               : std::numeric_limits<double>::infinity();
    rows.push_back(row);
  }
  markPareto(rows);
  return rows;
}

/// Returns rows of which the first is the default.
inline std::vector<hogelscope::TradeoffRow> sampleRows() {
  std::vector<hogelscope::TradeoffRow> rows = rowsOf({{"exact", 24.1, 0},
                                                      {"exact, float", 21.0, 0.0021},
                                                      {"direct", 19.2, 9.4},
                                                      {"fixed point 1", 20.3, 4.1},
                                                      {"fixed point 2", 21.1, 1.9},
                                                      {"fixed point 5", 24.6, 0.31},
                                                      {"fixed point 20", 38.0, 0},
                                                      {"Newton 5", 25.0, 0},
                                                      {"table 4 px", 19.8, 0.004},
                                                      {"table 8 px", 19.5, 0.012},
                                                      {"table 16 px", 19.3, 0.09},
                                                      {"PSF truncated", 9.8, 0.22},
                                                      {"PSF off", 1.9, 6.1},
                                                      {"PSF off, float", 1.5, 6.1},
                                                      {"bilinear", 33.0, 3.9},
                                                      {"quadrilinear", 61.0, 4.3},
                                                      {"nearest 2×2", 80.0, 2.8},
                                                      {"nearest 4×4", 180.0, 2.9},
                                                      {"nearest 8×8", 390.0, 3.0},
                                                      {"quadrilinear 2×2", 130.0, 4.6},
                                                      {"quadrilinear 4×4", 240.0, 4.7},
                                                      {"quadrilinear 8×8", 400.0, 4.75},
                                                      {"half size", 6.4, 7.9},
                                                      {"quarter size", 1.7, 13.0},
                                                      {"half size, PSF truncated", 3.1, 8.0},
                                                      {"half size, PSF off", 0.95, 11.0},
                                                      {"quarter size, PSF off", 0.55, 19.0},
                                                      {"half size, PSF off, float", 0.9, 11.0},
                                                      {"quarter size, PSF off, float", 0.5, 25.0}});
  rows.front().isDefault = true;
  return rows;
}

/// Returns rows of a fast scene without visible approximations: most methods equal the reference.
inline std::vector<hogelscope::TradeoffRow> agreeingRows() {
  std::vector<hogelscope::TradeoffRow> rows = sampleRows();
  for (hogelscope::TradeoffRow& row : rows) {
    if (row.rmse < 3.5) row.rmse = 0;
    setTimes(row, {0.2 * (row.rmse == 0 ? std::pow(row.milliseconds, 0.7) : row.milliseconds)});
  }
  markPareto(rows);
  return rows;
}
