// SPDX-License-Identifier: BSD-3-Clause
// The PSF dock: the current state's light leakage, a drawing of it, and what its window cuts off.
#pragma once

#include <QWidget>

class QLabel;

namespace hogelscope {

class KernelWidget;
class ParameterForm;
class SessionModel;
struct Scene;

class PsfDock : public QWidget {
  Q_OBJECT

 public:
  explicit PsfDock(SessionModel* model, QWidget* parent = nullptr);

  /// The light field that is shown: beyond 2·directions − 1 a wider window changes nothing.
  void setScene(const Scene& scene);

 private:
  void showKernel();

  SessionModel* m_model;
  ParameterForm* m_form;
  KernelWidget* m_kernel;
  QLabel* m_energy;
};

}  // namespace hogelscope
