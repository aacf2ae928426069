// SPDX-License-Identifier: BSD-3-Clause
// Reads the frames of a light field in their order, the next one while views are made of the last.
#pragma once

#include <atomic>
#include <cstddef>
#include <future>
#include <memory>
#include <vector>

#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// While a reader lives, nothing else reads its file. One thread.
class FrameReader {
 public:
  /// Reads ahead if two frames fit into `use.memory` bytes.
  FrameReader(LightFieldFile& file, std::vector<int> frames, const SourceUse& use);
  /// Waits until reading has stopped.
  ~FrameReader();
  FrameReader(const FrameReader&) = delete;
  FrameReader& operator=(const FrameReader&) = delete;

  /// Returns the next frame. Throws InputError, Cancelled.
  std::shared_ptr<const LightFieldSource> next(const Progress& progress);

 private:
  void readAhead();

  LightFieldFile& m_file;
  std::vector<int> m_frames;
  SourceUse m_use;
  bool m_readsAhead;
  std::size_t m_next = 0;
  std::atomic<bool> m_stops = false;
  std::atomic<double> m_done = 0;  ///< of the frame that is read ahead
  std::future<std::shared_ptr<const LightFieldSource>> m_ahead;
};

}  // namespace hogelscope
