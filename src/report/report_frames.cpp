// SPDX-License-Identifier: BSD-3-Clause
#include "report/report_frames.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/cameras/frame_states.h"

namespace hogelscope {

void takeFrames(ReportRequest& request, const std::optional<FrameNumbers>& chosen) {
  const FrameNumbers listed = request.file->frames();
  if (listed.isStill()) return;
  std::vector<FrameState> views =
      statesAtFrames(request.session.cameras, chosen.value_or(listed), listed,
                     frameRateOf(request.session.lightField, *request.file));
  request.session.cameras.clear();
  for (FrameState& view : views) {
    for (const ReportTest& test : request.tests) (void)frameOfTest(*request.file, test, view.frame);
    request.session.cameras.push_back(std::move(view.state));
    request.frames.push_back(view.frame);
  }
}

std::vector<FrameViews> framesOf(const ReportRequest& request) {
  const std::size_t views = request.session.cameras.size();
  if (request.frames.empty()) return {{request.file->frames().first, 0, views}};
  std::vector<FrameViews> frames;
  for (std::size_t k = 0; k < views; ++k) {
    if (frames.empty() || frames.back().frame != request.frames[k])
      frames.push_back({request.frames[k], k, k});
    frames.back().end = k + 1;
  }
  return frames;
}

std::vector<std::optional<std::size_t>> viewsBefore(const ReportRequest& request) {
  std::map<std::string, std::size_t> last;
  std::vector<std::optional<std::size_t>> before(request.session.cameras.size());
  for (std::size_t k = 0; k < request.frames.size(); ++k) {
    const std::string& state = request.session.cameras[k].camera.name;
    if (const auto at = last.find(state); at != last.end()) before[k] = at->second;
    last[state] = k;
  }
  return before;
}

ShardOfViews::ShardOfViews(const ReportRequest& request)
    : m_shard(request.shard), m_views(request.session.cameras.size()) {
  for (std::size_t k = 0; k < request.frames.size(); ++k)
    m_frames.push_back(k == 0 ? 0 : m_frames.back() + (request.frames[k] != request.frames[k - 1]));
}

bool ShardOfViews::has(std::size_t view) const {
  if (!m_shard) return true;
  if (m_frames.empty()) return m_shard->has(view);
  return m_frames[view] * m_shard->count / (m_frames.back() + 1) == m_shard->number - 1;
}

std::size_t ShardOfViews::count() const {
  std::size_t count = 0;
  for (std::size_t view = 0; view < m_views; ++view) count += has(view) ? 1 : 0;
  return count;
}

int frameOfTest(const LightFieldFile& own, const ReportTest& test, int frame) {
  const FrameNumbers ours = own.frames(), others = test.file->frames();
  if (const auto same = sameFrame(ours, frame, others)) return *same;
  const auto text = [](const FrameNumbers& frames) {
    return std::to_string(frames.count()) + ", " + std::to_string(frames.first) + " … " +
           std::to_string(frames.last);
  };
  throw InputError(test.name, "frames",
                   "are " + text(others) + ", but those of the session's light field are " +
                       text(ours) + ": list the same with lightField.frames");
}

}  // namespace hogelscope
