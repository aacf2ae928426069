// SPDX-License-Identifier: BSD-3-Clause
// The docks of parameters: display, camera, lens distortion and PSF.
#pragma once

#include <QWidget>
#include <optional>

#include "core/lens/lens_rays.h"
#include "gui/session/session_model.h"

class QLabel;
class QPushButton;
class QAction;
class QCheckBox;
class QToolButton;

namespace hogelscope {

class KernelWidget;
class LensWidget;
class ParameterForm;
struct CertifiedLens;
struct ViewSource;

class DisplayDock : public QWidget {
  Q_OBJECT

 public:
  explicit DisplayDock(SessionModel* model, QWidget* parent = nullptr);

  /// Shows the hogels and directions of the light field where the session leaves them out; none
  /// while it is read.
  void setSource(const std::optional<ViewSource>& source);

 Q_SIGNALS:
  /// An edit has been rejected because the plugin's lens cannot be opened.
  void failed(const QString& message);

 private:
  /// Creates a form that accepts an edit only if the display's lenses can be opened.
  ParameterForm* form(void (*visit)(ParameterVisitor&, DisplayParams&));
  void showSheet();
  void askSheet();

  SessionModel* m_model;
  ParameterForm* m_panel = nullptr;
  QWidget* m_sheet;  ///< a lens sheet's calibration, and the button for another one
  QLabel* m_figures;
  QPushButton* m_choose = nullptr;  ///< of a calibration
  QToolButton* m_lock = nullptr;    ///< on: the size is held, off: the hogels' pitch
};

/// The camera dock: the pose of the current state, and its field of view or its intrinsics.
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

/// The lens distortion dock: the current state's lens, its drawing, its valid range, and the import
/// of a calibration.
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

/// The PSF dock: the current state's light leakage, its drawing, and the light outside its window.
class PsfDock : public QWidget {
  Q_OBJECT

 public:
  explicit PsfDock(SessionModel* model, QWidget* parent = nullptr);

 private:
  void showKernel();

  SessionModel* m_model;
  ParameterForm* m_form;
  KernelWidget* m_kernel;
  QLabel* m_energy;
};

}  // namespace hogelscope
