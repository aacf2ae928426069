// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes viewers' traces: time does not fall, with the usual columns and with named ones.
#include "io/documents/trace_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

namespace {

void read(std::string_view input, const TraceParams& params) {
  mayRefuse([&] {
    const Trace trace = readTrace(input, 0.5, params);
    require(trace.points.size() > 1 && trace.points.back().time > 0);
    for (std::size_t k = 1; k < trace.points.size(); ++k)
      require(trace.points[k].time >= trace.points[k - 1].time && trace.points[k].eye.z > 0);
  });
}

}  // namespace

void fuzz(std::string_view input) {
  read(input, {});
  TraceParams named;
  named.time = "Timestamp";
  named.recording = "Stimulus";
  named.timeUnit = 0.001;
  named.origin = {4, 4, 0};
  read(input, named);
}
