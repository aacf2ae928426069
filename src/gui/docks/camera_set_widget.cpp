// SPDX-License-Identifier: BSD-3-Clause
// The camera set dock.
#include "gui/docks/camera_set_widget.h"

#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "gui/session/session_model.h"
#include "gui/widgets/file_dialogs.h"
#include "gui/widgets/parameter_form.h"
#include "io/documents/camera_set_file.h"

namespace hogelscope {

CameraSetWidget::CameraSetWidget(QWidget* parent)
    : QWidget(parent),
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
  column->addWidget(
      new ParameterForm([this](ParameterVisitor& visitor) { describe(visitor, m_params); }));
  column->addWidget(
      new ParameterForm([this](ParameterVisitor& visitor) { describe(visitor, m_region); }));
  column->addStretch();
  auto* area = new QScrollArea;
  area->setWidget(forms);
  area->setWidgetResizable(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(area, 1);
  layout->addWidget(m_addButton);
  layout->addWidget(m_fileButton);
  connect(m_addButton, &QPushButton::clicked, this, [this] {
    add([this] { return CameraSet{m_params, m_region, {}}; });
  });
  connect(m_fileButton, &QPushButton::clicked, this, &CameraSetWidget::askFile);
}

void CameraSetWidget::setModel(SessionModel* model) {
  m_model = model;
  const auto enable = [this] {
    const bool has = !m_model->session().cameras.empty();
    m_addButton->setEnabled(has);
    m_fileButton->setEnabled(has);
  };
  connect(m_model, &SessionModel::opened, this, enable);
  enable();
}

bool CameraSetWidget::add(const std::function<CameraSet()>& set) {
  try {
    m_model->changeStates(tr("Add camera set"), [&](Session& session) {
      const CameraSet added = set();
      const std::size_t first = session.cameras.size() - (added.params.keepTemplate ? 0 : 1);
      session = withCameras(session, added);
      return first;
    });
    return true;
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
    return false;
  }
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
