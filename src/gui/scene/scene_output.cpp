// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_output.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QPainter>
#include <algorithm>

#include "core/base/error.h"
#include "core/engine/renderer.h"
#include "core/optics/scene_eyes.h"
#include "gui/scene/display_scene.h"
#include "gui/scene/scene_controller.h"
#include "gui/scene/scene_picture.h"
#include "gui/scene/vtk_widget.h"
#include "gui/session/session_model.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/command.h"
#include "gui/widgets/dialogs.h"
#include "io/images/image_writer.h"
#include "picture/conversions.h"
#include "vtk/scene_export.h"

namespace hogelscope {

namespace {

/// Returns the job that renders the panel seen from `eye`, with pixels of `pixel` metres; none if
/// no light reaches the eye.
std::optional<RenderJob> panelJob(const RenderJob& current, const Vec3& eye, double pixel) {
  constexpr int longest = 4096;  // a texture of any OpenGL
  std::optional<CameraState> state = litPanelState(current.display, eye, pixel, longest);
  if (!state) return std::nullopt;
  state->psf = current.state.psf;
  RenderJob job = current;
  job.state = *state;
  job.sampling.tolerance = 0;
  job.sampling.samplesPerPixel = 1;
  return job;
}

VtkImage imageOf(const std::optional<RenderJob>& panel, const Progress& progress) {
  if (!panel) return nullptr;
  return toVtkImage(Renderer().render(*panel, progress), panelColour);
}

/// Asks for the width and the background of a picture.
class PictureDialog : public SizeDialog {
 public:
  PictureDialog(const QSize& proposed, QWidget* parent)
      : SizeDialog(SceneOutput::tr("Save scene picture"), proposed, parent) {
    m_background->setObjectName("backgroundBox");
    m_background->addItems(
        {SceneOutput::tr("As shown"), SceneOutput::tr("White"), SceneOutput::tr("Transparent")});
    m_background->setToolTip(
        SceneOutput::tr("White and transparent backgrounds have the colours of the light scheme, "
                        "for figures on paper; PNG and TIFF can be transparent"));
    form()->addRow(SceneOutput::tr("&Background"), m_background);
  }
  [[nodiscard]] SceneBackground background() const {
    return SceneBackground(m_background->currentIndex());
  }

