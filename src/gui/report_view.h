// SPDX-License-Identifier: BSD-3-Clause
// The report dock: test light fields, a run in the background, its rows, and the pictures of the row
// that is chosen.
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "report/report_run.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace hogelscope {

class PictureView;
class ReportTable;
class ReportWorker;

class ReportView : public QWidget {
  Q_OBJECT

 public:
  explicit ReportView(QWidget* parent = nullptr);

  /// What the next report is of. Rows of another session are not shown any more, and a report that
  /// is under way stops.
  void setSession(const Session& session, const QString& file);
  /// The session has other values than the rows that are shown.
  void setEdited(const Session& session, bool isModified);
  /// What is in memory already; none while it is read.
  void setReference(const std::optional<Scene>& scene);
  /// Shows the row of this state.
  void chooseState(std::size_t state);
  void addTest(const QString& file);
  void setFolder(const QString& folder);

 Q_SIGNALS:
  void stateChosen(std::size_t state);
  /// Of every state under the test of the chosen row, dB; not a number where there is none (yet).
  void psnrChanged(const std::vector<double>& dB);
  void failed(const QString& line);

 private:
  QWidget* makeSettings();
  QWidget* makePictures();
  void connectAll();
  void askTest();
  void askTestFolder();
  void askFolder();
  void openPage();
  void makeOrStop();
  void start();
  void stop();
  void showIdle();
  void showProgress(double fraction);
  void showRow(std::size_t index, const ReportRow& row);
  void showChosen();
  void showPictures(std::size_t index);
  void tellPsnr();
  [[nodiscard]] std::optional<std::size_t> chosenRow() const;

  Session m_session;
  QString m_file;
  bool m_isModified = false;
  std::optional<Scene> m_reference;
  ReportRequest m_request;           ///< of the rows that are shown
  std::vector<std::string> m_tests;  ///< likewise
  std::size_t m_test = 0;            ///< of the chosen row
  ReportWorker* m_worker;
  ReportTable* m_table;
  QSortFilterProxyModel* m_sorted;
  QListWidget* m_testList;
  QLineEdit* m_folder;
  QPushButton* m_makeButton;
  QPushButton* m_pageButton;
  QProgressBar* m_progress;
  QLabel* m_note;
  QTableView* m_rows;
  PictureView* m_referencePicture;
  PictureView* m_testPicture;
  PictureView* m_differencePicture;
  QElapsedTimer m_clock;
  bool m_isAtWork = false;
};

}  // namespace hogelscope
