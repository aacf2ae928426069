// SPDX-License-Identifier: BSD-3-Clause
// The order of the tests' views, where their pictures contradict it.
#pragma once

#include "report/report_request.h"

namespace hogelscope {

/// Compares the views of each test with the reference's, and takes the order in which they are the
/// same views, if that is another one: the frames of a video that run to and fro, for example. A
/// test whose document gives another order than the session keeps it. Each test's `order` tells
/// what was done; warningsOf() has these sentences. Throws InputError, Cancelled.
void orderTests(ReportRequest& request, const Progress& progress);

}  // namespace hogelscope
