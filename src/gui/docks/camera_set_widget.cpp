// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/camera_set_widget.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "gui/session/session_model.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "gui/widgets/parameter_form.h"
#include "io/documents/camera_set_file.h"

namespace hogelscope {

namespace {

/// Returns the states that a set adds to a session. Throws InputError.
std::vector<CameraState> addedStates(const Session& session, const CameraSet& set) {
  const std::size_t kept = session.cameras.size() - (set.params.keepTemplate ? 0 : 1);
  std::vector<CameraState> states = withCameras(session, set).cameras;
  states.erase(states.begin(), states.begin() + std::ptrdiff_t(kept));
  return states;
}

}  // namespace

CameraSetWidget::CameraSetWidget(QWidget* parent)
    : QWidget(parent),
      m_templates(new QComboBox),
      m_addButton(new QPushButton(tr("&Add these states"), this)),
      m_fileButton(new QPushButton(tr("Add from &file…"), this)) {
  m_addButton->setObjectName("addSetButton");
  m_addButton->setToolTip(tr("Adds the set at the end of the list of states"));
  m_fileButton->setObjectName("addSetFileButton");
  m_fileButton->setToolTip(tr(
      "A distribution, list or path (JSON), or a viewer's trace (CSV); the settings above that a "
      "file does not say are its own defaults"));
  auto* forms = new QWidget;
  auto* column = new QVBoxLayout(forms);
  column->addWidget(makeTemplates());
  column->addWidget(form(m_params));
  column->addWidget(form(m_region));
  column->addStretch();
  auto* area = new QScrollArea;
  area->setWidget(forms);
  area->setWidgetResizable(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(area, 1);
  layout->addWidget(m_addButton);
  layout->addWidget(m_fileButton);
  connect(m_addButton, &QPushButton::clicked, this,
          [this] { add([this] { return currentSet(); }); });
  connect(m_fileButton, &QPushButton::clicked, this, &CameraSetWidget::askFile);
}

template <class Params>
QWidget* CameraSetWidget::form(Params& params) {
  auto* made = new ParameterForm([this, &params](ParameterVisitor& visitor) {
    const Params before = params;
    describe(visitor, params);
    if (params != before) showPreview();
  });
  made->hideField("template", true);  // is chosen in a list
  return made;
}

QWidget* CameraSetWidget::makeTemplates() {
  m_templates->setObjectName("templateBox");
  m_templates->setToolTip(
      tr("<p>The state that lens, intrinsics, PSF, resolution and field of view are taken from</p>"
         "<p>In documents: <b>cameraSet.template</b></p>"));
  m_templates->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // names may be long
  connect(m_templates, &QComboBox::activated, this, &CameraSetWidget::showPreview);
  auto* row = new QWidget;
  auto* layout = new QFormLayout(row);
  layout->addRow(tr("Template"), m_templates);
  return row;
}

QString CameraSetWidget::currentText() const {
  return tr("Current state (%1)").arg(QString::fromStdString(m_model->current().camera.name));
}

/// Refills the list of template states, and keeps the choice while its state exists.
void CameraSetWidget::showTemplates() {
  const QString chosen = m_templates->currentIndex() > 0 ? m_templates->currentText() : QString();
  m_templates->clear();
  const Session& session = m_model->session();
  if (session.cameras.empty()) return;
  m_templates->addItem(currentText());
  for (const CameraState& state : session.cameras)
    m_templates->addItem(QString::fromStdString(state.camera.name));
  for (int k = 1; k < m_templates->count(); ++k)
    if (m_templates->itemText(k) == chosen) m_templates->setCurrentIndex(k);
}

CameraSet CameraSetWidget::currentSet() const {
  CameraSet set{m_params, m_region, {}};
  const int chosen = m_templates->currentIndex();
  const std::size_t index = chosen > 0 ? std::size_t(chosen - 1) : m_model->currentIndex();
  set.params.templateState = m_model->session().cameras.at(index).camera.name;
  return set;
}

/// Updates the preview; a set that cannot be generated leaves the previous one.
void CameraSetWidget::showPreview() {
  if (!isVisible() || m_model == nullptr || m_model->session().cameras.empty()) return;
  try {
    setPreview(addedStates(m_model->session(), currentSet()));
  } catch (const InputError&) {
  }
}

void CameraSetWidget::setPreview(const std::vector<CameraState>& states) {
  if (states == m_preview) return;
  m_preview = states;
  Q_EMIT previewChanged(m_preview);
}

void CameraSetWidget::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  showPreview();
}

void CameraSetWidget::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  setPreview({});
}

void CameraSetWidget::setModel(SessionModel* model) {
  m_model = model;
  for (const auto change : {&SessionModel::opened, &SessionModel::statesChanged})
    connect(m_model, change, this, &CameraSetWidget::showTemplates);
  connect(m_model, &SessionModel::currentChanged, this,
          [this] { m_templates->setItemText(0, currentText()); });
  showTemplates();
  // Changes of the session update an existing preview but do not show a removed one again.
  for (const auto change : {&SessionModel::currentChanged, &SessionModel::statesChanged,
                            &SessionModel::edited, &SessionModel::contentChanged})
    connect(m_model, change, this, [this] {
      if (!m_preview.empty()) showPreview();
    });
  connect(m_model, &SessionModel::opened, this, &CameraSetWidget::showPreview);
  const auto enable = [this] {
    const bool has = !m_model->session().cameras.empty();
    m_addButton->setEnabled(has);
    m_fileButton->setEnabled(has);
  };
  connect(m_model, &SessionModel::opened, this, enable);
  enable();
}

bool CameraSetWidget::add(const std::function<CameraSet()>& set) {
  return guarded(this, [&] {
    m_model->changeStates(tr("Add camera set"), [&](Session& session) {
      const CameraSet added = set();
      const std::size_t first = session.cameras.size() - (added.params.keepTemplate ? 0 : 1);
      session = withCameras(session, added);
      setPreview({});
      return first;
    });
  });
}

bool CameraSetWidget::addFromFile(const QString& file) {
  return add([&] { return loadCameraSet(file.toStdString(), {}); });
}

void CameraSetWidget::askFile() {
  const QString file = chooseFile(this, tr("Add states from a camera set"),
                                  tr("Camera sets and traces (*.json *.csv)"));
  if (!file.isEmpty()) addFromFile(file);
}

}  // namespace hogelscope
