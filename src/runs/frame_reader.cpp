// SPDX-License-Identifier: BSD-3-Clause
#include "runs/frame_reader.h"

#include <chrono>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace hogelscope {

FrameReader::FrameReader(LightFieldFile& file, std::vector<int> frames, const SourceUse& use)
    : m_file(file),
      m_frames(std::move(frames)),
      m_use(use),
      m_readsAhead(m_frames.size() > 1 && fitsInMemory(file, use.memory / 2)) {}

FrameReader::~FrameReader() {
  m_stops = true;
  if (m_ahead.valid()) m_ahead.wait();
}

std::shared_ptr<const LightFieldSource> FrameReader::next(const Progress& progress) {
  if (m_next == m_frames.size()) throw std::logic_error("FrameReader: there are no more frames");
  std::shared_ptr<const LightFieldSource> frame;
  if (m_ahead.valid()) {
    constexpr std::chrono::milliseconds often(20);
    while (m_ahead.wait_for(often) == std::future_status::timeout) reportProgress(progress, m_done);
    frame = m_ahead.get();
  } else {
    m_file.select(m_frames[m_next]);
    frame = m_file.source(m_use, progress);
  }
  ++m_next;
  if (m_readsAhead && m_next < m_frames.size()) readAhead();
  return frame;
}

void FrameReader::readAhead() {
  m_done = 0;
  try {
    m_ahead = std::async(std::launch::async, [this, frame = m_frames[m_next]] {
      m_file.select(frame);
      return m_file.source(m_use, [this](double done) {
        m_done = done;
        return !m_stops;
      });
    });
  } catch (const std::system_error&) {
    m_readsAhead = false;  // no thread can be had
  }
}

}  // namespace hogelscope
