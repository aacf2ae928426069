// SPDX-License-Identifier: BSD-3-Clause
// vtkSMPTools behind plain functions, since its header needs C++17.
#pragma once

#include <functional>

namespace hogelscope
{

/// Calls `rows(begin, end)` over [0, count) from several threads. What it throws stops the others
/// before their next piece, and is thrown here.
void parallelRows(int count, const std::function<void(int, int)>& rows);

/// How many threads work.
int threadCount();

/// How many threads work from now on, in the whole process; 0 = all.
void setThreads(int count);

} // namespace hogelscope
