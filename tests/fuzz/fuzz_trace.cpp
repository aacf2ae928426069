// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes viewers' traces: time rises.
#include "io/documents/trace_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  mayRefuse([&] {
    const Trace trace = readTrace(input, 0.5);
    require(trace.points.size() > 1);
    for (std::size_t k = 1; k < trace.points.size(); ++k)
      require(trace.points[k].time > trace.points[k - 1].time && trace.points[k].eye.z > 0);
  });
}
