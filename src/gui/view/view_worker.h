// SPDX-License-Identifier: BSD-3-Clause
// Reads light fields and renders views on its own thread; the newest request wins.
// One request waits at most, the newest. If a full image took longer than 30 ms, an edit's first
// image is smaller (ViewPace) and is finished even if newer edits come; the full one follows
// after 60 ms without any. A store's first image is its overview's; a live scene's has no leakage,
// which reads most texels.
#pragma once

#include <vtkNew.h>
#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <atomic>
#include <optional>
#include <utility>

#include "core/engine/view_pace.h"
#include "core/lens/lens_certificate.h"
#include "core/lens/lens_grid.h"
#include "core/optics/session.h"
#include "gui/widgets/latest_wins.h"
#include "io/scene/view_source.h"
#include "picture/stereo_view.h"
#include "study/tradeoff.h"
#include "vtk/vtkHogelViewFilter.h"

namespace hogelscope {

/// The view of a state, and of the second light field if there is one.
struct RenderedView {
  QImage image;
  QImage seen;  ///< black where no ray meets the display; with RayEnd as index if asked for
  QImage otherImage;
  QImage otherSeen;
  double milliseconds = 0;             ///< of both images
  int scale = 1;                       ///< above 1: a coarse image shown during editing
  bool isOverview = false;             ///< coarse by fewer hogels and directions, not by scale
  int samples = 0;                     ///< of the pupil, if they are fewer than wanted; otherwise 0
  QString plan;                        ///< the rendering plan in one line
  QString method;                      ///< the chosen method's name; "" for the session's own
  StereoView eyes = StereoView::head;  ///< of a state with two
  bool isBuilt = false;                ///< with the errors of the session's twin
};

/// The certificate of a lens, and its drawing.
struct CertifiedLens {
  LensKey key;
  LensCertificate certificate;
  LensGrid grid;
};

/// The view to render.
struct ViewRequest {
  CameraState state;
  ViewSource source;
  std::optional<NamedMethod> method;  ///< none: the session's own
  std::optional<ViewSource> other;    ///< the second light field
  bool asksWhy = false;               ///< why pixels are not seen
  StereoView eyes = StereoView::head;
};

/// Emits all signals on the thread that the object lives in. Its end stops a running job. No signal
/// of an older light field arrives after load().
class ViewWorker : public QObject {
  Q_OBJECT

 public:
  explicit ViewWorker(QObject* parent = nullptr);

  /// Reads the session's light field, at one of its frames, and stops an older reading.
  void load(const Session& session, std::optional<int> frame = {});
  /// Stops reading.
  void stopReading();
  /// Returns the share that has been read, 0 … 1. It is polled, because signals of each step would
  /// arrive faster than a busy window can process them.
  [[nodiscard]] double readShare() const { return m_readShare; }
  /// Stops an older rendering. A slow view starts with a coarse image; the full one follows when no
  /// newer request arrives for a moment.
  void render(const ViewRequest& request);

 Q_SIGNALS:
  void loaded(const hogelscope::ViewSource& source);
  void readingStopped();  ///< after stopReading()
  void rendered(const hogelscope::RenderedView& view);
  /// Emitted after the image if its lens has changed.
  void certified(const hogelscope::CertifiedLens& lens);
  void failed(const QString& line);

 private:
  template <class Signal>
  void send(Signal signal);
  void serve(LatestWins::Lock& lock);
  void loadNow(const Session& session, std::optional<int> frame);
  void renderNow(const ViewRequest& request);
  void renderAt(int scale, double patience, const ViewRequest& request);
  struct Shown;
  Shown renderEyes(const ViewSource& source, int scale, const ViewRequest& request);
  Shown renderEye(const RenderJob& view, bool asksWhy);
  void certifyNow(const ViewRequest& request);
  [[nodiscard]] bool hasNewer(bool isLoading);
  [[nodiscard]] bool mustStop();
  [[nodiscard]] bool staysIdle();

  // The requests, which m_thread guards.
  std::optional<std::pair<Session, std::optional<int>>> m_toLoad;  ///< and its frame
  std::optional<ViewRequest> m_toRender;
  bool m_isReadingStopped = false;

  int m_asked = 0;  ///< the number of the latest load(); written under the mutex too
  std::atomic<double> m_readShare = 0;

  int m_number = 0;  ///< the number of the load() that is served; the thread's own, as all below
  std::optional<LensKey> m_lens;  ///< the one certified last
  ViewPace m_pace;
  QElapsedTimer m_timer;  ///< since the rendering started
  double m_patience = 0;  ///< milliseconds after which a newer request stops the rendering
  vtkNew<vtkHogelViewFilter> m_filter;
  LatestWins m_thread;
};

}  // namespace hogelscope
