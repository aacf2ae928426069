// SPDX-License-Identifier: BSD-3-Clause
// The camera dock: the pose of the current state, and its field of view or its intrinsics.
#pragma once

#include <QWidget>

class QCheckBox;

namespace hogelscope {

class ParameterForm;
class SessionModel;

class CameraDock : public QWidget {
  Q_OBJECT

 public:
  explicit CameraDock(SessionModel* model, QWidget* parent = nullptr);

 private:
  void calibrate(bool isCalibrated);
  void showForms();

  SessionModel* m_model;
  ParameterForm* m_camera;
  QCheckBox* m_isCalibrated;
  ParameterForm* m_intrinsics;
};

}  // namespace hogelscope
