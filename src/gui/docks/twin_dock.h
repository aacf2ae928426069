// SPDX-License-Identifier: BSD-3-Clause
// The twin dock: how the unit that is seen differs from the display as designed.
#pragma once

#include <QWidget>

#include "gui/session/session_model.h"

namespace hogelscope {

class ParameterForm;

class TwinDock : public QWidget {
  Q_OBJECT

 public:
  explicit TwinDock(SessionModel* model, QWidget* parent = nullptr);

 private:
  /// Creates a form of a part of the twin, which `part` returns.
  template <class Part>
  ParameterForm* form(Part& (*part)(TwinParams&));
  /// Hides what a lens sheet cannot have, unless it is given and has to be removed.
  void showForms();

  SessionModel* m_model;
  ParameterForm* m_lenses;
  QWidget* m_ofHogels;
};

}  // namespace hogelscope
