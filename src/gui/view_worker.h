// SPDX-License-Identifier: BSD-3-Clause
// Reads light fields and renders views on a thread of its own; the newest request wins.
#pragma once

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "core/lens_certificate.h"
#include "core/session.h"
#include "io/light_field_file.h"
#include "study/tradeoff.h"

class vtkHogelViewFilter;

namespace hogelscope {

class ViewWorker : public QObject {
  Q_OBJECT

 public:
  explicit ViewWorker(QObject* parent = nullptr);
  /// Stops what is under way.
  ~ViewWorker() override;

  /// Reads the session's light field; an older reading stops.
  void load(const Session& session);
  /// Renders once the light field is there, by the session's own method if none is given; an older
  /// rendering stops.
  void render(const CameraState& state, const std::optional<NamedMethod>& method);

 Q_SIGNALS:
  void loaded(const hogelscope::Scene& scene);
  void rendered(const QImage& image, double milliseconds);
  /// After the picture, where its lens is another one than before.
  void certified(const hogelscope::LensCertificate& certificate);
  void failed(const QString& line);

 private:
  void run();
  void loadNow(const Session& session, vtkHogelViewFilter& filter);
  void renderNow(const View& view, vtkHogelViewFilter& filter);
  void certifyNow(const CameraState& state);
  [[nodiscard]] bool hasNewer(bool isLoading);

  std::mutex m_mutex;  ///< guards the next four
  std::condition_variable m_wake;
  std::optional<Session> m_toLoad;
  struct Request {
    CameraState state;
    std::optional<NamedMethod> method;
  };
  std::optional<Request> m_toRender;
  bool m_ends = false;

  std::optional<Scene> m_scene;   ///< the thread's own, as the next
  std::optional<LensKey> m_lens;  ///< the one certified last
  std::thread m_thread;
};

}  // namespace hogelscope
