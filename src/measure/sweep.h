// SPDX-License-Identifier: BSD-3-Clause
// --sweep: figures of many designs of a display.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/shard.h"
#include "core/metrics/statistics.h"
#include "core/optics/session.h"
#include "measure/sweep_solve.h"
#include "measure/sweep_table.h"
#include "page/figure.h"

namespace hogelscope {

struct SweepRequest {
  std::string name;  ///< of the session, for the page
  Session session;
  SweepTable table;
  std::filesystem::path output;  ///< "": nothing is written
  std::optional<Shard> shard;
};

/// A design's figures.
struct SweepRow {
  Design design;
  std::vector<double> figures;  ///< in the table's order; NaN if it cannot be measured
  bool isPareto = false;
  std::string problem;
  bool passes = false;  ///< within all limits of the table
  /// Of "solve": the largest value with which the unit passes; infinite if it does at the largest
  /// one, NaN if it does not at the least one.
  double limit = 0;
};

/// The share of units that pass.
struct SweepYield {
  std::size_t passed = 0;
  std::size_t count = 0;
  Interval interval;  ///< of the share, 95 %
};

struct Sweep {
  SweepTable table;  ///< of the rows; with "solve", at the value that was found
  std::vector<SweepRow> rows;
  std::size_t taken = 0;
  bool replacedAnother = false;
  std::optional<SolvedValue> solved{};  ///< with "solve"
  std::string solvedText{};             ///< the sentence of solveText()
};

/// Throws InputError unless all figures of the table are known: those of --measure that have one
/// value, "mtf:Z" (contrast of a grating of the frequency 1/(2p), p the hogel pitch, on the plane Z
/// in metres), "psnr:ideal", "psnr:design" (dB of the mean squared error over all states, of the
/// pixels seen, against the ideal views or the session's own) and "milliseconds" of the first
/// state's view.
void checkFigures(const SweepTable& table, const Session& session);

/// Returns all files that the figures depend on, with those that designs alone name. Throws
/// Cancelled.
std::vector<std::filesystem::path> inputsOf(const SweepRequest& request, const Progress& progress);

/// Measures all designs, and writes sweep.csv, sweep.html and plots; for a shard only its part.
/// With "solve" it finds the limit of each unit by bisection, to a thousandth, then measures all
/// units at the value that was found, and writes sweep.json too.
/// After a stop the same request goes on where it was. Throws InputError, Cancelled.
Sweep sweep(const SweepRequest& request, const Progress& progress);

/// Measures figures of designs that are whole sessions, one at least, as rows without `design`.
/// "psnr:design" is against `base`. Throws InputError for lens sheets, Cancelled.
std::vector<SweepRow> measureDesigns(const std::vector<Session>& designs, const Session& base,
                                     const std::vector<std::string>& figures,
                                     const Progress& progress);

/// Marks the rows that no other one beats: none is at least as good in all goals and better in one.
void markPareto(const SweepTable& table, std::vector<SweepRow>& rows);

/// Marks the rows that are within all limits; a figure that is not known is not.
void markPassing(const SweepTable& table, std::vector<SweepRow>& rows);
SweepYield yieldOf(const std::vector<SweepRow>& rows);
/// Returns a sentence such as "37 of 100 units pass (psnr:design at least 30): yield 37 % (28.2 …
/// 46.8 %)"; "" for a table without limits. Designs that were not drawn have no yield.
std::string yieldText(const SweepTable& table, const std::vector<SweepRow>& rows);

/// Returns a sentence that names the parameters that change no figure but the time, or no goal of
/// the Pareto front, as designs that differ in nothing else show; "" if there are none.
std::string effectText(const SweepTable& table, const std::vector<SweepRow>& rows);

/// Returns "sweep.csv".
std::string csv(const SweepTable& table, const std::vector<SweepRow>& rows);

/// Returns "sweep.html", and its plots. `solved` is the sentence of solveText().
std::string sweepPage(const SweepRequest& request, const std::vector<SweepRow>& rows,
                      const std::string& solved = {});
std::vector<Figure> sweepPlots(const SweepTable& table, const std::vector<SweepRow>& rows);

}  // namespace hogelscope
