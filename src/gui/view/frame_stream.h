// SPDX-License-Identifier: BSD-3-Clause
// Reads frames of a light field in time, and of a second one that it is compared with, on its own
// thread; the newest request wins.
#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <optional>

#include "core/light_field/light_field_source.h"
#include "core/optics/session.h"
#include "gui/widgets/latest_wins.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Frames that were read are kept while they fit into half of the allowed memory, so that a short
/// light field plays from memory; while nothing is asked for, the next frame is read. A reading
/// that has begun is finished: of videos each frame needs the one before it. Emits all signals on
/// the thread that the object lives in.
class FrameStream : public QObject {
  Q_OBJECT

 public:
  explicit FrameStream(QObject* parent);

  /// Opens the session's light field; opened() follows if it has several frames. Nothing of an
  /// older one arrives afterwards.
  void open(const Session& session);
  /// Closes both, and forgets their frames.
  void close();
  /// Opens a second light field, or closes it; otherOpened() follows if it has several frames.
  void openOther(const std::optional<Session>& session);
  /// Asks for a frame; read() follows, unless a newer one is asked for meanwhile.
  void show(int frame);

 Q_SIGNALS:
  /// `rate` is the frames shown in a second; 0 if it is not known.
  void opened(const hogelscope::FrameNumbers& frames, double rate);
  void otherOpened();
  /// `other` is null unless a second light field has that frame.
  void read(int frame, const std::shared_ptr<const hogelscope::LightFieldSource>& source,
            const std::shared_ptr<const hogelscope::LightFieldSource>& other);
  void failed(const QString& line);

 private:
  using Source = std::shared_ptr<const LightFieldSource>;
  template <class Signal>
  void send(Signal signal);
  void serve(LatestWins::Lock& lock);
  /// A light field that is open, and the frames of it that are in memory.
  struct Light {
    std::unique_ptr<LightFieldFile> file;
    std::map<int, Source> kept;
    bool isLive = false;

    /// Opens a session's light field if it has several frames.
    Light() = default;
    explicit Light(const Session& session);
  };
  void openNow(const Session& session);
  void openOtherNow(const std::optional<Session>& session);
  Source frameOf(Light& light, int frame);
  void readNow(int frame, bool isAhead);
  void setMostKept();
  [[nodiscard]] std::optional<int> nextFrame() const;

  // The requests, which m_thread guards.
  std::optional<std::optional<Session>> m_toOpen;  ///< none inside: to close
  std::optional<std::optional<Session>> m_toOpenOther;
  std::optional<int> m_toShow;
  std::optional<int> m_ahead;  ///< to be read while nothing is asked for

  int m_asked = 0;  ///< the number of the latest open() or close(); written under the mutex too

  int m_number = 0;  ///< the number that is served; the thread's own, as all below
  Light m_own;
  Light m_other;
  std::size_t m_mostKept = 1;  ///< frames of each
  int m_last = 0;              ///< the frame that was asked for last
  LatestWins m_thread;
};

}  // namespace hogelscope
