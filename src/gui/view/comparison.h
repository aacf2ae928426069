// SPDX-License-Identifier: BSD-3-Clause
// Comparison with a second light field, which is read on its own thread, so that the view stays
// responsive: its images, and the figures of both.
#pragma once

#include <QObject>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/optics/session.h"
#include "gui/widgets/task.h"
#include "io/scene/view_source.h"
#include "picture/comparison_figures.h"

namespace hogelscope {

class Comparison : public QObject {
  Q_OBJECT

 public:
  explicit Comparison(QObject* parent = nullptr);

  /// Reads a light field (withLightField) for the session's states and stops an older reading. The
  /// current comparison stays until the new one is read. Throws InputError.
  void start(const Session& session, const QString& file);
  /// Reads a session's own light field for its display, in the same way.
  void startDesign(const QString& name, const Session& session);
  /// Compares with the ideal view of the session's own light field while that is live.
  void startIdeal();
  /// Compares with the session's own light field on its display as it is now, if that has been
  /// read. It is kept under a name, also if its file is read again.
  void startKept(const QString& name);
  /// Compares the unit of the session's twin with the display as designed.
  void startDesigned();
  void stop();
  /// Sets the session's own light field; none while it is read.
  void setSource(const std::optional<ViewSource>& own) { m_own = own; }
  /// Returns the session of the second light field if that is another one, to follow its frames.
  [[nodiscard]] const std::optional<Session>& session() const { return m_other.session; }
  /// Shows frames in place of those that are shown: of the session's own light field, which may be
  /// kept on another display, and of the second one; null: it is a still.
  void showFrame(const std::shared_ptr<const LightFieldSource>& own,
                 const std::shared_ptr<const LightFieldSource>& other);

  /// Returns the second light field with the session's sampling, and with the session's display
  /// unless it has its own; none without a comparison.
  [[nodiscard]] std::optional<ViewSource> other(const Session& session) const;
  /// The file's name, or a description.
  [[nodiscard]] const QString& name() const { return m_other.name; }
  /// The file that is compared or being read; "" if there is none.
  [[nodiscard]] const QString& file() const { return m_file; }
  [[nodiscard]] bool isDesigned() const { return m_other.follows == Follows::design; }
  [[nodiscard]] bool isReading() const { return m_task.isRunning(); }
  /// Returns the share that has been read, 0 … 1; polled by PolledBar.
  [[nodiscard]] double readShare() const { return m_task.share(); }

 Q_SIGNALS:
  void changed();  ///< another light field, or none
  /// The file could not be read; the current comparison stays.
  void failed(const QString& line);

 private:
  /// Whether it is made of the session's own light field, and as what.
  enum class Follows { nothing, ideal, design };
  /// The second light field; empty: none.
  struct Other {
    QString name;
    std::optional<ViewSource> source = {};  ///< none if it follows
    Follows follows = Follows::nothing;
    bool hasOwnDisplay = false;
    std::optional<Session> session = {};  ///< that `source` was read from
  };
  void read(Other other, const Session& session);
  void set(const Other& other);

  std::optional<ViewSource> m_own;
  Other m_other;
  QString m_file;
  Task m_task;
};

/// Formats the metrics as HTML, with the names of the report's table.
QString textOf(const ComparisonFigures& figures);

class ComparisonMeter : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Starts a measurement. The newest request wins, but a running one is finished, so that metrics
  /// keep updating while images change.
  void measure(const ShownPictures& pictures);
  /// Stops measuring and clears the metrics.
  void forget();

 Q_SIGNALS:
  void measured(const hogelscope::ComparisonFigures& figures);

 private:
  void start();
  void finish(const ComparisonFigures& figures);

  std::optional<ShownPictures> m_next;
  Task m_task;
};

/// Histograms of the images shown, drawn over each other.
class HistogramWidget : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramWidget(QWidget* parent = nullptr);

  /// Sets the histograms and their names; the first is filled, the second is a line.
  void setHistograms(const std::vector<Histogram>& histograms, const QStringList& names);
  [[nodiscard]] const std::vector<Histogram>& histograms() const { return m_histograms; }
  [[nodiscard]] QSize sizeHint() const override { return {256, 88}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<Histogram> m_histograms;
  QStringList m_names;
};

}  // namespace hogelscope
