// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/display_dock.h"

#include <QVBoxLayout>

#include "gui/session/session_forms.h"
#include "io/plugins/display_json.h"

namespace hogelscope {

namespace {

/// Returns an edited display with its plugin's parameters. Throws InputError if there is no such
/// plugin or its lens cannot be opened.
DisplayParams completed(const DisplayParams& before, DisplayParams after) {
  if (after.lens != HogelLensModel::plugin) {
    after.lensSource.clear();
    after.lensParams = {};
    return after;
  }
  if (after.lens != before.lens) after.lensSource = "measured-lens";
  if (after.lensSource != before.lensSource) after.lensParams = lensParamsOf(after.lensSource);
  for (const std::size_t axis : {0, 1}) (void)lensOf(after, axis);
  return after;
}

}  // namespace

DisplayDock::DisplayDock(SessionModel* model, QWidget* parent) : QWidget(parent), m_model(model) {
  auto* lens = form([](ParameterVisitor& v, DisplayParams& p) {
    if (p.lensParams.isGiven()) describe(v, p.lensParams);
  });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(
      stackWidgets({form([](ParameterVisitor& v, DisplayParams& p) { describe(v, p); }), lens}));
  const auto show = [this, lens] {
    lens->setVisible(m_model->session().display.lensParams.isGiven());
  };
  for (const auto change : {&SessionModel::opened, &SessionModel::contentChanged})
    connect(m_model, change, lens, show);
  show();
}

QWidget* DisplayDock::form(void (*visit)(ParameterVisitor&, DisplayParams&)) {
  return checkedForm<DisplayParams>(m_model, &Session::display, visit, &completed,
                                    [this](const QString& why) { Q_EMIT failed(why); });
}

}  // namespace hogelscope
