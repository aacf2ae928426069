// SPDX-License-Identifier: BSD-3-Clause
// How far the reading of a light field is.
#include "gui/reading_bar.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QToolButton>

namespace hogelscope {

ReadingBar::ReadingBar(const QString& what, QWidget* parent)
    : QWidget(parent), m_bar(new QProgressBar) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  m_bar->setMaximumHeight(fontMetrics().height() + 4);
  m_bar->setMinimumWidth(fontMetrics().horizontalAdvance(what) * 2);
  m_bar->setFormat(tr("%1: %p %").arg(what));
  m_bar->setToolTip(tr("How much has been read"));
  auto* button = new QToolButton;
  button->setText(tr("Stop"));
  button->setToolTip(tr("Stops reading; the window stays as it is without what was read"));
  connect(button, &QToolButton::clicked, this, &ReadingBar::stopAsked);
  layout->addWidget(m_bar);
  layout->addWidget(button);
  hide();
}

void ReadingBar::advance(double done) {
  m_bar->setValue(int(100 * done));
  show();
}

}  // namespace hogelscope
