// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/note_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "gui/widgets/colours.h"

namespace hogelscope {

NoteBar::NoteBar(QAction* cure, QWidget* parent) : QFrame(parent), m_line(new QLabel) {
  setObjectName("noteBar");
  m_line->setObjectName("noteLine");
  m_line->setWordWrap(true);
  m_line->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* offered = new QToolButton;
  offered->setObjectName("noteCure");
  offered->setDefaultAction(cure);
  offered->setFocusPolicy(Qt::TabFocus);
  auto* close = new QToolButton;
  close->setObjectName("noteClose");
  close->setIcon(icon("close"));
  close->setToolTip(tr("Closes this line"));
  close->setAutoRaise(true);
  close->setFocusPolicy(Qt::TabFocus);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(scaled(12), scaled(4), scaled(4), scaled(4));
  row->addWidget(m_line, 1);
  row->addWidget(offered);
  row->addWidget(close);
  hide();
}

void NoteBar::say(const QString& line) {
  m_line->setText(line);
  show();
}

QString NoteBar::line() const {
  return m_line->text();
}

}  // namespace hogelscope
