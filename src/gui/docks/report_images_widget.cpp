// SPDX-License-Identifier: BSD-3-Clause
// A state's reference, test and difference.
#include "gui/docks/report_images_widget.h"

#include <QHBoxLayout>
#include <QLabel>

#include "gui/view/image_widget.h"

namespace hogelscope {

namespace {

std::array<QString, 3> titles() {
  return {ReportImagesWidget::tr("Reference"), ReportImagesWidget::tr("Test"),
          ReportImagesWidget::tr("Difference")};
}

}  // namespace

ReportImagesWidget::ReportImagesWidget(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  m_reference = add(0, "reportReference");
  m_test = add(1, "reportTest");
  m_difference = add(2, "reportDifference");
  m_difference->setMode(ImageWidget::Mode::difference);
  m_test->linkTo(*m_reference);
  m_difference->linkTo(*m_reference);
  clear();
}

ImageWidget* ReportImagesWidget::add(std::size_t index, const char* name) {
  auto* view = new ImageWidget;
  view->setObjectName(name);
  view->setMinimumSize(90, 90);
  m_captions[index] = new QLabel(titles()[index]);
  auto* column = new QVBoxLayout;
  column->addWidget(m_captions[index]);
  column->addWidget(view, 1);
  static_cast<QHBoxLayout*>(layout())->addLayout(column, 1);
  return view;
}

void ReportImagesWidget::setImages(const QString& state, const QImage& reference,
                                   const QImage& test) {
  for (std::size_t k = 0; k < m_captions.size(); ++k)
    m_captions[k]->setText(state.isEmpty() ? titles()[k] : titles()[k] + ": " + state);
  m_reference->setImages(reference);
  m_test->setImages(test);
  m_difference->setImages(reference, test);
  const std::array views{m_reference, m_test, m_difference};
  for (std::size_t k = 0; k < views.size(); ++k)
    views[k]->setNotice(views[k]->image().isNull() ? titles()[k] : QString());
}

void ReportImagesWidget::clear() {
  setImages({}, {}, {});
}

}  // namespace hogelscope
