// SPDX-License-Identifier: BSD-3-Clause
// The main window: puts scene, simulated view, docks and menus together.
#include "gui/main_window.h"

#include <vtkObject.h>

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QScrollArea>
#include <QSignalBlocker>

#include "core/error.h"
#include "gui/display_scene.h"
#include "gui/parameter_form.h"
#include "gui/session_model.h"
#include "gui/view_worker.h"
#include "ui_main_window.h"

namespace hogelscope {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_ui(std::make_unique<Ui::MainWindow>()),
      m_model(new SessionModel(this)),
      m_worker(new ViewWorker(this)),
      m_stateBox(new QComboBox(this)) {
  vtkObject::GlobalWarningDisplayOff();  // errors are shown in the status bar
  m_ui->setupUi(this);
  m_ui->splitter->setSizes({1, 1});
  m_scene = std::make_unique<DisplayScene>(*m_ui->sceneWidget);
  m_stateBox->setObjectName("stateBox");
  m_stateBox->setToolTip(tr("The current camera state"));
  m_stateBox->setMinimumContentsLength(24);
  m_ui->toolBar->addWidget(m_stateBox);
  addForms();
  connectActions();
  connectModel();
  showTitle();
}

MainWindow::~MainWindow() = default;

void MainWindow::addForms() {
  const auto add = [this](QScrollArea* area, auto part) {
    auto* form = new ParameterForm([this, part](ParameterVisitor& visitor) {
      CameraState state = m_model->current();
      describe(visitor, state.*part);
      m_model->setCurrent(state);
    });
    area->setWidget(form);
    m_forms.push_back(form);
  };
  add(m_ui->cameraArea, &CameraState::camera);
  add(m_ui->distortionArea, &CameraState::distortion);
  add(m_ui->psfArea, &CameraState::psf);
}

void MainWindow::connectActions() {
  connect(m_ui->openAction, &QAction::triggered, this, &MainWindow::askOpen);
  connect(m_ui->saveAction, &QAction::triggered, this, &MainWindow::save);
  connect(m_ui->saveAsAction, &QAction::triggered, this, &MainWindow::askSaveAs);
  connect(m_ui->quitAction, &QAction::triggered, this, &QWidget::close);
  connect(m_ui->fitAction, &QAction::triggered, this, [this] { m_scene->fit(); });
  connect(m_ui->aboutAction, &QAction::triggered, this, &MainWindow::showAbout);
  connect(m_stateBox, &QComboBox::currentIndexChanged, this,
          [this](int index) { m_model->setCurrentIndex(std::size_t(index)); });
  for (QDockWidget* dock : {m_ui->cameraDock, m_ui->distortionDock, m_ui->psfDock})
    m_ui->viewMenu->addAction(dock->toggleViewAction());
}

void MainWindow::connectModel() {
  connect(m_model, &SessionModel::opened, this, &MainWindow::showSession);
  connect(m_model, &SessionModel::saved, this, &MainWindow::showTitle);
  connect(m_model, &SessionModel::currentChanged, this, &MainWindow::showCurrent);
  connect(m_model, &SessionModel::edited, this, &MainWindow::showCurrent);
  connect(m_worker, &ViewWorker::failed, this, &MainWindow::showError);
  connect(m_worker, &ViewWorker::loaded, this, [this](const DisplayParams& display) {
    m_display = display;
    showCurrent();
    m_scene->fit();
  });
  connect(m_worker, &ViewWorker::rendered, this, [this](const QImage& image, double ms) {
    m_ui->imageView->setImage(image);
    statusBar()->showMessage(
        tr("%1 × %2 px in %3 ms").arg(image.width()).arg(image.height()).arg(ms, 0, 'f', 1));
  });
}

template <class Action>
bool MainWindow::guarded(Action action) {
  try {
    action();
    return true;
  } catch (const std::exception& error) {
    showError(QString::fromUtf8(error.what()));
    return false;
  }
}

bool MainWindow::openSession(const QString& file) {
  return guarded([&] { m_model->open(file); });
}

bool MainWindow::saveSession(const QString& file) {
  return guarded([&] { m_model->save(file); });
}

void MainWindow::askOpen() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open session"), m_model->file(),
                                                    tr("Sessions (*.json)"));
  if (!file.isEmpty()) openSession(file);
}

void MainWindow::save() {
  if (m_model->file().isEmpty()) return askSaveAs();
  saveSession(m_model->file());
}

void MainWindow::askSaveAs() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Save session as"), m_model->file(),
                                                    tr("Sessions (*.json)"));
  if (!file.isEmpty()) saveSession(file);
}

void MainWindow::showAbout() {
  QMessageBox::about(this, tr("About Hogelscope"),
                     tr("Hogelscope %1\nSimulated viewing of light field displays")
                         .arg(QStringLiteral(HOGELSCOPE_VERSION)));
}

void MainWindow::showSession() {
  const QSignalBlocker quiet(m_stateBox);
  m_stateBox->clear();
  for (const CameraState& state : m_model->session().cameras)
    m_stateBox->addItem(QString::fromStdString(state.camera.name));
  m_display = m_model->session().display;
  m_worker->load(m_model->session());
  statusBar()->showMessage(
      tr("Reading %1 …").arg(QString::fromStdString(m_model->session().lightField.file)));
  showCurrent();
  m_scene->fit();
}

void MainWindow::showCurrent() {
  const QSignalBlocker quiet(m_stateBox);
  const auto index = int(m_model->currentIndex());
  m_stateBox->setItemText(index, QString::fromStdString(m_model->current().camera.name));
  m_stateBox->setCurrentIndex(index);
  for (ParameterForm* form : m_forms) form->refresh();
  m_scene->show(m_display, m_model->session().cameras, m_model->currentIndex());
  m_worker->render(m_model->current());
  showTitle();
}

void MainWindow::showTitle() {
  const QString name =
      m_model->file().isEmpty() ? tr("no session") : QFileInfo(m_model->file()).fileName();
  setWindowTitle(tr("%1[*] – Hogelscope").arg(name));
  setWindowModified(m_model->isModified());
  setWindowFilePath(m_model->file());
  m_ui->saveAction->setEnabled(!m_model->session().cameras.empty());
  m_ui->saveAsAction->setEnabled(!m_model->session().cameras.empty());
}

void MainWindow::showError(const QString& line) {
  statusBar()->showMessage(tr("Error: %1").arg(line));
}

}  // namespace hogelscope
