// SPDX-License-Identifier: BSD-3-Clause
// The report dock: test light fields, a run in the background, and its rows; the test of the row
// that is chosen is compared in the view.
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
  /// What is in memory already; none while it is read.
  void setReference(const std::optional<Scene>& scene);
  void addTest(const QString& file);
  /// What is compared in the picture, to be added by one click; "": nothing.
  void offerTest(const QString& file);
  void setFolder(const QString& folder);

 Q_SIGNALS:
  /// Of every state under the test of the chosen row, dB; not a number where there is none (yet).
  /// Empty while there is none at all.
  void psnrChanged(const std::vector<double>& dB);
  /// The view is to show this light field beside the session's own.
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
  std::optional<Scene> m_reference;
  ReportRequest m_request;           ///< of the rows that are shown
  std::vector<std::string> m_tests;  ///< likewise
  std::size_t m_test = 0;            ///< of the chosen row
  bool m_follows = false;            ///< chooses the row of a state that was chosen elsewhere
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
  QLabel* m_stale;  ///< shown while the session is not what the rows are of
  QTableView* m_rows;
  QElapsedTimer m_clock;
};

}  // namespace hogelscope
