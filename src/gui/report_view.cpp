// SPDX-License-Identifier: BSD-3-Clause
// The report dock.
#include "gui/report_view.h"

#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>
#include <QUrl>
#include <limits>

#include "gui/picture_view.h"
#include "gui/report_table.h"
#include "gui/report_worker.h"

namespace hogelscope {

namespace {

QPushButton* button(const char* name, const QString& text, const QString& help) {
  auto* made = new QPushButton(text);
  made->setObjectName(name);
  made->setToolTip(help);
  return made;
}

QWidget* beside(std::initializer_list<QWidget*> widgets) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  for (QWidget* widget : widgets) layout->addWidget(widget);
  return row;
}

}  // namespace

ReportView::ReportView(QWidget* parent)
    : QWidget(parent),
      m_worker(new ReportWorker(this)),
      m_table(new ReportTable(this)),
      m_sorted(new QSortFilterProxyModel(this)),
      m_testList(new QListWidget),
      m_folder(new QLineEdit),
      m_makeButton(button("makeReportButton", {}, tr("Renders every state from the session's light "
                                                     "field and from each test, and compares"))),
      m_pageButton(button("openPageButton", tr("&Open page"),
                          tr("Shows report.html in the web browser"))),
      m_progress(new QProgressBar),
      m_note(new QLabel),
      m_rows(new QTableView) {
  m_sorted->setSourceModel(m_table);
  m_sorted->setSortRole(ReportTable::sortRole);
  m_rows->setObjectName("reportTable");
  m_rows->setModel(m_sorted);
  m_rows->setSortingEnabled(true);
  m_rows->sortByColumn(-1, Qt::AscendingOrder);  // as the report has them
  m_rows->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_rows->setSelectionMode(QAbstractItemView::SingleSelection);
  m_rows->verticalHeader()->hide();
  m_rows->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  auto* parts = new QSplitter;
  parts->addWidget(makeSettings());
  parts->addWidget(m_rows);
  parts->addWidget(makePictures());
  parts->setSizes({280, 420, 800});
  parts->setChildrenCollapsible(false);
  auto* layout = new QHBoxLayout(this);
  layout->addWidget(parts);
  connectAll();
  showIdle();
}

QWidget* ReportView::makeSettings() {
  m_testList->setObjectName("testList");
  m_testList->setToolTip(tr("The light fields that are compared with the session's own"));
  m_testList->setMaximumHeight(90);
  m_folder->setObjectName("reportFolder");
  m_folder->setToolTip(tr("Where report.html, report.csv and the pictures go"));
  m_note->setObjectName("reportNote");
  m_note->setWordWrap(true);
  m_progress->setObjectName("reportProgress");
  m_progress->setRange(0, 1000);
  auto* addFile = button("addTestButton", tr("&Add…"), tr("An image or a session"));
  auto* addFolder = button("addTestFolderButton", tr("Add &folder…"), tr("A folder of views"));
  auto* remove = button("removeTestButton", tr("&Remove"), tr("The one that is marked"));
  auto* choose = button("reportFolderButton", tr("Choose…"), tr("Another folder"));
  connect(addFile, &QPushButton::clicked, this, &ReportView::askTest);
  connect(addFolder, &QPushButton::clicked, this, &ReportView::askTestFolder);
  connect(choose, &QPushButton::clicked, this, &ReportView::askFolder);
  connect(remove, &QPushButton::clicked, this, [this] {
    delete m_testList->currentItem();
    showIdle();
  });
  auto* settings = new QWidget;
  auto* layout = new QVBoxLayout(settings);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(new QLabel(tr("Test light fields")));
  layout->addWidget(m_testList);
  layout->addWidget(beside({addFile, addFolder, remove}));
  layout->addWidget(new QLabel(tr("Report folder")));
  layout->addWidget(beside({m_folder, choose}));
  layout->addWidget(beside({m_makeButton, m_pageButton}));
  layout->addWidget(m_progress);
  layout->addWidget(m_note);
  layout->addStretch();
  return settings;
}

