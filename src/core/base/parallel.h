// SPDX-License-Identifier: BSD-3-Clause
// Parallel execution on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace hogelscope {

/// Runs `rows(begin, end)` over [0, count), possibly on several threads. An exception stops the
/// other threads before their next piece and is rethrown on the calling thread.
using ParallelRows =
    std::function<void(int count, const std::function<void(int begin, int end)>& rows)>;
/// Implements ParallelRows on the calling thread.
void serialRows(int count, const std::function<void(int begin, int end)>& rows);
/// Implements ParallelRows on threadCount() threads, for pieces of microseconds to milliseconds.
void parallelRows(int count, const std::function<void(int begin, int end)>& rows);

/// Returns the number of threads that parallelRows() uses in this process.
int threadCount();
/// Sets that number. 0 means one for each core, which is also the maximum.
void setThreads(int count);

/// Calls `work(k, worker)` for every k below `count`, in order, on `workers` threads numbered from
/// 0, for pieces that read files or take long. An exception stops the other threads before their
/// next piece and is rethrown on the calling thread.
void sideBySide(std::size_t count, int workers,
                const std::function<void(std::size_t k, std::size_t worker)>& work);

}  // namespace hogelscope
