// SPDX-License-Identifier: BSD-3-Clause
// vtkSMPTools behind a plain function; the only C++17 file.
#include "parallel_rows.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace hogelscope
{

void parallelRows(int count, const std::function<void(int, int)>& rows)
{
  constexpr vtkIdType grain = 4;
  std::atomic<bool> stops = false;
  std::mutex mutex;
  std::exception_ptr thrown;
  vtkSMPTools::For(0, count, grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      if (stops)
      {
        return;
      }
      try
      {
        rows(static_cast<int>(begin), static_cast<int>(end));
      }
      catch (...)
      {
        stops = true;
        const std::lock_guard lock(mutex);
        if (!thrown)
        {
          thrown = std::current_exception();
        }
      }
    });
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
}

int threadCount()
{
  return vtkSMPTools::GetEstimatedNumberOfThreads();
}

void setThreads(int count)
{
  // More threads than cores gain nothing, and TBB complains or ends the process.
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  vtkSMPTools::Initialize(count > 0 ? std::min(count, cores) : cores);
}

} // namespace hogelscope
