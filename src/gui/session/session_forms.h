// SPDX-License-Identifier: BSD-3-Clause
// Forms over the session's parts, which follow the model: what the docks are made of.
#pragma once

#include <functional>
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

/// A part of the current state, and what is edited of all marked ones.
template <class Part>
ParameterForm* stateForm(SessionModel* model, Part CameraState::*part) {
  auto* form = new ParameterForm(
      [model, part](ParameterVisitor& visitor) {
        model->editMarked([&](CameraState& state) { describe(visitor, state.*part); });
      },
      [](ParameterVisitor& visitor) {
        Part defaults;
        describe(visitor, defaults);
      });
  follow(model, form);
  return form;
}

/// The display, the light field or the sampling.
template <class Part>
ParameterForm* contentForm(SessionModel* model, Part Session::*part) {
  auto* form = new ParameterForm(
      [model, part](ParameterVisitor& visitor) {
        Session content = model->session();
        describe(visitor, content.*part);
        model->setContent(content);
      },
      [](ParameterVisitor& visitor) {
        Part defaults;
        describe(visitor, defaults);
      });
  follow(model, form);
  return form;
}

/// What `visit` visits of the display or the light field. complete(before, after) returns the
/// edited part with what belongs to it, or throws what is wrong with the edit: it is then not
/// taken, and `fail` hears why.
template <class Part>
ParameterForm* checkedForm(SessionModel* model, Part Session::*part,
                           void (*visit)(ParameterVisitor&, Part&),
                           Part (*complete)(const Part& before, Part after),
                           std::function<void(const QString&)> fail) {
  auto* form = new ParameterForm(
      [=](ParameterVisitor& visitor) {
        Session content = model->session();
        const Part before = content.*part;
        visit(visitor, content.*part);
        try {
          content.*part = complete(before, content.*part);
          model->setContent(content);
        } catch (const std::exception& error) {
          fail(QString::fromUtf8(error.what()));
        }
      },
      [=](ParameterVisitor& visitor) {
        Part defaults;
        visit(visitor, defaults);
      });
  follow(model, form);
  return form;
}

}  // namespace hogelscope
