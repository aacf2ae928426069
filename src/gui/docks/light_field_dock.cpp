// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/light_field_dock.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <array>

#include "gui/session/session_forms.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/task.h"
#include "io/documents/light_field_params.h"
#include "io/opening/session_around.h"
#include "io/scene/live_file.h"
#include "io/scene/view_source.h"

namespace hogelscope {

LightFieldDock::LightFieldDock(SessionModel* model, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_contents(new QLabel),
      m_hasWeave(new QCheckBox(tr("&Woven for another lens sheet"))),
      m_task(new Task(this)) {
  m_contents->setObjectName("contentsLabel");
  m_contents->setToolTip(tr("What has been read"));
  m_contents->setWordWrap(true);
  m_contents->setMargin(9);
  auto* fileButton = button("chooseFileButton", tr("Choose &file…"),
                            tr("Another picture: hogels, or tiles of views"));
  auto* folderButton = button("chooseFolderButton", tr("Choose f&older…"),
                              tr("Another folder of views (sub-aperture pictures)"));
  auto* optimise = button("optimiseButton", tr("O&ptimise…"),
                          tr("Content that makes up for the display's leakage"));
  connect(optimise, &QPushButton::clicked, this, &LightFieldDock::optimiseAsked);
  connect(fileButton, &QPushButton::clicked, this, &LightFieldDock::askFile);
  connect(folderButton, &QPushButton::clicked, this, &LightFieldDock::askFolder);
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  row->addWidget(fileButton);
  row->addWidget(folderButton);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  const auto visitContent = [](ParameterVisitor& v, LightFieldParams& p) {
    if (p.content.isGiven()) describe(v, p.content);
  };
  const auto visitLive = [](ParameterVisitor& v, LightFieldParams& p) { describe(v, p.live); };
  m_liveForms = {form(visitContent), form(visitLive)};
  m_file = form([](ParameterVisitor& v, LightFieldParams& p) { describe(v, p); });
  m_file->hideHeading();
  m_weave = form([](ParameterVisitor& v, LightFieldParams& p) {
    if (p.calibration) describe(v, p.calibration->params);
  });
  m_weave->hideHeading();
  m_hasWeave->setObjectName("weaveBox");
  m_hasWeave->setToolTip(
      tr("The panel's picture is made for these figures, and seen through the display's lenses: a "
         "wrong calibration can be recognised by its look"));
  connect(m_hasWeave, &QCheckBox::toggled, this, &LightFieldDock::setWeave);
  auto* below = new QWidget;
  (new QHBoxLayout(below))->addWidget(optimise);
  layout->addWidget(stackWidgets(
      {m_file, buttons, m_liveForms[0], m_liveForms[1], m_hasWeave, m_weave, m_contents, below}));
  for (const auto change : {&SessionModel::opened, &SessionModel::contentChanged})
    connect(m_model, change, this, &LightFieldDock::showForms);
  showForms();
  const auto enable = [this, buttons] { buttons->setEnabled(!m_model->session().cameras.empty()); };
  connect(m_model, &SessionModel::opened, this, enable);
  enable();
  connect(m_model, &SessionModel::opened, m_task, &Task::abandon);
  connect(m_task, &Task::failed, this, &LightFieldDock::failed);
  setSource(std::nullopt);
}

/// Creates a form for the light field or a part of it.
ParameterForm* LightFieldDock::form(void (*visit)(ParameterVisitor&, LightFieldParams&)) {
  return checkedForm<LightFieldParams>(m_model, &Session::lightField, visit, &withDefaults,
                                       [this](const QString& why) { Q_EMIT failed(why); });
}

void LightFieldDock::showForms() {
  const bool isLive = m_model->session().lightField.content.isGiven();
  for (QWidget* part : m_liveForms) part->setVisible(isLive);
  const bool isSheet = m_model->session().display.sheet.has_value();
  m_file->hideField("viewingDistance", isSheet);
  const bool hasWeave = m_model->session().lightField.calibration.has_value();
  const QSignalBlocker blocker(m_hasWeave);
  m_hasWeave->setChecked(hasWeave);
  m_hasWeave->setVisible(isSheet && m_model->session().lightField.layout != Layout::woven);
  m_weave->setVisible(hasWeave);
}

/// Begins with the display's own calibration, as the one that the panel's picture is made for.
void LightFieldDock::setWeave(bool isAnother) {
  Session content = m_model->session();
  content.lightField.calibration.reset();
  content.lightField.calibrationFile.clear();
  if (isAnother && content.display.sheet)
    content.lightField.calibration = content.display.sheet->calibration;
  m_model->setContent(content);
}

void LightFieldDock::setSource(const std::optional<ViewSource>& source) {
  if (!source) return m_contents->setText(tr("No light field has been read."));
  const LightFieldSize size = source->lightField->size();
  if (source->display.sheet)
    return m_contents->setText(tr("The picture of the lens sheet's panel, %1×%2 px, is in memory.")
                                   .arg(size.nx)
                                   .arg(size.ny));
  const std::array<QString, 3> types{tr("8 bit"), tr("16 bit"), tr("floating point")};
  const LightFieldSource& lightField = *source->lightField;
  const QString where =
      lightField.isInMemory()
          ? tr("%1 in memory")
                .arg(locale().formattedDataSize(qint64(LightField::bytes(size, lightField.type()))))
      : m_model->session().lightField.isLive()
          ? tr("traced as each view needs it")
          : tr("in a store, of which each view reads what it needs");
  m_contents->setText(tr("%1×%2 hogels of %3×%4 directions, %5\n"
                         "as one hogel image: %6×%7 px; %8")
                          .arg(size.nx)
                          .arg(size.ny)
                          .arg(size.du)
                          .arg(size.dv)
                          .arg(types[std::size_t(lightField.type())])
                          .arg(size.width())
                          .arg(size.height())
                          .arg(where));
}

void LightFieldDock::choose(const QString& file) {
  m_task->abandon();
  if (isMeshFile(file.toStdString())) return chooseMesh(file);
  Session content = m_model->session();
  content.lightField = withFile(content.lightField, file.toStdString());
  if (isGridOfViews(content.lightField.layout)) return chooseViews(content.lightField);
  m_model->setContent(content);
}

/// Sets the views in the background, after their order has been found.
void LightFieldDock::chooseViews(const LightFieldParams& views) {
  m_task->start([this, views, session = m_model->session()](const Progress& progress) {
    return [this, with = withViews(session, views, progress)] {
      Session content = m_model->session();
      content.lightField = with.session.lightField;
      content.display.directions = with.session.display.directions;
      m_model->setContent(content);
      for (const std::string& warning : with.order.warnings)
        Q_EMIT failed(QString::fromStdString(contentName(content.lightField) + ": " + warning));
    };
  });
}

/// Sets a mesh in the background, with a display that fits it at the panel's current pose.
void LightFieldDock::chooseMesh(const QString& file) {
  m_task->start([this, file](const Progress& progress) {
    return [this, around = sessionAround(file.toStdString(), {}, progress)] {
      Session content = m_model->session();
      content.lightField = around.lightField;
      content.display = around.display;
      content.display.position = m_model->session().display.position;
      content.display.orientation = m_model->session().display.orientation;
      m_model->setContent(content);
    };
  });
}

void LightFieldDock::askFile() {
  const QString file = chooseFile(this, tr("Choose light field"), lightFieldFilter());
  if (!file.isEmpty()) choose(file);
}

void LightFieldDock::askFolder() {
  const QString folder = chooseFolder(this, tr("Choose folder of views"));
  if (!folder.isEmpty()) choose(folder);
}

}  // namespace hogelscope
