// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/animation_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>
#include <array>

#include "gui/session/session_forms.h"
#include "io/scene/animation.h"

namespace hogelscope {

AnimationDialog::AnimationDialog(const Session& session, std::size_t current, const QSize& proposed,
                                 const QString& ffmpeg, QWidget* parent)
    : SizeDialog(tr("Save animation"), proposed, parent),
      m_session(session),
      m_current(current),
      m_path(new QComboBox),
      m_count(new QSpinBox),
      m_video(new QCheckBox(ffmpeg.isEmpty() ? tr("Video: needs the program ffmpeg, not in PATH")
                                             : tr("&Video (animation.mp4)"))),
      m_rate(new QSpinBox),
      m_folder(new QLineEdit),
      m_problem(new QLabel) {
  const auto describe = [](QWidget* field, const char* name, const QString& help) {
    field->setObjectName(name);
    field->setToolTip(help);
  };
  describe(
      m_path, "pathBox",
      tr("The way of the camera; a turn goes through the display's angle, a focus stack through "
         "the depths that it shows sharply, in even steps of dioptres"));
  describe(m_count, "countBox", tr("Of the turn or the stack, or between each two states"));
  describe(m_video, "videoBox", tr("Beside the numbered pictures, made by the program ffmpeg"));
  describe(m_rate, "rateBox", tr("How many pictures the video shows in a second"));
  describe(m_folder, "folderField", tr("A folder without frames; it is made if it is missing"));
  m_problem->setObjectName("problemLabel");
  m_path->addItems({tr("Through the states"), tr("Orbit around the look-at"),
                    tr("Turntable, around the display"), tr("Focus stack, from near to far")});
  m_count->setMaximum(9999);
  m_rate->setRange(1, 120);
  m_rate->setSuffix(tr(" per second"));
  m_video->setEnabled(!ffmpeg.isEmpty());
  m_video->setChecked(!ffmpeg.isEmpty());
  m_problem->setWordWrap(true);
  QPushButton* choose = button("chooseFolderButton", tr("&Choose…"), tr("Chooses the folder"));
  auto* folder = new QHBoxLayout;
  folder->addWidget(m_folder);
  folder->addWidget(choose);
  form()->insertRow(0, tr("&Path"), m_path);
  form()->insertRow(1, tr("P&ictures"), m_count);
  form()->addRow(m_video);
  form()->addRow(tr("&Speed"), m_rate);
  form()->addRow(tr("Folder"), folder);
  form()->addRow(m_problem);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString chosen = chooseOutputFolder(this, tr("Folder of the animation"));
    if (!chosen.isEmpty()) m_folder->setText(chosen);
  });
  connect(m_path, &QComboBox::currentIndexChanged, this, &AnimationDialog::showPath);
  connect(m_count, &QSpinBox::valueChanged, this, &AnimationDialog::showProblem);
  connect(m_video, &QCheckBox::toggled, this, &AnimationDialog::showProblem);
  connect(m_folder, &QLineEdit::textChanged, this, &AnimationDialog::showProblem);
  showPath();
}

/// Proposes numbers that suit the path.
void AnimationDialog::showPath() {
  struct Usual {
    int least, count, rate;
  };
  const Usual turn{1, 120, 30};
  const auto [least, count, rate] =
      std::array{Usual{0, 0, 10}, turn, turn, Usual{2, 9, 4}}[std::size_t(path().kind)];
  m_count->setMinimum(least);
  m_count->setValue(count);
  m_count->setSuffix(path().kind == PathKind::between ? tr(" between two states") : QString());
  m_rate->setValue(rate);
  showProblem();
}

void AnimationDialog::showProblem() {
  CameraPath shortPath = path();
  // Has all sizes that the path has.
  shortPath.count = std::min(shortPath.kind == PathKind::focus ? 2 : 1, shortPath.count);
  QString problem;
  try {
    const std::vector<CameraState> states = statesAlong(shortPath, m_session, m_current);
    if (folder().isEmpty())
      problem = tr("Choose a folder.");
    else
      checkAnimation(states, folder().toStdString(), hasVideo());
  } catch (const std::exception& error) {
    problem = QString::fromUtf8(error.what());
  }
  m_rate->setEnabled(hasVideo());
  m_problem->setText(problem);
  findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->setEnabled(problem.isEmpty());
}

CameraPath AnimationDialog::path() const {
  return {PathKind(m_path->currentIndex()), m_count->value(), m_session.display.fov[0]};
}

QString AnimationDialog::folder() const {
  return m_folder->text();
}

bool AnimationDialog::hasVideo() const {
  return m_video->isChecked();
}

int AnimationDialog::framesPerSecond() const {
  return m_rate->value();
}

}  // namespace hogelscope
