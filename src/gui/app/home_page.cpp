// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/home_page.h"

#include <QAction>
#include <QCommandLinkButton>
#include <QCoreApplication>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <tuple>

#include "gui/files/recent_files.h"

namespace hogelscope {

namespace {

/// Returns the installed sample, or the one in the source tree; empty if there is none.
QString sampleFile(const QString& name) {
  const QString program = QCoreApplication::applicationDirPath();
  for (const QString& file : {program + "/../share/hogelscope/samples/" + name + ".hogelscope",
                              program + "/../../../data/" + name + ".json"})
    if (QFileInfo::exists(file)) return QFileInfo(file).canonicalFilePath();
  return {};
}

QLabel* heading(const QString& text, int larger) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setPointSize(font.pointSize() + larger);
  font.setBold(true);
  label->setFont(font);
  return label;
}

/// Creates a button for an action that shows the action's key.
QCommandLinkButton* buttonFor(QAction* action) {
  const QString key = action->shortcut().toString(QKeySequence::NativeText);
  auto* button = new QCommandLinkButton(action->text().remove('&') + "   " + key);
  button->setObjectName(action->objectName() + "Button");
  button->setDescription(action->toolTip());
  QObject::connect(button, &QCommandLinkButton::clicked, action, &QAction::trigger);
  return button;
}

}  // namespace

HomePage::HomePage(const QList<QAction*>& begins, QWidget* parent) : QScrollArea(parent) {
  setObjectName("homePage");
  auto* columns = new QHBoxLayout;
  columns->setSpacing(40);
  columns->addWidget(makeActions(begins), 1);
  columns->addWidget(makeFiles(), 1);
  auto* page = new QWidget;
  page->setMaximumWidth(60 * fontMetrics().horizontalAdvance("mm"));  // even in a large window
  auto* around = new QWidget;
  auto* sides = new QHBoxLayout(around);
  sides->addWidget(page);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(48, 24, 48, 24);
  layout->addStretch(1);
  layout->addWidget(heading(tr("Hogelscope"), 12));
  auto* line =
      new QLabel(tr("What a viewer sees on a light field display that does not exist yet, "
                    "and how good it is"));
  line->setWordWrap(true);
  layout->addWidget(line);
  layout->addSpacing(24);
  layout->addLayout(columns);
  layout->addStretch(2);
  setWidget(around);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
}

QWidget* HomePage::makeActions(const QList<QAction*>& begins) {
  auto* part = new QWidget;
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Begin"), 2));
  for (QAction* action : begins) layout->addWidget(buttonFor(action));
  auto* hint =
      new QLabel(tr("Or drop files here: a hogel image, a quilt, a mosaic, a folder of "
                    "views, a store, a mesh, a session."));
  hint->setWordWrap(true);
  layout->addWidget(hint);
  layout->addStretch();
  return part;
}

QWidget* HomePage::makeFiles() {
  auto* part = new QWidget;
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(heading(tr("Samples"), 2));
  for (const auto& [name, text, what] :
       {std::tuple("table1", tr("Table I"), tr("A hogel image and the paper's six camera states")),
        std::tuple("room", tr("Room"), tr("A 3-D scene, traced as it is looked at"))})
    if (const QString file = sampleFile(name); !file.isEmpty()) {
      QWidget* button = fileButton(file, text, what);
      button->setObjectName(QString(name) + "Sample");
      layout->addWidget(button);
    }
  layout->addWidget(heading(tr("Recent sessions"), 2));
  m_recent = new QVBoxLayout;
  layout->addLayout(m_recent);
  layout->addStretch();
  return part;
}

QWidget* HomePage::fileButton(const QString& file, const QString& text,
                              const QString& description) {
  auto* button = new QCommandLinkButton(text, description);
  button->setToolTip(file);
  connect(button, &QCommandLinkButton::clicked, this, [this, file] { Q_EMIT chosen(file); });
  return button;
}

void HomePage::showEvent(QShowEvent* event) {
  fillRecent();
  if (auto* room = findChild<QWidget*>("roomSample")) room->setFocus();  // a key opens it
  QScrollArea::showEvent(event);
}

void HomePage::fillRecent() {
  while (QLayoutItem* item = m_recent->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  constexpr int most = 6;  // the menu lists all of them
  for (const RecentFile& recent : RecentFiles::list()) {
    const QFileInfo info(recent.file);
    if (m_recent->count() == most) break;
    QWidget* button = fileButton(recent.file, info.fileName(), info.path());
    button->setObjectName("recentSession");
    m_recent->addWidget(button);
  }
  if (m_recent->count() == 0) m_recent->addWidget(new QLabel(tr("None yet")));
}

}  // namespace hogelscope
