// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/parameter_docks.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/engine/plan.h"
#include "core/panel/design_numbers.h"
#include "gui/docks/parameter_drawings.h"
#include "gui/session/session_forms.h"
#include "gui/view/view_worker.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "io/documents/sheet_file.h"
#include "io/opening/session_around.h"
#include "io/plugins/display_json.h"
#include "io/scene/view_source.h"
#include "picture/scene_text.h"

namespace hogelscope {

DisplayDock::DisplayDock(SessionModel* model, QWidget* parent)
    : QWidget(parent), m_model(model), m_sheet(new QWidget), m_figures(new QLabel) {
  auto* panel = form([](ParameterVisitor& v, DisplayParams& p) { describe(v, p); });
  auto* lens = form([](ParameterVisitor& v, DisplayParams& p) {
    if (p.lensParams.isGiven()) describe(v, p.lensParams);
  });
  m_panel = panel;
  panel->hideHeading();
  for (const char* pair : {"hogels", "directions", "fov"}) panel->linkPair(pair, true);
  panel->linkPair("size", false);
  m_lock = panel->addButton("size", "lock", true,
                            tr("Locked: the size is held while the number of hogels changes. Open: "
                               "the hogels' pitch is held, and the size changes"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  m_figures->setObjectName("sheetLabel");
  m_figures->setToolTip(tr("The lens sheet's calibration"));
  m_figures->setWordWrap(true);
  m_figures->setTextFormat(Qt::RichText);
  m_choose = button("chooseSheetButton", {}, tr("The visual.json of a lens sheet"));
  connect(m_choose, &QPushButton::clicked, this, &DisplayDock::askSheet);
  auto* rows = new QVBoxLayout(m_sheet);
  rows->addWidget(m_figures);
  rows->addWidget(m_choose);
  layout->addWidget(stackWidgets({panel, lens, m_sheet}));
  for (const auto change : {&SessionModel::opened, &SessionModel::contentChanged})
    connect(m_model, change, this, &DisplayDock::showSheet);
  showSheet();
  const auto show = [this, lens] {
    lens->setVisible(m_model->session().display.lensParams.isGiven());
  };
  for (const auto change : {&SessionModel::opened, &SessionModel::contentChanged})
    connect(m_model, change, lens, show);
  show();
}

void DisplayDock::setSource(const std::optional<ViewSource>& source) {
  const DisplayParams known = source ? DisplayParams(source->display) : DisplayParams();
  for (const auto& [name, counts] :
       {std::pair("hogels", known.hogels), std::pair("directions", known.directions)})
    for (std::size_t k = 0; k < counts.size(); ++k)
      m_panel->showLeftOut(QString("%1.%2").arg(name).arg(k),
                           source && counts[k] > 0 ? QLocale().toString(counts[k]) : QString());
}

void DisplayDock::showSheet() {
  const std::optional<SheetDisplay>& sheet = m_model->session().display.sheet;
  m_sheet->setVisible(sheet || m_model->session().lightField.layout == Layout::quilt);
  m_figures->setVisible(sheet.has_value());
  m_choose->setText(sheet ? tr("Choose &calibration…") : tr("See it on a &lens sheet…"));
  if (!sheet) return;
  const QString name = QFileInfo(QString::fromStdString(sheet->file)).fileName().toHtmlEscaped();
  m_figures->setText((name.isEmpty() ? QString() : "<b>" + name + "</b><br>") +
                     SceneText::sheet(*sheet));
}

void DisplayDock::askSheet() {
  const QString file = chooseSheet(this);
  if (file.isEmpty()) return;
  guarded(this, [&] {
    Session content = m_model->session();
    content.display = withCalibration(content.display, file.toStdString());
    content.lightField.viewingDistance = notGiven;  // which is of hogels
    m_model->setContent(content);
    for (const std::string& warning : sheetWarnings(content))
      Q_EMIT failed(file + ": " + QString::fromStdString(warning));
  });
}

ParameterForm* DisplayDock::form(void (*visit)(ParameterVisitor&, DisplayParams&)) {
  const auto complete = [this](const DisplayParams& before, DisplayParams after) {
    if (after.hogels != before.hogels && !m_lock->isChecked()) holdPitch(before, after);
    return withLensParams(before, std::move(after));
  };
  return checkedForm<DisplayParams>(m_model, &Session::display, visit, complete,
                                    [this](const QString& why) { Q_EMIT failed(why); });
}

CameraDock::CameraDock(SessionModel* model, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_camera(stateForm(model, &CameraState::camera)),
      m_isCalibrated(new QCheckBox(tr("Calibrated camera"))),
      m_intrinsics(stateForm(model, &CameraState::intrinsics)) {
  m_isCalibrated->setObjectName("calibrated");
  m_isCalibrated->setToolTip(tr(
      "Focal lengths and centre in pixels in place of the field of view; the first ones take the "
      "same picture"));
  auto* choice = new QWidget;
  auto* row = new QVBoxLayout(choice);
  row->setContentsMargins(scaled(12), 0, scaled(12), 0);
  row->addWidget(m_isCalibrated);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(stackWidgets({m_camera, choice, m_intrinsics}));
  m_camera->hideHeading();
  connect(m_isCalibrated, &QCheckBox::toggled, this, &CameraDock::calibrate);
  for (const auto change : {&SessionModel::opened, &SessionModel::currentChanged,
                            &SessionModel::edited, &SessionModel::statesChanged})
    connect(model, change, this, &CameraDock::showForms);
  showForms();
}

/// Sets intrinsics of the same image in the marked states, or removes them.
void CameraDock::calibrate(bool isCalibrated) {
  m_model->editMarked([isCalibrated](CameraState& state) {
    state.intrinsics = {};
    if (isCalibrated && hasFrame(state.camera))
      state.intrinsics.fx = Camera(state.camera).focalLength().x;
  });
  showForms();
}

void CameraDock::showForms() {
  const bool isCalibrated = m_model->current().intrinsics.isGiven();
  const QSignalBlocker quiet(m_isCalibrated);
  m_isCalibrated->setChecked(isCalibrated);
  m_intrinsics->setVisible(isCalibrated);
  m_camera->hideField("fov", isCalibrated);
}

DistortionDock::DistortionDock(SessionModel* model, QAction* importAction, QWidget* parent)
    : QWidget(parent), m_model(model), m_lens(new LensWidget), m_certificate(new QLabel) {
  m_certificate->setObjectName("certificateLabel");
  m_certificate->setWordWrap(true);
  m_certificate->setMargin(9);
  m_certificate->setToolTip(
      tr("How far the lens can be trusted; grey while it is worked out for another lens"));
  auto* importButton = new QToolButton;
  importButton->setObjectName("importButton");
  importButton->setDefaultAction(importAction);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* form = followingForm(
      model,
      [model](ParameterVisitor& visitor) {
        model->editMarked([&](CameraState& state) {
          const DistortionModel before = state.distortion.model;
          describe(visitor, state.distortion);
          if (state.distortion.model != before) state.distortion = ofItsModel(state.distortion);
        });
      },
      [](ParameterVisitor& visitor) {
        DistortionParams defaults;
        describe(visitor, defaults);
      });
  form->hideHeading();
  layout->addWidget(form);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(layout->spacing() + 3, 0, 0, 0);
  buttons->addWidget(importButton);
  buttons->addStretch();
  layout->addLayout(buttons);
  layout->addWidget(m_certificate);
  layout->addWidget(m_lens, 1);
  onAnyChange(model, this, &DistortionDock::noteEdits);
}

void DistortionDock::showLens(const CertifiedLens& lens) {
  m_shown = lens.key;
  m_lens->setLens(lens.grid);
  const LensCertificate& certificate = lens.certificate;
  const double share = 100 * double(certificate.withoutRay) / double(certificate.pixels);
  const QString warning =
      certificate.withoutRay == 0 ? QString()
      : certificate.endsAtRightAngle
          ? tr("<b>⚠ %1 % of the pixels have no ray: they would be 90° off the axis or "
               "more.</b><br>")
                .arg(share, 0, 'f', 1)
          : tr("<b>⚠ %1 % of the pixels have no ray: the lens folds or ends within the "
               "picture.</b><br>")
                .arg(share, 0, 'f', 1);
  m_certificate->setText(
      warning +
      tr("Lens: %1.").arg(QString::fromStdString(certificateText(certificate)).toHtmlEscaped()));
  noteEdits();
}

void DistortionDock::noteEdits() {
  const CameraState state = m_model->current();
  const bool isShown =
      hasFrame(state.camera) && m_shown == lensKeyOf(state, m_model->session().sampling);
  m_certificate->setEnabled(isShown);
  m_lens->setEnabled(isShown);
}

PsfDock::PsfDock(SessionModel* model, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_form(stateForm(m_model, &CameraState::psf)),
      m_kernel(new KernelWidget),
      m_energy(new QLabel) {
  m_energy->setObjectName("energyLabel");
  m_energy->setToolTip(
      tr("How much of the Gaussian's light the window leaves out; a wider window "
         "leaves out less"));
  m_energy->setWordWrap(true);
  m_energy->setMargin(9);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  m_form->hideHeading();
  layout->addWidget(m_form);
  layout->addWidget(m_energy);
  layout->addWidget(m_kernel, 1);
  onAnyChange(m_model, this, &PsfDock::showKernel);
  showKernel();
}

void PsfDock::showKernel() {
  const PsfParams psf = m_model->current().psf;
  // A window that a sheet refuses can still be mended here.
  const bool isSheet = !hasDirections(m_model->session().display) && psf.windowSize == 1;
  m_form->setHidden(isSheet);
  m_kernel->setHidden(isSheet);
  if (isSheet)
    return m_energy->setText(tr("The pixels behind a lens sheet have no directions to leak into."));
  m_kernel->setParams(psf);
  if (psf.windowSize == 1)
    return m_energy->setText(tr("A window of 1: no light leaks, and sigma is not used."));
  if (!(psf.sigma > 0))
    return m_energy->setText(tr("<b>⚠ A sigma of 0 needs a windowSize of 1.</b>"));
  const double outside = 1 - energyInWindow(psf);
  const QString line =
      tr("%1 % of the Gaussian's energy lies outside the window.").arg(100 * outside, 0, 'g', 3);
  m_energy->setText(cutsTooMuch(psf) ? tr("<b>⚠ %1</b> Widen it.").arg(line) : line);
}

}  // namespace hogelscope
