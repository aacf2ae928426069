// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/image_commands.h"

#include <QClipboard>
#include <QFileInfo>

#include "gui/session/session_model.h"
#include "gui/view/comparison_commands.h"
#include "gui/view/view_output.h"
#include "gui/view/view_worker.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "gui/widgets/polled_bar.h"
#include "io/files/folders.h"
#include "io/images/image_writer.h"
#include "io/scene/view_source.h"
#include "ui_main_window.h"

namespace hogelscope {

ImageCommands::ImageCommands(const Ui::MainWindow& ui, SessionModel* model, QObject* parent)
    : QObject(parent),
      m_ui(ui),
      m_model(model),
      m_comparison(new Comparison(this)),
      m_comparing(new ComparisonCommands(ui, this)),
      m_output(new ViewOutput(ui, model, this)),
      m_bar(new ReadingBar(
          tr("Other light field"), [this] { return m_comparison->readShare(); }, ui.statusBar)) {
  const auto connectAction = [this](QAction* action, void (ImageCommands::*does)()) {
    connect(action, &QAction::triggered, this, does);
  };
  connectAction(m_ui.compareAction, &ImageCommands::askFile);
  connectAction(m_ui.compareFolderAction, &ImageCommands::askFolder);
  connect(m_ui.compareIdealAction, &QAction::triggered, m_comparison, &Comparison::startIdeal);
  connectAction(m_ui.stopComparingAction, &ImageCommands::stopComparing);
  connectAction(m_ui.savePictureAction, &ImageCommands::askImage);
  connectAction(m_ui.copyPictureAction, &ImageCommands::copy);
  connect(m_ui.fitViewAction, &QAction::triggered, m_ui.pictureView, &ImageWidget::fit);
  connect(m_ui.oneToOneViewAction, &QAction::triggered, m_ui.pictureView, &ImageWidget::oneToOne);
  connect(m_ui.maskAction, &QAction::toggled, m_ui.pictureView, &ImageWidget::showMask);
  connect(m_comparison, &Comparison::changed, this, &ImageCommands::otherChanged);
  connect(m_comparison, &Comparison::changed, this, &ImageCommands::showComparison);
  connect(m_comparison, &Comparison::changed, this,
          [this] { Q_EMIT compared(m_comparison->file()); });
  connect(m_comparison, &Comparison::failed, this, &ImageCommands::failed);
  connect(m_comparison, &Comparison::failed, this, &ImageCommands::showComparison);
  connect(m_model, &SessionModel::opened, m_comparison, &Comparison::stop);
  connect(m_output, &ViewOutput::done, this, &ImageCommands::done);
  connect(m_output, &ViewOutput::failed, this, &ImageCommands::failed);
  m_bar->setObjectName("otherReadingBar");
  m_ui.statusBar->addPermanentWidget(m_bar);
  connect(m_bar, &ReadingBar::stopAsked, this, &ImageCommands::stopReading);
  drop(tr("No view yet: open a session (Ctrl+O)"));
}

void ImageCommands::setSource(const std::optional<ViewSource>& own) {
  m_comparison->setSource(own);
  m_output->setSource(own);
}

std::optional<ViewSource> ImageCommands::other() const {
  return m_comparison->other(m_model->session());
}

void ImageCommands::show(const RenderedView& view) {
  const bool hasOther = other().has_value();  // false for an image that arrives after the stop
  m_ui.pictureView->setImages(view.image, hasOther ? view.otherImage : QImage());
  m_ui.pictureView->setMask(view.seen, hasOther ? view.otherSeen : QImage());
  showNotice({});
}

void ImageCommands::showNotice(const QString& why) {
  m_ui.pictureView->setNotice(why);
  showComparison();
}

void ImageCommands::drop(const QString& why) {
  m_ui.pictureView->setMask({}, {});
  m_ui.pictureView->setImages({});
  showNotice(why);
}

bool ImageCommands::isRight() const {
  return !m_ui.pictureView->image().isNull() && m_ui.pictureView->notice().isEmpty();
}

/// Enables the commands that are available now.
void ImageCommands::showComparison() {
  const bool hasImage = !m_ui.pictureView->image().isNull();
  m_bar->setVisible(m_comparison->isReading());
  m_comparing->setComparing(other().has_value());
  m_comparing->measure();
  m_ui.stopComparingAction->setEnabled(other() || m_comparison->isReading());
  m_ui.compareAction->setEnabled(hasImage);
  m_ui.compareFolderAction->setEnabled(hasImage);
  m_ui.compareIdealAction->setEnabled(hasImage && m_model->session().lightField.isLive());
  for (QAction* action : {m_ui.fitViewAction, m_ui.oneToOneViewAction})
    action->setEnabled(hasImage);
  for (QAction* action : {m_ui.savePictureAction, m_ui.copyPictureAction})
    action->setEnabled(isRight());
  const std::string own = contentName(m_model->session().lightField);
  m_ui.pictureView->setTitles(QFileInfo(QString::fromStdString(own)).fileName(),
                              m_comparison->name());
}

void ImageCommands::stopComparing() {
  m_comparison->stop();
  m_ui.pictureView->setImages(m_ui.pictureView->image());
  m_comparing->measure();
}

/// Stops reading and, as every stop does, the current comparison.
void ImageCommands::stopReading() {
  stopComparing();
  Q_EMIT done(tr("Stopped reading the other light field"));
}

bool ImageCommands::compareWith(const QString& file) {
  if (m_comparison->file() == file) return true;
  if (!guarded(this, [&] { m_comparison->start(m_model->session(), file); })) return false;
  Q_EMIT done(tr("Reading %1 …").arg(file));
  showComparison();
  return true;
}

bool ImageCommands::saveImage(const QString& file) {
  if (!isRight()) {  // outdated while its name was asked for
    Q_EMIT failed(tr("%1: not written: there is no picture of the current state").arg(file));
    return false;
  }
  const QImage image = m_ui.pictureView->shownImage().convertToFormat(QImage::Format_RGB888);
  const auto rowBytes = 3 * std::size_t(image.width());
  std::vector<std::uint8_t> rgb;
  for (int y = 0; y < image.height(); ++y)
    rgb.insert(rgb.end(), image.constScanLine(y), image.constScanLine(y) + rowBytes);
  return guarded(this, [&] {
    checkOutputs({file.toStdString()}, lightFieldFiles(m_model->session()));
    writeImage(file.toStdString(), image.width(), image.height(), rgb);
    Q_EMIT done(tr("Saved %1").arg(file));
  });
}

void ImageCommands::copy() {
  QGuiApplication::clipboard()->setImage(m_ui.pictureView->shownImage());
  Q_EMIT done(tr("Copied"));
}

void ImageCommands::askFile() {
  const QString file = chooseFile(m_ui.pictureView, tr("Compare with light field"),
                                  lightFieldFilter(sessionPatterns));
  if (!file.isEmpty()) compareWith(file);
}

void ImageCommands::askFolder() {
  const QString folder = chooseFolder(m_ui.pictureView, tr("Compare with folder of views"));
  if (!folder.isEmpty()) compareWith(folder);
}

void ImageCommands::askImage() {
  const QString name = QString::fromStdString(m_model->current().camera.name) + ".png";
  const QString file = chooseNewFile(m_ui.pictureView, tr("Save picture"), name,
                                     tr("Pictures (*.png *.tif *.tiff *.exr *.jpg)"));
  if (!file.isEmpty()) saveImage(file);
}

}  // namespace hogelscope
