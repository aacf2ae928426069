// SPDX-License-Identifier: BSD-3-Clause
// The display dock: the panel, and the parameters of its lens where a plugin has it.
#pragma once

#include <QWidget>

#include "core/optics/session.h"
#include "gui/session/session_model.h"

namespace hogelscope {

class DisplayDock : public QWidget {
  Q_OBJECT

 public:
  explicit DisplayDock(SessionModel* model, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// An edit is refused: the plugin's lens cannot be opened.
  void failed(const QString& message);

 private:
  /// Makes a form that takes an edit only if the display's lenses can be opened.
  QWidget* form(void (*visit)(ParameterVisitor&, DisplayParams&));

  SessionModel* m_model;
};

}  // namespace hogelscope
