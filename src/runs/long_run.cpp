// SPDX-License-Identifier: BSD-3-Clause
#include "runs/long_run.h"

#include <limits>

#include "core/base/parallel.h"
#include "io/files/atomic_file.h"

namespace hogelscope {

LongRun longRun(const LongRunRequest& request, int workers,
                const std::function<std::vector<double>(std::size_t item, std::size_t worker,
                                                        const Progress& progress)>& work,
                const Progress& progress) {
  LongRun result;
  result.rows.resize(request.items);
  if (!request.folder.empty()) {
    makeFolder(request.folder);
    result.journal = std::make_shared<RunRows>(
        request.folder, JournalHead{request.key, request.items, 1}, request.shard, request.values);
    result.replacedAnother = result.journal->replacedAnother();
    for (const auto& [item, entry] : result.journal->taken()) result.rows[item] = entry;
    result.taken = result.journal->taken().size();
  }
  std::vector<std::size_t> missing;
  for (std::size_t item = 0; item < request.items; ++item)
    if (result.rows[item].values.empty() && (!request.shard || request.shard->has(item)))
      missing.push_back(item);
  StepProgress steps(progress);
  steps.expect(double(missing.size()));
  sideBySide(missing.size(), workers, [&](std::size_t k, std::size_t worker) {
    JournalEntry entry;
    try {
      entry.values = work(missing[k], worker, steps.within());
    } catch (const InputError& error) {
      entry.problem = error.what();
      entry.values.assign(request.values, std::numeric_limits<double>::quiet_NaN());
    }
    if (result.journal) result.journal->add(missing[k], entry, [] {});
    result.rows[missing[k]] = std::move(entry);
    steps.finish();
  });
  return result;
}

}  // namespace hogelscope
