// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/hint.h"

#include <QEvent>
#include <QGraphicsOpacityEffect>
#include <QPropertyAnimation>
#include <QSettings>
#include <QStyle>

#include "gui/widgets/colours.h"

namespace hogelscope {

namespace {
constexpr const char* usedKey = "window/hintsUsed";
}  // namespace

Hint::Hint(const char* name, const QString& text, QWidget* view) : QLabel(text, view) {
  setObjectName(name);
  setProperty("isHint", true);  // for the style sheet
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAlignment(Qt::AlignCenter);
  setWordWrap(true);
  hide();
}

void Hint::offer() {
  if (QSettings().value(usedKey).toStringList().contains(objectName())) return;
  parent()->installEventFilter(this);
  show();
  place();
}

bool Hint::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  if (event->type() == QEvent::MouseButtonPress) fade();
  return QLabel::eventFilter(watched, event);
}

void Hint::place() {
  const int margin = scaled(12);
  const QRect room = parentWidget()->rect().adjusted(margin, margin, -margin, -3 * margin);
  const int wanted = fontMetrics().horizontalAdvance(text()) + scaled(40);
  const int width = std::min(wanted, room.width());
  const int height = heightForWidth(width);
  setGeometry(room.center().x() - width / 2, room.bottom() - height, width, height);
}

/// Fades quickly, and not at all where the desktop's style has no animations.
void Hint::fade() {
  parent()->removeEventFilter(this);
  QSettings settings;
  settings.setValue(usedKey, settings.value(usedKey).toStringList() << objectName());
  auto* effect = new QGraphicsOpacityEffect(this);
  setGraphicsEffect(effect);
  auto* fading = new QPropertyAnimation(effect, "opacity", this);
  fading->setDuration(std::min(120, style()->styleHint(QStyle::SH_Widget_Animation_Duration)));
  fading->setStartValue(1);
  fading->setEndValue(0);
  connect(fading, &QAbstractAnimation::finished, this, &QWidget::hide);
  fading->start();
}

}  // namespace hogelscope
