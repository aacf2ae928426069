// SPDX-License-Identifier: BSD-3-Clause
// Reads light fields and renders views on a thread of its own; the newest request wins.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "core/lens/lens_certificate.h"
#include "core/lens/lens_grid.h"
#include "core/optics/session.h"
#include "gui/view/view_pace.h"
#include "io/scene/scene.h"
#include "study/tradeoff.h"

class vtkHogelViewFilter;

namespace hogelscope {

/// What a state looks like, and on the second light field where there is one.
struct RenderedView {
  QImage image;
  QImage seen;  ///< 0 where no ray meets the display
  QImage otherImage;
  QImage otherSeen;
  double milliseconds = 0;  ///< of both
  int scale = 1;            ///< above 1: a coarse image, because the hand moves:
  bool isOverview = false;  ///< of fewer hogels and directions, or one pixel in scale × scale
  QString plan;             ///< how, in one line
};

/// How far a lens can be trusted, and its drawing.
struct CertifiedLens {
  LensKey key;
  LensCertificate certificate;
  LensGrid grid;
};

/// What is to be seen.
struct ViewRequest {
  CameraState state;
  DisplayParams display;
  SamplingParams sampling;
  std::optional<NamedMethod> method;  ///< none: the session's own
  std::optional<Scene> other;         ///< the second light field
};

/// All signals come from the thread that the object lives in, and none that belongs to an older
/// light field comes after load().
class ViewWorker : public QObject {
  Q_OBJECT

 public:
  explicit ViewWorker(QObject* parent = nullptr);
  /// Stops what is under way.
  ~ViewWorker() override;

  /// Reads the session's light field; an older reading stops.
  void load(const Session& session);
  /// There is no light field then until the next load().
  void stopReading();
  /// How much of it has been read, 0 … 1. To be asked: a signal for each step of the reading would
  /// come faster than a busy window can follow.
  [[nodiscard]] double readShare() const { return m_readShare; }
  /// Renders once the light field is there, and not at all where it could not be read; an older
  /// rendering stops. Where it takes long a coarse image comes first, and the full one when no
  /// newer request has come for a moment.
  void render(const ViewRequest& request);

 Q_SIGNALS:
  void loaded(const hogelscope::Scene& scene);
  void readingStopped();  ///< because it was asked for
  void rendered(const hogelscope::RenderedView& view);
  /// After the image, where its lens is another one than before.
  void certified(const hogelscope::CertifiedLens& lens);
  void failed(const QString& line);

 private:
  template <class Signal>
  void send(Signal signal);
  void run();
  void loadNow(const Session& session);
  void renderNow(const ViewRequest& request, vtkHogelViewFilter& filter);
  void renderAt(int scale, double patience, const ViewRequest& request, vtkHogelViewFilter& filter);
  void certifyNow(const ViewRequest& request);
  [[nodiscard]] bool hasNewer(bool isLoading);
  [[nodiscard]] bool mustStop();
  [[nodiscard]] bool handRests();

  std::mutex m_mutex;  ///< guards the next five
  std::condition_variable m_wake;
  std::optional<Session> m_toLoad;
  std::optional<ViewRequest> m_toRender;
  bool m_isReadingStopped = false;
  bool m_ends = false;

  int m_asked = 0;  ///< the number of the latest load(); written under the mutex, too
  std::atomic<double> m_readShare = 0;

  int m_number = 0;  ///< of the load() that is served; the thread's own, as all below
  std::optional<Scene> m_scene;
  std::optional<LensKey> m_lens;  ///< the one certified last
  ViewPace m_pace;
  QElapsedTimer m_timer;  ///< since the rendering began
  double m_patience = 0;  ///< milliseconds after which a newer request stops the rendering
  std::thread m_thread;
};

}  // namespace hogelscope
