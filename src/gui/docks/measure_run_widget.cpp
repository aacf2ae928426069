// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/measure_run_widget.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QUrl>
#include <QVBoxLayout>

#include "core/base/error.h"
#include "gui/session/session_forms.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/task_widgets.h"
#include "measure/measure_run.h"

namespace hogelscope {

MeasureRunWidget::MeasureRunWidget(SessionModel* model, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_task(new Task(this)),
      m_open(button("openMeasurePageButton", tr("&Open the page"),
                    tr("Shows the page in a web browser"))),
      m_note(new QLabel) {
  m_note->setObjectName("measureAllNote");
  m_note->setWordWrap(true);
  m_note->setTextFormat(Qt::PlainText);
  m_open->hide();
  auto* measureAll = button<TaskButton>(
      "measureAllButton", tr("Measure &all…"),
      tr("Measures all figures of the display, and writes a page with plots and a "
         "table into a folder"));
  measureAll->control(m_task, [this] { askFolder(); });
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{measureAll, new PolledBar(m_task, this), m_note, m_open})
    column->addWidget(widget);
  connect(m_open, &QPushButton::clicked, this, [this] {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(m_page)))
      showNote(tr("%1: no web browser could be started for it").arg(m_page));
  });
  connect(m_task, &Task::stopped, this, [this] {
    showNote(tr("Stopped. What is finished is kept: the same folder goes on from there."));
  });
  connect(m_task, &Task::failed, this, &MeasureRunWidget::showNote);
  showNote({});
}

MeasureRunWidget::~MeasureRunWidget() {
  m_task->abandon();
}

void MeasureRunWidget::askFolder() {
  const QString folder = chooseFolder(this, tr("Measure all into a folder"));
  if (!folder.isEmpty()) measureInto(folder);
}

void MeasureRunWidget::measureInto(const QString& folder) {
  if (m_model->session().cameras.empty() || m_task->isRunning()) return;
  MeasureRequest request;
  request.session = m_model->session();
  request.session.cameras = {m_model->current()};
  request.name =
      (m_model->file().isEmpty() ? tr("new session") : QFileInfo(m_model->file()).fileName())
          .toStdString();
  request.output = folder.toStdString();
  const QString page = QDir(folder).filePath("measure.html");
  m_task->start([=, this](const Progress& progress) mutable {
    request.display = displayToMeasure(request.session, progress);
    const std::size_t count = measure(request, progress).figures.size();
    return [this, page, count] {
      m_page = page;
      showNote(tr("%1 rows are in %2").arg(count).arg(QFileInfo(page).dir().dirName()));
      m_open->show();
    };
  });
  m_open->hide();
  m_note->hide();
}

void MeasureRunWidget::showNote(const QString& note) {
  m_note->setText(note);
  m_note->setVisible(!note.isEmpty());
}

}  // namespace hogelscope
