// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/animation_dialog.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QSpinBox>

namespace hogelscope {

AnimationDialog::AnimationDialog(const QSize& proposed, const QString& ffmpeg, QWidget* parent)
    : SizeDialog(tr("Save animation"), proposed, parent),
      m_video(new QCheckBox(tr("&Video (animation.mp4)"))),
      m_rate(new QSpinBox) {
  m_video->setObjectName("videoBox");
  m_rate->setObjectName("rateBox");
  m_rate->setRange(1, 120);
  m_rate->setValue(10);
  m_rate->setSuffix(tr(" per second"));
  m_rate->setToolTip(tr("How many states the video shows in a second"));
  m_video->setEnabled(!ffmpeg.isEmpty());
  m_video->setChecked(!ffmpeg.isEmpty());
  m_video->setToolTip(
      ffmpeg.isEmpty() ? tr("Needs the program ffmpeg, which is not installed: no ffmpeg in PATH")
                       : tr("Beside the numbered pictures, made by %1").arg(ffmpeg));
  m_rate->setEnabled(m_video->isChecked());
  connect(m_video, &QCheckBox::toggled, m_rate, &QWidget::setEnabled);
  form()->addRow(m_video);
  form()->addRow(tr("&States"), m_rate);
}

bool AnimationDialog::hasVideo() const {
  return m_video->isChecked();
}

int AnimationDialog::framesPerSecond() const {
  return m_rate->value();
}

}  // namespace hogelscope
