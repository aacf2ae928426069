// SPDX-License-Identifier: BSD-3-Clause
// vtkSMPTools behind a plain function; the only C++17 file.
#include "parallel_rows.h"

#include <vtkSMPTools.h>

namespace hogelscope
{

void parallelRows(int count, const std::function<void(int, int)>& rows)
{
  constexpr vtkIdType grain = 4;
  vtkSMPTools::For(0, count, grain,
    [&rows](vtkIdType begin, vtkIdType end)
    { rows(static_cast<int>(begin), static_cast<int>(end)); });
}

void setThreads(int count)
{
  vtkSMPTools::Initialize(count);
}

} // namespace hogelscope
