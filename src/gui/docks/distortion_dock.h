// SPDX-License-Identifier: BSD-3-Clause
// The lens distortion dock: the current state's lens, its drawing, its valid range, and the import
// of a calibration.
#pragma once

#include <QWidget>
#include <optional>

#include "core/lens/lens_rays.h"

class QAction;
class QLabel;

namespace hogelscope {

class LensWidget;
class SessionModel;
struct CertifiedLens;

class DistortionDock : public QWidget {
  Q_OBJECT

 public:
  DistortionDock(SessionModel* model, QAction* importAction, QWidget* parent = nullptr);

  /// Shows a lens. It turns grey as soon as the current state has another lens.
  void showLens(const CertifiedLens& lens);

 private:
  void noteEdits();

  SessionModel* m_model;
  std::optional<LensKey> m_shown;
  LensWidget* m_lens;
  QLabel* m_certificate;
};

}  // namespace hogelscope
