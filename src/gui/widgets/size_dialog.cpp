// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/size_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace hogelscope {

SizeDialog::SizeDialog(const QString& title, const QSize& proposed, QWidget* parent)
    : QDialog(parent),
      m_proposed(proposed.expandedTo({1, 1})),
      m_form(new QFormLayout),
      m_width(new QSpinBox) {
  setObjectName("sizeDialog");
  setWindowTitle(title);
  constexpr double longest = 16384;  // px, the limit of a state's resolution
  const double aspect = double(m_proposed.height()) / m_proposed.width();
  m_width->setObjectName("widthBox");
  m_width->setRange(1, int(longest / std::max(1.0, aspect)));
  m_width->setValue(m_proposed.width());
  m_width->setSuffix(tr(" px"));
  m_width->setToolTip(tr("The height follows, so that the same field is seen"));
  auto* height = new QLabel;
  const auto showHeight = [this, height] { height->setText(tr("%1 px").arg(size().height())); };
  connect(m_width, &QSpinBox::valueChanged, height, showHeight);
  showHeight();
  m_form->addRow(tr("&Width"), m_width);
  m_form->addRow(tr("Height"), height);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(m_form);
  layout->addWidget(buttons);
  m_width->selectAll();
}

QSize SizeDialog::size() const {
  const double height = double(m_width->value()) * m_proposed.height() / m_proposed.width();
  return {m_width->value(), std::max(1, int(std::lround(height)))};
}

}  // namespace hogelscope