 private:
  QComboBox* m_background = new QComboBox;
};

}  // namespace

SceneOutput::SceneOutput(QMenu* menu, QStatusBar* statusBar, SceneController* controller,
                         SessionModel* model, QObject* parent)
    : FileOutput("sceneOutputBar", tr("Scene"),
                 tr("How much of the scene has been drawn and written"), statusBar, parent),
      m_controller(controller),
      m_model(model),
      m_savePicture(addCommand(menu,
                               {"saveSceneAction", tr("Sa&ve scene picture…"),
                                tr("Saves the 3-D scene from where it is seen now, with as many "
                                   "pixels as you say: PNG, TIFF, JPEG or EXR"),
                                Qt::CTRL | Qt::ALT | Qt::Key_S},
                               this, &SceneOutput::askPicture)),
      m_export(addCommand(menu,
                          {"exportSceneAction", tr("E&xport scene…"),
                           tr("Saves panel, hogel grid, frusta and mesh in metres of the world: "
                              "glTF for viewers and renderers, VTP for ParaView and VTK"),
                           Qt::CTRL | Qt::ALT | Qt::Key_X},
                          this, &SceneOutput::askExport)) {
  connect(m_task, &Task::runningChanged, this, &SceneOutput::showState);
  connect(model, &SessionModel::opened, this, [this] {
    // Results that arrive later would be of another scene.
    if (m_task->isRunning())
      Q_EMIT failed(tr("%1: not written: another session opens").arg(m_file));
    m_task->abandon();
    showState();
  });
  showState();
}

void SceneOutput::showState() {
  for (QAction* action : {m_savePicture, m_export})
    action->setEnabled(!m_model->session().cameras.empty() && !m_task->isRunning());
}

/// Renders the panel and writes the file on the task's thread; draws the scene on the window's
/// thread, which has OpenGL.
void SceneOutput::savePicture(const QString& file, const QSize& size, SceneBackground background) {
  m_file = file;
  DisplayScene& scene = m_controller->scene();
  const std::optional<RenderJob> current = m_controller->job();
  std::optional<RenderJob> panel;
  if (current && m_controller->showsPanelImage())
    panel = panelJob(*current, scene.viewpoint(),
                     scene.pixelOnPanel() * m_controller->widget()->deviceSize().height() /
                         std::max(1, size.height()));
  m_task->start([this, panel, file, size, background](const Progress& progress) {
    return [this, image = imageOf(panel, progress), file, size, background] {
      if (image != nullptr) m_controller->scene().panel().setImage(image);
      draw(file, size, background);
    };
  });
}

void SceneOutput::draw(const QString& file, const QSize& size, SceneBackground background) {
  DisplayScene& scene = m_controller->scene();
  const bool isTransparent = background == SceneBackground::transparent;
  try {
    if (isTransparent &&
        !QStringList({"png", "tif", "tiff"}).contains(QFileInfo(file).suffix().toLower()))
      throw InputError("the scene's picture", "only .png and .tif have a transparent background");
    VtkWidget& widget = *m_controller->widget();
    if (widget.image().isNull())  // initialises OpenGL if the scene was never shown
      throw InputError("the scene's picture", "OpenGL 3.2 is not available");
    if (background != SceneBackground::asShown)
      scene.setColours(lightTokens(), isTransparent ? Qt::transparent : Qt::white);
    QImage picture = scenePicture(*widget.renderWindow(), size);
    const double scale = double(size.height()) / std::max(1, widget.height());
    QPainter painter(&picture);
    painter.scale(scale, scale);
    scene.paintOver(painter, false);
    painter.end();
    scene.setColours(tokens(), tokens().canvas);
    scene.redraw();
    m_controller->renderPanel();  // replaces the fine image, which is slow to rotate
    m_task->start([this, picture, file, isTransparent](const Progress& progress) {
      writeImage(file.toStdString(), picture.width(), picture.height(),
                 bytesOf(picture, isTransparent), progress);
      return [this, file] { Q_EMIT done(tr("Saved %1").arg(file)); };
    });
  } catch (const std::exception& error) {
    scene.setColours(tokens(), tokens().canvas);
    Q_EMIT failed(file + ": " + QString::fromUtf8(error.what()));
  }
}

void SceneOutput::exportTo(const QString& file) {
  m_file = file;
  constexpr double pixelsOfPanel = 1024;
  SceneParts parts{displayOf(m_model->session()), m_model->session().cameras, nullptr, nullptr};
  const std::optional<RenderJob> current = m_controller->job();
  std::optional<RenderJob> panel;
  if (current) {
    parts.display = current->display;
    const double side = std::max(parts.display.size[0], parts.display.size[1]);
    panel = panelJob(*current, m_controller->scene().viewpoint(), side / pixelsOfPanel);
  }
  m_task->start([this, parts, current, panel, file](const Progress& progress) mutable {
    parts.panelImage = imageOf(panel, progress);
    const LiveScene* const live = current ? current->lightField->scene() : nullptr;
    if (live != nullptr) parts.mesh = toVtkMesh(live->triangles());
    exportScene(file.toStdString(), parts);
    return [this, file] { Q_EMIT done(tr("Saved %1").arg(file)); };
  });
}

void SceneOutput::askPicture() {
  PictureDialog dialog(m_controller->widget()->deviceSize(), m_controller->widget());
  if (dialog.exec() != QDialog::Accepted) return;
  const QString file = chooseNewFile(m_controller->widget(), tr("Save scene picture"), "scene.png",
                                     tr("Pictures (*.png *.tif *.tiff *.exr *.jpg)"));
  if (!file.isEmpty()) savePicture(file, dialog.size(), dialog.background());
}

void SceneOutput::askExport() {
  const QString file = chooseNewFile(m_controller->widget(), tr("Export scene"), "scene.gltf",
                                     tr("Scenes (*.gltf *.vtp)"));
  if (!file.isEmpty()) exportTo(file);
}

}  // namespace hogelscope
