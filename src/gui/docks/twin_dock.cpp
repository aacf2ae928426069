// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/twin_dock.h"

#include <QVBoxLayout>

#include "gui/session/session_forms.h"

namespace hogelscope {

template <class Part>
ParameterForm* TwinDock::form(Part& (*part)(TwinParams&)) {
  return followingForm(
      m_model,
      [model = m_model, part](ParameterVisitor& visitor) {
        TwinParams twin = model->session().twin;
        describe(visitor, part(twin));
        if (twin != model->session().twin) model->setContent(withTwin(model->session(), twin));
      },
      [](ParameterVisitor& visitor) {
        Part defaults;
        describe(visitor, defaults);
      });
}

TwinDock::TwinDock(SessionModel* model, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_lenses(form<LensArrayErrors>([](TwinParams & twin) -> auto& { return twin.lensArray; })),
      m_ofHogels(stackWidgets(
          {form<RandomShift>([](TwinParams & twin) -> auto& { return twin.random.shift; }),
           form<RandomGain>([](TwinParams & twin) -> auto& { return twin.random.gain; }),
           form<TwinRandom>([](TwinParams & twin) -> auto& { return twin.random; }),
           form<ColourErrors>([](TwinParams & twin) -> auto& { return twin.colour; }),
           form<LeakageErrors>([](TwinParams & twin) -> auto& { return twin.leakage; }),
           form<LightErrors>([](TwinParams & twin) -> auto& { return twin.light; }),
           form<TwinMapFiles>([](TwinParams & twin) -> auto& { return twin.maps; })})) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(stackWidgets({m_lenses, m_ofHogels}));
  onAnyChange(model, this, &TwinDock::showForms);
  showForms();
}

void TwinDock::showForms() {
  const Session& session = m_model->session();
  const bool isSheet = session.display.sheet && isOfSheet(session.twin);
  for (const char* name : {"wedge", "focalError", "outside"}) m_lenses->hideField(name, isSheet);
  m_ofHogels->setHidden(isSheet);
}

}  // namespace hogelscope
