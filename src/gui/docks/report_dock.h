// SPDX-License-Identifier: BSD-3-Clause
// The report dock: test light fields, a report in the background, and its rows. The test of the
// chosen row is compared in the view.
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "report/report_run.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace hogelscope {

class PolledBar;
class ReportPlots;
class ReportTable;
class SessionModel;
class Task;

class ReportDock : public QWidget {
  Q_OBJECT

 public:
  explicit ReportDock(QWidget* parent = nullptr);

  void setModel(SessionModel* model);
  /// Sets the light field that is in memory; none while it is read.
  void setReference(const std::optional<ViewSource>& source) { m_reference = source; }
  void addTest(const QString& file);
  /// Offers the test compared in the view, to be added by one click; "": none.
  void offerTest(const QString& file);
  void setFolder(const QString& folder);

 Q_SIGNALS:
  /// Passes the PSNR in dB of every state under the chosen row's test; NaN for states without one
  /// (yet). Empty if there is none at all.
  void psnrChanged(const std::vector<double>& dB);
  /// Requests a comparison of the session's light field with `file` in the view.
  void comparisonAsked(const QString& file);
  void failed(const QString& line);

 private:
  void forget();
  void noteEdits();
  void chooseState(std::size_t state);
  void chooseRow(std::size_t row);
  QWidget* makeSettings();
  void connectAll();
  void showOffer();
  void askTest();
  void askTestFolder();
  void askFolder();
  void openPage();
  void makeOrStop();
  void start(const MetricSet& metrics);
  void stop();
  void showIdle();
  void showReport(const Report& report);
  void showTimeLeft();
  void showRow(std::size_t index, const ReportRow& row);
  void showChosen();
  void compare();
  void emitPsnr();
  [[nodiscard]] std::optional<std::size_t> chosenRow() const;
  [[nodiscard]] ReportOrder order() const { return {m_tests.size()}; }

  SessionModel* m_model = nullptr;
  std::optional<ViewSource> m_reference;
  ReportRequest m_request;           ///< the request of the current rows
  std::vector<std::string> m_tests;  ///< the tests of the current rows
  std::size_t m_test = 0;            ///< the test of the chosen row
  bool m_follows = false;            ///< the row selection follows the current state
  Task* m_task;
  ReportTable* m_table;
  ReportPlots* m_plots;
  QSortFilterProxyModel* m_sorted;
  QListWidget* m_testList;
  QLineEdit* m_folder;
  QString m_offered;
  QPushButton* m_addOffered;
  QPushButton* m_makeButton;
  QPushButton* m_pageButton;
  PolledBar* m_progress;
  QLabel* m_note;
  QLabel* m_stale;  ///< shown while the session differs from that of the rows
  QTableView* m_rows;
  QElapsedTimer m_clock;
};

}  // namespace hogelscope
