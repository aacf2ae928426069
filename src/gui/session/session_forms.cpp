// SPDX-License-Identifier: BSD-3-Clause
#include "gui/session/session_forms.h"

#include <QVBoxLayout>

namespace hogelscope {

ParameterForm* followingForm(SessionModel* model, const ParameterForm::Visit& visit,
                             const ParameterForm::Visit& defaults) {
  auto* form = new ParameterForm(visit, defaults);
  onAnyChange(model, form, &ParameterForm::refresh);
  QObject::connect(form, &ParameterForm::dragged, model, &SessionModel::holdEdits);
  return form;
}

QWidget* stackWidgets(const std::vector<QWidget*>& widgets) {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  for (QWidget* widget : widgets) layout->addWidget(widget);
  layout->addStretch();
  return column;
}

}  // namespace hogelscope
