// SPDX-License-Identifier: BSD-3-Clause
// The display dock: the panel, and the parameters of a plugin's lens.
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
  /// An edit has been rejected because the plugin's lens cannot be opened.
  void failed(const QString& message);

 private:
  /// Creates a form that accepts an edit only if the display's lenses can be opened.
  QWidget* form(void (*visit)(ParameterVisitor&, DisplayParams&));

  SessionModel* m_model;
};

}  // namespace hogelscope
