// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/camera_dock.h"

#include <QCheckBox>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/session/session_forms.h"

namespace hogelscope {

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
  row->setContentsMargins(9, 0, 9, 0);
  row->addWidget(m_isCalibrated);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(stackWidgets({m_camera, choice, m_intrinsics}));
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

}  // namespace hogelscope
