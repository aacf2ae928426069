// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/properties.h"

#include <QAction>
#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/docks/design_numbers_widget.h"
#include "gui/docks/light_field_dock.h"
#include "gui/docks/parameter_docks.h"
#include "gui/docks/twin_dock.h"
#include "gui/session/session_forms.h"
#include "gui/session/session_model.h"
#include "gui/widgets/column_area.h"
#include "gui/widgets/section.h"
#include "io/documents/light_field_params.h"

namespace hogelscope {

namespace {

QString eyesText(const CameraState& state) {
  QStringList parts;
  if (state.pupil.diameter > 0)
    parts << Properties::tr("pupil %1 mm").arg(1000 * state.pupil.diameter);
  if (state.stereo.ipd > 0) parts << Properties::tr("two, %1 mm").arg(1000 * state.stereo.ipd);
  return parts.isEmpty() ? Properties::tr("one pinhole") : parts.join(QStringLiteral(" · "));
}

/// Returns what a closed section says of the session and its current state.
QStringList summariesOf(const Session& session, const CameraState& state) {
  const auto words = [](std::string_view name) {
    return QString::fromUtf8(name.data(), qsizetype(name.size()));
  };
  const DisplayParams& display = session.display;
  const QString file =
      QFileInfo(QString::fromStdString(contentName(session.lightField))).fileName();
  return {file + QStringLiteral(" · ") + words(nameOf(session.lightField.layout)),
          display.sheet ? Properties::tr("lens sheet")
                        : QStringLiteral("%1 × %2 · %3 × %4")
                              .arg(display.hogels[0])
                              .arg(display.hogels[1])
                              .arg(display.directions[0])
                              .arg(display.directions[1]),
          session.twin.isZero() ? Properties::tr("as designed")
          : session.twinFile.empty()
              ? Properties::tr("as built")
              : QFileInfo(QString::fromStdString(session.twinFile)).fileName(),
          QString::fromStdString(state.camera.name),
          eyesText(state),
          state.distortion.isPinhole() ? Properties::tr("off") : Properties::tr("on"),
          state.psf.windowSize == 1
              ? Properties::tr("off")
              : Properties::tr("σ %1 · %2 px").arg(state.psf.sigma).arg(state.psf.windowSize),
          Properties::tr("%1 · %n rays", "",
                         session.sampling.samplesPerPixel * session.sampling.samplesPerPixel)
              .arg(words(nameOf(session.sampling.reconstruction)))};
}

}  // namespace

Properties::Properties(SessionModel* model, QAction* importAction, QMainWindow* window)
    : m_model(model),
      m_area(new ColumnArea),
      m_column(new QVBoxLayout),
      m_lightField(new LightFieldDock(model)),
      m_numbers(new DesignNumbersWidget(model)),
      m_display(new DisplayDock(model)),
      m_distortion(new DistortionDock(model, importAction)) {
  auto* sampling = checkedForm<SamplingParams>(
      model, &Session::sampling, [](ParameterVisitor& v, SamplingParams& p) { describe(v, p); },
      [](const SamplingParams&, SamplingParams after) { return after; },
      [this](const QString& why) { Q_EMIT failed(why); });
  sampling->hideHeading();
  add("lightFieldDock", tr("Light field"), m_lightField, window);
  add("displayDock", tr("Display"), stackWidgets({m_display, m_numbers}), window);
  add("twinDock", tr("Twin"), new TwinDock(model), window);
  add("cameraDock", tr("Camera"), new CameraDock(model), window);
  add("eyesDock", tr("Eyes"),
      stackWidgets({stateForm(model, &CameraState::pupil), stateForm(model, &CameraState::stereo)}),
      window);
  add("distortionDock", tr("Lens"), m_distortion, window);
  add("psfDock", tr("Leakage"), new PsfDock(model), window);
  add("samplingDock", tr("Sampling"), stackWidgets({sampling}), window);
  connect(m_lightField, &LightFieldDock::failed, this, &Properties::failed);
  connect(m_display, &DisplayDock::failed, this, &Properties::failed);
  const QStringList open =
      QSettings().value("window/sections", QStringList{"displayDock", "cameraDock"}).toStringList();
  for (Section* section : m_sections) {
    section->setOpen(open.contains(section->dock()->objectName()));
    connect(section, &Section::toggled, this, [this] {
      QStringList names;
      for (const Section* one : m_sections)
        if (one->isOpen()) names << one->dock()->objectName();
      QSettings().setValue("window/sections", names);
    });
  }
  m_column->setContentsMargins(0, 0, 0, 0);
  m_column->setSpacing(0);
  m_column->addStretch(1);
  auto* column = new QWidget;
  column->setLayout(m_column);
  m_area->setWidget(column);
  m_area->setObjectName("propertiesArea");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_area);
  onAnyChange(model, this, &Properties::showSummaries);
  onAnyChange(model, sampling, [model, sampling] {
    const Session& session = model->session();
    sampling->hideField("reconstruction",
                        !hasDirections(session.display) &&
                            session.sampling.reconstruction == Reconstruction::nearest);
  });
}

Section* Properties::add(const char* name, const QString& title, QWidget* content,
                         QMainWindow* window) {
  auto* dock = new QDockWidget(title, window);
  dock->setObjectName(name);
  window->addDockWidget(Qt::RightDockWidgetArea, dock);
  auto* section = new Section(content, dock);
  m_column->addWidget(section);
  m_sections.push_back(section);
  return section;
}

Section* Properties::sectionOf(const QDockWidget* dock) const {
  const auto found = std::ranges::find(m_sections, dock, &Section::dock);
  return found == m_sections.end() ? nullptr : *found;
}

void Properties::reveal(Section* section) {
  section->setOpen(true);
  // After the column has its new height.
  QTimer::singleShot(0, section, [this, section] { m_area->ensureWidgetVisible(section, 0, 0); });
}

void Properties::setOpen(bool isOpen) {
  for (Section* section : m_sections)
    if (section->content() != m_lightField) section->content()->setEnabled(isOpen);
}

void Properties::showSummaries() {
  const QStringList summaries = summariesOf(m_model->session(), m_model->current());
  for (std::size_t k = 0; k < m_sections.size(); ++k)
    m_sections[k]->setSummary(summaries[qsizetype(k)]);
}

}  // namespace hogelscope
