// SPDX-License-Identifier: BSD-3-Clause
// The lens distortion dock: the current state's lens, a drawing of it, how far it can be trusted,
// and the import of a calibration.
#pragma once

#include <QWidget>

#include "core/lens_certificate.h"
#include "core/lens_grid.h"

class QAction;
class QLabel;

namespace hogelscope {

class LensView;
class SessionModel;

class DistortionDock : public QWidget {
  Q_OBJECT

 public:
  DistortionDock(SessionModel* model, QAction* importAction, QWidget* parent = nullptr);

  void showLens(const LensCertificate& certificate, const LensGrid& grid);

 private:
  LensView* m_lens;
  QLabel* m_certificate;
};

}  // namespace hogelscope
