// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/camera_set_widget.h"

#include "gui/session/session_model.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "gui/widgets/parameter_form.h"
#include "io/documents/camera_set_file.h"
#include "io/scene/view_source.h"
#include "ui_camera_set_widget.h"

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
    : QWidget(parent), m_ui(std::make_unique<Ui::CameraSetWidget>()) {
  m_ui->setupUi(this);
  m_ui->forms->addWidget(form(m_params));
  m_ui->forms->addWidget(form(m_region));
  m_ui->forms->addStretch();
  connect(m_ui->templateBox, &QComboBox::activated, this, &CameraSetWidget::showPreview);
  connect(m_ui->addSetButton, &QPushButton::clicked, this,
          [this] { add([this] { return currentSet(); }); });
  connect(m_ui->addSetFileButton, &QPushButton::clicked, this, &CameraSetWidget::askFile);
}

CameraSetWidget::~CameraSetWidget() = default;

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

QString CameraSetWidget::currentText() const {
  return tr("Current state (%1)").arg(QString::fromStdString(m_model->current().camera.name));
}

/// Refills the list of template states, and keeps the choice while its state exists.
void CameraSetWidget::showTemplates() {
  const QString chosen =
      m_ui->templateBox->currentIndex() > 0 ? m_ui->templateBox->currentText() : QString();
  m_ui->templateBox->clear();
  const Session& session = m_model->session();
  if (session.cameras.empty()) return;
  m_ui->templateBox->addItem(currentText());
  for (const CameraState& state : session.cameras)
    m_ui->templateBox->addItem(QString::fromStdString(state.camera.name));
  for (int k = 1; k < m_ui->templateBox->count(); ++k)
    if (m_ui->templateBox->itemText(k) == chosen) m_ui->templateBox->setCurrentIndex(k);
}

CameraSet CameraSetWidget::currentSet() const {
  CameraSet set{m_params, m_region, {}};
  const int chosen = m_ui->templateBox->currentIndex();
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
          [this] { m_ui->templateBox->setItemText(0, currentText()); });
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
    m_ui->addSetButton->setEnabled(has);
    m_ui->addSetFileButton->setEnabled(has);
  };
  connect(m_model, &SessionModel::opened, this, enable);
  enable();
}

bool CameraSetWidget::add(const std::function<CameraSet()>& set) {
  std::vector<std::string> notes;
  const bool isAdded = guarded(this, [&] {
    m_model->changeStates(tr("Add camera set"), [&](Session& session) {
      CameraSet added = set();
      added.keepsTimes = std::holds_alternative<Trace>(added.source) && isInTime(session);
      notes = added.notes;
      const std::size_t first = session.cameras.size() - (added.params.keepTemplate ? 0 : 1);
      session = withCameras(session, added);
      setPreview({});
      return first;
    });
  });
  for (const std::string& note : notes)
    if (isAdded) Q_EMIT failed(QString::fromStdString(note));
  return isAdded;
}

bool CameraSetWidget::addFromFile(const QString& file) {
  return add([&] { return loadCameraSet(file.toStdString(), {}); });
}

void CameraSetWidget::askFile() {
  const QString file = chooseFile(
      this, tr("Add states from a camera set"),
      tr("Camera sets, traces and cameras (*.json *.csv *.txt *.yaml *.xml *.bin);;All files (*)"));
  if (!file.isEmpty()) addFromFile(file);
}

}  // namespace hogelscope