/// Zoomed and panned together.
QWidget* ReportView::makePictures() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const char* name, const QString& title) {
    auto* view = new PictureView;
    view->setObjectName(name);
    view->setHint(title);
    view->setMinimumSize(120, 120);
    auto* column = new QVBoxLayout;
    column->addWidget(new QLabel(title));
    column->addWidget(view, 1);
    layout->addLayout(column, 1);
    return view;
  };
  m_referencePicture = add("reportReference", tr("Reference"));
  m_testPicture = add("reportTest", tr("Test"));
  m_differencePicture = add("reportDifference", tr("Difference"));
  m_differencePicture->setMode(PictureView::Mode::difference);
  m_testPicture->linkTo(*m_referencePicture);
  m_differencePicture->linkTo(*m_referencePicture);
  return row;
}

void ReportView::connectAll() {
  connect(m_makeButton, &QPushButton::clicked, this, &ReportView::makeOrStop);
  connect(m_pageButton, &QPushButton::clicked, this, &ReportView::openPage);
  connect(m_rows->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &ReportView::showChosen);
  connect(m_worker, &ReportWorker::advanced, this, &ReportView::showProgress);
  connect(m_worker, &ReportWorker::rowFinished, this, &ReportView::showRow);
  connect(m_worker, &ReportWorker::finished, this, [this](const Report& report) {
    showIdle();
    m_note->setText(QString::fromStdString(summaryText(summarise(report.rows), report.rows)));
    m_pageButton->setEnabled(true);
  });
  connect(m_worker, &ReportWorker::stopped, this, [this] {
    showIdle();
    m_note->setText(tr("Stopped. What is finished is kept: the same report goes on from there."));
  });
  connect(m_worker, &ReportWorker::failed, this, [this](const QString& line) {
    showIdle();
    m_note->setText(line);
    Q_EMIT failed(line);
  });
}

void ReportView::setSession(const Session& session, const QString& file) {
  m_session = session;
  m_file = file;
  m_isModified = false;
  if (m_isAtWork) stop();
  m_request = {};
  m_table->begin(0);
  m_note->clear();
  m_pageButton->setEnabled(false);
  for (PictureView* view : {m_referencePicture, m_testPicture, m_differencePicture})
    view->setImages({});
  const QFileInfo info(file);
  if (!file.isEmpty()) m_folder->setText(info.path() + "/" + info.completeBaseName() + "-report");
  tellPsnr();
  if (!m_isAtWork) showIdle();
}

void ReportView::setEdited(const Session& session, bool isModified) {
  m_isModified = isModified;
  if (session == m_session) return;
  const bool hasOtherStates = session.cameras.size() != m_session.cameras.size();
  m_session = session;
  if (m_table->rowCount() == 0) return;
  if (hasOtherStates) {
    setSession(session, m_file);
    m_isModified = isModified;
  } else if (!m_isAtWork) {
    m_note->setText(tr("The session has been edited since this report was made."));
  }
}

void ReportView::setReference(const std::optional<Scene>& scene) {
  m_reference = scene;
}

void ReportView::askTest() {
  const QStringList files = QFileDialog::getOpenFileNames(
      this, tr("Add test light fields"), m_file,
      tr("Light fields and sessions (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.json);;All files (*)"));
  for (const QString& file : files) addTest(file);
}

void ReportView::askTestFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Add a folder of views"), QFileInfo(m_file).path());
  if (!folder.isEmpty()) addTest(folder);
}

void ReportView::addTest(const QString& file) {
  m_testList->addItem(file);
  m_testList->setCurrentRow(m_testList->count() - 1);
  if (!m_isAtWork) showIdle();
}

void ReportView::askFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Folder of the report"), m_folder->text());
  if (!folder.isEmpty()) setFolder(folder);
}

void ReportView::setFolder(const QString& folder) {
  m_folder->setText(folder);
}

void ReportView::openPage() {
  QDesktopServices::openUrl(
      QUrl::fromLocalFile(QString::fromStdString(m_request.output) + "/report.html"));
}

