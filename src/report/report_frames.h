// SPDX-License-Identifier: BSD-3-Clause
// The frames of a report: a state at a frame is a view of its own, so that rows, journals and
// shards know nothing of time. Views of one frame follow each other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/report_request.h"

namespace hogelscope {

/// Puts the states at their frames in place of the states, if the light field has several: those
/// without a time at each of the frames `chosen`, by default all. Throws InputError: a time without
/// a frame rate, or a test that has other frames.
void takeFrames(ReportRequest& request, const std::optional<FrameNumbers>& chosen);

/// The views [begin, end) of one frame.
struct FrameViews {
  int frame = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
  bool operator==(const FrameViews&) const = default;
};
/// Returns the frames of a request; a still has one.
std::vector<FrameViews> framesOf(const ReportRequest& request);

/// Returns for each view the one of the same state at the frame before; none at the first one.
std::vector<std::optional<std::size_t>> viewsBefore(const ReportRequest& request);

/// Whether a view belongs to the request's shard: every n-th state of a still, or whole frames that
/// follow each other.
class ShardOfViews {
 public:
  explicit ShardOfViews(const ReportRequest& request);
  [[nodiscard]] bool has(std::size_t view) const;
  /// Returns how many views it has.
  [[nodiscard]] std::size_t count() const;

 private:
  std::optional<Shard> m_shard;
  std::size_t m_views;
  std::vector<std::size_t> m_frames;  ///< the number of each view's frame; empty for a still
};

/// Returns the test's frame that is compared with a frame of the session's light field
/// (sameFrame()). Throws InputError that names the test.
int frameOfTest(const LightFieldFile& own, const ReportTest& test, int frame);

}  // namespace hogelscope
