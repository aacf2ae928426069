// SPDX-License-Identifier: BSD-3-Clause
// The PSF dock: the current state's light leakage, a drawing of it, and what its window cuts off.
#pragma once

#include <QWidget>

class QLabel;

namespace hogelscope {

class KernelWidget;
class SessionModel;

class PsfDock : public QWidget {
  Q_OBJECT

 public:
  explicit PsfDock(SessionModel* model, QWidget* parent = nullptr);

 private:
  void showKernel();

  SessionModel* m_model;
  KernelWidget* m_kernel;
  QLabel* m_energy;
};

}  // namespace hogelscope
