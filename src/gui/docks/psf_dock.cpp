// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/psf_dock.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/docks/kernel_widget.h"
#include "gui/session/session_forms.h"
#include "io/scene/view_source.h"

namespace hogelscope {

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
  layout->addWidget(m_form);
  layout->addWidget(m_energy);
  layout->addWidget(m_kernel, 1);
  for (const auto change : {&SessionModel::opened, &SessionModel::currentChanged,
                            &SessionModel::edited, &SessionModel::statesChanged})
    connect(m_model, change, this, &PsfDock::showKernel);
  showKernel();
}

void PsfDock::setSource(const ViewSource& source) {
  const LightFieldSize size = source.lightField->size();
  m_form->slideTo("windowSize", 2.0 * std::max(size.du, size.dv) - 1);
}

void PsfDock::showKernel() {
  const PsfParams psf = m_model->current().psf;
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
