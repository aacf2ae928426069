// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/frame_stream.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "gui/widgets/task.h"
#include "io/scene/view_source.h"

namespace hogelscope {

FrameStream::FrameStream(QObject* parent) : QObject(parent) {
  m_thread.start([this] { return m_toOpen || m_toOpenOther || m_toShow || m_ahead; },
                 [this](LatestWins::Lock& lock) { serve(lock); });
}

void FrameStream::open(const Session& session) {
  m_thread.ask([&] {
    m_toOpen.emplace(session);
    m_toShow.reset();
    m_ahead.reset();
    ++m_asked;
  });
}

void FrameStream::close() {
  m_thread.ask([this] {
    m_toOpen.emplace(std::nullopt);
    m_toOpenOther.emplace(std::nullopt);
    m_toShow.reset();
    m_ahead.reset();
    ++m_asked;
  });
}

void FrameStream::openOther(const std::optional<Session>& session) {
  m_thread.ask([&] { m_toOpenOther.emplace(session); });
}

void FrameStream::show(int frame) {
  m_thread.ask([&] { m_toShow = frame; });
}

template <class Signal>
void FrameStream::send(Signal signal) {
  queueAnswer(this, m_asked, m_number, signal);
}

void FrameStream::serve(LatestWins::Lock& lock) {
  const auto toOpen = std::exchange(m_toOpen, std::nullopt);
  const auto toOpenOther = std::exchange(m_toOpenOther, std::nullopt);
  const auto toShow = std::exchange(m_toShow, std::nullopt);
  const auto ahead = std::exchange(m_ahead, std::nullopt);
  m_number = m_asked;
  lock.unlock();
  try {
    if (toOpen) {
      m_own = {};
      if (*toOpen) openNow(**toOpen);
    }
    if (toOpenOther) openOtherNow(*toOpenOther);
    if (m_own.file && toShow)
      readNow(*toShow, false);
    else if (m_own.file && ahead)
      readNow(*ahead, true);
  } catch (const Cancelled&) {
    // a newer light field waits
  } catch (const std::exception& error) {
    send([this, line = QString::fromUtf8(error.what())] { Q_EMIT failed(line); });
  }
}

FrameStream::Light::Light(const Session& session) : isLive(session.lightField.isLive()) {
  try {
    file = openLightField(session.lightField, session.display);
  } catch (const InputError&) {
    return;  // said by whoever reads the light field
  }
  if (file->frames().isStill()) file.reset();
}

void FrameStream::openNow(const Session& session) {
  m_own = Light(session);
  setMostKept();
  if (!m_own.file) return;
  const double rate = frameRateOf(session.lightField, *m_own.file);
  send([this, frames = m_own.file->frames(), rate] { Q_EMIT opened(frames, rate); });
}

void FrameStream::openOtherNow(const std::optional<Session>& session) {
  m_other = session ? Light(*session) : Light();
  setMostKept();
  if (m_other.file) send([this] { Q_EMIT otherOpened(); });
}

/// Both together take at most half of the allowed memory, but two frames. Those of an animation are
/// computed, so that no more are kept.
void FrameStream::setMostKept() {
  double bytes = 0;
  for (Light* const light : {&m_own, &m_other}) {
    light->kept.clear();
    if (!light->file) continue;
    bytes += light->isLive ? double(allowedMemory())
                           : double(LightField::bytes(light->file->size(), light->file->type()));
  }
  m_mostKept = bytes > 0 ? std::size_t(std::max(2.0, double(allowedMemory()) / 2 / bytes)) : 1;
}

/// Returns a frame. Makes room by the one that is shown again last when it plays on.
FrameStream::Source FrameStream::frameOf(Light& light, int frame) {
  if (const auto at = light.kept.find(frame); at != light.kept.end()) return at->second;
  const auto isStopped = [this] {
    return m_thread.mustStop([this] { return m_toOpen.has_value(); });
  };
  light.file->select(frame);
  Source source = light.file->source({.memory = allowedMemory() / 2, .threads = threadCount()},
                                     [&](double) { return !isStopped(); });
  const FrameNumbers frames = light.file->frames();
  const auto distance = [&](int other) {
    const int ahead = (other - frame) / frames.step;
    return ahead < 0 ? ahead + int(frames.count()) : ahead;
  };
  if (light.kept.size() >= m_mostKept)
    light.kept.erase(std::ranges::max_element(
        light.kept, {}, [&](const auto& kept) { return distance(kept.first); }));
  light.kept[frame] = source;
  return source;
}

void FrameStream::readNow(int frame, bool isAhead) {
  if (!isAhead) m_last = frame;
  const Source own = frameOf(m_own, frame);
  Source other;
  if (m_other.file)
    if (const auto same = sameFrame(m_own.file->frames(), frame, m_other.file->frames()))
      other = frameOf(m_other, *same);
  if (!isAhead) send([this, frame, own, other] { Q_EMIT read(frame, own, other); });
  m_thread.ask([this] { m_ahead = nextFrame(); });
}

/// Returns the first of the next frames that is not there, if there is room for it.
std::optional<int> FrameStream::nextFrame() const {
  const FrameNumbers frames = m_own.file->frames();
  const std::size_t most = std::min(m_mostKept, frames.count());
  int frame = m_last;
  for (std::size_t k = 1; k < most; ++k) {
    frame = frame + frames.step > frames.last ? frames.first : frame + frames.step;
    if (!m_own.kept.contains(frame)) return frame;
  }
  return std::nullopt;
}

}  // namespace hogelscope
