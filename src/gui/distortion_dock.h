// SPDX-License-Identifier: BSD-3-Clause
// The lens distortion dock: the current state's lens, a drawing of it, how far it can be trusted,
// and the import of a calibration.
#pragma once

#include <QWidget>

#include "core/lens_certificate.h"

class QAction;
class QLabel;

namespace hogelscope {

class LensView;
class SessionModel;

class DistortionDock : public QWidget {
  Q_OBJECT

 public:
  DistortionDock(SessionModel* model, QAction* importAction, QWidget* parent = nullptr);

  void showCertificate(const LensCertificate& certificate);

 private:
  void showLens();

  SessionModel* m_model;
  LensView* m_lens;
  QLabel* m_certificate;
  std::optional<LensKey> m_drawn;
};

}  // namespace hogelscope
