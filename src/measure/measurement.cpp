// SPDX-License-Identifier: BSD-3-Clause
#include "measure/measurement.h"

namespace hogelscope {

std::vector<Measurement> allMeasurements(const Bench& bench, double ipd, double pupil) {
  std::vector<Measurement> all;
  if (bench.sheet() != nullptr) {
    addLensSheet(bench, ipd, all);
  } else {
    addDataSheet(bench, pupil, all);
    addViewingSpace(bench, ipd, all);
    addPhotometry(bench, all);
  }
  addGratings(bench, pupil, all);
  return all;
}

}  // namespace hogelscope
