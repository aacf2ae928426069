// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/distortion_dock.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/engine/plan.h"
#include "gui/docks/lens_widget.h"
#include "gui/session/session_forms.h"
#include "gui/view/view_worker.h"

namespace hogelscope {

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
  layout->addWidget(stateForm(model, &CameraState::distortion));
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(layout->spacing() + 3, 0, 0, 0);
  buttons->addWidget(importButton);
  buttons->addStretch();
  layout->addLayout(buttons);
  layout->addWidget(m_certificate);
  layout->addWidget(m_lens, 1);
  for (const auto change :
       {&SessionModel::opened, &SessionModel::currentChanged, &SessionModel::edited,
        &SessionModel::statesChanged, &SessionModel::contentChanged})
    connect(model, change, this, &DistortionDock::noteEdits);
}

void DistortionDock::showLens(const CertifiedLens& lens) {
  m_shown = lens.key;
  m_lens->setLens(lens.grid);
  const LensCertificate& certificate = lens.certificate;
  const double share = 100 * double(certificate.withoutRay) / double(certificate.pixels);
  const QString warning =
      certificate.withoutRay == 0
          ? QString()
          : tr("<b>⚠ %1 % of the pixels have no ray: the lens folds within the picture.</b><br>")
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

}  // namespace hogelscope
