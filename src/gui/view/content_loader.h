// SPDX-License-Identifier: BSD-3-Clause
// Keeps the session's light field open while the session is edited.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "core/optics/session.h"
#include "io/scene/view_source.h"

namespace hogelscope {

class SessionModel;
class ViewWorker;

/// Reads a light field again only where an edit asks for another one. The display's pose, size and
/// lens and the sampling change without reading.
class ContentLoader : public QObject {
  Q_OBJECT

 public:
  ContentLoader(SessionModel* model, ViewWorker* worker, QObject* parent);

  /// Returns the light field with the session's display and sampling; none while it is read, or if
  /// it cannot be read.
  [[nodiscard]] const std::optional<ViewSource>& source() const { return m_source; }
  /// Whether scene() is what the session asks for.
  [[nodiscard]] bool isReady() const { return m_source && !m_isReading; }

  /// Sets whether views are of the session's twin, or of the display as designed.
  void showTwin(bool isBuilt);
  /// Reads the session's light field.
  void load();
  /// Shows a frame of it by its number, in place of the one that is shown.
  void showFrame(int number, const std::shared_ptr<const LightFieldSource>& frame);
  /// Returns the number of the frame that is shown; none: the first one.
  [[nodiscard]] std::optional<int> frame() const { return m_frame; }
  /// Returns the session whose light field was read last.
  [[nodiscard]] const Session& asked() const { return m_asked; }
  /// Follows an edit of the session's content. Returns whether sourceChanged() was emitted for it.
  bool follow();
  /// Reads what was edited while the image was rendered that has now been shown.
  void followImage();

 Q_SIGNALS:
  void sourceChanged();  ///< to another one, or to none
  void frameChanged();   ///< only the frame of it has changed
  void loaded();
  /// Reading has begun, or takes longer than a moment.
  void reading(const QString& line);
  /// The light field has been read, and nothing that is shown fits it.
  void renderingBegun();
  void stopped(const QString& line);
  /// The light field cannot be read, or a state cannot be rendered.
  void failed(const QString& line);

 private:
  void forget();
  void end();
  void sayReading();
  [[nodiscard]] std::shared_ptr<const Twin> twin(const PanelParams& display);
  void showSession();
  void onLoaded(const ViewSource& source);
  void onFailed(const QString& line);
  void onStopped();

  SessionModel* m_model;
  ViewWorker* m_worker;
  QTimer m_delay;  ///< until reading a live scene's edit is reported
  std::optional<ViewSource> m_source;
  std::optional<int> m_frame;  ///< the one that is shown; none: the first one
  Session m_asked;             ///< the session whose light field is being read or was read last
  bool m_showsTwin = true;
  /// The twin that was made last, its parameters and its display.
  std::shared_ptr<const Twin> m_twin;
  std::pair<TwinParams, PanelParams> m_twinOf;
  bool m_isReading = false;  ///< m_asked is being read; m_source is an older light field, if any
  bool m_isAwaited = false;  ///< the first image of m_asked has not been rendered yet
};

}  // namespace hogelscope
