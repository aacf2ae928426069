// SPDX-License-Identifier: BSD-3-Clause
// The lens distortion dock.
#include "gui/distortion_dock.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/error.h"
#include "core/plan.h"
#include "gui/lens_view.h"
#include "gui/session_forms.h"

namespace hogelscope {

DistortionDock::DistortionDock(SessionModel* model, QAction* importAction, QWidget* parent)
    : QWidget(parent), m_model(model), m_lens(new LensView), m_certificate(new QLabel) {
  m_certificate->setObjectName("certificateLabel");
  m_certificate->setWordWrap(true);
  m_certificate->setMargin(6);
  m_certificate->setToolTip(tr("How far the lens can be trusted"));
  auto* importButton = new QToolButton;
  importButton->setObjectName("importButton");
  importButton->setDefaultAction(importAction);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(stateForm(m_model, &CameraState::distortion));
  layout->addWidget(importButton);
  layout->addWidget(m_certificate);
  layout->addWidget(m_lens, 1);
  for (const auto change :
       {&SessionModel::opened, &SessionModel::currentChanged, &SessionModel::edited,
        &SessionModel::statesChanged, &SessionModel::contentChanged})
    connect(m_model, change, this, &DistortionDock::showLens);
  showLens();
}

void DistortionDock::showLens() {
  try {
    const LensKey lens = lensKeyOf(m_model->current(), m_model->session().sampling);
    if (m_drawn == lens) return;
    m_drawn = lens;
    m_lens->setLens(lensGrid(lens), lens.res);
  } catch (const InputError&) {  // the camera looks nowhere: the status bar says so
    m_drawn.reset();
    m_lens->setLens({}, {});
  }
}

void DistortionDock::showCertificate(const LensCertificate& certificate) {
  const double share = 100 * double(certificate.withoutRay) / double(certificate.pixels);
  const QString warning =
      certificate.withoutRay == 0
          ? QString()
          : tr("<b>⚠ %1 % of the pixels have no ray: the lens folds within the picture.</b><br>")
                .arg(share, 0, 'f', 1);
  m_certificate->setText(
      warning + tr("Lens: %1.").arg(QString::fromStdString(text(certificate)).toHtmlEscaped()));
}

}  // namespace hogelscope
