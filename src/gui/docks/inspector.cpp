// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/inspector.h"

#include <QPainter>
#include <cmath>

#include "core/base/error.h"
#include "gui/scene/scene_controller.h"
#include "gui/view/image_widget.h"
#include "picture/conversions.h"
#include "picture/scene_text.h"
#include "ui_inspector.h"

namespace hogelscope {

namespace {

/// Returns a swatch for the pixel's fate: hatched as the mask if it is not seen, plain with light.
QPixmap swatchOf(const PixelTrace& trace) {
  constexpr int side = 32;
  QPixmap swatch(side, side);
  QPainter painter(&swatch);
  painter.fillRect(swatch.rect(), Qt::black);
  const PixelFate fate = fateOf(trace);
  if (fate == PixelFate::noRay || fate == PixelFate::outside)
    painter.drawImage(0, 0, hatchOf(trace.end, side, hatchColours()));
  if (fate == PixelFate::lit)
    painter.fillRect(swatch.rect(), QColor(quantised(trace.colour->r), quantised(trace.colour->g),
                                           quantised(trace.colour->b)));
  painter.setPen(Qt::gray);
  painter.drawRect(swatch.rect().adjusted(0, 0, -1, -1));
  return swatch;
}

QPoint cellOf(double a, double b) {
  return {int(std::floor(a)), int(std::floor(b))};
}

}  // namespace

Inspector::Inspector(QWidget* parent) : QWidget(parent), m_ui(std::make_unique<Ui::Inspector>()) {
  m_ui->setupUi(this);
  showNothing({});
}

Inspector::~Inspector() = default;

void Inspector::follow(SceneController* scene, ImageWidget* picture) {
  m_scene = scene;
  m_picture = picture;
  connect(scene, &SceneController::pickChanged, this, &Inspector::refresh);
  connect(picture, &ImageWidget::imagesChanged, this, &Inspector::refresh);
  connect(picture, &ImageWidget::pointed, this, &Inspector::point);
}

void Inspector::showEvent(QShowEvent*) {
  refresh();
}

/// Follows the pointer if the light field is in memory; fetching would be slower than the pointer.
void Inspector::point(const QPoint& pixel) {
  if (!isVisible() || m_scene == nullptr) return;
  const std::optional<RenderJob> job = m_scene->job();
  const bool isQuick = job && job->lightField->isInMemory();
  const std::optional<QPoint> next =
      isQuick && pixel.x() >= 0 ? std::optional(pixel) : std::nullopt;
  if (next == m_pointed) return;
  m_pointed = next;
  refresh();
}

void Inspector::refresh() {
  if (!isVisible() || m_scene == nullptr || m_picture == nullptr) return;
  const std::optional<RenderJob> job = m_scene->job();
  const std::optional<QPoint> pixel = m_pointed ? m_pointed : m_scene->pickedPixel();
  if (!job) return showNothing(tr("There is no light field."));
  try {
    const auto view = pixel ? m_scene->viewAt(*pixel) : std::nullopt;
    if (view) return showPixel(*view, *pixel);
    if (m_scene->pickedHogel()) return showHogel(*job, *m_scene->pickedHogel());
    showNothing(tr("Point at a pixel of the picture, or click one, or a hogel of the scene."));
  } catch (const InputError& error) {  // no camera frame, or damaged content
    showNothing(QString::fromUtf8(error.what()));
  }
}

void Inspector::showNothing(const QString& hint) {
  m_ui->inspectorVerdict->setText(hint);
  for (QWidget* part : std::initializer_list<QWidget*>{
           m_ui->inspectorSwatch, m_ui->inspectorNeighbours, m_ui->inspectorValues,
           m_ui->inspectorHogelTitle, m_ui->inspectorHogel, m_ui->inspectorWeights})
    part->hide();
}

void Inspector::showFocus(const QPoint& pixel, const QString& text) {
  m_focused = pixel;
  m_focusText = text;
  refresh();
}

void Inspector::showPixel(const PickedView& view, const QPoint& shown) {
  const RenderJob& job = view.job;
  const QPoint& pixel = view.pixel;
  const PixelTrace trace = pixelTrace(job, pixel.x(), pixel.y());
  showNothing(SceneText::verdict(trace, job.display));
  m_ui->inspectorSwatch->setPixmap(swatchOf(trace));
  m_ui->inspectorSwatch->show();
  showNeighbours(shown);
  const bool hasFocus = shown == m_focused && !m_focusText.isEmpty();
  m_ui->inspectorValues->setText(SceneText::pixel(pixel.x(), pixel.y(), trace) + valuesAt(shown) +
                                 SceneText::ray(trace, job.display, m_scene->views()) +
                                 (hasFocus ? '\n' + m_focusText : ""));
  m_ui->inspectorValues->show();
  const bool hasHogel = trace.end == RayEnd::seen || trace.end == RayEnd::outsideField;
  if (!hasHogel || !hasDirections(job.display)) return;
  showPictureOf(job, cellOf(trace.place->i, trace.place->j));
  if (trace.end == RayEnd::seen) showDirection(job, *trace.place);
}

void Inspector::showHogel(const RenderJob& job, const QPoint& hogel) {
  showNothing(SceneText::hogel(job.display, hogel.x(), hogel.y()));
  showPictureOf(job, hogel);
}

void Inspector::showNeighbours(const QPoint& pixel) {
  constexpr double zoom = 12;
  m_ui->inspectorNeighbours->setImages(m_picture->image(), m_picture->otherImage());
  m_ui->inspectorNeighbours->setNotice(m_picture->notice());
  m_ui->inspectorNeighbours->setViewport(
      {false, zoom * devicePixelRatioF(), QPointF(pixel) + QPointF(0.5, 0.5)});
  m_ui->inspectorNeighbours->markPixels(QRect(pixel, QSize(1, 1)));
  m_ui->inspectorNeighbours->show();
}

/// Returns the displayed code values of both images; empty for a single image.
QString Inspector::valuesAt(const QPoint& pixel) const {
  QStringList texts;
  for (const QImage* image : {&m_picture->image(), &m_picture->otherImage()}) {
    if (!image->rect().contains(pixel)) continue;
    const QColor colour = image->pixelColor(pixel);
    texts << QStringLiteral("%1 %2 %3").arg(colour.red()).arg(colour.green()).arg(colour.blue());
  }
  if (texts.size() < 2) return {};
  return tr("\nshown %1, other %2").arg(texts[0], texts[1]);
}

void Inspector::showPictureOf(const RenderJob& job, const QPoint& hogel) {
  const Image image = hogelImage(*job.lightField, hogel.x(), hogel.y());
  m_ui->inspectorHogel->setImages(toQImage(image));
  m_ui->inspectorHogel->markPixels({});
  m_ui->inspectorHogel->setRegion({});
  m_ui->inspectorHogel->show();
  const auto [du, dv] = job.display.directions;
  QString title = tr("Hogel %1, %2").arg(hogel.x()).arg(hogel.y());
  if (image.width != du || image.height != dv)
    title += tr(" (near it: %1 × %2 of its %3 × %4 directions)")
                 .arg(image.width)
                 .arg(image.height)
                 .arg(du)
                 .arg(dv);
  m_ui->inspectorHogelTitle->setText(title);
  m_ui->inspectorHogelTitle->show();
}

/// Marks the direction in the hogel's image, which may have fewer directions.
void Inspector::showDirection(const RenderJob& job, const Hit& place) {
  const QSize directions(job.display.directions[0], job.display.directions[1]);
  const QPoint seen = cellOf(place.u, place.v);
  const QSize size = m_ui->inspectorHogel->image().size();
  const auto inPicture = [&](const QPoint& at) {
    return QPoint(at.x() * size.width() / directions.width(),
                  at.y() * size.height() / directions.height());
  };
  m_ui->inspectorHogel->markPixels(QRect(inPicture(seen), QSize(1, 1)));
  const PsfParams& psf = job.state.psf;
  if (psf.windowSize == 1) return;
  const QPoint reach(psf.windowSize / 2, psf.windowSize / 2);
  const QRect window = QRect(seen - reach, seen + reach) & QRect(QPoint(), directions);
  m_ui->inspectorHogel->setRegion({inPicture(window.topLeft()), inPicture(window.bottomRight())});
  m_ui->inspectorWeights->setWeights(psf,
                                     psfKernelAt(psf, job.lightField->size(), seen.x(), seen.y()));
  m_ui->inspectorWeights->show();
}

}  // namespace hogelscope
