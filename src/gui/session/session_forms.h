// SPDX-License-Identifier: BSD-3-Clause
// Forms for the session's parts, which follow the model; the contents of the docks.
#pragma once

#include <QPushButton>
#include <functional>
#include <vector>

#include "core/optics/session.h"
#include "gui/session/session_model.h"
#include "gui/widgets/parameter_form.h"

namespace hogelscope {

/// Calls `slot` of `receiver` after any change of the model.
template <class Receiver, class Slot>
void onAnyChange(const SessionModel* model, Receiver* receiver, Slot slot) {
  for (const auto change :
       {&SessionModel::opened, &SessionModel::currentChanged, &SessionModel::edited,
        &SessionModel::statesChanged, &SessionModel::contentChanged})
    QObject::connect(model, change, receiver, slot);
}

/// Creates a form that is refreshed after any change of the model, whose drags are one edit each.
ParameterForm* followingForm(SessionModel* model, const ParameterForm::Visit& visit,
                             const ParameterForm::Visit& defaults);

/// Stacks widgets vertically without spacing. The returned column owns them.
QWidget* stackWidgets(const std::vector<QWidget*>& widgets);

/// Creates a button with an object name and a tooltip. The caller takes ownership.
template <class Button = QPushButton>
Button* button(const char* name, const QString& text, const QString& help) {
  auto* made = new Button(text);
  made->setObjectName(name);
  made->setToolTip(help);
  return made;
}

/// Creates a form for a part of the current state; edits apply to all marked states.
template <class Part>
ParameterForm* stateForm(SessionModel* model, Part CameraState::*part) {
  return followingForm(
      model,
      [model, part](ParameterVisitor& visitor) {
        model->editMarked([&](CameraState& state) { describe(visitor, state.*part); });
      },
      [](ParameterVisitor& visitor) {
        Part defaults;
        describe(visitor, defaults);
      });
}

/// Creates a form for the fields of display, light field or sampling that `visit` visits.
/// complete(before, after) returns the edited part with its dependent fields, or throws an error:
/// the edit is then rejected, and `fail` is called with the reason.
template <class Part>
ParameterForm* checkedForm(SessionModel* model, Part Session::*part,
                           void (*visit)(ParameterVisitor&, Part&),
                           const std::function<Part(const Part& before, Part after)>& complete,
                           std::function<void(const QString&)> fail) {
  return followingForm(
      model,
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
}

}  // namespace hogelscope
