// SPDX-License-Identifier: BSD-3-Clause
// How far the reading of a light field is.
#include "gui/widgets/reading_bar.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <utility>

namespace hogelscope {

ReadingBar::ReadingBar(const QString& what, PolledBar::Share share, QWidget* parent)
    : QWidget(parent) {
  auto* bar = new PolledBar(std::move(share));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  bar->setMaximumHeight(fontMetrics().height() + 4);
  bar->setMinimumWidth(fontMetrics().horizontalAdvance(what) * 2);
  bar->setFormat(tr("%1: %p %").arg(what));
  bar->setToolTip(tr("How much has been read"));
  auto* button = new QToolButton;
  button->setText(tr("Stop"));
  button->setToolTip(tr("Stops reading; the window stays as it is without what was read"));
  connect(button, &QToolButton::clicked, this, &ReadingBar::stopAsked);
  layout->addWidget(bar);
  layout->addWidget(button);
  hide();
}

}  // namespace hogelscope
