// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/guide.h"

#include <QSettings>

#include "gui/session/session_model.h"

namespace hogelscope {

namespace {

constexpr const char* doneKey = "window/hintsUsed";

struct Step {
  const char* name;
  const char* text;
};
constexpr std::array steps{
    Step{"eye", QT_TRANSLATE_NOOP("hogelscope::Guide", "Next: drag the orange eye in the scene")},
    Step{"pixel", QT_TRANSLATE_NOOP("hogelscope::Guide",
                                    "Next: click a black or coarse pixel to see why it is so")},
    Step{"directions",
         QT_TRANSLATE_NOOP("hogelscope::Guide",
                           "Next: drag Directions in Display: more of them, deeper content")}};

QStringList doneSteps() {
  return QSettings().value(doneKey).toStringList();
}

}  // namespace

Guide::Guide(SessionModel* model) : m_model(model) {
  setObjectName("guide");
  setToolTip(tr("What to try next; it goes once you have done it"));
  hide();
  const auto remember = [this] {
    m_eye = m_model->current().camera.eye;
    m_directions = m_model->session().display.directions;
  };
  for (const auto other : {&SessionModel::opened, &SessionModel::currentChanged})
    connect(m_model, other, this, remember);
  for (const auto edit : {&SessionModel::edited, &SessionModel::contentChanged})
    connect(m_model, edit, this, &Guide::follow);
}

void Guide::offer() {
  const QStringList done = doneSteps();
  for (const Step& step : steps)
    if (!done.contains(step.name)) {
      setText(tr(step.text));
      return show();
    }
  hide();
}

void Guide::follow() {
  if (!(m_model->current().camera.eye == m_eye)) finish("eye");
  if (m_model->session().display.directions != m_directions) finish("directions");
}

void Guide::finish(const QString& step) {
  const QStringList done = doneSteps();
  if (done.contains(step)) return;
  QSettings().setValue(doneKey, done + QStringList{step});
  if (isVisible()) offer();
}

}  // namespace hogelscope
