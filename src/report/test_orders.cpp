// SPDX-License-Identifier: BSD-3-Clause
#include "report/test_orders.h"

#include "io/opening/matched_order.h"
#include "io/scene/numbered_frames.h"

namespace hogelscope {

namespace {

bool isSameOrder(const LightFieldParams& a, const LightFieldParams& b) {
  return a.scan == b.scan && a.rows == b.rows && a.columns == b.columns && a.pattern == b.pattern;
}

}  // namespace

void orderTests(ReportRequest& request, const Progress& progress) {
  const Session& session = request.session;
  if (request.file && request.file->files().empty()) return;
  OrderMatcher matcher(firstStillOf(session.lightField), session.display);
  double done = 0;
  for (ReportTest& test : request.tests) {
    const auto count = double(request.tests.size());
    const Progress own = part(progress, done / count, (done + 1) / count);
    ++done;
    LightFieldParams& lightField = test.session.lightField;
    // Of a twin or another display the light field is the same; arrays have no files.
    if (lightField.file == session.lightField.file || test.file->files().empty()) continue;
    const auto found = matcher.match(firstStillOf(lightField), test.session.display, own);
    if (!found) continue;
    const std::string order = orderText(lightField, *found);
    const bool isGiven = !isSameOrder(lightField, session.lightField) &&
                         !isSameOrder(lightField, LightFieldParams());
    if (isGiven) {
      test.order = "its views are those of the reference only with " + order +
                   ", which its session does not say";
      continue;
    }
    lightField.scan = found->scan;
    lightField.rows = found->rows;
    lightField.columns = found->columns;
    test.file = openLightField(lightField, test.session.display);
    test.order =
        "its views are read with " + order + ", because these are the views of the reference";
  }
}

}  // namespace hogelscope
