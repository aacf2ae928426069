// SPDX-License-Identifier: BSD-3-Clause
// Forms for the session's parts, which follow the model; the contents of the docks.
#pragma once

#include <functional>
#include <vector>

#include "core/optics/session.h"
#include "gui/session/session_model.h"
#include "gui/widgets/parameter_form.h"

class QPushButton;

namespace hogelscope {

/// Refreshes the form after any change of the model.
void follow(const SessionModel* model, ParameterForm* form);

/// Stacks widgets vertically without spacing. The returned column owns them.
QWidget* stackWidgets(const std::vector<QWidget*>& widgets);

/// Creates a button with an object name and a tooltip. The caller takes ownership.
QPushButton* button(const char* name, const QString& text, const QString& help);

/// Creates a form for a part of the current state; edits apply to all marked states.
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

/// Creates a form for the display, the light field or the sampling.
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

/// Creates a form for the fields of the display or the light field that `visit` visits.
/// complete(before, after) returns the edited part with its dependent fields, or throws an error:
/// the edit is then rejected, and `fail` is called with the reason.
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
