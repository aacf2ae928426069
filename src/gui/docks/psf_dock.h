// SPDX-License-Identifier: BSD-3-Clause
// The PSF dock: the current state's light leakage, its drawing, and the light outside its window.
#pragma once

#include <QWidget>

class QLabel;

namespace hogelscope {

class KernelWidget;
class ParameterForm;
class SessionModel;
struct ViewSource;

class PsfDock : public QWidget {
  Q_OBJECT

 public:
  explicit PsfDock(SessionModel* model, QWidget* parent = nullptr);

  /// Sets the current light field. A window wider than 2·directions − 1 has no further effect.
  void setSource(const ViewSource& source);

 private:
  void showKernel();

  SessionModel* m_model;
  ParameterForm* m_form;
  KernelWidget* m_kernel;
  QLabel* m_energy;
};

}  // namespace hogelscope
