// SPDX-License-Identifier: BSD-3-Clause
// Forms over the session's parts, which follow the model: what the docks are made of.
#pragma once

#include <vector>

#include "core/optics/session.h"
#include "gui/session/session_model.h"
#include "gui/widgets/parameter_form.h"

class QPushButton;

namespace hogelscope {

/// Shows again what the model says, whatever changes in it.
void follow(const SessionModel* model, ParameterForm* form);

/// One below the other, with nothing between them; the column takes them.
QWidget* stackWidgets(const std::vector<QWidget*>& widgets);

/// A button with its object name and tooltip; who takes it owns it.
QPushButton* button(const char* name, const QString& text, const QString& help);

/// A part of the current state.
template <class Part>
ParameterForm* stateForm(SessionModel* model, Part CameraState::*part) {
  auto* form = new ParameterForm([model, part](ParameterVisitor& visitor) {
    CameraState state = model->current();
    describe(visitor, state.*part);
    model->setCurrent(state);
  });
  follow(model, form);
  return form;
}

/// The display, the light field or the sampling.
template <class Part>
ParameterForm* contentForm(SessionModel* model, Part Session::*part) {
  auto* form = new ParameterForm([model, part](ParameterVisitor& visitor) {
    Session content = model->session();
    describe(visitor, content.*part);
    model->setContent(content);
  });
  follow(model, form);
  return form;
}

}  // namespace hogelscope
