// SPDX-License-Identifier: BSD-3-Clause
// The report dock: test light fields, a report in the background or one that was made before, its
// tests and states. The test of the chosen row is compared in the view.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <memory>

#include "gui/docks/report_results.h"
#include "report/report_run.h"

class QLabel;
class QMenu;

namespace Ui {
class ReportDock;
}

namespace hogelscope {

class ReportPlots;
class SessionModel;
class Task;

class ReportDock : public QWidget {
  Q_OBJECT

 public:
  explicit ReportDock(QWidget* parent = nullptr);
  ~ReportDock() override;

  /// Adds the commands of the dock to two menus.
  void setModel(SessionModel* model, QMenu* fileMenu, QMenu* statesMenu);
  /// Sets the light field that is in memory; none while it is read.
  void setReference(const std::optional<ViewSource>& source) { m_reference = source; }
  /// Sets the frames of the session's light field; a still has one. `rate` is 0 if it is not known.
  void setFrames(const FrameNumbers& frames, double rate) {
    m_frames = frames;
    m_frameRate = rate;
  }
  void addTest(const QString& file);
  /// Offers the test compared in the view, to be added by one click; "": none.
  void offerTest(const QString& file);
  void setFolder(const QString& folder);
  /// Shows a report that was made before. Errors are reported through failed(), now or later.
  void openReport(const QString& folder);

 Q_SIGNALS:
  /// Passes the PSNR in dB of every state under the chosen test; NaN for states without one (yet).
  /// Empty if there is none at all. A stale one is of a state, or a display, that was edited since.
  void frameChosen(int frame);  ///< of the row that is chosen, after its state
  void psnrChanged(const std::vector<double>& dB, const std::vector<bool>& isStale);
  /// Requests a comparison of the session's light field with `file` in the view.
  void comparisonAsked(const QString& file);
  void failed(const QString& line);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void connectTools();
  void fillMetrics(QMenu* menu);
  void connectTables();
  void forget();
  void noteEdits();
  void showOffer();
  void openPage();
  void start();
  void make();
  [[nodiscard]] int statesInFolder() const;
  void showFailure(const QString& line);
  void showIdle();
  void finish(const Report& report, const std::vector<std::optional<double>>& rates);
  void showRead(const ReportData& read);
  void sizeColumns();
  void showAll();
  void showRow(std::size_t index, const ReportRow& row);
  void showNote();
  void chooseTest(std::size_t test);
  void chooseState(std::size_t state);
  void chooseRow(std::size_t row);
  void chooseExtreme(bool isBest);
  void followSession();
  void showChosen();
  void compare();
  void emitPsnr();
  [[nodiscard]] bool isStale(std::size_t state, const Session& now) const;
  [[nodiscard]] std::optional<std::size_t> chosenState() const;

  SessionModel* m_model = nullptr;
  std::optional<ViewSource> m_reference;
  FrameNumbers m_frames;
  double m_frameRate = 0;
  ReportData m_data;
  std::size_t m_test = 0;  ///< the chosen test
  bool m_follows = false;  ///< the row selection follows the current state
  std::unique_ptr<Ui::ReportDock> m_ui;
  Task* m_task;     ///< makes a report
  Task* m_reading;  ///< reads one that was made before
  TestTable* m_testTable;
  StateTable* m_stateTable;
  FilteredRows* m_sorted;
  ReportPlots* m_plots;
  QString m_offered;
  bool m_isReplacing = false;  ///< a second click replaces the report of another session
  QLabel* m_empty;             ///< what to do, in place of tables without a report
  QElapsedTimer m_clock;
};

}  // namespace hogelscope
