// SPDX-License-Identifier: BSD-3-Clause
#include "gui/files/opening_dialog.h"

#include <QComboBox>
#include <QFileInfo>
#include <QPushButton>
#include <QStandardItemModel>
#include <utility>

#include "gui/session/session_forms.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/task.h"
#include "io/documents/light_field_params.h"
#include "picture/conversions.h"
#include "picture/scene_text.h"
#include "ui_opening_dialog.h"

namespace hogelscope {

namespace {

QString markOf(const Assumption& each) {
  if (each.sureness == Sureness::sure)
    return OpeningDialog::tr("<span style='color:%1'>✓</span> sure").arg(tokens().good.name());
  const QString words = each.isUsual                        ? OpeningDialog::tr("assumed")
                        : each.sureness == Sureness::likely ? OpeningDialog::tr("~ likely")
                                                            : OpeningDialog::tr("? please check");
  return QStringLiteral("<span style='color:%1'>%2</span>").arg(tokens().amber.name(), words);
}

QString rowOf(const QString& what, const QString& value, const QString& mark = {}) {
  return QStringLiteral("<tr><td><b>%1</b>&nbsp; </td><td>%2&nbsp; </td><td>%3</td></tr>")
      .arg(what, value, mark);
}

QString escaped(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped();
}

/// Returns the headline while the size is not known.
QString questionOf(Layout layout) {
  return (layout == Layout::hogels     ? OpeningDialog::tr("How many hogels? &nbsp;")
          : layout == Layout::lenslets ? OpeningDialog::tr("How many lenslets? &nbsp;")
                                       : OpeningDialog::tr("How many views? &nbsp;")) +
         markOf({});
}

QString headlineOf(const Opening& opening, Layout asked) {
  const auto& [nx, ny, du, dv] = opening.size;
  const bool isOnSheet = opening.around.session.display.sheet.has_value();
  for (const Assumption& each : opening.assumptions)
    if (each.what == "Size")
      return (isOnSheet ? OpeningDialog::tr("%1 views of %2 × %3 px &nbsp;").arg(du).arg(nx).arg(ny)
                        : OpeningDialog::tr("%1 × %2 hogels of %3 × %4 &nbsp;")
                              .arg(nx)
                              .arg(ny)
                              .arg(du)
                              .arg(dv)) +
             markOf(each);
  return questionOf(asked);
}

/// Lists what the headline does not say, with the reasons of what the user has to check. A lens
/// sheet's calibration takes the place of what is assumed of a display of hogels.
QString tableOf(const Opening& opening) {
  QString rows;
  const std::optional<SheetDisplay>& sheet = opening.around.session.display.sheet;
  for (const Assumption& each : opening.assumptions) {
    if (sheet && (each.what == "Panel" || each.what == "Field of view")) continue;
    const bool isOpen = each.sureness == Sureness::unknown && !each.isUsual;
    if (each.what != "Size") rows += rowOf(escaped(each.what), escaped(each.value), markOf(each));
    if (isOpen) rows += rowOf({}, "<i>" + escaped(each.reason) + "</i>");
  }
  if (sheet) rows += rowOf(OpeningDialog::tr("Lens sheet"), SceneText::sheet(*sheet));
  for (const std::string& warning : opening.around.order.warnings)
    rows += rowOf(QStringLiteral("⚠"), escaped(warning));
  return "<table>" + rows + "</table>";
}

QString reasonsOf(const Opening& opening) {
  QString rows;
  for (const Assumption& each : opening.assumptions)
    rows += rowOf(escaped(each.what), escaped(each.reason), markOf(each));
  return "<table>" + rows + "</table>";
}

}  // namespace

OpeningDialog::OpeningDialog(const QString& file, const Opening& opening, const QString& sheet,
                             QWidget* window)
    : QDialog(window),
      m_ui(std::make_unique<Ui::OpeningDialog>()),
      m_file(file),
      m_sheet(sheet),
      m_opening(opening),
      m_task(new Task(this)) {
  m_ui->setupUi(this);
  setWindowTitle(tr("Open %1").arg(QFileInfo(file).fileName()));
  m_ui->previewView->setTitles({}, {});
  addForms();
  listDisplays();
  connect(m_ui->displaysBox, &QComboBox::activated, this, &OpeningDialog::chooseDisplay);
  connect(m_task, &Task::stopped, this, &OpeningDialog::takeNext);
  connect(m_task, &Task::failed, this, [this](const QString& line) {
    if (!m_isStale) {
      const Layout layout = m_shown.lightField.layout;
      if (layout != m_opening.around.session.lightField.layout)
        m_ui->headlineLabel->setText(questionOf(layout));
      showProblem(line);
    }
    takeNext();
  });
  showOpening(opening);
  look(true);
}

/// Stops the task before its widgets are deleted.
OpeningDialog::~OpeningDialog() {
  m_task->abandon();
}

/// Adds the fields of light field and display that change how the file is interpreted.
void OpeningDialog::addForms() {
  m_shown = shownOf(m_opening);
  const auto form = [this](auto Session::*part) {
    return new ParameterForm([this, part](ParameterVisitor& visitor) {
      Session edited = m_shown;
      describe(visitor, edited.*part);
      edit(edited);
    });
  };
  m_lightField = form(&Session::lightField);
  m_display = form(&Session::display);
  m_lightField->hideField("file", true);
  for (const char* name : {"position", "orientation", "lens"}) m_display->hideField(name, true);
  m_ui->fieldsArea->setWidget(stackWidgets({m_lightField, m_display}));
  auto* layouts = m_lightField->findChild<QComboBox*>("layout");
  const auto* items = qobject_cast<QStandardItemModel*>(layouts->model());
  const std::string file = m_file.toStdString();
  for (int k = 0; k < layouts->count(); ++k)
    items->item(k)->setEnabled(mayHave(Layout(k), file, m_shown.lightField.layout));
}

/// Offers hogels, the lens sheet that was used last, and another one, which has no file yet.
void OpeningDialog::listDisplays() {
  QComboBox* box = m_ui->displaysBox;
  box->clear();
  box->addItem(tr("Seen on a display of hogels"), QString());
  const QString known = m_sheet.isEmpty() ? lastSheet() : m_sheet;
  if (!known.isEmpty())
    box->addItem(tr("Seen on the lens sheet of %1").arg(QFileInfo(known).fileName()), known);
  box->addItem(tr("Seen on a lens sheet…"));
  box->setCurrentIndex(m_sheet.isEmpty() ? 0 : 1);
}

void OpeningDialog::chooseDisplay(int index) {
  const QVariant known = m_ui->displaysBox->itemData(index);
  const QString chosen = known.isValid() ? known.toString() : chooseSheet(this);
  if (known.isValid() || !chosen.isEmpty()) m_sheet = chosen;
  listDisplays();
  look(false);
}

bool OpeningDialog::isOnSheet() const {
  return !m_sheet.isEmpty() && m_opening.around.session.lightField.layout == Layout::quilt;
}

Opening OpeningDialog::opening() const {
  Opening result = m_opening;
  Session& session = result.around.session;
  if (isOnSheet()) session = onSheet(session.lightField, m_sheet.toStdString());
  return result;
}

void OpeningDialog::edit(const Session& edited) {
  if (edited == m_shown) return;
  m_said = saidAfter(m_said, m_shown, edited, m_opening.picture);
  m_shown = edited;
  look(false);
}

/// Analyses the file and shows a preview. The newest edit wins: a running analysis stops without
/// blocking the window. If `isKnown`, the analysis is not repeated.
void OpeningDialog::look(bool isKnown) {
  if (!isKnown) m_ui->buttons->button(QDialogButtonBox::Open)->setEnabled(false);
  m_ui->previewView->setNotice(tr("Looking at it …"));
  m_isStale = m_task->isRunning();
  if (m_isStale)
    m_task->stop();
  else
    start(isKnown);
}

void OpeningDialog::start(bool isKnown) {
  m_task->start([this, isKnown, file = m_file.toStdString(), said = m_said,
                 known = m_opening](const Progress& progress) -> Task::Answer {
    const Opening opening = isKnown ? known : inspectFile(file, said, part(progress, 0, 0.7));
    if (!isKnown)
      m_task->queue([this, opening] {
        if (!m_isStale) showOpening(opening);
      });
    Preview preview;
    QString why;
    try {
      preview = previewOf(opening, part(progress, 0.7, 1));
    } catch (const InputError& error) {
      why = QString::fromUtf8(error.what());
    }
    return [this, preview, why] {
      if (!m_isStale) {
        m_ui->previewView->setImages(toQImage(preview.image));
        m_ui->previewCaption->setText(preview.isStretched ? tr("contrast stretched") : QString());
        m_ui->previewView->setNotice(why);
      }
      takeNext();
    };
  });
}

void OpeningDialog::takeNext() {
  if (std::exchange(m_isStale, false)) start(false);
}

/// Shows the analysis. Fields that are not consistent yet stay as typed.
void OpeningDialog::showOpening(const Opening& opening) {
  m_opening = opening;
  if (opening.problem.empty()) m_shown = shownOf(opening);
  Opening shown = opening;
  try {
    if (opening.problem.empty()) shown = this->opening();
  } catch (const InputError& error) {
    shown.problem = error.what();
  }
  m_ui->headlineLabel->setText(headlineOf(shown, m_shown.lightField.layout));
  m_ui->assumedLabel->setText(tableOf(shown));
  for (QLabel* label : {m_ui->headlineLabel, m_ui->assumedLabel})
    label->setToolTip(reasonsOf(opening));
  showProblem(QString::fromStdString(shown.problem));
  showFields();
}

void OpeningDialog::showProblem(const QString& problem) {
  m_ui->problemLabel->setText(problem);
  m_ui->problemLabel->setVisible(!problem.isEmpty());
  m_ui->buttons->button(QDialogButtonBox::Open)->setEnabled(problem.isEmpty());
}

/// Shows the fields that apply: hogel counts for images of hogels only, directions for these and
/// for views.
void OpeningDialog::showFields() {
  const Layout layout = m_shown.lightField.layout;
  m_ui->displaysBox->setVisible(layout == Layout::quilt);
  m_display->setVisible(!isOnSheet());
  m_lightField->hideField("viewingDistance", isOnSheet());
  m_display->hideField("hogels", layout != Layout::hogels);
  m_display->hideField("directions", layout != Layout::hogels && !isGridOfViews(layout));
  m_lightField->refresh();
  m_display->refresh();
}

}  // namespace hogelscope
