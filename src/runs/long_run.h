// SPDX-License-Identifier: BSD-3-Clause
// A long run over items, each of which gives a row of numbers: rows outlive a stop, and several
// processes share them.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "runs/journal.h"

namespace hogelscope {

struct LongRunRequest {
  std::filesystem::path folder;  ///< made if missing; "": no row outlives the process
  std::string key;               ///< unique to the run: another one's journal is replaced
  std::size_t items = 0;
  std::size_t values = 0;  ///< numbers of each row
  std::optional<Shard> shard;
};

struct LongRun {
  std::vector<JournalEntry> rows;  ///< of all items; empty values for those of other shards
  std::size_t taken = 0;           ///< rows of earlier runs
  bool replacedAnother = false;    ///< another run's journal, in the same folder
  std::shared_ptr<RunRows>
      journal;  ///< to be removed once the results have been written; may be null
};

/// Computes the rows that are missing, on `workers` threads numbered from 0. An InputError of
/// `work` becomes the row's problem, with NaN as values. Throws InputError (the folder cannot be
/// written, or another process uses it), Cancelled; finished rows are then kept for the next run.
LongRun longRun(const LongRunRequest& request, int workers,
                const std::function<std::vector<double>(std::size_t item, std::size_t worker,
                                                        const Progress& progress)>& work,
                const Progress& progress);

}  // namespace hogelscope