void ReportView::makeOrStop() {
  if (m_isAtWork) return stop();
  start();
}

void ReportView::start() {
  m_tests.clear();
  for (int k = 0; k < m_testList->count(); ++k)
    m_tests.push_back(m_testList->item(k)->text().toStdString());
  m_request = {};
  m_request.session = m_session;
  m_request.session.sampling.tolerance = 0;  // differences are the light fields'
  m_request.sessionFile = m_isModified ? std::string() : m_file.toStdString();
  m_request.output = m_folder->text().toStdString();
  m_request.command = m_isModified ? "made in the window, from " + m_file.toStdString() + " as edited"
                                   : "made in the window";
  m_request.images = true;  // what a click on a row shows
  m_request.reference = m_reference;
  if (m_request.reference) m_request.reference->sampling.tolerance = 0;
  m_table->begin(m_session.cameras.size() * m_tests.size());
  m_test = 0;
  tellPsnr();
  m_isAtWork = true;
  m_note->clear();
  m_pageButton->setEnabled(false);
  m_makeButton->setText(tr("&Stop"));
  m_progress->setVisible(true);
  m_clock.start();
  m_worker->start(m_request, m_tests);
}

void ReportView::stop() {
  m_worker->stop();
  m_makeButton->setText(tr("Stopping…"));
  m_makeButton->setEnabled(false);
}

void ReportView::showIdle() {
  m_isAtWork = false;
  m_makeButton->setText(tr("&Make report"));
  m_makeButton->setEnabled(!m_session.cameras.empty() && m_testList->count() > 0);
  m_progress->setVisible(false);
  m_progress->setValue(0);
}

void ReportView::showProgress(double fraction) {
  m_progress->setValue(int(1000 * fraction));
  const std::string left = timeLeft(double(m_clock.elapsed()) / 1000, fraction);
  m_progress->setFormat("%p % " + QString::fromStdString(left));
}

void ReportView::showRow(std::size_t index, const ReportRow& row) {
  m_table->set(index, row);
  if (chosenRow() == index) showPictures(index);
  tellPsnr();
}

void ReportView::tellPsnr() {
  std::vector<double> dB;
  if (m_table->rowCount() > 0) {
    dB.assign(m_session.cameras.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t state = 0; state < dB.size(); ++state)
      if (const auto& row = m_table->row(state * m_tests.size() + m_test); row)
        dB[state] = psnr(row->metrics.mse);
  }
  Q_EMIT psnrChanged(dB);
}

std::optional<std::size_t> ReportView::chosenRow() const {
  const QModelIndex current = m_sorted->mapToSource(m_rows->currentIndex());
  if (!current.isValid()) return std::nullopt;
  return std::size_t(current.row());
}

void ReportView::showChosen() {
  const std::optional<std::size_t> row = chosenRow();
  if (!row || m_tests.empty()) return;
  if (const std::size_t test = *row % m_tests.size(); test != m_test) {
    m_test = test;
    tellPsnr();
  }
  showPictures(*row);
  Q_EMIT stateChosen(*row / m_tests.size());
}

void ReportView::showPictures(std::size_t index) {
  const std::optional<ReportRow>& row = m_table->row(index);
  QImage reference;
  QImage test;
  if (row && row->problem.empty()) {
    const QString folder = QString::fromStdString(m_request.output);
    const QString name = "/" + QString::fromStdString(row->state) + ".png";
    reference.load(folder + "/reference" + name);
    test.load(folder + "/test" + QString::number(index % m_tests.size() + 1) + name);
  }
  m_referencePicture->setImages(reference);
  m_testPicture->setImages(test);
  m_differencePicture->setImages(reference, test);
}

void ReportView::chooseState(std::size_t state) {
  const std::size_t row = state * m_tests.size() + m_test;
  if (m_tests.empty() || row >= std::size_t(m_table->rowCount()) || chosenRow() == row) return;
  m_rows->selectRow(m_sorted->mapFromSource(m_table->index(int(row), 0)).row());
}

}  // namespace hogelscope
